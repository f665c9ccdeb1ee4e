#pragma once

#include "mesh_builder.hpp"
#include "terrain.hpp"

#include <cstdint>

namespace hybridfusion {

/// Share of the tunnel that a drive covers, centred: it begins and ends inside.
inline constexpr double kTunnelDriveShare = 0.8;
inline constexpr double kTunnelLane_m = -1.6;  ///< Of the drive, beside the axis.

/// A straight vaulted road tunnel along x of the block frame, centred at its origin: smooth lining,
/// a lamp every 12 m and niches 20 to 34 m apart on either side, so that little shows the way
/// along.
void build_tunnel(const Terrain& terrain,
                  double length_m,
                  float contrast,
                  std::uint64_t seed,
                  MeshBuilder& builder);

}  // namespace hybridfusion
