#include "recording_reader.hpp"
#include "ros2_metadata.hpp"
#include "text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kMetadataFile = "metadata.yaml";

/// "bag_12.mcap.zstd" -> ("bag_", 12): files that one recorder split share the first.
[[nodiscard]] std::pair<std::string, std::uint64_t> split_name(const std::filesystem::path& path) {
  std::string name = lower_case(path.filename().string());
  for (const std::string_view ending : {".zstd", ".db3", ".mcap"}) {
    if (name.ends_with(ending)) name.resize(name.size() - ending.size());
  }
  const std::size_t letters = name.find_last_not_of("0123456789") + 1;
  const std::string digits = name.substr(letters);
  name.resize(letters);
  return {name, parse_number<std::uint64_t>(digits).value_or(0)};
}

[[nodiscard]] bool by_number(const std::filesystem::path& a, const std::filesystem::path& b) {
  return split_name(a) < split_name(b);
}

/// Bag files of a folder, in the order of their numbers.
Expected<std::vector<std::filesystem::path>> bag_files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code code;
  for (std::filesystem::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    std::string name = lower_case(entry->path().filename().string());
    if (name.ends_with(".zstd")) name.resize(name.size() - 5);
    if (name.ends_with(".db3") || name.ends_with(".mcap")) files.push_back(entry->path());
  }
  std::ranges::sort(files, by_number);
  return files;
}

/// Without metadata only names tell that files are parts of one recording.
Expected<std::vector<std::filesystem::path>> parts_in(const std::filesystem::path& folder) {
  HF_TRY(std::vector<std::filesystem::path> files, bag_files_in(folder));
  for (std::size_t i = 1; i < files.size(); ++i) {
    const std::string name = split_name(files[i]).first;
    if (name.ends_with('_') && name == split_name(files[0]).first) continue;
    std::vector<std::string> names;
    for (const std::filesystem::path& file : files) names.push_back(file.filename().string());
    return fail(ErrorCode::kParse,
                fmt::format("{}: several recordings in one folder: {}; give one of these files",
                            folder.string(),
                            printable(fmt::format("{}", fmt::join(names, ", ")))));
  }
  return files;
}

/// When the first message of a file was recorded; nothing when that cannot be told cheaply.
[[nodiscard]] std::optional<Timestamp> start_of(const std::filesystem::path& path,
                                                const RecordingSetup& setup) {
  if (lower_case(path.extension().string()) == ".zstd") return std::nullopt;
  auto file = MessageFile::open(path, setup);
  if (!file) return std::nullopt;
  const auto message = file->next();
  if (!message || !*message || (*message)->time == Timestamp{}) return std::nullopt;
  return (*message)->time;
}

/// Files that are listed in the order of their numbers are; others go by the time of their start.
void sort_parts(std::vector<std::filesystem::path>& files, const RecordingSetup& setup) {
  if (std::ranges::is_sorted(files, by_number)) return;
  std::vector<std::pair<Timestamp, std::filesystem::path>> parts;
  for (const std::filesystem::path& file : files) {
    const auto start = start_of(file, setup);
    if (!start) {
      std::ranges::sort(files, by_number);
      return;
    }
    parts.emplace_back(*start, file);
  }
  std::ranges::stable_sort(parts, {}, &std::pair<Timestamp, std::filesystem::path>::first);
  for (std::size_t i = 0; i < files.size(); ++i) files[i] = parts[i].second;
}

}  // namespace

Expected<std::vector<std::filesystem::path>> ros2_bag_files(const std::filesystem::path& folder) {
  const std::filesystem::path metadata_path = folder / kMetadataFile;
  std::error_code code;
  if (!std::filesystem::exists(metadata_path, code)) return parts_in(folder);
  HF_TRY(const Ros2Metadata metadata, read_ros2_metadata(metadata_path));
  std::vector<std::filesystem::path> files = {metadata_path};
  for (const std::string& name : metadata.files) {
    if (std::filesystem::exists(folder / name, code)) files.push_back(folder / name);
  }
  return files;
}

Expected<Ros2Bag> Ros2Bag::open(const std::filesystem::path& folder, const RecordingSetup& setup) {
  Ros2Bag bag;
  bag.setup_ = setup;
  std::error_code code;
  const std::filesystem::path metadata_path = folder / kMetadataFile;
  Ros2Metadata metadata;
  if (std::filesystem::exists(metadata_path, code)) {
    HF_TRY(metadata, read_ros2_metadata(metadata_path));
    for (const std::string& file : metadata.files) bag.files_.push_back(folder / file);
    bag.connections_ = std::move(metadata.connections);
    sort_parts(bag.files_, setup);
  }
  if (bag.files_.empty() && std::filesystem::exists(metadata_path, code)) {
    HF_TRY(bag.files_, parts_in(folder));
    bag.warnings_.push_back(
        fmt::format("{}: metadata.yaml names no file (recorder killed?); the bag files of the "
                    "folder are read",
                    folder.string()));
  } else if (bag.files_.empty()) {
    HF_TRY(bag.files_, parts_in(folder));
    bag.warnings_.push_back(
        fmt::format("{}: no metadata.yaml; its bag files are read in the order of their names",
                    folder.string()));
  }
  if (bag.files_.empty()) {
    return fail(
        ErrorCode::kParse,
        fmt::format("{}: the ROS 2 bag has no file; copy or record it again", folder.string()));
  }
  if (auto opened = bag.open_next_file(); !opened) return std::unexpected(opened.error());
  bag.format_ = fmt::format("ROS 2 bag folder: {}", bag.file_->format());
  // Without metadata each file must be asked what it holds.
  if (metadata.files.empty()) {
    for (std::size_t i = 1; i < bag.files_.size(); ++i) {
      HF_TRY(const MessageFile other, MessageFile::open(bag.files_[i], setup));
      bag.add_connections(other);
      for (const BagConnection& part : other.connections()) {
        const auto known = std::ranges::find(bag.connections_, part.topic, &BagConnection::topic);
        if (known->messages && part.messages) *known->messages += *part.messages;
      }
    }
  }
  return bag;
}

/// Topics that are not known yet.
void Ros2Bag::add_connections(const MessageFile& file) {
  for (const BagConnection& connection : file.connections()) {
    const auto found = std::ranges::find(connections_, connection.topic, &BagConnection::topic);
    if (found != connections_.end()) continue;
    connections_.push_back(connection);
    connections_.back().id = static_cast<std::uint32_t>(connections_.size() - 1);
  }
}

Expected<void> Ros2Bag::open_next_file() {
  HF_TRY(MessageFile file, MessageFile::open(files_[next_file_++], setup_));
  add_connections(file);
  if (!topics_.empty()) file.select_topics(topics_);
  file_.emplace(std::move(file));
  return {};
}

void Ros2Bag::close_file() {
  truncated_ = truncated_ || file_->truncated();
  for (std::string& warning : file_->warnings()) warnings_.push_back(std::move(warning));
  file_.reset();
}

Expected<std::optional<BagMessage>> Ros2Bag::next() {
  for (;;) {
    if (!file_) {
      if (next_file_ == files_.size()) return std::nullopt;
      if (auto opened = open_next_file(); !opened) {
        const ErrorCode code = opened.error().code;
        if (code != ErrorCode::kNotFound && code != ErrorCode::kParse) {
          return std::unexpected(opened.error());
        }
        truncated_ = true;
        warnings_.push_back(opened.error().message + " (the other files of the bag are used)");
        continue;
      }
    }
    HF_TRY(std::optional<BagMessage> message, file_->next());
    if (!message) {
      close_file();
      continue;
    }
    const auto& own = file_->connections();
    const auto from = std::ranges::find(own, message->connection, &BagConnection::id);
    if (from == own.end()) continue;
    const auto known = std::ranges::find(connections_, from->topic, &BagConnection::topic);
    if (known == connections_.end()) continue;
    message->connection = known->id;
    return message;
  }
}

bool Ros2Bag::truncated() const {
  return truncated_ || (file_ && file_->truncated());
}

std::vector<std::string> Ros2Bag::warnings() const {
  std::vector<std::string> warnings = warnings_;
  if (file_) {
    for (std::string& warning : file_->warnings()) warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace hybridfusion
