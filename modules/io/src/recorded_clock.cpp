#include "recorded_clock.hpp"

namespace hybridfusion {
namespace {

using std::chrono::seconds;

// Beyond the year 2096: no recorder's clock, but what becomes of a small negative number.
constexpr Timestamp kAbsurd{4'000'000'000'000'000'000};
constexpr Timestamp kMaxGap = seconds(10);
constexpr int kRunToBelieve = 5;
// Messages that a program wrote out of their order, or chunks that overlap: sorted, as they stand.
constexpr Timestamp kOutOfOrder = seconds(1);

}  // namespace

Timestamp RecordedClock::place(std::uint32_t connection, Timestamp time) {
  const auto [found, is_first] = states_.try_emplace(connection);
  State& state = found->second;
  const bool absurd = time > kAbsurd || time < Timestamp{};
  if (is_first) {
    state.last = absurd ? Timestamp{} : time;
    return state.last;
  }
  if (absurd) return state.last;
  const Timestamp shifted = time + state.shift;
  if (shifted >= state.last && shifted <= state.last + kMaxGap) {
    state.run = 0;
    state.last = shifted;
    return shifted;
  }
  if (shifted < state.last && shifted >= state.last - kOutOfOrder) return shifted;
  const bool goes_on =
      state.run > 0 && shifted >= state.run_last && shifted <= state.run_last + kMaxGap;
  if (!goes_on) state.run_first = shifted;
  state.run = goes_on ? state.run + 1 : 1;
  state.run_last = shifted;
  const bool ahead = shifted > state.last;
  if (state.run < kRunToBelieve) return ahead ? shifted : state.last;
  // A pause, or a clock that was set back for good; the latter goes on where it was.
  if (!ahead) {
    const Timestamp gap = (state.run_last - state.run_first) / (state.run - 1);
    state.shift += state.last + gap - state.run_first;
  }
  state.last = time + state.shift;
  state.run = 0;
  return state.last;
}

}  // namespace hybridfusion
