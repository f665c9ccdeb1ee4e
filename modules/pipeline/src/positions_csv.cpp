#include "positions_csv.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <charconv>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kMaxCsvBytes = 256U << 20U;
constexpr std::size_t kNumColumns = 11;

std::string coordinates(const std::optional<Eigen::Vector3d>& point) {
  if (!point) return ",,";
  return fmt::format("{:.6f},{:.6f},{:.6f}", point->x(), point->y(), point->z());
}

std::optional<Eigen::Vector3d> point_of(const std::vector<std::string>& fields, std::size_t first) {
  Eigen::Vector3d point;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string& field = fields[first + k];
    const char* end = field.data() + field.size();
    const auto parsed = std::from_chars(field.data(), end, point[static_cast<Eigen::Index>(k)]);
    if (parsed.ec != std::errc{} || parsed.ptr != end) return std::nullopt;
  }
  return point;
}

}  // namespace

std::vector<std::string> next_csv_record(std::string_view text, std::size_t& at) {
  std::vector<std::string> fields(1);
  bool in_quotes = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (in_quotes) {
      if (c != '"') {
        fields.back() += c;
      } else if (at + 1 < text.size() && text[at + 1] == '"') {
        fields.back() += text[++at];
      } else {
        in_quotes = false;
      }
    } else if (c == '"') {
      in_quotes = true;
    } else if (c == ',') {
      fields.emplace_back();
    } else if (c == '\n') {
      ++at;
      break;
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  return fields;
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

Expected<void> write_positions_csv(const std::filesystem::path& path,
                                   const std::vector<PositionRow>& rows) {
  std::string text = "name,registered,x,y,z,gnss_x,gnss_y,gnss_z,residual_h,residual_v,reason\n";
  for (const PositionRow& row : rows) {
    std::string residuals = ",";
    if (row.position && row.gnss) {
      const Eigen::Vector3d residual = *row.position - *row.gnss;
      residuals = fmt::format("{:.6f},{:.6f}", residual.head<2>().norm(), residual.z());
    }
    text += fmt::format("{},{},{},{},{},{}\n",
                        csv_text(row.name),
                        row.position ? 1 : 0,
                        coordinates(row.position),
                        coordinates(row.gnss),
                        residuals,
                        csv_text(row.reason));
  }
  return write_file_atomically(path, text);
}

Expected<std::vector<PositionRow>> read_positions_csv(const std::filesystem::path& path) {
  HF_TRY(const std::string text, read_text_file(path, kMaxCsvBytes));
  std::vector<PositionRow> rows;
  std::size_t at = 0;
  next_csv_record(text, at);  // the header
  while (at < text.size()) {
    const std::vector<std::string> fields = next_csv_record(text, at);
    if (fields.size() != kNumColumns) {
      return fail(ErrorCode::kParse,
                  fmt::format("{}: record {} has {} fields instead of {}",
                              path.string(),
                              rows.size() + 1,
                              fields.size(),
                              kNumColumns));
    }
    rows.push_back({.name = fields[0],
                    .position = point_of(fields, 2),
                    .gnss = point_of(fields, 5),
                    .reason = fields[10]});
  }
  return rows;
}

}  // namespace hybridfusion
