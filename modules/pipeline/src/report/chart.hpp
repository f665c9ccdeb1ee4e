#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Colours of the report, told apart by colour-blind readers too.
namespace ink {
inline constexpr std::string_view kVision = "#2471a3";
inline constexpr std::string_view kLidar = "#d35400";
inline constexpr std::string_view kBoth = "#239b56";
inline constexpr std::string_view kQuiet = "#8a929b";
inline constexpr std::string_view kAlarm = "#c0392b";
}  // namespace ink

/// Axis of a chart. Range of equal ends grows by itself.
struct Axis {
  std::string title = {};  ///< With the unit in brackets.
  double min = 0.0;
  double max = 1.0;
};

/// A rectangular diagram as inline SVG: open it, draw into it, take the text.
class Chart {
 public:
  Chart(Axis x, Axis y, double width_px = 620.0, double height_px = 250.0);

  void bars(std::span<const double> edges, std::span<const double> heights, std::string_view color);
  void line(std::span<const Eigen::Vector2d> points, std::string_view color, double width_px = 1.6);
  void dots(std::span<const Eigen::Vector2d> points,
            std::string_view color,
            double radius_px = 2.2);
  /// A filled band between two values of y.
  void band(double y_min, double y_max, std::string_view color);
  void upright(double x, std::string_view color, std::string_view label);
  /// Coloured names in the upper right corner.
  void legend(std::span<const std::pair<std::string, std::string_view>> entries);
  [[nodiscard]] std::string svg() const;

 private:
  [[nodiscard]] double page_x(double x) const;
  [[nodiscard]] double page_y(double y) const;
  void draw_frame();

  Axis x_;
  Axis y_;
  double width_px_;
  double height_px_;
  std::string body_ = {};
  std::string overlay_ = {};
};

/// Round numbers between the ends, about `count` of them.
[[nodiscard]] std::vector<double> ticks(double min, double max, int count);
/// "12", "0.25", "3e-05": as many digits as the step between ticks needs.
[[nodiscard]] std::string tick_text(double value, double step);

struct Histogram {
  std::vector<double> edges = {};
  std::vector<double> counts = {};
};
/// Values beyond the ends are counted in the outermost bins. @pre bins > 0 and max > min
[[nodiscard]] Histogram histogram(std::span<const double> values, double min, double max, int bins);

/// The value below which `share` of the values lie; 0 for none.
[[nodiscard]] double quantile(std::vector<double> values, double share);

/// Colour between blue (0), green, yellow and red (1) as "#rrggbb".
[[nodiscard]] std::string ramp_color(double share);
/// A strip of those colours with its ends named.
[[nodiscard]] std::string ramp_legend(std::string_view low, std::string_view high);

}  // namespace hybridfusion
