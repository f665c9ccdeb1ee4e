#include "cloud_rows.hpp"

#include <hybridfusion/io/cloud_stream.hpp>

#include <limits>
#include <optional>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Asks for the stop and reports every so many points.
class ReadingProgress {
 public:
  ReadingProgress(std::string_view stage, const RunContext& ctx) : stage_(stage), ctx_(ctx) {}

  void begin(const InputFile& file) { file_ = &file; }
  [[nodiscard]] Expected<void> count_point() {
    constexpr std::uint64_t kInterval = 1U << 15U;
    if (++points_ % kInterval != 0) return {};
    if (ctx_.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    constexpr std::uint64_t kMiB = 1U << 20U;
    ctx_.report({.stage = stage_,
                 .done = static_cast<std::int64_t>(file_->position() / kMiB),
                 .total = static_cast<std::int64_t>(file_->size() / kMiB)});
    return {};
  }
  [[nodiscard]] std::uint64_t points() const { return points_; }

 private:
  std::string_view stage_;
  const RunContext& ctx_;
  const InputFile* file_ = nullptr;
  std::uint64_t points_ = 0;
};

[[nodiscard]] CloudTraits traits_of(const CloudSurvey& survey) {
  std::vector<ScalarTrait> scalars;
  for (const SurveyedScalar& scalar : survey.scalars) scalars.push_back({.name = scalar.name});
  return {.offset_m = survey.offset_m,
          .color_max = survey.color_max,
          .has_intensity = survey.has_intensity,
          .largest_intensity = survey.largest_intensity,
          .time_is_seconds = survey.time_is_seconds,
          .scalars = std::move(scalars)};
}

}  // namespace

Expected<CloudSurvey> survey_rows(const std::filesystem::path& path,
                                  const CloudRowReader& read_rows,
                                  const RunContext& ctx) {
  constexpr std::size_t kForgetAfter = 4096;
  std::optional<CloudBuilder> builder;
  std::uint64_t num_dropped = 0;
  ReadingProgress progress("convert/survey", ctx);
  const CloudRowSink sink = {
      .begin =
          [&](const InputFile& file, std::span<const CloudColumn> columns, std::uint64_t) {
            builder.emplace(columns);
            progress.begin(file);
          },
      .row = [&](std::span<const double> row) -> Expected<bool> {
        if (!builder->add(row)) {
          ++num_dropped;
          return false;
        }
        if (builder->size() >= kForgetAfter) builder->forget_points();
        if (auto counted = progress.count_point(); !counted) {
          return std::unexpected(counted.error());
        }
        return true;
      }};
  HF_TRY(CloudFileFacts facts, read_rows(path, sink));
  HF_TRY(const std::string dropped, told_of_dropped(path, num_dropped, progress.points()));
  if (!dropped.empty()) facts.warnings.push_back(dropped);
  const CloudTraits traits = builder->traits();
  if (traits.lossy_color) facts.warnings.emplace_back("its colours of 16 bits became 8 bits");
  std::vector<SurveyedScalar> scalars;
  for (const ScalarTrait& trait : traits.scalars) {
    scalars.push_back({.name = trait.name,
                       .type = trait.type,
                       .description = trait.description,
                       .smallest = trait.smallest,
                       .largest = trait.largest});
  }
  return CloudSurvey{.num_points = progress.points(),
                     .offset_m = traits.offset_m,
                     .crs = std::move(facts.crs),
                     .warnings = std::move(facts.warnings),
                     .color_max = traits.color_max,
                     .has_intensity = traits.has_intensity,
                     .largest_intensity = traits.largest_intensity,
                     .smallest_intensity = traits.smallest_intensity,
                     .fractional_intensity = traits.fractional_intensity,
                     .time_is_seconds = traits.time_is_seconds,
                     .channels = builder->channels(),
                     .scalars = std::move(scalars),
                     .viewpoint = facts.viewpoint};
}

Expected<void> visit_rows(const std::filesystem::path& path,
                          const CloudSurvey& survey,
                          const CloudRowReader& read_rows,
                          const CloudBatches& batches,
                          const RunContext& ctx) {
  HF_CHECK(batches.points > 0);
  std::optional<CloudBuilder> builder;
  ReadingProgress progress("convert/points", ctx);
  const auto hand_on = [&]() -> Expected<void> {
    auto taken = builder->take();
    if (!taken) return std::unexpected(std::move(taken.error()).with_context(path.string()));
    CloudBatch cloud = *std::move(taken);
    return batches.visit(std::move(cloud));
  };
  const CloudRowSink sink = {
      .begin =
          [&](const InputFile& file, std::span<const CloudColumn> columns, std::uint64_t) {
            builder.emplace(columns, traits_of(survey));
            progress.begin(file);
          },
      .row = [&](std::span<const double> row) -> Expected<bool> {
        if (!builder->add(row)) return false;
        auto taken = progress.count_point();
        if (taken && builder->size() >= batches.points) taken = hand_on();
        if (!taken) return std::unexpected(taken.error());
        return true;
      }};
  HF_TRY([[maybe_unused]] const CloudFileFacts facts, read_rows(path, sink));
  if (builder->size() > 0) {
    if (auto taken = hand_on(); !taken) return taken;
  }
  if (progress.points() == survey.num_points) return {};
  return fail(ErrorCode::kIo,
              fmt::format("{}: the file changed while it was read ({} points, then {}); try again "
                          "when it is complete",
                          path.string(),
                          survey.num_points,
                          progress.points()));
}

Expected<PlacedCloud> collect_rows(const std::filesystem::path& path,
                                   const CloudSurvey& survey,
                                   const CloudRowReader& read_rows) {
  PlacedCloud placed = {
      .offset_m = survey.offset_m, .crs = survey.crs, .warnings = survey.warnings};
  const CloudBatches all = {.points = std::numeric_limits<std::size_t>::max(),
                            .visit = [&placed](CloudBatch&& cloud) -> Expected<void> {
                              placed.cloud = std::move(cloud);
                              return {};
                            }};
  if (auto read = visit_rows(path, survey, read_rows, all, {}); !read) {
    return std::unexpected(read.error());
  }
  return placed;
}

}  // namespace hybridfusion
