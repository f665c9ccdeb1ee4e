#include "imu_vibration.hpp"

#include <hybridfusion/core/random.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

/// Root mean square within a band of frequencies: accel x y z [m/s^2], gyro x y z [rad/s].
struct Band {
  double low_hz;
  double high_hz;
  std::array<double, 6> rms;
};

// Measured on the 100 Hz record of KITTI raw, 2011_09_29 (OXTS RT3003 in a station wagon; 110 s,
// of which 79 s at 1 to 6 m/s, mean 2.8 m/s), Welch's method with windows of 2.56 s. Below 2 Hz the
// car itself moves, which the simulated motion does; above 46 Hz the record is filtered.
constexpr double kMeasuredSpeed_mps = 2.8;
constexpr std::array<Band, 11> kRoad = {
    {{2, 4, {0.0405, 0.0881, 0.1139, 0.0040, 0.0040, 0.0017}},
     {4, 7, {0.0167, 0.0275, 0.0478, 0.0019, 0.0011, 0.0005}},
     {7, 10, {0.0135, 0.0140, 0.0205, 0.0007, 0.0005, 0.0003}},
     {10, 13, {0.0157, 0.0171, 0.0127, 0.0004, 0.0003, 0.0002}},
     {13, 17, {0.0165, 0.0231, 0.0158, 0.0005, 0.0003, 0.0002}},
     {17, 21, {0.0069, 0.0156, 0.0095, 0.0004, 0.0003, 0.0001}},
     {21, 26, {0.0063, 0.0154, 0.0108, 0.0003, 0.0003, 0.0002}},
     {26, 31, {0.0085, 0.0104, 0.0141, 0.0003, 0.0008, 0.0001}},
     {31, 36, {0.0048, 0.0036, 0.0097, 0.0002, 0.0006, 0.0001}},
     {36, 41, {0.0017, 0.0025, 0.0020, 0.0001, 0.0001, 0.0001}},
     {41, 46, {0.0012, 0.0021, 0.0026, 0.0001, 0.0001, 0.0001}}}};
// The same record at rest (5.3 s): the engine idles, one line at 24.8 Hz stands out.
constexpr std::array<Band, 1> kEngine = {
    {{24.6, 25.0, {0.0077, 0.0059, 0.0087, 0.0002, 0.0004, 0.0002}}}};
constexpr int kTonesPerBand = 3;  // enough for the sum to look normal

}  // namespace

CarVibration::CarVibration(std::uint64_t seed, std::uint64_t index) {
  Random random(seed, "imu/vibration", index);
  const auto fill = [&random](const auto& bands, std::vector<Tone>& tones) {
    for (const Band& band : bands) {
      for (int i = 0; i < kTonesPerBand; ++i) {
        Tone tone{.frequency_hz = random.uniform(band.low_hz, band.high_hz)};
        for (Eigen::Index k = 0; k < 6; ++k) {
          // The square of a tone's rms is half that of its amplitude.
          tone.amplitude[k] =
              band.rms[static_cast<std::size_t>(k)] * std::sqrt(2.0 / kTonesPerBand);
          tone.phase_rad[k] = random.uniform(0.0, 2.0 * std::numbers::pi);
        }
        tones.push_back(tone);
      }
    }
  };
  fill(kRoad, road_);
  fill(kEngine, engine_);
}

Vibration CarVibration::sum(const std::vector<Tone>& tones, double time_s) {
  Vibration out;
  for (const Tone& tone : tones) {
    const double turn = 2.0 * std::numbers::pi * tone.frequency_hz * time_s;
    for (Eigen::Index k = 0; k < 3; ++k) {
      out.accel_mps2[k] += tone.amplitude[k] * std::sin(turn + tone.phase_rad[k]);
      out.gyro_radps[k] += tone.amplitude[k + 3] * std::sin(turn + tone.phase_rad[k + 3]);
    }
  }
  return out;
}

Vibration CarVibration::at(double time_s, double speed_mps) const {
  // Of a road whose roughness falls with the square of the spatial frequency (ISO 8608, waviness 2)
  // the power at a fixed frequency in time grows with the speed.
  const double share = std::sqrt(speed_mps / kMeasuredSpeed_mps);
  const Vibration road = sum(road_, time_s);
  const Vibration engine = sum(engine_, time_s);
  return {.accel_mps2 = share * road.accel_mps2 + engine.accel_mps2,
          .gyro_radps = share * road.gyro_radps + engine.gyro_radps};
}

}  // namespace hybridfusion
