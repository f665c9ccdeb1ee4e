#include "adjustment_gnss.hpp"

#include "flight_errors.hpp"

#include <algorithm>

namespace hybridfusion {
namespace {

// About what the alignment found. HybridFusion names no prior; consumer receivers drift by metres
// of height in a flight.
constexpr double kOffsetSigma_m = 20.0;
constexpr double kRateSigma_mps = 0.5 / 60.0;
constexpr double kLagSigma_s = 2.0;

}  // namespace

GnssBlocks::GnssBlocks(GnssTerms& terms)
    : terms_(terms), loss_(std::make_unique<ceres::CauchyLoss>(terms.loss_width)) {
  int flights = 0;
  for (const GnssObservation& o : terms.observations) flights = std::max(flights, o.flight + 1);
  terms.flights.resize(static_cast<std::size_t>(flights));
  for (const FlightErrors& f : terms.flights) {
    flights_.emplace_back(f.offset_m, f.rate_mps, f.lag_s);
  }
}

void GnssBlocks::add_to(ceres::Problem& problem,
                        std::vector<std::array<double, kPoseSize>>& poses,
                        const std::vector<bool>& in_problem) {
  if (terms_.form == GnssForm::kAbsolute) {
    add_positions(problem, poses, in_problem);
  } else {
    add_displacements(problem, poses, in_problem);
  }
  for (const UpObservation& up : terms_.ups) {
    if (!in_problem[up.view]) continue;
    // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the problem owns its costs
    auto* cost = new UpDirectionCost(up.up_in_camera, up.sigma_rad);
    problem.AddResidualBlock(cost, nullptr, poses[up.view].data());
  }
}

void GnssBlocks::add_positions(ceres::Problem& problem,
                               std::vector<std::array<double, kPoseSize>>& poses,
                               const std::vector<bool>& in_problem) {
  for (const GnssObservation& o : terms_.observations) {
    if (!in_problem[o.view]) continue;
    // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the problem owns its costs
    auto* cost = new GnssPositionCost({.position = o.position,
                                       .sigma_m = o.sigma_m,
                                       .time_s = o.flight_time_s,
                                       .velocity_mps = o.velocity_mps,
                                       .antenna_in_camera = terms_.antenna_in_camera});
    problem.AddResidualBlock(cost,
                             loss_.get(),
                             poses[o.view].data(),
                             flights_[static_cast<std::size_t>(o.flight)].data());
  }
  for (Eigen::Vector3d& errors : flights_) hold_flight(problem, errors);
}

/// Errors that are not estimated stay; the others are held by their priors.
void GnssBlocks::hold_flight(ceres::Problem& problem, Eigen::Vector3d& errors) {
  if (!problem.HasParameterBlock(errors.data())) return;
  if (!terms_.estimate_drift && !terms_.estimate_lag) {
    problem.SetParameterBlockConstant(errors.data());
    return;
  }
  if (!terms_.estimate_lag) problem.SetManifold(errors.data(), &drift_only_);
  if (!terms_.estimate_drift) problem.SetManifold(errors.data(), &lag_only_);
  const Eigen::Vector3d sigma(kOffsetSigma_m, kRateSigma_mps, kLagSigma_s);
  // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the problem owns its costs
  problem.AddResidualBlock(
      new NormalPriorCost<kNumTagErrors>(errors, sigma), nullptr, errors.data());
}

void GnssBlocks::add_displacements(ceres::Problem& problem,
                                   std::vector<std::array<double, kPoseSize>>& poses,
                                   const std::vector<bool>& in_problem) {
  const auto corrected = [&](const GnssObservation& o) -> Eigen::Vector3d {
    const FlightErrors& flight = terms_.flights[static_cast<std::size_t>(o.flight)];
    return o.position - tag_error(flight, o.flight_time_s, o.velocity_mps);
  };
  const GnssObservation* previous = nullptr;
  for (const GnssObservation& o : terms_.observations) {
    if (!in_problem[o.view]) continue;
    if (previous != nullptr && previous->flight == o.flight) {
      const Eigen::Vector3d sigma =
          (o.sigma_m.array().square() + previous->sigma_m.array().square()).sqrt();
      // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the problem owns its costs
      auto* cost = new GnssDisplacementCost(
          corrected(o) - corrected(*previous), sigma, terms_.antenna_in_camera);
      problem.AddResidualBlock(
          cost, loss_.get(), poses[previous->view].data(), poses[o.view].data());
    }
    previous = &o;
  }
}

void GnssBlocks::store() {
  for (std::size_t f = 0; f < flights_.size(); ++f) {
    terms_.flights[f] = {
        .offset_m = flights_[f][0], .rate_mps = flights_[f][1], .lag_s = flights_[f][2]};
  }
}

}  // namespace hybridfusion
