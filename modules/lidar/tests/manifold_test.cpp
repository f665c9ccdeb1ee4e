#include "manifold.hpp"

#include "nav_state.hpp"

#include <hybridfusion/core/random.hpp>

#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

Eigen::Vector3d random_vector(Random& random, double size) {
  return size * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
}

TEST(So3, LogUndoesExpUpToHalfATurn) {
  Random random(1, "test/so3");
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d phi = random_vector(random, i < 50 ? 1e-7 : 0.8);
    if (phi.norm() > std::numbers::pi) continue;
    EXPECT_TRUE(so3_log(so3_exp(phi)).isApprox(phi, 1e-9)) << phi.transpose();
  }
  EXPECT_NEAR(so3_log(so3_exp({std::numbers::pi, 0, 0})).norm(), std::numbers::pi, 1e-9);
}

TEST(So3, RightJacobianAgreesWithDifferences) {
  Random random(2, "test/so3");
  constexpr double kH = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d phi = random_vector(random, i % 2 == 0 ? 1e-6 : 0.7);
    Eigen::Matrix3d numeric;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d d = kH * Eigen::Vector3d::Unit(k);
      numeric.col(k) = so3_log(so3_exp(phi - d).transpose() * so3_exp(phi + d)) / (2.0 * kH);
    }
    EXPECT_TRUE(so3_right_jacobian(phi).isApprox(numeric, 1e-5));
  }
}

TEST(S2, MinusUndoesPlusAndKeepsTheLength) {
  Random random(3, "test/s2");
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d g = 9.81 * random_vector(random, 1.0).normalized();
    const Eigen::Vector2d u(0.5 * random.normal(), 0.5 * random.normal());
    EXPECT_NEAR(s2_plus(g, u).norm(), 9.81, 1e-12);
    EXPECT_TRUE(s2_minus(s2_plus(g, u), g).isApprox(u, 1e-8));
  }
  const Eigen::Vector3d down(0, 0, -9.81);
  EXPECT_EQ(s2_minus(down, down), Eigen::Vector2d::Zero());
  EXPECT_EQ(s2_minus(-down, down).x(), std::numbers::pi);
}

TEST(S2, JacobiansAgreeWithDifferences) {
  Random random(4, "test/s2");
  constexpr double kH = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d g = 9.81 * random_vector(random, 1.0).normalized();
    const Eigen::Vector2d u(0.3 * random.normal(), 0.3 * random.normal());
    S2Basis plus_numeric;
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d d = kH * Eigen::Vector2d::Unit(k);
      plus_numeric.col(k) = (s2_plus(g, u + d) - s2_plus(g, u - d)) / (2.0 * kH);
    }
    EXPECT_TRUE(s2_plus_jacobian(g, u).isApprox(plus_numeric, 1e-6));
    Eigen::Matrix<double, 2, 3> minus_numeric;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d d = kH * Eigen::Vector3d::Unit(k);
      minus_numeric.col(k) = (s2_minus(g + d, g) - s2_minus(g - d, g)) / (2.0 * kH);
    }
    EXPECT_TRUE(s2_minus_jacobian(g).isApprox(minus_numeric, 1e-5));
    // Spec of the pair: their product at u = 0 is the identity.
    EXPECT_TRUE((s2_minus_jacobian(g) * s2_plus_jacobian(g, Eigen::Vector2d::Zero()))
                    .isApprox(Eigen::Matrix2d::Identity(), 1e-12));
  }
}

TEST(NavState, MinusUndoesPlus) {
  Random random(5, "test/state");
  ErrorVector error;
  for (int i = 0; i < err::kSize; ++i) error[i] = 0.3 * random.normal();
  const NavState state = plus({}, ErrorVector::Constant(0.1));
  EXPECT_TRUE(minus(plus(state, error), state).isApprox(error, 1e-9));
}

TEST(NavState, TransportAgreesWithDifferences) {
  Random random(6, "test/state");
  const NavState prior = plus({}, ErrorVector::Constant(0.2));
  ErrorVector deviation;
  for (int i = 0; i < err::kSize; ++i) deviation[i] = 0.2 * random.normal();
  const NavState at = plus(prior, deviation);
  ErrorMatrix from_current;  // d minus(plus(at, e), prior) / de
  constexpr double kH = 1e-6;
  for (int k = 0; k < err::kSize; ++k) {
    const ErrorVector d = kH * ErrorVector::Unit(k);
    from_current.col(k) = (minus(plus(at, d), prior) - minus(plus(at, -d), prior)) / (2.0 * kH);
  }
  EXPECT_TRUE((transport(prior, deviation) * from_current).isIdentity(1e-6));
}

}  // namespace
}  // namespace hybridfusion
