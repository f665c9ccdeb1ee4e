#include "byte_reader.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] std::string header(const PointCloud& cloud,
                                 std::size_t num_points,
                                 const PlyWriteOptions& options) {
  std::string text =
      fmt::format("ply\nformat {} 1.0\n",
                  options.format == PlyFormat::kAscii ? "ascii" : "binary_little_endian");
  for (std::string comment : options.comments) {
    std::ranges::replace_if(comment, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    text += "comment " + comment + "\n";
  }
  text += fmt::format("element vertex {}\n", num_points);
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

void append_rows(const PointCloud& cloud, PlyFormat format, AtomicFile& file) {
  std::string row;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    row.clear();
    if (format == PlyFormat::kBinaryLittleEndian) {
      visit_values(cloud, i, [&row](auto value) { append_value(row, value); });
    } else {
      visit_values(
          cloud, i, [&row](auto value) { fmt::format_to(std::back_inserter(row), "{} ", value); });
      row.back() = '\n';
    }
    file.write(row);
  }
}

/// The header of a file whose number of points becomes known last: a comment makes up for its
/// digits.
std::string padded_header(const PointCloud& channels, std::size_t num_points, PlyFormat format) {
  constexpr std::size_t kDigits = 20;
  const std::size_t digits = fmt::format("{}", num_points).size();
  return header(
      channels, num_points, {.format = format, .comments = {std::string(kDigits - digits, '-')}});
}

}  // namespace

Expected<void> write_ply(const std::filesystem::path& path,
                         const PointCloud& cloud,
                         const PlyWriteOptions& options) {
  HF_CHECK(validate(cloud).has_value());
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  file.write(header(cloud, cloud.size(), options));
  append_rows(cloud, options.format, file);
  return file.commit();
}

Expected<PlyPieceWriter> PlyPieceWriter::create(const std::filesystem::path& path,
                                                PlyFormat format) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  return PlyPieceWriter(std::move(file), format);
}

void PlyPieceWriter::add(const PointCloud& piece) {
  HF_CHECK(validate(piece).has_value());
  if (piece.empty()) return;
  if (num_points_ == 0) {
    channels_ = select(piece, {0});
    file_.write(padded_header(channels_, 0, format_));
  }
  num_points_ += piece.size();
  append_rows(piece, format_, file_);
}

Expected<void> PlyPieceWriter::commit() {
  const std::string text = padded_header(channels_, num_points_, format_);
  if (num_points_ == 0) {
    file_.write(text);
  } else {
    file_.overwrite_start(text);
  }
  return file_.commit();
}

}  // namespace hybridfusion
