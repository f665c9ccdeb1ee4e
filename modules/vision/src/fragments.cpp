#include "fragments.hpp"

#include "enu_alignment.hpp"
#include "incremental_mapper.hpp"
#include "triangulation.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Poses and calibration of a fragment go into `merged`; its points are triangulated again there.
void merge(SfmModel& merged, const SfmModel& fragment) {
  const bool first = merged.num_registered() == 0;
  for (const std::uint32_t view : fragment.registered()) {
    merged.world_from_view[view] = fragment.world_from_view[view];
    if (first) merged.cameras[fragment.camera_of_view[view]] = fragment.camera_of(view);
  }
}

}  // namespace

Expected<Fragments> map_fragments(const SfmModel& empty,
                                  std::span<const VerifiedPair> pairs,
                                  const GnssIngest& gnss,
                                  std::span<const PhotoMetadata> metadata,
                                  const ReconstructionOptions& options,
                                  const RunContext& ctx) {
  Fragments result{.model = empty};
  std::vector<bool> usable(metadata.size(), true);
  const bool placeable = std::ranges::any_of(
      gnss.fixes, [](const PhotoFix& f) { return f.position_in_enu.has_value(); });
  for (int fragment = 0;; ++fragment) {
    SfmModel model = empty;
    model.cameras = result.model.cameras;
    IncrementalMapper mapper(model, pairs, gnss, options, ctx);
    if (auto grown = mapper.grow(usable); !grown) return std::unexpected(grown.error());
    if (fragment == 0) result.reasons = mapper.reasons();
    const std::vector<std::uint32_t> views = model.registered();
    if (static_cast<int>(views.size()) < options.mapping.min_model_photos) break;
    const Expected<EnuAlignment> alignment =
        !placeable && fragment == 0
            ? align_to_nothing(model, metadata)
            : align_to_enu(model, gnss, metadata, Random(ctx.seed, "vision/alignment"));
    if (!alignment && fragment == 0) return std::unexpected(alignment.error());
    for (const std::uint32_t view : views) usable[view] = false;
    if (!alignment) {
      for (const std::uint32_t view : views) {
        result.reasons[view] =
            fmt::format("in a fragment of {} photos without a place on the map: {}",
                        views.size(),
                        alignment.error().message);
      }
      continue;
    }
    std::ranges::copy(alignment->warnings, std::back_inserter(result.warnings));
    if (fragment > 0) {
      result.warnings.push_back(
          fmt::format("{} photos from {} on share no matches with the rest: placed by GNSS only",
                      views.size(),
                      metadata[views.front()].name));
    }
    add_placement(*alignment, model, result.placement);
    transform_model(model, alignment->enu_from_world);
    merge(result.model, model);
    for (const std::uint32_t view : views) result.reasons[view].clear();
  }
  if (result.model.num_registered() < 3) {
    return fail(ErrorCode::kInsufficient,
                "no three photos could be connected; the photos may overlap too little (80 % along "
                "and 60 % across the flight are usual) or show nothing but water or vegetation");
  }
  std::vector<std::uint32_t> all(result.model.tracks.size());
  std::iota(all.begin(), all.end(), 0);
  triangulate_tracks(result.model, all, options.mapping, ctx);
  return result;
}

}  // namespace hybridfusion
