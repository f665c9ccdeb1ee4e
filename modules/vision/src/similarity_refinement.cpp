#include "flight_errors.hpp"
#include "robust_statistics.hpp"
#include "rotation.hpp"
#include "similarity_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

constexpr int kIterations = 40;
constexpr int kStatedSigmas = 5;  // iterations before the residuals scale the sigmas
constexpr int kLeastIterations = 20;
constexpr double kCauchyWidth = 2.0;
constexpr Eigen::Index kSimilarity = 7;  // translation, rotation (left), log scale
constexpr std::size_t kMinPhotos = 8;    // of a flight whose errors are estimated
// HybridFusion names no priors. The rate is wide: receivers that lose their fix drift by 1 m/s.
constexpr double kOffsetSigma_m = 20.0;
constexpr double kRateSigma_mps = 1.0;
constexpr double kLagSigma_s = 2.0;

/// Columns of the parameters of each flight; -1: not estimated.
struct Layout {
  std::vector<Eigen::Index> drift;
  std::vector<Eigen::Index> lag;
  Eigen::Index size = kSimilarity;
};

Layout make_layout(std::span<const PositionPair> pairs, const TagErrorModel& model) {
  int flights = 0;
  for (const PositionPair& pair : pairs) flights = std::max(flights, pair.flight + 1);
  std::vector<std::size_t> photos(static_cast<std::size_t>(flights), 0);
  for (const PositionPair& pair : pairs) ++photos[static_cast<std::size_t>(pair.flight)];
  Layout layout;
  for (int f = 0; f < flights; ++f) {
    const bool enough = photos[static_cast<std::size_t>(f)] >= kMinPhotos;
    const bool drift = model.drift && enough;
    const bool lag = model.lag && enough && tells_lag(pairs, f);
    layout.drift.push_back(drift ? layout.size : -1);
    layout.size += drift ? 2 : 0;
    layout.lag.push_back(lag ? layout.size : -1);
    layout.size += lag ? 1 : 0;
  }
  return layout;
}

class Refiner {
 public:
  Refiner(std::span<const PositionPair> pairs,
          const Sim3& start,
          const std::optional<UpPrior>& up,
          const TagErrorModel& model)
      : pairs_(pairs), up_(up), layout_(make_layout(pairs, model)), sim_(start) {
    flights_.resize(layout_.drift.size());
  }

  SimilarityFit run() {
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      if (iteration >= kStatedSigmas) scale_sigmas();
      const Eigen::VectorXd step = -accumulate(iteration).ldlt().solve(gradient_);
      if (!step.allFinite()) break;
      apply(step);
      if (iteration > kLeastIterations && step.norm() < 1e-9) break;
    }
    return result();
  }

 private:
  [[nodiscard]] Eigen::Vector3d residual(const PositionPair& pair) const {
    const Eigen::Vector3d velocity = sim_.scale * (sim_.rotation * pair.velocity_in_world);
    return sim_ * pair.in_world +
           tag_error(
               flights_[static_cast<std::size_t>(pair.flight)], pair.flight_time_s, velocity) -
           pair.in_enu;
  }

  [[nodiscard]] Eigen::Vector3d sigma(const PositionPair& pair) const {
    const double vertical = pair.sigma_m.z() < kUnknownSigma_m ? vertical_scale_ : 1.0;
    return {horizontal_scale_ * pair.sigma_m.x(),
            horizontal_scale_ * pair.sigma_m.y(),
            vertical * pair.sigma_m.z()};
  }

  /// Robust deviations of the residuals over the stated sigmas.
  [[nodiscard]] std::array<double, 2> ratios() const {
    std::vector<double> horizontal;
    std::vector<double> vertical;
    for (const PositionPair& pair : pairs_) {
      const Eigen::Vector3d r = residual(pair).cwiseQuotient(pair.sigma_m);
      horizontal.insert(horizontal.end(), {r.x(), r.y()});
      if (pair.sigma_m.z() < kUnknownSigma_m) vertical.push_back(r.z());
    }
    return {robust_sigma_about_zero(std::move(horizontal)),
            vertical.empty() ? 0.0 : robust_sigma_about_zero(std::move(vertical))};
  }

  void scale_sigmas() {
    const auto [horizontal, vertical] = ratios();
    horizontal_scale_ = std::max(1.0, horizontal);
    vertical_scale_ = std::max(1.0, vertical);
  }

  /// Normal matrix; fills gradient_.
  Eigen::MatrixXd accumulate(int iteration) {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(layout_.size, layout_.size);
    gradient_ = Eigen::VectorXd::Zero(layout_.size);
    std::vector<double> norms;
    for (const PositionPair& pair : pairs_) {
      norms.push_back(residual(pair).cwiseQuotient(sigma(pair)).norm());
    }
    // Stated sigmas may be optimistic: the loss is at least as wide as what is found.
    double width = kCauchyWidth * std::max(1.0, median(norms));
    // The strips of one direction look like outliers to a start that knows of no lag.
    if (layout_.size > kSimilarity) {
      width = std::max(width, upper_quantile(norms, 0.9) * std::pow(0.7, iteration - 4));
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const double weight = 1.0 / (1.0 + std::pow(norms[i] / width, 2.0));
      add(pairs_[i], weight, normal);
    }
    add_priors(normal);
    return normal;
  }

  void add(const PositionPair& pair, double weight, Eigen::MatrixXd& normal) {
    const auto flight = static_cast<std::size_t>(pair.flight);
    const Eigen::Vector3d velocity = sim_.scale * (sim_.rotation * pair.velocity_in_world);
    const Eigen::Vector3d turned =
        sim_.scale * (sim_.rotation * pair.in_world) - flights_[flight].lag_s * velocity;
    Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, 10);
    jacobian << Eigen::Matrix3d::Identity(), -skew(turned), turned, Eigen::Vector3d::UnitZ(),
        pair.flight_time_s * Eigen::Vector3d::UnitZ(), -velocity;
    const Eigen::Vector3d inverse_sigma = sigma(pair).cwiseInverse();
    jacobian = inverse_sigma.asDiagonal() * jacobian;
    const Eigen::Vector3d r = residual(pair).cwiseProduct(inverse_sigma);
    std::array<Eigen::Index, 10> column{};
    for (Eigen::Index k = 0; k < kSimilarity; ++k) column[static_cast<std::size_t>(k)] = k;
    const Eigen::Index drift = layout_.drift[flight];
    column[7] = drift;
    column[8] = drift < 0 ? -1 : drift + 1;
    column[9] = layout_.lag[flight];
    for (std::size_t a = 0; a < column.size(); ++a) {
      if (column[a] < 0) continue;
      const Eigen::Vector3d ja = jacobian.col(static_cast<Eigen::Index>(a));
      gradient_[column[a]] += weight * ja.dot(r);
      for (std::size_t b = 0; b < column.size(); ++b) {
        if (column[b] < 0) continue;
        normal(column[a], column[b]) += weight * ja.dot(jacobian.col(static_cast<Eigen::Index>(b)));
      }
    }
  }

  void add_priors(Eigen::MatrixXd& normal) {
    const auto hold = [&](Eigen::Index column, double value, double sigma) {
      normal(column, column) += 1.0 / (sigma * sigma);
      gradient_[column] += value / (sigma * sigma);
    };
    for (std::size_t f = 0; f < flights_.size(); ++f) {
      if (layout_.drift[f] >= 0) {
        hold(layout_.drift[f], flights_[f].offset_m, kOffsetSigma_m);
        hold(layout_.drift[f] + 1, flights_[f].rate_mps, kRateSigma_mps);
      }
      if (layout_.lag[f] >= 0) hold(layout_.lag[f], flights_[f].lag_s, kLagSigma_s);
    }
    if (!up_) return;
    // Horizontal components of the up direction; d (R u)/d turn = -[R u]x.
    const Eigen::Vector3d turned = sim_.rotation * up_->up_in_world;
    const Eigen::Matrix3d jacobian = -skew(turned) / up_->sigma_rad;
    const Eigen::Vector3d r = (turned - Eigen::Vector3d::UnitZ()) / up_->sigma_rad;
    normal.block<3, 3>(3, 3) += jacobian.transpose() * jacobian;
    gradient_.segment<3>(3) += jacobian.transpose() * r;
  }

  void apply(const Eigen::VectorXd& step) {
    sim_.rotation = (rotation_exp(step.segment<3>(3)) * sim_.rotation).normalized();
    sim_.translation += step.head<3>();
    sim_.scale *= std::exp(std::clamp(step[6], -1.0, 1.0));
    for (std::size_t f = 0; f < flights_.size(); ++f) {
      if (layout_.drift[f] >= 0) {
        flights_[f].offset_m += step[layout_.drift[f]];
        flights_[f].rate_mps += step[layout_.drift[f] + 1];
      }
      if (layout_.lag[f] >= 0) flights_[f].lag_s += step[layout_.lag[f]];
    }
  }

  SimilarityFit result() {
    SimilarityFit fit{.enu_from_world = sim_, .flights = flights_};
    const Eigen::MatrixXd normal = accumulate(kIterations);
    // Relative to the diagonal: what nothing determines gets a large deviation, not an infinite
    // one.
    Eigen::MatrixXd damped = normal;
    damped.diagonal() += 1e-12 * Eigen::VectorXd::Constant(layout_.size, normal.trace());
    const Eigen::MatrixXd covariance = damped.inverse();
    const auto deviation = [&](Eigen::Index k) {
      return k < 0 ? 0.0 : std::sqrt(std::max(0.0, covariance(k, k)));
    };
    fit.tilt_sigma_rad = std::max(deviation(3), deviation(4));
    fit.scale_sigma = deviation(6);
    for (std::size_t f = 0; f < flights_.size(); ++f) {
      const Eigen::Index drift = layout_.drift[f];
      fit.sigmas.push_back({.offset_m = deviation(drift),
                            .rate_mps = deviation(drift < 0 ? -1 : drift + 1),
                            .lag_s = deviation(layout_.lag[f])});
    }
    const auto [horizontal, vertical] = ratios();
    fit.horizontal_ratio = horizontal;
    fit.vertical_ratio = vertical;
    fill_spreads(fit);
    return fit;
  }

  void fill_spreads(SimilarityFit& fit) const {
    constexpr double kShare = 0.8;
    constexpr double kNormal = 1.2816;    // |x| of a normal variable is below this with 80 %
    constexpr double kRayleigh = 1.7941;  // the length of two of them
    std::vector<double> horizontal;
    std::vector<double> vertical;
    for (const PositionPair& pair : pairs_) {
      const Eigen::Vector3d r = residual(pair).cwiseQuotient(pair.sigma_m);
      horizontal.push_back(r.head<2>().norm());
      if (pair.sigma_m.z() < kUnknownSigma_m) vertical.push_back(std::abs(r.z()));
    }
    fit.horizontal_spread = upper_quantile(std::move(horizontal), kShare) / kRayleigh;
    if (!vertical.empty()) {
      fit.vertical_spread = upper_quantile(std::move(vertical), kShare) / kNormal;
    }
  }

  std::span<const PositionPair> pairs_;
  std::optional<UpPrior> up_;
  Layout layout_;
  Sim3 sim_;
  std::vector<FlightErrors> flights_;
  double horizontal_scale_ = 1.0;
  double vertical_scale_ = 1.0;
  Eigen::VectorXd gradient_;
};

}  // namespace

bool tells_lag(std::span<const PositionPair> pairs, int flight) {
  constexpr double kOneWay = 0.8;  // length of the mean heading; 1: all the same
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t moving = 0;
  for (const PositionPair& pair : pairs) {
    if (pair.flight != flight || !(pair.velocity_in_world.norm() > 0.0)) continue;
    sum += pair.velocity_in_world.normalized();
    ++moving;
  }
  return moving >= kMinPhotos && sum.norm() < kOneWay * static_cast<double>(moving);
}

SimilarityFit refine_similarity(std::span<const PositionPair> pairs,
                                const Sim3& start,
                                const std::optional<UpPrior>& up,
                                const TagErrorModel& model) {
  return Refiner(pairs, start, up, model).run();
}

}  // namespace hybridfusion
