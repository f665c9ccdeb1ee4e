#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion::bench {

using Points = std::vector<Eigen::Vector3f>;

/// Thinned map of a town as a vehicle collects it: streets of 600 m side by side, each with a
/// carriageway of 16 m, house fronts 12 m high and poles; one point in a voxel of 0.5 m, range
/// noise of 2 cm. In order of the drive.
[[nodiscard]] Points town_map(std::size_t size);

/// Places of the vehicle, spread over a map of that size.
[[nodiscard]] Points stops(std::size_t map_size, int count);

/// A thinned scan from such a place, all within 40 m: it shows voxels of the map again, but for
/// every `new_every`th point, which is new (on fronts above 12 m).
[[nodiscard]] Points scan_at(const Eigen::Vector3f& place,
                             std::size_t size,
                             std::size_t new_every,
                             std::uint64_t seed);

}  // namespace hybridfusion::bench
