#pragma once

#include "scalar_type.hpp"

#include <hybridfusion/io/point_cloud2.hpp>

#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// The time field of one scan as the message has it; no values when there is no such field.
struct RawPointTimes {
  std::string_view field = {};
  ScalarType type = ScalarType::kFloat32;
  std::vector<double> values = {};  ///< One per point of the scan.
  std::string missing = {};         ///< Why there are none, if the reader of the scan knows.
};

/// Fills LidarPoint::offset_ns. What the time field means (unit, relative or absolute) is decided
/// at the first scan that tells, by its span: a scan lasts about 0.01 to 0.5 s, so only one of s,
/// ms, us, ns fits. Without usable times they are synthesised; times are also unusable when they
/// span another time than the scans are apart, unless their unit was given.
class PointTimeReader {
 public:
  explicit PointTimeReader(PointTimeOptions options) : options_(std::move(options)) {}

  [[nodiscard]] const PointTimeOptions& options() const { return options_; }
  /// Index of the field to read: the one asked for, else the first of the known names.
  [[nodiscard]] std::optional<std::size_t> choose_field(std::span<const std::string> names) const;

  /// Sets the offsets; drops points whose time is impossible (more than 1 s off the stamp).
  void assign(LidarScan& scan, const RawPointTimes& raw);

  [[nodiscard]] const std::string& description() const { return description_; }
  [[nodiscard]] bool made_up() const { return made_up_; }
  [[nodiscard]] std::vector<std::string> take_warnings();
  void warn_once(std::string text);

 private:
  enum class Clock : std::uint8_t {
    kFromStamp,  ///< Seconds after (or before) the header stamp.
    kAbsolute,   ///< The clock of the header stamp.
    kForeign     ///< A clock of its own; its first point is taken for the stamp.
  };
  struct Format {
    double unit_ns = 1.0;
    Clock clock = Clock::kFromStamp;
  };
  struct Extent {
    std::size_t count = 0;  ///< Of points with a return and a finite time.
    double low = 0.0;
    double high = 0.0;
    bool varies = false;  ///< At least four different values.
  };

  [[nodiscard]] static Extent measure(const LidarScan& scan, std::span<const double> values);
  [[nodiscard]] std::optional<Format> detect(const LidarScan& scan,
                                             const RawPointTimes& raw,
                                             const Extent& extent);
  [[nodiscard]] bool fits_period(const Extent& extent) const;
  void convert(LidarScan& scan, std::span<const double> values, const Extent& extent);
  void synthesize(LidarScan& scan, std::string_view why);
  void note_stamp(Timestamp stamp);
  [[nodiscard]] Timestamp scan_period() const;

  PointTimeOptions options_;
  std::optional<Format> format_ = {};
  int num_misfits_ = 0;  ///< Scans in a row whose span does not fit their distance.
  std::string description_ = {};
  bool made_up_ = false;
  std::vector<std::string> warnings_ = {};
  std::set<std::string> told_ = {};
  std::optional<Timestamp> last_stamp_ = {};
  std::deque<Timestamp> stamp_gaps_ = {};
};

/// Offsets within a scan of a spinning LiDAR, from the azimuth of the points; nothing when the scan
/// is not a turn (fewer than 270 degrees seen). Direction and start are taken from the data.
[[nodiscard]] std::optional<std::vector<std::int32_t>> offsets_from_azimuth(
    std::span<const LidarPoint> points, Timestamp period);

/// True for a point with a return: finite and not at the sensor.
[[nodiscard]] bool has_return(const LidarPoint& point);

}  // namespace hybridfusion
