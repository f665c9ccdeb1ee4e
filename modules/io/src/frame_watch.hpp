#pragma once

#include <hybridfusion/core/time.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// Tells sensors that share a topic apart by the frame_id of their headers (of Livox units also by
/// their number). A driver that was restarted under another name is one sensor: its frames follow
/// each other, those of several sensors alternate.
class FrameWatch {
 public:
  /// @param sensor  "LiDAR". @param option  What chooses a frame, "lidar_frame".
  /// @param chosen  The frame to take; empty: the only one.
  FrameWatch(std::string_view sensor, std::string_view option, std::string chosen);

  /// Counts a message of `frame`. @returns whether it is of the sensor to read.
  [[nodiscard]] bool admit(std::string_view frame, Timestamp recorded);

  /// The frames alternate and none was chosen.
  [[nodiscard]] bool undecided() const;
  /// A frame was chosen that no message had.
  [[nodiscard]] bool missed() const;
  /// Frames without a choice, one after the other.
  [[nodiscard]] bool changed() const { return chosen_.empty() && frames_.size() > 1; }

  /// What undecided(), missed() or changed() mean for a person, with the remedy.
  [[nodiscard]] std::string describe(std::string_view topic) const;

 private:
  struct Frame {
    std::string name;
    std::uint64_t messages = 0;
    Timestamp last{};
  };

  [[nodiscard]] std::string list() const;

  std::string_view sensor_;
  std::string_view option_;
  std::string chosen_;
  std::vector<Frame> frames_ = {};
  std::size_t current_ = 0;
  std::uint64_t admitted_ = 0;
  std::uint64_t returns_ = 0;        ///< To a frame that had been left.
  std::uint64_t quick_returns_ = 0;  ///< After less than a driver needs to restart.
};

}  // namespace hybridfusion
