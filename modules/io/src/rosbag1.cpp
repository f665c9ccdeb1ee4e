#include "bag_file.hpp"
#include "message_merger.hpp"

#include <hybridfusion/io/rosbag1.hpp>

namespace hybridfusion {

struct Rosbag1Reader::State {
  explicit State(MessageMerger<BagFile> opened) : messages(std::move(opened)) {}
  MessageMerger<BagFile> messages;
};

Rosbag1Reader::Rosbag1Reader(std::unique_ptr<State> state) : state_(std::move(state)) {}
Rosbag1Reader::Rosbag1Reader(Rosbag1Reader&&) noexcept = default;
Rosbag1Reader& Rosbag1Reader::operator=(Rosbag1Reader&&) noexcept = default;
Rosbag1Reader::~Rosbag1Reader() = default;

Expected<Rosbag1Reader> Rosbag1Reader::open(const std::filesystem::path& path,
                                            const std::filesystem::path& name) {
  HF_TRY(BagFile file, BagFile::open(path, name));
  HF_TRY(auto messages, MessageMerger<BagFile>::create(std::move(file)));
  return Rosbag1Reader(std::make_unique<State>(std::move(messages)));
}

const std::vector<BagConnection>& Rosbag1Reader::connections() const {
  return state_->messages.connections();
}

void Rosbag1Reader::select_topics(std::vector<std::string> topics) {
  state_->messages.select_topics(std::move(topics));
}

Expected<std::optional<BagMessage>> Rosbag1Reader::next() {
  return state_->messages.next();
}

bool Rosbag1Reader::truncated() const {
  return state_->messages.truncated();
}

const std::vector<std::string>& Rosbag1Reader::warnings() const {
  return state_->messages.warnings();
}

}  // namespace hybridfusion
