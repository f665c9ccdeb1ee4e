#pragma once

#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/io/scan_source.hpp>

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

[[nodiscard]] Timestamp& stamp_of(SensorMessage& message);

/// Says in the summary's warnings what was wrong with its stamps.
void add_stamp_warnings(RecordingSummary& summary);

/// Clocks that were set back or ahead while recording, as one sensor shows them to the others.
struct ClockStep {
  Timestamp recorded{};  ///< When.
  Timestamp step{};      ///< After minus before.
};

/// Lets the messages of one sensor pass in strictly ascending time. A single stamp that is off
/// moves nothing but its own message: one that is ahead waits for its time, one that is late is
/// left out. Only a run of messages that agree with each other over a second is believed: a pause
/// where the times of recording say so too, else a clock that was set, whose stamps are shifted to
/// go on.
class StampGate {
 public:
  /// @param sensor  "IMU". @param confirm  How long a run must last to be believed.
  /// @param steps  What other gates found, and where to add what this one finds.
  StampGate(std::string_view sensor, Timestamp confirm, std::vector<ClockStep>& steps)
      : sensor_(sensor), confirm_(confirm), steps_(&steps) {}

  /// A message in the order of recording. A stamp of zero is replaced by the time of recording, at
  /// the distance that the stamps of this sensor keep from it.
  void add(SensorMessage message, Timestamp recorded);
  /// No more will come.
  void finish();
  /// What may pass.
  [[nodiscard]] std::optional<SensorMessage> take();

  [[nodiscard]] const StampFaults& faults() const { return faults_; }
  [[nodiscard]] std::vector<std::string> take_warnings();

 private:
  struct Held {
    SensorMessage message = {};
    Timestamp stamp{};
    Timestamp recorded{};
  };

  void start();
  void judge(Held held);
  void pass(Held held);
  void release(Held held);
  void hold(Held held);
  [[nodiscard]] bool shows_step(const Held& held) const;
  [[nodiscard]] bool run_believed() const;
  void believe_run();
  void give_up_run();
  void park(Held held);
  [[nodiscard]] Timestamp max_gap() const;
  [[nodiscard]] Timestamp offset() const;  ///< Median of stamp minus time of recording.
  [[nodiscard]] Timestamp shared_step(Timestamp step, Timestamp recorded) const;
  void warn(std::string text);

  std::string_view sensor_;
  Timestamp confirm_;
  std::vector<ClockStep>* steps_;
  std::vector<Held> first_ = {};  ///< Until the start is known.
  bool started_ = false;
  std::optional<Timestamp> last_ = {};
  Timestamp shift_{};
  bool clock_stands_ = false;           ///< Stamps are made of the times of recording from now on.
  std::deque<Timestamp> gaps_ = {};     ///< Recent ones.
  std::deque<Timestamp> offsets_ = {};  ///< Recent ones.
  std::vector<Held> run_ = {};          ///< Not (yet) in line with what passed.
  std::vector<Held> parked_ = {};       ///< Ahead of their time; sorted by stamp.
  std::deque<SensorMessage> ready_ = {};
  StampFaults faults_ = {};
  std::vector<std::string> warnings_ = {};
};

}  // namespace hybridfusion
