#include "ndt_objective.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/registration/ndt.hpp>

#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// An L of two lines.
std::vector<Eigen::Vector2f> corner_2d(std::uint64_t seed, double noise) {
  Random random(seed, "ndt-2d");
  std::vector<Eigen::Vector2f> points;
  for (int i = 0; i < 1500; ++i) {
    const double t = random.uniform(0.0, 12.0);
    const Eigen::Vector2d p = i % 2 == 0 ? Eigen::Vector2d(t, 0.0) : Eigen::Vector2d(0.0, 0.7 * t);
    points.emplace_back(
        (p + noise * Eigen::Vector2d(random.normal(), random.normal())).cast<float>());
  }
  return points;
}

/// Three faces of a box.
std::vector<Eigen::Vector3f> corner_3d(std::uint64_t seed, double noise) {
  Random random(seed, "ndt-3d");
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 9000; ++i) {
    Eigen::Vector3d p(
        random.uniform(0.0, 10.0), random.uniform(0.0, 10.0), random.uniform(0.0, 6.0));
    p[i % 3] = 0.0;
    const Eigen::Vector3d e(random.normal(), random.normal(), random.normal());
    points.emplace_back((p + noise * e).cast<float>());
  }
  return points;
}

template <int Dim>
std::vector<NdtVector<Dim>> displaced(const std::vector<NdtVector<Dim>>& points,
                                      const NdtVector<Dim>& centre,
                                      const Eigen::Matrix<double, kNdtParams<Dim>, 1>& step) {
  std::vector<NdtVector<Dim>> moved;
  for (const NdtVector<Dim>& p : points) {
    if constexpr (Dim == 2) {
      moved.push_back(centre + Eigen::Rotation2D<double>(step[2]) * (p - centre) +
                      step.template head<2>());
    } else {
      const Eigen::Vector3d w = step.template tail<3>();
      const Eigen::Matrix3d turn =
          w.norm() > 0.0 ? Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix()
                         : Eigen::Matrix3d::Identity();
      moved.push_back(centre + turn * (p - centre) + step.template head<3>());
    }
  }
  return moved;
}

template <int Dim>
void expect_derivatives_match(const std::vector<Eigen::Matrix<float, Dim, 1>>& target,
                              const std::vector<Eigen::Matrix<float, Dim, 1>>& source) {
  constexpr int kParams = kNdtParams<Dim>;
  // One large cell: no point changes its cells within the differences.
  const NdtCells<Dim> cells(target, 1000.0, 6);
  const NdtMixture mixture = make_mixture(0.55, 4.0, Dim);
  std::vector<NdtVector<Dim>> points;
  for (std::size_t i = 0; i < source.size(); i += 37) {
    points.push_back(source[i].template cast<double>() + NdtVector<Dim>::Constant(0.3));
  }
  const NdtVector<Dim> centre = NdtVector<Dim>::Constant(1.0);
  const NdtTerms<Dim> terms = ndt_terms<Dim>(cells, mixture, points, centre, true, RunContext{});
  const auto value_at = [&](const Eigen::Matrix<double, kParams, 1>& step) {
    const auto moved = displaced<Dim>(points, centre, step);
    return ndt_terms<Dim>(cells, mixture, moved, centre, false, RunContext{}).value;
  };
  using Step = Eigen::Matrix<double, kParams, 1>;
  constexpr double kH = 1e-4;
  const double scale = terms.hessian.cwiseAbs().maxCoeff();
  for (int i = 0; i < kParams; ++i) {
    const Step a = kH * Step::Unit(i);
    EXPECT_NEAR(terms.gradient[i], (value_at(a) - value_at(-a)) / (2.0 * kH), 1e-5 * scale) << i;
    for (int j = 0; j < kParams; ++j) {
      const Step b = kH * Step::Unit(j);
      const double difference =
          (value_at(a + b) - value_at(a - b) - value_at(b - a) + value_at(-a - b)) /
          (4.0 * kH * kH);
      EXPECT_NEAR(terms.hessian(i, j), difference, 1e-4 * scale) << i << " " << j;
    }
  }
}

TEST(NdtObjective, DerivativesMatchDifferencesIn2d) {
  expect_derivatives_match<2>(corner_2d(1, 0.05), corner_2d(2, 0.05));
}

TEST(NdtObjective, DerivativesMatchDifferencesIn3d) {
  expect_derivatives_match<3>(corner_3d(1, 0.05), corner_3d(2, 0.05));
}

TEST(AlignNdt2d, RecoversAMotion) {
  const std::vector<Eigen::Vector2f> target = corner_2d(3, 0.02);
  const std::vector<Eigen::Vector2f> source = corner_2d(4, 0.02);
  const auto aligned =
      align_ndt_2d(target, source, {.yaw_rad = 0.05, .translation = {0.4, -0.3}}, {.cell_m = 2.0});
  ASSERT_TRUE(aligned) << aligned.error().message;
  EXPECT_TRUE(aligned->quality.converged);
  EXPECT_NEAR(aligned->target_from_source.yaw_rad, 0.0, 0.005);
  EXPECT_LT(aligned->target_from_source.translation.norm(), 0.05);
}

TEST(AlignNdt3d, RecoversAMotion) {
  const std::vector<Eigen::Vector3f> target = corner_3d(5, 0.02);
  const std::vector<Eigen::Vector3f> source = corner_3d(6, 0.02);
  Rigid3 start;
  start.rotation = Eigen::AngleAxisd(0.05, Eigen::Vector3d(0.3, -0.2, 1.0).normalized());
  start.translation = {0.3, -0.2, 0.25};
  const auto aligned = align_ndt_3d(target, source, start, {.cell_m = 2.0});
  ASSERT_TRUE(aligned) << aligned.error().message;
  EXPECT_LT(
      rotation_distance_rad(aligned->target_from_source.rotation, Eigen::Quaterniond::Identity()),
      0.005);
  EXPECT_LT(aligned->target_from_source.translation.norm(), 0.05);
  EXPECT_GT(aligned->quality.matched_share, 0.9);
}

TEST(AlignNdt3d, IsTheSameAtAnyThreadCount) {
  const std::vector<Eigen::Vector3f> target = corner_3d(5, 0.02);
  const std::vector<Eigen::Vector3f> source = corner_3d(6, 0.02);
  Rigid3 start;
  start.translation = {0.2, 0.0, 0.1};
  RunContext one;
  one.num_threads = 1;
  RunContext four;
  four.num_threads = 4;
  const auto a = align_ndt_3d(target, source, start, {}, one);
  const auto b = align_ndt_3d(target, source, start, {}, four);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->target_from_source.translation, b->target_from_source.translation);
}

TEST(AlignNdt, RefusesEmptyAndDistantClouds) {
  const std::vector<Eigen::Vector3f> target = corner_3d(7, 0.02);
  EXPECT_EQ(align_ndt_3d({}, target, Rigid3{}).error().code, ErrorCode::kInsufficient);
  Rigid3 far;
  far.translation = {900.0, 0.0, 0.0};
  EXPECT_EQ(align_ndt_3d(target, target, far).error().code, ErrorCode::kInsufficient);
  EXPECT_EQ(align_ndt_2d(corner_2d(1, 0.1), {}, Rigid2{}).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
