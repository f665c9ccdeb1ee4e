#include "byte_reader.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] std::string header(const PointCloud& cloud, const PlyWriteOptions& options) {
  std::string text =
      fmt::format("ply\nformat {} 1.0\n",
                  options.format == PlyFormat::kAscii ? "ascii" : "binary_little_endian");
  for (std::string comment : options.comments) {
    std::ranges::replace_if(comment, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    text += "comment " + comment + "\n";
  }
  text += fmt::format("element vertex {}\n", cloud.size());
  text += "property float x\nproperty float y\nproperty float z\n";
  if (!cloud.normals.empty()) text += "property float nx\nproperty float ny\nproperty float nz\n";
  if (!cloud.colors.empty()) {
    text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  }
  if (!cloud.intensities.empty()) text += "property float intensity\n";
  if (!cloud.times_s.empty()) text += "property double time\n";
  if (!cloud.sigmas_m.empty()) text += "property float sigma\n";
  if (!cloud.confidences.empty()) text += "property float confidence\n";
  if (!cloud.sources.empty()) text += "property uchar source\n";
  return text + "end_header\n";
}

/// Calls `put(value)` for each value of point `i`, in the order of the header.
template <class Put>
void visit_values(const PointCloud& cloud, std::size_t i, Put&& put) {
  for (const float value : cloud.points[i]) put(value);
  if (!cloud.normals.empty()) {
    for (const float value : cloud.normals[i]) put(value);
  }
  if (!cloud.colors.empty()) {
    for (const std::uint8_t value : cloud.colors[i]) put(value);
  }
  if (!cloud.intensities.empty()) put(cloud.intensities[i]);
  if (!cloud.times_s.empty()) put(cloud.times_s[i]);
  if (!cloud.sigmas_m.empty()) put(cloud.sigmas_m[i]);
  if (!cloud.confidences.empty()) put(cloud.confidences[i]);
  if (!cloud.sources.empty()) put(static_cast<std::uint8_t>(cloud.sources[i]));
}

}  // namespace

Expected<void> write_ply(const std::filesystem::path& path,
                         const PointCloud& cloud,
                         const PlyWriteOptions& options) {
  HF_CHECK(validate(cloud).has_value());
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  file.write(header(cloud, options));
  std::string row;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    row.clear();
    if (options.format == PlyFormat::kAscii) {
      visit_values(
          cloud, i, [&row](auto value) { fmt::format_to(std::back_inserter(row), "{} ", value); });
      row.back() = '\n';
    } else {
      visit_values(cloud, i, [&row](auto value) { append_value(row, value); });
    }
    file.write(row);
  }
  return file.commit();
}

}  // namespace hybridfusion
