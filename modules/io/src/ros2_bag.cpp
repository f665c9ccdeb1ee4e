#include "recording_reader.hpp"
#include "ros2_metadata.hpp"
#include "text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kMetadataFile = "metadata.yaml";

/// Bag files of a folder without metadata, by name (their numbers are of equal length up to 9).
Expected<std::vector<std::filesystem::path>> bag_files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code code;
  for (std::filesystem::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    std::string name = lower_case(entry->path().filename().string());
    if (name.ends_with(".zstd")) name.resize(name.size() - 5);
    if (name.ends_with(".db3") || name.ends_with(".mcap")) files.push_back(entry->path());
  }
  std::ranges::sort(files, [](const auto& a, const auto& b) {
    // Shorter first: bag_9.db3 comes before bag_10.db3.
    return std::pair(a.native().size(), a.native()) < std::pair(b.native().size(), b.native());
  });
  return files;
}

}  // namespace

Expected<std::vector<std::filesystem::path>> ros2_bag_files(const std::filesystem::path& folder) {
  const std::filesystem::path metadata_path = folder / kMetadataFile;
  std::error_code code;
  if (!std::filesystem::exists(metadata_path, code)) return bag_files_in(folder);
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
  } else {
    HF_TRY(bag.files_, bag_files_in(folder));
    bag.warnings_.push_back(
        fmt::format("{}: no metadata.yaml; its bag files are read in the order of their names",
                    folder.string()));
  }
  if (bag.files_.empty()) {
    return fail(
        ErrorCode::kParse,
        fmt::format("{}: the ROS 2 bag names no file; copy or record it again", folder.string()));
  }
  if (auto opened = bag.open_next_file(); !opened) return std::unexpected(opened.error());
  bag.format_ = fmt::format("ROS 2 bag folder: {}", bag.file_->format());
  // Without metadata each file must be asked what it holds.
  if (metadata.files.empty()) {
    for (std::size_t i = 1; i < bag.files_.size(); ++i) {
      HF_TRY(const MessageFile other, MessageFile::open(bag.files_[i], setup));
      bag.add_connections(other);
    }
  }
  return bag;
}

void Ros2Bag::add_connections(const MessageFile& file) {
  for (const BagConnection& connection : file.connections()) {
    const auto found = std::ranges::find(connections_, connection.topic, &BagConnection::topic);
    if (found == connections_.end()) {
      connections_.push_back(connection);
      connections_.back().id = static_cast<std::uint32_t>(connections_.size() - 1);
    } else if (found->messages && connection.messages) {
      *found->messages += *connection.messages;
    }
  }
}

Expected<void> Ros2Bag::open_next_file() {
  HF_TRY(MessageFile file, MessageFile::open(files_[next_file_++], setup_));
  if (connections_.empty()) add_connections(file);
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
