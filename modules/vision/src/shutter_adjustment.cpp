#include "shutter_adjustment.hpp"

#include "flight_errors.hpp"
#include "rolling_shutter.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Mean mean error error over all observations of registered photos [px of the reduced photos];
/// one that was filtered out counts as the limit, or leaving out what disagrees would look well.
double mean_error_px(const SfmModel& model, double limit_px) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t t = 0; t < model.tracks.size(); ++t) {
    for (const TrackElement& element : model.tracks[t]) {
      if (!model.world_from_view[element.view]) continue;
      const bool counts = element.active && model.points[t].has_value();
      sum += counts ? std::min(limit_px, model.error_px(element, *model.points[t])) : limit_px;
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

Expected<void> adjust_with_shutter(SfmModel& model,
                                   GnssTerms& terms,
                                   const AdjustmentInputs& inputs,
                                   const RunContext& ctx) {
  const auto& [gnss, metadata, control, options] = inputs;
  const GnssTerms stated = terms;
  if (auto done = adjust_with_gnss(model, terms, control, options, ctx); !done) return done;
  SfmModel corrected = model;
  const RollingShutterReport report = correct_rolling_shutter(
      corrected, readout_times(metadata, options.rolling_shutter), view_velocities(model, gnss));
  if (report.num_views == 0) return {};
  GnssTerms again = stated;
  if (auto done = adjust_with_gnss(corrected, again, control, options, ctx); !done) return done;
  const double before_px = mean_error_px(model, options.mapping.max_error_px);
  const double after_px = mean_error_px(corrected, options.mapping.max_error_px);
  const bool taken = options.rolling_shutter.readout_ms > 0.0 || after_px <= before_px;
  ctx.info(
      fmt::format("rolling shutter: {} photos corrected by up to {:.1f} px, mean error "
                  "{:.3f} -> {:.3f} px{}",
                  report.num_views,
                  report.largest_px,
                  before_px,
                  after_px,
                  taken ? "" : ": not taken"));
  if (!taken) return {};
  model = std::move(corrected);
  terms = std::move(again);
  return {};
}

}  // namespace hybridfusion
