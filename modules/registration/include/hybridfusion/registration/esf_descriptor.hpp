#pragma once

#include <hybridfusion/core/error.hpp>

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace hybridfusion {

/// Ensemble of Shape Functions: ten 64-bin histograms over random point triples. Order: D2 in, out,
/// mixed; D2 ratio; D3 in, out, mixed; A3 in, out, mixed, where a line (all three lines) runs
/// through occupied space, through empty space, or through both. Each family (D2, ratio, D3, A3)
/// sums to 1/4. Wohlkinger and Vincze, "Ensemble of shape functions for 3D object classification",
/// ROBIO 2011.
using EsfSignature = std::array<float, 640>;

struct EsfSampling {
  int samples = 20000;     ///< Triples.
  std::uint64_t seed = 0;  ///< Same seed, same points, same order: same bytes.
};

/// @param points  Patch in a local metric frame [m]; the signature ignores translation and scale,
///                and rotation up to the lattice it is traced in.
/// @returns       The signature; kInsufficient for fewer than 100 finite points, kDegenerate when
///                they all coincide or lie on a line.
[[nodiscard]] Expected<EsfSignature> compute_esf(std::span<const Eigen::Vector3f> points,
                                                 const EsfSampling& sampling = {});

/// A signature less its mean, and the length of the rest: what Pearson correlation needs, computed
/// once per patch (HybridFusion III-C.2b).
struct CentredSignature {
  std::array<float, 640> values = {};
  double norm = 0.0;  ///< 0 for a constant signature.
};
[[nodiscard]] CentredSignature centre_signature(const EsfSignature& signature);

/// Pearson correlation in [-1, 1] (HybridFusion Eq. (rho) of III-C.2b); 0 when either signature is
/// constant.
[[nodiscard]] double pearson_correlation(const CentredSignature& x, const CentredSignature& y);

}  // namespace hybridfusion
