#include "cloud_rows.hpp"

namespace hybridfusion {

Expected<PointCloud> finished(const std::filesystem::path& path, Expected<PointCloud> cloud) {
  if (!cloud) return std::unexpected(std::move(cloud.error()).with_context(path.string()));
  return cloud;
}

Expected<PointCloud> build_cloud(const std::filesystem::path& path, CloudRowReader read_rows) {
  std::optional<CloudBuilder> builder;
  const CloudRowSink sink = {
      .begin =
          [&builder](const InputFile&, std::span<const CloudColumn> columns, std::uint64_t count) {
            builder.emplace(columns);
            builder->reserve(count);
          },
      .row = [&builder](std::span<const double> row) -> Expected<bool> {
        return builder->add(row);
      }};
  if (auto read = read_rows(path, sink); !read) return std::unexpected(read.error());
  return finished(path, std::move(*builder).finish());
}

}  // namespace hybridfusion
