#include "bag_file.hpp"

#include <hybridfusion/io/rosbag1.hpp>

#include <algorithm>
#include <limits>
#include <set>

namespace hybridfusion {
namespace {

constexpr Timestamp kNever = Timestamp::max();
// Messages wait for earlier ones in later chunks; beyond this they are delivered as they come.
constexpr std::uint64_t kMaxPendingBytes = std::uint64_t{256} << 20;
// A bag without index is searched for topics this far when some kind of sensor is missing.
constexpr int kMaxProbedChunks = 64;
constexpr int kMinProbedChunks = 4;

[[nodiscard]] bool holds_lidar_imu_and_gnss(const std::vector<BagConnection>& connections) {
  const auto any = [&](std::string_view part) {
    return std::ranges::any_of(connections, [part](const BagConnection& connection) {
      return connection.type.find(part) != std::string::npos;
    });
  };
  return (any("/PointCloud2") || any("/CustomMsg")) && any("/Imu") && any("/NavSatFix");
}

}  // namespace

struct Rosbag1Reader::State {
  explicit State(BagFile opened) : file(std::move(opened)) {}

  BagFile file;
  std::size_t next_chunk = 0;                 ///< Into file.chunks() when the bag has an index.
  std::vector<Timestamp> earliest_from = {};  ///< Earliest start of chunk i and all after it.
  bool exhausted = false;
  Timestamp last_chunk_start = kNever;
  std::optional<std::set<std::string>> topics = {};
  // A vector kept sorted by descending time: the next message is at the back, equal times keep the
  // order of the file.
  std::vector<BagMessage> pending = {};
  std::uint64_t pending_bytes = 0;

  [[nodiscard]] bool wanted(const BagMessage& message) const;
  [[nodiscard]] Expected<void> load_chunk();
  void enqueue(std::vector<BagMessage> messages);
  [[nodiscard]] Timestamp earliest_to_come() const;
};

bool Rosbag1Reader::State::wanted(const BagMessage& message) const {
  if (!topics) return true;
  const BagConnection* connection = file.find_connection(message.connection);
  return connection != nullptr && topics->contains(connection->topic);
}

void Rosbag1Reader::State::enqueue(std::vector<BagMessage> messages) {
  last_chunk_start = kNever;
  for (const BagMessage& message : messages) {
    last_chunk_start = std::min(last_chunk_start, message.time);
  }
  std::erase_if(messages, [this](const BagMessage& message) { return !wanted(message); });
  for (const BagMessage& message : messages) pending_bytes += message.data.size();
  // Reversed, stable: equal times end up in file order when taken from the back.
  std::ranges::reverse(pending);
  pending.insert(pending.end(),
                 std::make_move_iterator(messages.begin()),
                 std::make_move_iterator(messages.end()));
  std::ranges::stable_sort(pending, {}, &BagMessage::time);
  std::ranges::reverse(pending);
}

Expected<void> Rosbag1Reader::State::load_chunk() {
  if (file.has_index()) {
    if (next_chunk == file.chunks().size()) {
      exhausted = true;
      return {};
    }
    HF_TRY(auto messages, file.read_chunk_at(file.chunks()[next_chunk].position));
    ++next_chunk;
    enqueue(std::move(messages));
    return {};
  }
  HF_TRY(auto messages, file.read_next_chunk());
  if (!messages) {
    exhausted = true;
  } else {
    enqueue(std::move(*messages));
  }
  return {};
}

Timestamp Rosbag1Reader::State::earliest_to_come() const {
  if (exhausted) return kNever;
  return file.has_index() ? (next_chunk < earliest_from.size() ? earliest_from[next_chunk] : kNever)
                          : last_chunk_start;
}

Rosbag1Reader::Rosbag1Reader(std::unique_ptr<State> state) : state_(std::move(state)) {}
Rosbag1Reader::Rosbag1Reader(Rosbag1Reader&&) noexcept = default;
Rosbag1Reader& Rosbag1Reader::operator=(Rosbag1Reader&&) noexcept = default;
Rosbag1Reader::~Rosbag1Reader() = default;

Expected<Rosbag1Reader> Rosbag1Reader::open(const std::filesystem::path& path) {
  HF_TRY(BagFile file, BagFile::open(path));
  if (!file.has_index()) {
    for (int chunk = 0; chunk < kMaxProbedChunks; ++chunk) {
      if (chunk >= kMinProbedChunks && holds_lidar_imu_and_gnss(file.connections())) break;
      HF_TRY(const auto messages, file.read_next_chunk());
      if (!messages) break;
    }
    file.rewind();
  }
  auto state = std::make_unique<State>(std::move(file));
  Timestamp earliest = kNever;
  state->earliest_from.resize(state->file.chunks().size());
  for (std::size_t i = state->earliest_from.size(); i-- > 0;) {
    earliest = std::min(earliest, state->file.chunks()[i].start);
    state->earliest_from[i] = earliest;
  }
  return Rosbag1Reader(std::move(state));
}

const std::vector<BagConnection>& Rosbag1Reader::connections() const {
  return state_->file.connections();
}

void Rosbag1Reader::select_topics(std::vector<std::string> topics) {
  state_->topics.emplace(std::make_move_iterator(topics.begin()),
                         std::make_move_iterator(topics.end()));
}

Expected<std::optional<BagMessage>> Rosbag1Reader::next() {
  State& state = *state_;
  while (!state.exhausted && state.pending_bytes <= kMaxPendingBytes &&
         (state.pending.empty() || state.pending.back().time > state.earliest_to_come())) {
    if (auto loaded = state.load_chunk(); !loaded) return std::unexpected(loaded.error());
  }
  if (state.pending.empty()) return std::nullopt;
  BagMessage message = std::move(state.pending.back());
  state.pending.pop_back();
  state.pending_bytes -= message.data.size();
  return message;
}

bool Rosbag1Reader::truncated() const {
  return state_->file.truncated();
}

const std::vector<std::string>& Rosbag1Reader::warnings() const {
  return state_->file.warnings();
}

}  // namespace hybridfusion
