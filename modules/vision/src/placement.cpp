#include "placement.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {

void add_placement(const EnuAlignment& alignment, const SfmModel& model, Placement& placement) {
  // A guessed or measured up direction that stands against the altitudes must not yield to them.
  constexpr double kTightUp = 0.1;
  placement.altitude_trusted = placement.altitude_trusted && alignment.altitude_trusted;
  placement.errors.drift = placement.errors.drift || alignment.errors.drift;
  placement.errors.lag = placement.errors.lag || alignment.errors.lag;
  if (placement.flights.size() < alignment.flights.size()) {
    placement.flights.resize(alignment.flights.size());
  }
  for (std::size_t f = 0; f < alignment.flights.size(); ++f) {
    FlightErrors& flight = placement.flights[f];
    const bool fresh = flight.offset_m == 0.0 && flight.rate_mps == 0.0 && flight.lag_s == 0.0;
    if (fresh) flight = alignment.flights[f];
  }
  if (!alignment.up) return;
  const std::vector<std::uint32_t> views = model.registered();
  const double share = std::sqrt(static_cast<double>(views.size()));
  const double tight = alignment.altitude_trusted ? 1.0 : kTightUp;
  for (const std::uint32_t view : views) {
    placement.ups.push_back({.view = view,
                             .up_in_camera = model.world_from_view[view]->rotation.conjugate() *
                                             alignment.up->up_in_world,
                             .sigma_rad = share * tight * alignment.up->sigma_rad});
  }
  placement.up_sigma_rad = std::max(placement.up_sigma_rad.value_or(0.0), alignment.up->sigma_rad);
}

}  // namespace hybridfusion
