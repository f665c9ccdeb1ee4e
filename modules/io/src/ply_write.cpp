#include "byte_reader.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] std::string_view ply_type(ScalarType type) {
  // PLY knows no integers of 64 bits.
  constexpr std::array<std::string_view, 10> kNames = {
      "char", "uchar", "short", "ushort", "int", "uint", "float", "double", "double", "double"};
  return kNames[static_cast<std::size_t>(type)];
}

/// The value in the type that ply_type names.
template <class Put>
void put_scalar(double value, ScalarType type, Put&& put) {
  const auto whole = [value, &put]<class T>(T) {
    constexpr auto kLow = static_cast<double>(std::numeric_limits<T>::min());
    constexpr auto kHigh = static_cast<double>(std::numeric_limits<T>::max());
    put(value > kLow ? static_cast<T>(std::min(value, kHigh)) : std::numeric_limits<T>::min());
  };
  switch (type) {
    case ScalarType::kInt8:
      return whole(std::int8_t{});
    case ScalarType::kUint8:
      return whole(std::uint8_t{});
    case ScalarType::kInt16:
      return whole(std::int16_t{});
    case ScalarType::kUint16:
      return whole(std::uint16_t{});
    case ScalarType::kInt32:
      return whole(std::int32_t{});
    case ScalarType::kUint32:
      return whole(std::uint32_t{});
    case ScalarType::kFloat32:
      return put(static_cast<float>(value));
    case ScalarType::kFloat64:
    case ScalarType::kInt64:
    case ScalarType::kUint64:
      return put(value);
  }
}

[[nodiscard]] std::string header(const CloudBatch& cloud,
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
  const std::string_view prefix = options.scalar_prefix ? "scalar_" : "";
  const auto add = [&text, prefix](std::string_view type, std::string name) {
    std::ranges::replace_if(name, [](char c) { return c <= ' '; }, '_');
    if (!prefix.empty() && name.starts_with(prefix)) name.erase(0, prefix.size());
    text += fmt::format("property {} {}{}\n", type, prefix, name);
  };
  if (!cloud.intensities.empty()) add("float", "intensity");
  if (!cloud.times_s.empty()) add("double", "time");
  if (!cloud.sigmas_m.empty()) add("float", "sigma");
  if (!cloud.confidences.empty()) add("float", "confidence");
  if (!cloud.sources.empty()) add("uchar", "source");
  for (const PointScalar& scalar : cloud.scalars) add(ply_type(scalar.type), scalar.name);
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

void append_rows(const PointCloud& cloud,
                 std::span<const PointScalar> scalars,
                 PlyFormat format,
                 AtomicFile& file) {
  std::string row;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    row.clear();
    const auto put_all = [&](auto&& put) {
      visit_values(cloud, i, put);
      for (const PointScalar& scalar : scalars) put_scalar(scalar.values[i], scalar.type, put);
    };
    if (format == PlyFormat::kBinaryLittleEndian) {
      put_all([&row](auto value) { append_value(row, value); });
    } else {
      put_all([&row](auto value) { fmt::format_to(std::back_inserter(row), "{} ", value); });
      row.back() = '\n';
    }
    file.write(row);
  }
}

/// One point, and the scalars without values.
CloudBatch channels_of(const PointCloud& cloud, std::span<const PointScalar> scalars) {
  CloudBatch channels;
  if (!cloud.empty()) static_cast<PointCloud&>(channels) = select(cloud, {0});
  for (const PointScalar& scalar : scalars) {
    channels.scalars.push_back({.name = scalar.name, .type = scalar.type});
  }
  return channels;
}

/// The header of a file whose number of points becomes known last: a comment makes up for its
/// digits.
std::string padded_header(const CloudBatch& channels,
                          std::size_t num_points,
                          PlyWriteOptions options) {
  constexpr std::size_t kDigits = 20;
  const std::size_t digits = fmt::format("{}", num_points).size();
  options.comments = {std::string(kDigits - digits, '-')};
  return header(channels, num_points, options);
}

}  // namespace

Expected<void> write_ply(const std::filesystem::path& path,
                         const PointCloud& cloud,
                         const PlyWriteOptions& options) {
  HF_CHECK(validate(cloud).has_value());
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  file.write(header(channels_of(cloud, {}), cloud.size(), options));
  append_rows(cloud, {}, options.format, file);
  return file.commit();
}

Expected<PlyPieceWriter> PlyPieceWriter::create(const std::filesystem::path& path,
                                                PlyFormat format,
                                                bool scalar_prefix) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  return PlyPieceWriter(std::move(file), {.format = format, .scalar_prefix = scalar_prefix});
}

void PlyPieceWriter::add(const PointCloud& piece) {
  add_rows(piece, {});
}

void PlyPieceWriter::add(const CloudBatch& piece) {
  add_rows(piece, piece.scalars);
}

void PlyPieceWriter::add_rows(const PointCloud& piece, std::span<const PointScalar> scalars) {
  HF_CHECK(validate(piece).has_value());
  if (piece.empty()) return;
  if (num_points_ == 0) {
    channels_ = channels_of(piece, scalars);
    file_.write(padded_header(channels_, 0, options_));
  }
  num_points_ += piece.size();
  append_rows(piece, scalars, options_.format, file_);
}

Expected<void> PlyPieceWriter::commit() {
  const std::string text = padded_header(channels_, num_points_, options_);
  if (num_points_ == 0) {
    file_.write(text);
  } else {
    file_.overwrite_start(text);
  }
  return file_.commit();
}

}  // namespace hybridfusion
