#pragma once

#include "recorded_clock.hpp"

#include <hybridfusion/io/rosbag1.hpp>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hybridfusion {

/// Delivers the messages of a file of chunks in the order of recording. File is BagFile or
/// McapFile: chunks from an index when there is one, one after the other otherwise.
template <class File>
class MessageMerger {
 public:
  /// Looks into the first chunks of a file without index, so that its topics are known.
  [[nodiscard]] static Expected<MessageMerger> create(File file);

  [[nodiscard]] const std::vector<BagConnection>& connections() const {
    return file_.connections();
  }
  [[nodiscard]] bool truncated() const { return file_.truncated(); }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return file_.warnings(); }
  void select_topics(std::vector<std::string> topics) {
    topics_.emplace(std::make_move_iterator(topics.begin()), std::make_move_iterator(topics.end()));
  }
  [[nodiscard]] Expected<std::optional<BagMessage>> next();

 private:
  static constexpr Timestamp kNever = Timestamp::max();

  explicit MessageMerger(File file) : file_(std::move(file)) {}
  [[nodiscard]] bool wanted(const BagMessage& message) const;
  [[nodiscard]] Expected<void> load_chunk();
  void enqueue(std::vector<BagMessage> messages);
  void end() {
    exhausted_ = true;
    if constexpr (requires { file_.note_end(); }) file_.note_end();
  }
  [[nodiscard]] Timestamp earliest_to_come() const;

  File file_;
  std::size_t next_chunk_ = 0;                 ///< Into file.chunks() when there is an index.
  std::vector<Timestamp> earliest_from_ = {};  ///< Earliest start of chunk i and all after it.
  bool exhausted_ = false;
  Timestamp last_chunk_start_ = kNever;
  RecordedClock clock_ = {};
  std::optional<std::set<std::string>> topics_ = {};
  // A vector kept sorted by descending time: the next message is at the back, equal times keep the
  // order of the file.
  std::vector<BagMessage> pending_ = {};
  std::uint64_t pending_bytes_ = 0;
};

[[nodiscard]] inline bool holds_lidar_imu_and_gnss(const std::vector<BagConnection>& connections) {
  const auto any = [&](std::string_view part) {
    return std::ranges::any_of(connections, [part](const BagConnection& connection) {
      return connection.type.find(part) != std::string::npos;
    });
  };
  return (any("/PointCloud2") || any("/CustomMsg")) && any("/Imu") && any("/NavSatFix");
}

template <class File>
Expected<MessageMerger<File>> MessageMerger<File>::create(File file) {
  // A file without index is searched for topics this far when some kind of sensor is missing.
  constexpr int kMaxProbedChunks = 64;
  constexpr int kMinProbedChunks = 4;
  if (!file.has_index()) {
    for (int chunk = 0; chunk < kMaxProbedChunks; ++chunk) {
      if (chunk >= kMinProbedChunks && holds_lidar_imu_and_gnss(file.connections())) break;
      HF_TRY(const auto messages, file.read_next_chunk());
      if (!messages) break;
    }
    file.rewind();
  }
  MessageMerger merger(std::move(file));
  Timestamp earliest = kNever;
  merger.earliest_from_.resize(merger.file_.chunks().size());
  for (std::size_t i = merger.earliest_from_.size(); i-- > 0;) {
    earliest = std::min(earliest, merger.file_.chunks()[i].start);
    merger.earliest_from_[i] = earliest;
  }
  return merger;
}

template <class File>
bool MessageMerger<File>::wanted(const BagMessage& message) const {
  if (!topics_) return true;
  const BagConnection* connection = file_.find_connection(message.connection);
  return connection != nullptr && topics_->contains(connection->topic);
}

template <class File>
void MessageMerger<File>::enqueue(std::vector<BagMessage> messages) {
  last_chunk_start_ = kNever;
  for (BagMessage& message : messages) {
    message.time = clock_.place(message.connection, message.time);
    last_chunk_start_ = std::min(last_chunk_start_, message.time);
  }
  std::erase_if(messages, [this](const BagMessage& message) { return !wanted(message); });
  for (const BagMessage& message : messages) pending_bytes_ += message.data.size();
  // Reversed, stable: equal times end up in file order when taken from the back.
  std::ranges::reverse(pending_);
  pending_.insert(pending_.end(),
                  std::make_move_iterator(messages.begin()),
                  std::make_move_iterator(messages.end()));
  std::ranges::stable_sort(pending_, {}, &BagMessage::time);
  std::ranges::reverse(pending_);
}

template <class File>
Expected<void> MessageMerger<File>::load_chunk() {
  if (file_.has_index()) {
    if (next_chunk_ == file_.chunks().size()) {
      end();
      return {};
    }
    HF_TRY(auto messages, file_.read_chunk_at(file_.chunks()[next_chunk_].position));
    ++next_chunk_;
    enqueue(std::move(messages));
    return {};
  }
  HF_TRY(auto messages, file_.read_next_chunk());
  if (!messages) {
    end();
  } else {
    enqueue(std::move(*messages));
  }
  return {};
}

template <class File>
Timestamp MessageMerger<File>::earliest_to_come() const {
  if (exhausted_) return kNever;
  if (!file_.has_index()) return last_chunk_start_;
  return next_chunk_ < earliest_from_.size() ? earliest_from_[next_chunk_] : kNever;
}

template <class File>
Expected<std::optional<BagMessage>> MessageMerger<File>::next() {
  // Messages wait for earlier ones in later chunks; beyond this they are delivered as they come.
  constexpr std::uint64_t kMaxPendingBytes = std::uint64_t{256} << 20;
  while (!exhausted_ && pending_bytes_ <= kMaxPendingBytes &&
         (pending_.empty() || pending_.back().time > earliest_to_come())) {
    if (auto loaded = load_chunk(); !loaded) return std::unexpected(loaded.error());
  }
  if (pending_.empty()) return std::nullopt;
  BagMessage message = std::move(pending_.back());
  pending_.pop_back();
  pending_bytes_ -= message.data.size();
  return message;
}

}  // namespace hybridfusion
