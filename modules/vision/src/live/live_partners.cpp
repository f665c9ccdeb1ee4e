#include "live/live_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace hybridfusion {

std::vector<std::uint32_t> live_partners(std::span<const PhotoMetadata> photos,
                                         const GnssIngest& gnss,
                                         const std::vector<bool>& usable,
                                         const PairOptions& options,
                                         int max_count) {
  constexpr std::size_t kNextInTime = 2;
  const auto last = static_cast<std::uint32_t>(photos.size() - 1);
  std::vector<std::size_t> rank(photos.size());  // in time
  for (std::size_t k = 0; k < gnss.by_time.size(); ++k) rank[gnss.by_time[k]] = k;
  const auto& here = gnss.fixes[last].position_in_enu;
  using Scored = std::tuple<int, double, std::uint32_t>;
  std::vector<Scored> scored;
  for (const PhotoPair& pair : select_pairs(photos, gnss, options)) {
    if (pair.first != last && pair.second != last) continue;
    const std::uint32_t other = pair.first == last ? pair.second : pair.first;
    if (!usable[other]) continue;
    const std::size_t gap =
        rank[other] > rank[last] ? rank[other] - rank[last] : rank[last] - rank[other];
    const auto& there = gnss.fixes[other].position_in_enu;
    const bool placed = here && there;
    const double distance = placed ? (*there - *here).head<2>().norm() : static_cast<double>(gap);
    const int group = gap <= kNextInTime ? 0 : placed ? 1 : 2;
    scored.emplace_back(group, distance, other);
  }
  std::ranges::sort(scored);
  std::vector<std::uint32_t> partners;
  for (const Scored& s : scored) {
    if (partners.size() == static_cast<std::size_t>(max_count)) break;
    partners.push_back(std::get<2>(s));
  }
  std::ranges::sort(partners);
  return partners;
}

}  // namespace hybridfusion
