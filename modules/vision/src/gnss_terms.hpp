#pragma once

#include <hybridfusion/vision/reconstruction.hpp>

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// GNSS of one view as it enters the adjustment.
struct GnssObservation {
  std::uint32_t view = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< East-north-up [m].
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Ones();   ///< Infinite: the component does not count.
  int flight = 0;
  double flight_time_s = 0.0;
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();  ///< Of the camera; zero: unknown.
};

/// What a camera holds for up, from elsewhere than GNSS.
struct UpObservation {
  std::uint32_t view = 0;
  Eigen::Vector3d up_in_camera = Eigen::Vector3d::UnitZ();
  double sigma_rad = 1.0;
};

enum class GnssForm : std::uint8_t { kAbsolute, kDisplacement };

struct GnssTerms {
  GnssForm form = GnssForm::kAbsolute;
  std::vector<GnssObservation> observations = {};  ///< In order of time.
  bool estimate_drift = false;                     ///< Else offsets and rates stay as they are.
  bool estimate_lag = false;
  std::vector<FlightErrors> flights = {};  ///< Per flight; the start and, then, the estimate.
  Eigen::Vector3d antenna_in_camera = Eigen::Vector3d::Zero();  ///< Lever arm [m].
  std::vector<UpObservation> ups = {};
  double loss_width = 3.0;  ///< Cauchy, in sigmas.
};

}  // namespace hybridfusion
