#include "plan_map.hpp"

#include "chart.hpp"
#include "html.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMaxHeight_px = 820.0;

/// 1, 2 or 5 times a power of ten metres, at most a quarter of the page.
double bar_length_m(double width_m) {
  const double most = 0.25 * width_m;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= most) return factor * power;
  }
  return power;
}

}  // namespace

PlanMap::PlanMap(const Eigen::AlignedBox2d& box, double width_px, Orientation orientation)
    : box_(box), orientation_(orientation) {
  const Eigen::Vector2d size = box.sizes().cwiseMax(1.0);
  box_.max() = box_.min() + size;
  px_per_m_ = std::min(width_px / size.x(), kMaxHeight_px / size.y());
  width_px_ = size.x() * px_per_m_;
  height_px_ = size.y() * px_per_m_;
}

Eigen::Vector2d PlanMap::page(const Eigen::Vector2d& at) const {
  return {(at.x() - box_.min().x()) * px_per_m_, (box_.max().y() - at.y()) * px_per_m_};
}

void PlanMap::background(const std::string& data_uri, double opacity) {
  body_ += fmt::format(
      "<image href='{}' x=0 y=0 width='{:.1f}' height='{:.1f}' opacity='{}' "
      "preserveAspectRatio=none />\n",
      data_uri,
      width_px_,
      height_px_,
      opacity);
}

void PlanMap::line(std::span<const Eigen::Vector2d> points,
                   std::string_view color,
                   double width_px) {
  body_ += fmt::format(
      "<polyline fill=none stroke='{}' stroke-width='{}' stroke-linejoin=round points='",
      color,
      width_px);
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d at = page(point);
    body_ += fmt::format("{:.1f},{:.1f} ", at.x(), at.y());
  }
  body_ += "'/>\n";
}

void PlanMap::polygon(std::span<const Eigen::Vector2d> corners,
                      std::string_view fill,
                      double fill_opacity,
                      std::string_view stroke) {
  body_ += "<polygon points='";
  for (const Eigen::Vector2d& corner : corners) {
    const Eigen::Vector2d at = page(corner);
    body_ += fmt::format("{:.1f},{:.1f} ", at.x(), at.y());
  }
  body_ += fmt::format("' fill='{}' fill-opacity='{}' stroke='{}' stroke-width='.8'/>\n",
                       fill,
                       fill_opacity,
                       stroke);
}

void PlanMap::dot(const Eigen::Vector2d& at,
                  std::string_view color,
                  double radius_px,
                  std::string_view name) {
  const Eigen::Vector2d p = page(at);
  body_ += fmt::format(
      "<circle cx='{:.1f}' cy='{:.1f}' r='{}' fill='{}'", p.x(), p.y(), radius_px, color);
  body_ += name.empty() ? "/>\n" : fmt::format("><title>{}</title></circle>\n", escaped(name));
}

void PlanMap::ring(const Eigen::Vector2d& at, std::string_view color, double radius_px) {
  const Eigen::Vector2d p = page(at);
  body_ += fmt::format(
      "<circle cx='{:.1f}' cy='{:.1f}' r='{}' fill=none stroke='{}' stroke-width='1.4'/>\n",
      p.x(),
      p.y(),
      radius_px,
      color);
}

void PlanMap::square(const Eigen::Vector2d& corner, double side_m, std::string_view color) {
  const Eigen::Vector2d p = page(corner + Eigen::Vector2d(0.0, side_m));
  const double side = side_m * px_per_m_;
  body_ += fmt::format(
      "<rect x='{:.1f}' y='{:.1f}' width='{:.2f}' height='{:.2f}' fill='{}' "
      "shape-rendering=crispEdges />\n",
      p.x(),
      p.y(),
      side + 0.1,
      side + 0.1,
      color);
}

std::string PlanMap::svg() const {
  const double bar_m = bar_length_m(box_.sizes().x());
  const double y = height_px_ - 14.0;
  std::string svg =
      fmt::format("<svg class=map viewBox='0 0 {0:.1f} {1:.1f}' width='{0:.0f}' role=img>\n{2}",
                  width_px_,
                  height_px_,
                  body_);
  svg += fmt::format(
      "<g class=scale><rect x=6 y='{0:.1f}' width='{1:.1f}' height=26 rx=4 fill='#fff' "
      "fill-opacity='.85'/><line x1=14 x2='{2:.1f}' y1='{3:.1f}' y2='{3:.1f}' stroke='#222' "
      "stroke-width=2 /><text x='{4:.1f}' y='{5:.1f}'>{6:g} m</text></g>\n",
      y - 13.0,
      bar_m * px_per_m_ + 62.0,
      14.0 + bar_m * px_per_m_,
      y,
      20.0 + bar_m * px_per_m_,
      y + 4.0,
      bar_m);
  if (orientation_ == Orientation::kOwnFrame) return svg + "</svg>\n";
  svg += fmt::format(
      "<g class=scale transform='translate({:.1f} 8)'><rect x='-14' y='-4' width=28 height=36 rx=4 "
      "fill='#fff' fill-opacity='.85'/><path d='M0 0l6 15h-12z' fill='#222'/>"
      "<text y=28 text-anchor=middle>N</text></g></svg>\n",
      width_px_ - 22.0);
  return svg;
}

std::string cloud_from_above(const PointCloud& cloud, const Eigen::AlignedBox2d& box) {
  constexpr int kWidth_px = 900;
  if (cloud.empty()) return {};
  Splatter splatter(view_from_above(box, kWidth_px));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    splatter.add(cloud.points[i], cloud.colors.empty() ? Rgb8{120, 120, 120} : cloud.colors[i], 1);
  }
  return data_uri(splatter.image({70, 76, 84})).value_or("");
}

Eigen::AlignedBox2d trimmed_box(std::span<const Eigen::Vector3f> points,
                                double share,
                                double margin_m) {
  if (points.empty()) return {};
  constexpr std::size_t kMaxSamples = 200000;
  const std::size_t step = 1 + points.size() / kMaxSamples;
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < points.size(); i += step) {
    x.push_back(points[i].x());
    y.push_back(points[i].y());
  }
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(margin_m);
  return {Eigen::Vector2d(quantile(x, share), quantile(y, share)) - margin,
          Eigen::Vector2d(quantile(x, 1.0 - share), quantile(y, 1.0 - share)) + margin};
}

}  // namespace hybridfusion
