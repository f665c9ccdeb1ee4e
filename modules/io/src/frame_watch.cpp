#include "frame_watch.hpp"

#include "text.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// Two restarts of a driver take longer than this; sensors that alternate do not.
constexpr std::chrono::seconds kQuick{2};
constexpr std::uint64_t kQuickReturns = 2;
// Nobody renames a driver to and fro so often in one recording.
constexpr std::uint64_t kReturns = 3;
// A topic of more frames than any vehicle has sensors; the rest is counted together.
constexpr std::size_t kMaxFrames = 64;

/// tf2 knows no leading slash; drivers of the time of tf wrote one.
[[nodiscard]] std::string_view plain(std::string_view frame) {
  if (frame.starts_with('/')) frame.remove_prefix(1);
  return frame;
}

/// "livox_frame#2" is also called "livox_frame".
[[nodiscard]] bool is_called(std::string_view frame, std::string_view asked) {
  return frame == asked || frame.substr(0, frame.rfind('#')) == asked;
}

}  // namespace

FrameWatch::FrameWatch(std::string_view sensor, std::string_view option, std::string chosen)
    : sensor_(sensor), option_(option), chosen_(plain(chosen)) {}

bool FrameWatch::admit(std::string_view frame, Timestamp recorded) {
  frame = plain(frame);
  auto found = std::ranges::find(frames_, frame, &Frame::name);
  if (found == frames_.end() && frames_.size() == kMaxFrames) found = frames_.end() - 1;
  const bool is_new = found == frames_.end();
  if (is_new) {
    frames_.push_back({.name = std::string(frame)});
    found = frames_.end() - 1;
  }
  const auto index = static_cast<std::size_t>(found - frames_.begin());
  if (!is_new && index != current_) {
    ++returns_;
    if (std::chrono::abs(recorded - found->last) <= kQuick) ++quick_returns_;
  }
  current_ = index;
  ++found->messages;
  found->last = recorded;
  const bool admitted = chosen_.empty() || is_called(frame, chosen_);
  if (admitted) ++admitted_;
  return admitted;
}

bool FrameWatch::undecided() const {
  return chosen_.empty() && (quick_returns_ >= kQuickReturns || returns_ >= kReturns);
}

bool FrameWatch::missed() const {
  return !chosen_.empty() && admitted_ == 0 && !frames_.empty();
}

std::string FrameWatch::list() const {
  std::string text;
  for (const Frame& frame : frames_) {
    text += fmt::format(
        "{}'{}' ({} messages)", text.empty() ? "" : ", ", printable(frame.name), frame.messages);
  }
  return text;
}

std::string FrameWatch::describe(std::string_view topic) const {
  if (missed()) {
    return fmt::format("no message of {} has the frame_id '{}'; there are {}; correct {}",
                       printable(std::string(topic)),
                       printable(chosen_),
                       list(),
                       option_);
  }
  if (undecided()) {
    return fmt::format(
        "several {} sensors send on {}, told apart by frame_id: {}; choose one with "
        "lidar.recording.{} (or {} in sensors.yaml)",
        sensor_,
        printable(std::string(topic)),
        list(),
        option_,
        option_);
  }
  return fmt::format("the frame_id of {} changes, {}: taken for one {} that was restarted",
                     printable(std::string(topic)),
                     list(),
                     sensor_);
}

}  // namespace hybridfusion
