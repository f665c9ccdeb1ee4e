#include "gnss_model.hpp"

#include <hybridfusion/core/error.hpp>

#include <cmath>

namespace hybridfusion {
namespace {

constexpr double kConstantShare = 0.85;
constexpr double kWalkShare = 0.40;
constexpr double kWhiteShare = 0.35;
constexpr double kRtkSigma_m = 0.03;

Eigen::Vector3d normal3(Random& random) {
  const double east = random.normal();
  const double north = random.normal();
  return {east, north, random.normal()};
}

}  // namespace

GnssError::GnssError(const GnssModelOptions& options,
                     std::uint64_t seed,
                     std::string_view receiver,
                     std::uint64_t index)
    : random_(seed, receiver, index),
      correlation_s_(options.correlation_s),
      sigma_(options.sigma_horizontal_m, options.sigma_horizontal_m, options.sigma_vertical_m) {
  if (options.rtk) sigma_.setConstant(kRtkSigma_m);
  constant_ = kConstantShare * sigma_.cwiseProduct(normal3(random_));
  walk_ = kWalkShare * sigma_.cwiseProduct(normal3(random_));
}

Eigen::Vector3d GnssError::at(double time_s) {
  HF_CHECK(!started_ || time_s >= time_s_);
  const double passed = started_ ? time_s - time_s_ : 0.0;
  const double keep = std::exp(-passed / correlation_s_);
  walk_ = keep * walk_ +
          kWalkShare * std::sqrt(1.0 - keep * keep) * sigma_.cwiseProduct(normal3(random_));
  time_s_ = time_s;
  started_ = true;
  return constant_ + walk_ + kWhiteShare * sigma_.cwiseProduct(normal3(random_));
}

}  // namespace hybridfusion
