#include "cloud_rows.hpp"

#include <fmt/format.h>

namespace hybridfusion {

Expected<PointCloud> finished(const std::filesystem::path& path, Expected<PointCloud> cloud) {
  if (!cloud) return std::unexpected(std::move(cloud.error()).with_context(path.string()));
  return cloud;
}

Expected<std::string> told_of_dropped(const std::filesystem::path& path,
                                      std::uint64_t num_dropped,
                                      std::uint64_t num_left) {
  if (num_dropped == 0) return std::string();
  if (num_left == 0) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: none of its {} points has a position (all NaN); export the cloud "
                            "again",
                            path.string(),
                            num_dropped));
  }
  return fmt::format("{} point{} without a position (NaN or infinite) {} left out",
                     num_dropped,
                     num_dropped == 1 ? "" : "s",
                     num_dropped == 1 ? "is" : "are");
}

Expected<PointCloud> build_cloud(const std::filesystem::path& path,
                                 const CloudRowReader& read_rows) {
  std::optional<CloudBuilder> builder;
  std::uint64_t num_dropped = 0;
  const CloudRowSink sink = {
      .begin =
          [&builder](const InputFile&, std::span<const CloudColumn> columns, std::uint64_t count) {
            builder.emplace(columns);
            builder->reserve(count);
          },
      .row = [&](std::span<const double> row) -> Expected<bool> {
        const bool kept = builder->add(row);
        num_dropped += kept ? 0 : 1;
        return kept;
      }};
  if (auto read = read_rows(path, sink); !read) return std::unexpected(read.error());
  HF_TRY([[maybe_unused]] const std::string dropped,
         told_of_dropped(path, num_dropped, builder->size()));
  return finished(path, std::move(*builder).finish());
}

}  // namespace hybridfusion
