#include "pcd_header.hpp"

#include "text.hpp"

#include <optional>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kAgain = "export the cloud again";
constexpr std::size_t kMaxColumns = 4096;
constexpr std::size_t kMaxHeaderLines = 1000;

[[nodiscard]] std::optional<ScalarType> scalar_type(std::string_view type, std::string_view size) {
  using enum ScalarType;
  if (type == "F")
    return size == "4"   ? std::optional(kFloat32)
           : size == "8" ? std::optional(kFloat64)
                         : std::nullopt;
  const bool is_signed = type == "I";
  if (!is_signed && type != "U") return std::nullopt;
  if (size == "1") return is_signed ? kInt8 : kUint8;
  if (size == "2") return is_signed ? kInt16 : kUint16;
  if (size == "4") return is_signed ? kInt32 : kUint32;
  if (size == "8") return is_signed ? kInt64 : kUint64;
  return std::nullopt;
}

/// The header's lines as words by keyword.
struct RawHeader {
  std::vector<std::string> fields = {};
  std::vector<std::string> sizes = {};
  std::vector<std::string> types = {};
  std::vector<std::string> counts = {};
  std::optional<std::uint64_t> width = {};
  std::optional<std::uint64_t> height = {};
  std::optional<std::uint64_t> points = {};
  std::optional<Viewpoint> viewpoint = Viewpoint(kNoViewpoint);  ///< Nothing: not seven numbers.
  std::string data = {};
};

[[nodiscard]] std::optional<Viewpoint> parse_viewpoint(std::span<const std::string_view> words) {
  Viewpoint viewpoint{};
  if (words.size() != viewpoint.size() + 1) return std::nullopt;
  for (std::size_t i = 0; i < viewpoint.size(); ++i) {
    const auto number = parse_number<double>(words[i + 1]);
    if (!number) return std::nullopt;
    viewpoint[i] = *number;
  }
  return viewpoint;
}

Expected<RawHeader> read_raw_header(InputFile& file) {
  RawHeader header;
  for (std::size_t i = 0; header.data.empty(); ++i) {
    HF_TRY(const auto line, file.line());
    if (!line || i == kMaxHeaderLines) {
      return file.malformed("not a PCD file, or its header is cut (no DATA line)",
                            "give a point cloud in PCD format");
    }
    const std::vector<std::string_view> words = split_words(*line);
    if (words.empty() || words[0].starts_with('#')) continue;
    const auto texts = [&words] {
      return std::vector<std::string>(words.begin() + 1, words.end());
    };
    const auto number = [&words] {
      return words.size() == 2 ? parse_number<std::uint64_t>(words[1]) : std::nullopt;
    };
    if (words[0] == "FIELDS" || words[0] == "COLUMNS") header.fields = texts();
    if (words[0] == "SIZE") header.sizes = texts();
    if (words[0] == "TYPE") header.types = texts();
    if (words[0] == "COUNT") header.counts = texts();
    if (words[0] == "WIDTH") header.width = number();
    if (words[0] == "HEIGHT") header.height = number();
    if (words[0] == "VIEWPOINT") header.viewpoint = parse_viewpoint(words);
    if (words[0] == "POINTS") header.points = number();
    if (words[0] == "DATA" && words.size() == 2) header.data = words[1];
  }
  return header;
}

}  // namespace

Expected<PcdHeader> read_pcd_header(InputFile& file) {
  HF_TRY(const RawHeader raw, read_raw_header(file));
  const std::size_t count = raw.fields.size();
  if (count == 0 || raw.sizes.size() != count || raw.types.size() != count ||
      (!raw.counts.empty() && raw.counts.size() != count)) {
    return file.malformed("the header's FIELDS, SIZE, TYPE and COUNT lines do not match", kAgain);
  }
  PcdHeader header = {.viewpoint = raw.viewpoint.value_or(kNoViewpoint), .data = raw.data};
  std::size_t columns = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto type = scalar_type(raw.types[i], raw.sizes[i]);
    const auto repeat = raw.counts.empty() ? std::optional<std::size_t>(1)
                                           : parse_number<std::size_t>(raw.counts[i]);
    if (!type || !repeat || *repeat > kMaxColumns) {
      return file.malformed(fmt::format("field '{}' has an unknown type", printable(raw.fields[i])),
                            kAgain);
    }
    const std::string name = lower_case(raw.fields[i]);
    const bool packed = (name == "rgb" || name == "rgba") && size_of(*type) == 4 && *repeat == 1;
    header.fields.push_back({.name = name,
                             .label = raw.fields[i],
                             .type = *type,
                             .count = *repeat,
                             .packed_color = packed});
    columns += *repeat;
  }
  if (columns == 0 || columns > kMaxColumns) {
    return file.malformed(fmt::format("points of {} values", columns), kAgain);
  }
  const bool has_grid = raw.width && raw.height;
  if (!has_grid && !raw.points) {
    return file.malformed("the header gives no number of points", kAgain);
  }
  std::uint64_t cells = 0;
  const bool wraps = has_grid && __builtin_mul_overflow(*raw.width, *raw.height, &cells);
  header.points = raw.points.value_or(cells);
  // PCL writes 0 x 0 beside the number of points when a cloud was filled by hand.
  const bool no_grid = has_grid && cells == 0 && !wraps;
  if (has_grid && !no_grid && (wraps || cells != header.points)) {
    return file.malformed("the header's WIDTH, HEIGHT and POINTS do not fit each other", kAgain);
  }
  return header;
}

}  // namespace hybridfusion
