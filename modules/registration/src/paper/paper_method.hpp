#pragma once

#include "prepared_clouds.hpp"

namespace hybridfusion {

/// The published chain from the height-aligned coarse pose (HybridFusion III-C).
[[nodiscard]] Expected<RegistrationResult> register_paper(const PreparedClouds& clouds,
                                                          const RegistrationOptions& options,
                                                          const RunContext& ctx);

}  // namespace hybridfusion
