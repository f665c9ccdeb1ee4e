#pragma once

#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/vision/camera.hpp>
#include <hybridfusion/vision/ground_control.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A feature of a photo that belongs to a scene point.
struct Observation {
  std::uint32_t point = 0;  ///< Into Reconstruction::points.
  Eigen::Vector2f pixel = Eigen::Vector2f::Zero();
};

/// One input photo, registered or not. Reconstruction::views has one per photo, in input order.
struct View {
  std::string name = {};
  std::uint32_t camera = 0;                    ///< Into Reconstruction::cameras.
  std::optional<Rigid3> enu_from_camera = {};  ///< Camera: x right, y down, z forward.
  /// Of [camera centre, east-north-up (m); rotation, right perturbation (rad)], from pixels, GNSS
  /// and calibration together. Empty in sets too large for it (300 photos) and without positions.
  std::optional<Eigen::Matrix<double, 6, 6>> pose_covariance = {};
  std::vector<Observation> observations = {};
  std::optional<Eigen::Vector3d> gnss_in_enu = {};   ///< Absent or rejected: empty.
  std::optional<Eigen::Vector3d> gnss_sigma_m = {};  ///< As used in the adjustment.
  std::string reason = {};                           ///< Why it is not registered; else empty.
};

struct ViewObservation {
  std::uint32_t view = 0;
  std::uint32_t observation = 0;  ///< Into View::observations.
};

/// Triangulated feature track.
struct ScenePoint {
  Eigen::Vector3d point_in_enu = Eigen::Vector3d::Zero();
  Rgb8 color = {};
  float mean_error_px = 0.0F;
  std::vector<ViewObservation> track = {};
};

/// Systematic errors of the GNSS tags of one flight: a tag shows where the camera was `lag_s`
/// before its photo, `offset_m + rate_mps * time since the first photo` too high.
struct FlightErrors {
  double offset_m = 0.0;
  double rate_mps = 0.0;
  double lag_s = 0.0;
};

/// How far place, scale and tilt of the result can be relied on.
enum class GeoreferenceVerdict : std::uint8_t {
  kGood,      ///< Scale to 0.5 % and tilt to 0.5 degrees (one deviation).
  kLimited,   ///< Worse, or heights rest on something else than the altitudes of the photos.
  kUnusable,  ///< Scale worse than 1 %, tilt worse than 1 degree, or nothing to place the model by.
};

/// Figures that tell whether the geometry can be trusted; all over registered views.
struct ReconstructionQuality {
  double mean_reprojection_px = 0.0;
  double median_reprojection_px = 0.0;
  double gnss_horizontal_rms_m = 0.0;  ///< After the adjustment, over photos with a used GNSS fix.
  double gnss_vertical_rms_m = 0.0;
  double estimated_sigma_horizontal_m = 0.0;
  double estimated_sigma_vertical_m = 0.0;
  double initial_focal_px = 0.0;
  double scale_sigma = 0.0;     ///< Relative standard deviation of the scale.
  double tilt_sigma_rad = 0.0;  ///< Standard deviation of the up direction.
  /// Height by which GNSS bent the block at its edge against its middle: near 0 where images and
  /// GNSS agree; a wrong calibration domes it.
  double dome_m = 0.0;
  std::vector<FlightErrors> flights = {};  ///< Estimated errors of the GNSS tags, per flight.
  GeoreferenceVerdict georeference = GeoreferenceVerdict::kGood;
  std::vector<std::string> georeference_reasons = {};  ///< Why it is not kGood.
};

/// Cameras and sparse points in the east-north-up frame at `origin`.
struct Reconstruction {
  GeodeticOrigin origin = {};
  /// False: no positions were usable. Then the frame is arbitrary: z about up where that is known,
  /// the middle of the cameras at the origin, and a unit that is no metre.
  bool georeferenced = true;
  std::vector<CameraIntrinsics> cameras = {};
  std::vector<View> views = {};
  std::vector<ScenePoint> points = {};
  std::vector<ControlResidual> control = {};  ///< Of the surveyed points, in input order.
  ReconstructionQuality quality = {};
  std::vector<std::string> warnings = {};
};

}  // namespace hybridfusion
