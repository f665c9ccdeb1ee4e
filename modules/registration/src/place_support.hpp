#pragma once

#include "hybrid.hpp"

namespace hybridfusion {

/// Share of the facades of L that lie on a surface of G at a pose: within 0.1 m of a plane whose
/// normal agrees. Facades outside G count as not supported.
[[nodiscard]] double facade_support(FineInputs& inputs,
                                    const PreparedClouds& clouds,
                                    const Rigid3& vision_from_leveled,
                                    const FineOptions& options,
                                    const RunContext& ctx);

/// Points of vertical planes that G has where the facades of L come to lie: within the distance
/// from their middle that holds nine tenths of them. Of some 4000 points there, scaled to all.
[[nodiscard]] double facade_supply(FineInputs& inputs,
                                   const PreparedClouds& clouds,
                                   const Rigid3& vision_from_leveled,
                                   const FineOptions& options,
                                   const RunContext& ctx);

/// True when two poses of L are within `max_shift_m` and half a metre of height of each other at
/// `centroid`, and within `max_turn_rad`.
[[nodiscard]] bool are_near(const Rigid3& a,
                            const Rigid3& b,
                            const Eigen::Vector3d& centroid,
                            double max_shift_m,
                            double max_turn_rad);

/// Places whose outlines score alike, after the surfaces were asked.
struct SurfaceChoice {
  std::size_t place = 0;       ///< Whose facades are supported most; 0 when nothing was compared.
  bool is_compared = false;    ///< There were places alike, and G shows facades at all of them.
  double support = 0.0;        ///< facade_support of that place.
  double rival_support = 0.0;  ///< Largest of the places that its surfaces do not lead to.
};

/// Outlines seen from above look alike where surfaces do not: every place that scores within
/// `options.verdict.doubtful_peak_ratio` of the best is aligned finely, and the shares of its
/// facades on surfaces are compared. The first place stays unless another has
/// `options.verdict.min_facade_support` and more support than it. Nothing is said against a place
/// where G shows less than half of the facades that it shows at the chosen one: photos straight
/// down on one of two equal houses must not decide for the other.
/// @param inputs  Made at the first place.
/// @returns kCancelled when stopped.
[[nodiscard]] Expected<SurfaceChoice> choose_by_surfaces(FineInputs& inputs,
                                                         const PreparedClouds& clouds,
                                                         const OutlinePlaces& found,
                                                         const RegistrationOptions& options,
                                                         const RunContext& ctx);

}  // namespace hybridfusion
