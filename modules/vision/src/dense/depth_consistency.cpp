#include "depth_consistency.hpp"

#include "footprint.hpp"
#include "other_view.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace hybridfusion {
namespace {

constexpr int kBandRows = 16;  // rows checked at a time: what the others show there fits the cache
constexpr std::size_t kChunkRows = std::size_t{8} * kBandRows;  // of one thread
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

std::vector<OtherView> others_of(const DepthMap& reference, std::span<const DepthMap* const> maps) {
  std::vector<OtherView> others;
  for (const DepthMap* map : maps) {
    const Rigid3 other_from_reference = map->enu_from_camera.inverse() * reference.enu_from_camera;
    others.push_back({.map = map,
                      .rotation = other_from_reference.rotation.toRotationMatrix().cast<float>(),
                      .translation = other_from_reference.translation.cast<float>(),
                      .is_partner = std::ranges::find(reference.partners, map->view) !=
                                    reference.partners.end()});
  }
  return others;
}

/// Photos that have the depth and were not matched with the reference judge first, then its
/// partners that have it, then photos that know no depth there.
bool looks_alike(std::span<const OtherViewBand> bands, int x, int y, double min_correlation) {
  constexpr int kMaxJudges = 3;
  enum class Judge : std::uint8_t { kOther, kPartner, kWithoutDepth };
  const auto kind_of = [&](const OtherViewBand& band) -> std::optional<Judge> {
    const Seen& seen = band.at(x, y);
    if (!seen.has_depth) return Judge::kWithoutDepth;
    if (std::isnan(seen.depth_m)) return std::nullopt;
    return band.other().is_partner ? Judge::kPartner : Judge::kOther;
  };
  for (const Judge kind : {Judge::kOther, Judge::kPartner, Judge::kWithoutDepth}) {
    int judges = 0;
    for (const OtherViewBand& band : bands) {
      if (judges == kMaxJudges || kind_of(band) != kind) continue;
      const std::optional<float> value = band.correlation(x, y);
      if (!value) continue;
      if (*value >= min_correlation) return true;
      ++judges;
    }
    if (judges > 0) return false;
  }
  return false;
}

/// The depth at a pixel after the check; nothing when it fails.
std::optional<DepthGuess> checked_depth(const DepthMap& reference,
                                        std::span<const OtherViewBand> bands,
                                        int x,
                                        int y,
                                        const DepthCheckOptions& options,
                                        std::vector<DepthGuess>& supporting) {
  supporting.assign(1, {reference.depth_m.at(x, y), reference.sigma_m.at(x, y)});
  int violations = 0;
  for (const OtherViewBand& band : bands) {
    const Seen& seen = band.at(x, y);
    if (seen.looks_through) ++violations;
    if (!std::isnan(seen.depth_m)) supporting.push_back({seen.depth_m, seen.sigma_m});
  }
  // A second pair of the reference is a second photo that agrees.
  const int other_pairs = reference.num_pairs.at(x, y) - 1;
  const int support = static_cast<int>(supporting.size()) - 1 + other_pairs;
  if (support < options.min_supporting_views || support <= violations) return std::nullopt;
  const bool settled = violations == 0 && support >= options.trusted_views;
  if (!settled && !looks_alike(bands, x, y, options.min_correlation)) return std::nullopt;
  return merge_guesses(supporting);
}

/// Fills the rows [begin, end) of `result`.
void check_rows(const DepthMap& reference,
                std::span<const OtherView> others,
                const DepthCheckOptions& options,
                int begin,
                int end,
                std::vector<OtherViewBand>& bands,
                CheckedDepth& result) {
  const int first_row = std::max(0, begin - kCorrelationReach_px);
  const int end_row = std::min(reference.grid.height_px, end + kCorrelationReach_px);
  const std::vector<DepthTile> tiles = tiles_of_rows(reference, first_row, end_row);
  for (std::size_t i = 0; i < others.size(); ++i) {
    bands[i].look(others[i], tiles, first_row, end_row);
  }
  std::vector<DepthGuess> supporting;
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < reference.grid.width_px; ++x) {
      if (!reference.has_depth(x, y)) continue;
      const auto depth = checked_depth(reference, bands, x, y, options, supporting);
      if (!depth) continue;
      result.depth_m.at(x, y) = static_cast<float>(depth->depth_m);
      result.sigma_m.at(x, y) = static_cast<float>(depth->sigma_m);
    }
  }
}

}  // namespace

CheckedDepth check_depths(const DepthMap& reference,
                          std::span<const DepthMap* const> others,
                          const DepthCheckOptions& options,
                          const RunContext& ctx) {
  const std::vector<OtherView> views = others_of(reference, others);
  const int width = reference.grid.width_px;
  const int height = reference.grid.height_px;
  CheckedDepth result{.depth_m = {width, height, kNothing}, .sigma_m = {width, height, 0.0F}};
  const auto num_rows = static_cast<std::size_t>(height);
  parallel_for(ctx, num_rows, kChunkRows, [&](std::size_t first, std::size_t last) {
    std::vector<OtherViewBand> bands(views.size(), OtherViewBand(reference, options));
    const int end_row = static_cast<int>(last);
    for (int begin = static_cast<int>(first); begin < end_row; begin += kBandRows) {
      const int end = std::min(end_row, begin + kBandRows);
      check_rows(reference, views, options, begin, end, bands, result);
    }
  });
  return result;
}

}  // namespace hybridfusion
