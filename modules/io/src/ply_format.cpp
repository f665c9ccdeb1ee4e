#include "ply_format.hpp"

#include "text.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxElements = 64;
constexpr std::size_t kMaxProperties = 512;
constexpr std::size_t kMaxHeaderLines = 65536;
constexpr std::string_view kAgain = "export the cloud again";

struct TypeName {
  std::string_view name;
  ScalarType type;
};
constexpr std::array<TypeName, 16> kTypeNames = {{
    {"char", ScalarType::kInt8},
    {"int8", ScalarType::kInt8},
    {"uchar", ScalarType::kUint8},
    {"uint8", ScalarType::kUint8},
    {"short", ScalarType::kInt16},
    {"int16", ScalarType::kInt16},
    {"ushort", ScalarType::kUint16},
    {"uint16", ScalarType::kUint16},
    {"int", ScalarType::kInt32},
    {"int32", ScalarType::kInt32},
    {"uint", ScalarType::kUint32},
    {"uint32", ScalarType::kUint32},
    {"float", ScalarType::kFloat32},
    {"float32", ScalarType::kFloat32},
    {"double", ScalarType::kFloat64},
    {"float64", ScalarType::kFloat64},
}};

[[nodiscard]] std::optional<ScalarType> parse_type(std::string_view name) {
  for (const TypeName& known : kTypeNames) {
    if (known.name == name) return known.type;
  }
  return std::nullopt;
}

/// "property float x" or "property list uchar int vertex_indices".
[[nodiscard]] std::optional<PlyProperty> parse_property(std::span<const std::string_view> words) {
  PlyProperty property;
  if (words.size() == 5 && words[1] == "list") {
    property.count_type = parse_type(words[2]);
    if (!property.count_type || !is_integer(*property.count_type)) return std::nullopt;
    words = words.subspan(2);
  } else if (words.size() != 3) {
    return std::nullopt;
  }
  const std::optional<ScalarType> type = parse_type(words[1]);
  if (!type) return std::nullopt;
  property.type = *type;
  property.name = words[2];
  return property;
}

}  // namespace

Expected<PlyReader> PlyReader::open(const std::filesystem::path& path) {
  HF_TRY(InputFile file, InputFile::open(path));
  PlyReader reader(std::move(file));
  if (auto header = reader.read_header(); !header) return std::unexpected(header.error());
  return reader;
}

Expected<void> PlyReader::read_header() {
  HF_TRY(const auto magic, file_.line());
  if (!magic || trimmed(*magic) != "ply") {
    return file_.malformed("not a PLY file (it does not start with 'ply')",
                           "give a point cloud in PLY format");
  }
  for (std::size_t lines = 0; lines < kMaxHeaderLines; ++lines) {
    HF_TRY(const auto line, file_.line());
    if (!line) return file_.malformed("truncated: the header has no 'end_header'", kAgain);
    if (trimmed(*line) == "end_header") return check_counts();
    if (auto parsed = parse_header_line(*line); !parsed) return parsed;
  }
  return file_.malformed(fmt::format("the header has more than {} lines", kMaxHeaderLines), kAgain);
}

Expected<void> PlyReader::parse_header_line(std::string_view line) {
  const std::vector<std::string_view> words = split_words(line);
  if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return {};
  const auto bad = [&] {
    return file_.malformed(fmt::format("header line '{}' is not understood", printable(line)),
                           kAgain);
  };
  if (words[0] == "format" && words.size() == 3) {
    if (words[1] == "ascii") encoding_ = PlyEncoding::kAscii;
    if (words[1] == "binary_little_endian") encoding_ = PlyEncoding::kLittleEndian;
    if (words[1] == "binary_big_endian") encoding_ = PlyEncoding::kBigEndian;
    return encoding_ ? Expected<void>() : bad();
  }
  if (words[0] == "element" && words.size() == 3) {
    const auto count = parse_number<std::uint64_t>(words[2]);
    if (!count || elements_.size() == kMaxElements) return bad();
    elements_.push_back({.name = std::string(words[1]), .count = *count});
    return {};
  }
  if (words[0] == "property" && !elements_.empty()) {
    auto property = parse_property(words);
    if (!property || elements_.back().properties.size() == kMaxProperties) return bad();
    elements_.back().properties.push_back(std::move(*property));
    return {};
  }
  return bad();
}

Expected<void> PlyReader::check_counts() const {
  if (!encoding_) return file_.malformed("the header names no format", kAgain);
  std::uint64_t left = file_.remaining() + 1;  // the last ascii value needs no line end
  for (const PlyElement& element : elements_) {
    std::uint64_t row_bytes = 0;
    for (const PlyProperty& property : element.properties) {
      row_bytes += *encoding_ == PlyEncoding::kAscii
                       ? 2  // a digit and a separator
                       : size_of(property.count_type.value_or(property.type));
    }
    if (row_bytes > 0 && element.count > left / row_bytes) {
      return file_.malformed(
          fmt::format(
              "truncated: the header announces {} rows of '{}' with at least {} bytes each, "
              "but only {} bytes follow",
              element.count,
              printable(element.name),
              row_bytes,
              file_.remaining()),
          "copy or export the file again");
    }
    left -= row_bytes * element.count;
  }
  return {};
}

Expected<double> PlyReader::read_value(ScalarType type) {
  if (encoding_ == PlyEncoding::kAscii) {
    HF_TRY(const auto word, file_.token());
    if (!word) return file_.malformed("truncated: the file ends within the data", kAgain);
    const auto value = parse_number<double>(*word);
    if (!value) {
      return file_.malformed(
          fmt::format("'{}' before byte {} is not a number", printable(*word), file_.position()),
          kAgain);
    }
    return *value;
  }
  HF_TRY(const auto bytes, file_.take(size_of(type)));
  return load_scalar(bytes.data(),
                     type,
                     encoding_ == PlyEncoding::kBigEndian ? std::endian::big : std::endian::little);
}

Expected<void> PlyReader::read_list(const PlyProperty& property, std::vector<double>& values) {
  HF_TRY(const double count, read_value(*property.count_type));
  const std::size_t value_bytes = encoding_ == PlyEncoding::kAscii ? 2 : size_of(property.type);
  const auto most = static_cast<double>((file_.remaining() + 1) / value_bytes);
  if (!(count >= 0.0 && count <= most)) {
    return file_.malformed(
        fmt::format(
            "a list of {} values before byte {} does not fit the file", count, file_.position()),
        kAgain);
  }
  values.clear();
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) {
    HF_TRY(const double value, read_value(property.type));
    values.push_back(value);
  }
  return {};
}

Expected<void> PlyReader::read_row(const PlyElement& element,
                                   std::vector<double>& scalars,
                                   std::vector<std::vector<double>>& lists) {
  scalars.resize(element.properties.size());
  lists.resize(element.properties.size());
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (property.count_type) {
      if (auto list = read_list(property, lists[i]); !list) return list;
      scalars[i] = static_cast<double>(lists[i].size());
    } else {
      HF_TRY(scalars[i], read_value(property.type));
    }
  }
  return {};
}

Expected<void> PlyReader::skip(const PlyElement& element) {
  if (element.properties.empty()) return {};
  std::vector<double> scalars;
  std::vector<std::vector<double>> lists;
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (auto read = read_row(element, scalars, lists); !read) return read;
  }
  return {};
}

}  // namespace hybridfusion
