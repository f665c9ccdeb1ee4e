#pragma once

#include "sfm_model.hpp"

#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A camera centre on its way.
struct TimedPosition {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< Any frame and unit.
  int flight = 0;
  double time_s = 0.0;  ///< Since the start of the flight.
};

/// Velocity [unit/s] at each position: slope over up to two neighbours on either side that continue
/// in the same direction. Zero where neighbours are missing or more than half a minute away.
/// @param track  Flight after flight, each in order of time.
[[nodiscard]] std::vector<Eigen::Vector3d> track_velocities(std::span<const TimedPosition> track);

/// As track_velocities for the registered views of a model; one per view, zero where unknown.
[[nodiscard]] std::vector<Eigen::Vector3d> view_velocities(const SfmModel& model,
                                                           const GnssIngest& gnss);

/// What the tags of a flight show less where the camera was: height offset and drift, and the way
/// back that a late tag lags behind.
[[nodiscard]] inline Eigen::Vector3d tag_error(const FlightErrors& errors,
                                               double flight_time_s,
                                               const Eigen::Vector3d& velocity_mps) {
  return Eigen::Vector3d(0.0, 0.0, errors.offset_m + errors.rate_mps * flight_time_s) -
         errors.lag_s * velocity_mps;
}

}  // namespace hybridfusion
