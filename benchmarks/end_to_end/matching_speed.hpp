#pragma once

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/densify_options.hpp>

#include <nlohmann/json.hpp>

namespace hybridfusion::benchmark {

/// CPU time of all threads of this process [s].
[[nodiscard]] double cpu_s();

/// CPU seconds a megapixel of matching alone with 161 disparities: one photo against itself,
/// shifted. The time does not depend on what is in the photo. Null for one that cannot be decoded.
[[nodiscard]] nlohmann::ordered_json matching_speed(const Photo& photo,
                                                    const DensifyOptions& options);

}  // namespace hybridfusion::benchmark
