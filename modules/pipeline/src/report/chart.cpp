#include "chart.hpp"

#include "html.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kLeft_px = 64.0;
constexpr double kRight_px = 14.0;
constexpr double kTop_px = 12.0;
constexpr double kBottom_px = 44.0;

void widen(Axis& axis) {
  if (!(std::isfinite(axis.min) && std::isfinite(axis.max))) axis.min = 0.0, axis.max = 1.0;
  if (axis.max > axis.min) return;
  axis.max = axis.min + std::max(1e-9, std::abs(axis.min)) * 0.1 + (axis.min == 0.0 ? 1.0 : 0.0);
}

double tick_step(double min, double max, int count) {
  const double raw = (max - min) / std::max(1, count);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

std::vector<double> ticks(double min, double max, int count) {
  std::vector<double> values;
  if (!(max > min) || !std::isfinite(max - min)) return values;
  const double step = tick_step(min, max, count);
  const double first = std::ceil(min / step - 1e-9);
  for (double k = first; k * step <= max + 1e-9 * step; k += 1.0) values.push_back(k * step);
  return values;
}

std::string tick_text(double value, double step) {
  if (std::abs(value) < 1e-9 * step) return "0";
  if (std::abs(value) >= 1e6 || step < 1e-4) return fmt::format("{:.3g}", value);
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  return fmt::format("{:.{}f}", value, digits);
}

Histogram histogram(std::span<const double> values, double min, double max, int bins) {
  Histogram result;
  const double step = (max - min) / bins;
  for (int i = 0; i <= bins; ++i) result.edges.push_back(min + step * i);
  result.counts.assign(static_cast<std::size_t>(bins), 0.0);
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const double bin = std::clamp((value - min) / step, 0.0, bins - 1.0);
    result.counts[static_cast<std::size_t>(bin)] += 1.0;
  }
  return result;
}

double quantile(std::vector<double> values, double share) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return 0.0;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::string ramp_color(double share) {
  constexpr std::array<std::array<double, 3>, 5> kStops = {
      {{44, 123, 182}, {0, 166, 160}, {125, 190, 80}, {240, 190, 60}, {205, 40, 35}}};
  const double at = std::clamp(std::isfinite(share) ? share : 1.0, 0.0, 1.0) * (kStops.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double t = at - static_cast<double>(k);
  std::string color = "#";
  for (std::size_t c = 0; c < 3; ++c) {
    color += fmt::format("{:02x}", std::lround((1.0 - t) * kStops[k][c] + t * kStops[k + 1][c]));
  }
  return color;
}

std::string ramp_legend(std::string_view low, std::string_view high) {
  std::string html = "<div class=ramp><span>" + escaped(low) + "</span>";
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    html += fmt::format("<i style='background:{}'></i>", ramp_color((i + 0.5) / kSteps));
  }
  return html + "<span>" + escaped(high) + "</span></div>\n";
}

Chart::Chart(Axis x, Axis y, double width_px, double height_px)
    : x_(std::move(x)), y_(std::move(y)), width_px_(width_px), height_px_(height_px) {
  widen(x_);
  widen(y_);
  draw_frame();
}

double Chart::page_x(double x) const {
  const double share = std::clamp((x - x_.min) / (x_.max - x_.min), 0.0, 1.0);
  return kLeft_px + share * (width_px_ - kLeft_px - kRight_px);
}

double Chart::page_y(double y) const {
  const double share = std::clamp((y - y_.min) / (y_.max - y_.min), 0.0, 1.0);
  return height_px_ - kBottom_px - share * (height_px_ - kTop_px - kBottom_px);
}

void Chart::draw_frame() {
  const double bottom = height_px_ - kBottom_px;
  const auto xs = ticks(x_.min, x_.max, static_cast<int>(width_px_ / 80.0));
  for (const double x : xs) {
    body_ += fmt::format(
        "<line class=g x1='{0:.1f}' x2='{0:.1f}' y1='{1:.1f}' y2='{2:.1f}'/>"
        "<text x='{0:.1f}' y='{3:.1f}' text-anchor=middle>{4}</text>\n",
        page_x(x),
        kTop_px,
        bottom,
        bottom + 15.0,
        tick_text(x, xs.size() > 1 ? xs[1] - xs[0] : 1.0));
  }
  const auto ys = ticks(y_.min, y_.max, static_cast<int>(height_px_ / 34.0));
  for (const double y : ys) {
    body_ += fmt::format(
        "<line class=g x1='{0:.1f}' x2='{1:.1f}' y1='{2:.1f}' y2='{2:.1f}'/>"
        "<text x='{3:.1f}' y='{4:.1f}' text-anchor=end>{5}</text>\n",
        kLeft_px,
        width_px_ - kRight_px,
        page_y(y),
        kLeft_px - 6.0,
        page_y(y) + 4.0,
        tick_text(y, ys.size() > 1 ? ys[1] - ys[0] : 1.0));
  }
  overlay_ += fmt::format("<text class=t x='{:.1f}' y='{:.1f}' text-anchor=middle>{}</text>\n",
                          0.5 * (kLeft_px + width_px_ - kRight_px),
                          height_px_ - 8.0,
                          escaped(x_.title));
  overlay_ += fmt::format(
      "<text class=t transform='translate(14 {:.1f}) rotate(-90)' text-anchor=middle>{}</text>\n",
      0.5 * (kTop_px + bottom),
      escaped(y_.title));
}

void Chart::bars(std::span<const double> edges,
                 std::span<const double> heights,
                 std::string_view color) {
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double left = page_x(edges[i]);
    const double right = page_x(edges[i + 1]);
    const double top = page_y(std::max(0.0, heights[i]));
    const double base = page_y(std::min(0.0, heights[i]));
    if (base - top <= 0.0) continue;
    body_ += fmt::format("<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='{}'/>\n",
                         left + 0.4,
                         top,
                         std::max(0.6, right - left - 0.8),
                         base - top,
                         color);
  }
}

void Chart::line(std::span<const Eigen::Vector2d> points, std::string_view color, double width_px) {
  if (points.empty()) return;
  body_ += fmt::format(
      "<polyline fill=none stroke='{}' stroke-width='{}' stroke-linejoin=round points='",
      color,
      width_px);
  for (const Eigen::Vector2d& point : points) {
    body_ += fmt::format("{:.1f},{:.1f} ", page_x(point.x()), page_y(point.y()));
  }
  body_ += "'/>\n";
}

void Chart::dots(std::span<const Eigen::Vector2d> points,
                 std::string_view color,
                 double radius_px) {
  // Round caps on lines without length: one path, a third of the bytes of circles.
  body_ +=
      fmt::format("<path stroke='{}' stroke-width='{}' stroke-linecap=round stroke-opacity=.75 d='",
                  color,
                  2.0 * radius_px);
  for (const Eigen::Vector2d& point : points) {
    if (!point.allFinite()) continue;
    body_ += fmt::format("M{:.1f} {:.1f}h0", page_x(point.x()), page_y(point.y()));
  }
  body_ += "'/>\n";
}

void Chart::band(double y_min, double y_max, std::string_view color) {
  const double top = page_y(y_max);
  body_ += fmt::format(
      "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='{}' fill-opacity='.13'/>\n",
      kLeft_px,
      top,
      width_px_ - kLeft_px - kRight_px,
      page_y(y_min) - top,
      color);
}

void Chart::upright(double x, std::string_view color, std::string_view label) {
  const double at = page_x(x);
  const bool to_left = at > 0.7 * width_px_;
  overlay_ += fmt::format(
      "<line x1='{0:.1f}' x2='{0:.1f}' y1='{1:.1f}' y2='{2:.1f}' stroke='{3}' "
      "stroke-dasharray='4 3'/><text x='{4:.1f}' y='{5:.1f}' fill='{3}' "
      "text-anchor={6}>{7}</text>\n",
      at,
      kTop_px,
      height_px_ - kBottom_px,
      color,
      at + (to_left ? -5.0 : 5.0),
      kTop_px + 11.0,
      to_left ? "end" : "start",
      escaped(label));
}

void Chart::legend(std::span<const std::pair<std::string, std::string_view>> entries) {
  constexpr double kRow_px = 16.0;
  constexpr double kLetter_px = 6.6;
  std::size_t longest = 0;
  for (const auto& entry : entries) longest = std::max(longest, entry.first.size());
  const double width_px = 30.0 + kLetter_px * static_cast<double>(longest);
  overlay_ += fmt::format(
      "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='#fff' "
      "fill-opacity='.82'/>\n",
      width_px_ - kRight_px - width_px,
      kTop_px,
      width_px,
      4.0 + kRow_px * static_cast<double>(entries.size()));
  double y = kTop_px + 14.0;
  for (const auto& [name, color] : entries) {
    overlay_ += fmt::format(
        "<circle cx='{:.1f}' cy='{:.1f}' r='4.5' fill='{}'/>"
        "<text x='{:.1f}' y='{:.1f}' text-anchor=end>{}</text>\n",
        width_px_ - kRight_px - 10.0,
        y - 4.0,
        color,
        width_px_ - kRight_px - 20.0,
        y,
        escaped(name));
    y += kRow_px;
  }
}

std::string Chart::svg() const {
  return fmt::format("<svg class=chart viewBox='0 0 {0:.0f} {1:.0f}' width='{0:.0f}' role=img>\n",
                     width_px_,
                     height_px_) +
         body_ + overlay_ +
         fmt::format(
             "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill=none "
             "stroke='#9aa3ad'/>"
             "</svg>\n",
             kLeft_px,
             kTop_px,
             width_px_ - kLeft_px - kRight_px,
             height_px_ - kTop_px - kBottom_px);
}

}  // namespace hybridfusion
