#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// What the metadata of one photo is worth as a position.
struct PhotoFix {
  std::optional<Eigen::Vector3d> position_in_enu = {};  ///< Empty: absent or rejected.
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Zero();    ///< Standard deviations east, north, up.
  bool has_altitude = false;                            ///< Else only east and north count.
  bool is_rtk = false;
  int flight = 0;              ///< Photos of one flight share vertical GNSS errors.
  double flight_time_s = 0;    ///< Since the first photo of the flight; 0 without time stamps.
  std::string rejection = {};  ///< Why position_in_enu is empty.
};

struct GnssIngest {
  GeodeticOrigin origin = {};             ///< Component-wise median of the accepted fixes.
  std::vector<PhotoFix> fixes = {};       ///< One per photo, in input order.
  std::vector<std::size_t> by_time = {};  ///< Photo indices in order of time (input order if none).
  std::vector<std::string> warnings = {};
};

/// Positions, deviations and flights of the photos. Zero and impossible coordinates, altitudes of
/// exactly 0 and positions off their neighbours in time are rejected one by one; altitudes come
/// from one source for all photos (XMP absolute altitude where most photos have it, else EXIF).
/// @returns kInsufficient when fewer than 3 usable positions remain or when most are identical.
[[nodiscard]] Expected<GnssIngest> ingest_gnss(std::span<const PhotoMetadata> photos,
                                               const GnssOptions& options);

/// For photos whose positions are of no use: no fixes, order of time and flights only.
/// @param reason  Why; becomes the rejection of every fix and a warning.
[[nodiscard]] GnssIngest without_gnss(std::span<const PhotoMetadata> photos,
                                      const std::string& reason);

}  // namespace hybridfusion
