#pragma once

#include <hybridfusion/core/time.hpp>

#include <cstdint>
#include <unordered_map>

namespace hybridfusion {

/// Times of recording, made fit to order messages by. Messages of one connection stand in a file in
/// the order in which they came, whatever their times say: a time that goes back (0 before a
/// simulated clock runs, a clock that was set) keeps the place of its message; one that cannot be
/// (a negative difference written without sign) likewise.
class RecordedClock {
 public:
  /// @param time  Of the next message of this connection in the file.
  [[nodiscard]] Timestamp place(std::uint32_t connection, Timestamp time);

 private:
  struct State {
    Timestamp last{};   ///< The latest that others agree with.
    Timestamp shift{};  ///< Added since the clock was set back for good.
    Timestamp run_first{};
    Timestamp run_last{};
    int run = 0;  ///< Messages in a row that agree with each other, not with `last`.
  };

  std::unordered_map<std::uint32_t, State> states_ = {};
};

}  // namespace hybridfusion
