#include "cloud_rows.hpp"
#include "text.hpp"
#include "text_plan.hpp"

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// The scans of a file, each with the number of points that stands before it.
class AnnouncedCounts {
 public:
  /// @returns false when the line is no announcement.
  bool take(std::string_view line) {
    const auto count = parse_number<std::uint64_t>(line);
    if (!count) return false;
    close();
    announced_ = *count;
    ++scans_;
    return true;
  }
  void count_row() { ++rows_; }
  void close() {
    if (announced_ && *announced_ != rows_) {
      warnings_.push_back(fmt::format(
          "{} points are announced, {} follow: the file may be incomplete", *announced_, rows_));
    }
    announced_.reset();
    rows_ = 0;
  }
  [[nodiscard]] std::vector<std::string> warnings() const {
    std::vector<std::string> all = warnings_;
    constexpr std::size_t kMost = 5;
    if (all.size() > kMost) all.resize(kMost);
    if (scans_ > 1) all.push_back(fmt::format("its {} scans became one cloud", scans_));
    return all;
  }

 private:
  std::optional<std::uint64_t> announced_ = {};
  std::uint64_t rows_ = 0;
  std::size_t scans_ = 0;
  std::vector<std::string> warnings_ = {};
};

/// Turns lines into rows.
class TextRows {
 public:
  TextRows(const TextPlan& plan, const CloudRowSink& sink) : plan_(plan), sink_(sink) {}

  [[nodiscard]] Expected<void> add(const TextLines& lines, std::string_view line) {
    const auto bad = [&] {
      return lines.malformed(fmt::format("'{}' is no point like those before", printable(line)),
                             kNameTheColumns);
    };
    split_table_line(line, plan_.dialect.separator, fields_);
    // An empty last field is dropped with its separator.
    if (fields_.size() + 1 == plan_.num_fields && plan_.fields.back() + 1 == plan_.num_fields &&
        plan_.dialect.separator != TextDialect::Separator::kSpace) {
      fields_.emplace_back();
    }
    if (fields_.size() != plan_.num_fields) return bad();
    row_.clear();
    for (const std::size_t field : plan_.fields) {
      const auto number = table_number(fields_[field], plan_.dialect.decimal_comma);
      if (!number) return bad();
      row_.push_back(*number);
    }
    HF_TRY([[maybe_unused]] const bool finite, sink_.row(row_));
    return {};
  }

 private:
  const TextPlan& plan_;
  const CloudRowSink& sink_;
  std::vector<std::string_view> fields_ = {};
  std::vector<double> row_ = {};
};

}  // namespace

Expected<CloudFileFacts> read_text_rows(const std::filesystem::path& path,
                                        const CloudRowSink& sink,
                                        const std::vector<std::string>& columns) {
  HF_TRY(TextLines start_lines, TextLines::open(path));
  HF_TRY(const TextStart start, read_text_start(start_lines));
  HF_TRY(const TextPlan plan, plan_text(start_lines.file(), start, columns));
  HF_TRY(TextLines lines, TextLines::open(path));
  sink.begin(lines.file(), plan.columns, 0);
  TextRows rows(plan, sink);
  AnnouncedCounts counts;
  for (std::size_t number = 0;; ++number) {
    HF_TRY(const auto line, lines.next());
    if (!line) break;
    const std::string_view text = number == 0 ? text_of_line(*line) : trimmed(*line);
    if (text.empty() || text == plan.heading || counts.take(text)) continue;
    if (number < start.num_head_lines || is_text_comment(text)) continue;
    counts.count_row();
    if (auto added = rows.add(lines, text); !added) return std::unexpected(added.error());
  }
  counts.close();
  CloudFileFacts facts{.warnings = plan.warnings};
  for (std::string& warning : counts.warnings()) facts.warnings.push_back(std::move(warning));
  return facts;
}

Expected<CloudFileFacts> read_xyz_rows(const std::filesystem::path& path,
                                       const CloudRowSink& sink) {
  return read_text_rows(path, sink, {});
}

}  // namespace hybridfusion
