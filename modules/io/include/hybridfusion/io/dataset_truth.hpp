#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// True pinhole camera of a data set, OpenCV pixel convention (first pixel centre (0, 0)).
struct TrueCamera {
  int width_px = 0;
  int height_px = 0;
  double focal_px = 0.0;
  Eigen::Vector2d principal_point_px = Eigen::Vector2d::Zero();
  double k1 = 0.0;
  double k2 = 0.0;
};

/// truth/dataset.json. Entries a data set does not have are empty.
struct DatasetTruth {
  GeodeticOrigin origin = {};
  std::optional<TrueCamera> camera = {};
  std::optional<Rigid3> enu_from_imu_at_first_scan = {};
  std::optional<Rigid3> imu_from_lidar = {};
};

/// One line of truth/cameras.csv.
struct TruePhotoPose {
  std::string name = {};
  double time_s = 0.0;  ///< UNIX epoch.
  Rigid3 enu_from_camera = {};
  std::optional<Eigen::Vector3d> gnss_in_enu = {};  ///< What was written into the EXIF [m].
};

[[nodiscard]] Expected<DatasetTruth> read_dataset_truth(const std::filesystem::path& dataset_json);
[[nodiscard]] Expected<std::vector<TruePhotoPose>> read_true_photo_poses(
    const std::filesystem::path& cameras_csv);

}  // namespace hybridfusion
