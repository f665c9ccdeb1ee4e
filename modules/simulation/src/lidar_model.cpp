#include "lidar_model.hpp"

#include "shading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kAviaHalfWidth = 35.2 * kDegree;   // 70.4 degrees wide
constexpr double kAviaHalfHeight = 38.6 * kDegree;  // 77.2 degrees high
constexpr int kAviaLines = 6;
constexpr float kDivergence_rad = 0.0025F;

struct Beam {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  double time_s = 0.0;  ///< Since the scan began.
  std::uint16_t ring = 0;
};

/// Column by column, every ring at once, starting behind the vehicle and turning clockwise.
Beam spinning_beam(const LidarModelOptions& options, int index) {
  const int column = index / options.beams;
  const int ring = index % options.beams;
  const double turn = static_cast<double>(column) / options.columns;
  const double azimuth = std::numbers::pi - 2.0 * std::numbers::pi * turn;
  const double elevation =
      kDegree * (options.lowest_deg +
                 (options.highest_deg - options.lowest_deg) * ring / (options.beams - 1));
  return {.direction = {std::cos(elevation) * std::cos(azimuth),
                        std::cos(elevation) * std::sin(azimuth),
                        std::sin(elevation)},
          .time_s = turn / options.rate_hz,
          .ring = static_cast<std::uint16_t>(ring)};
}

/// Rosette of two rotating prisms whose rates have no common period; six lines side by side.
Beam avia_beam(const LidarModelOptions& options, std::uint64_t scan, int index) {
  const int firing = index / kAviaLines;
  const int line = index % kAviaLines;
  const int firings = options.avia_rays / kAviaLines;
  const double time_s = static_cast<double>(firing) / firings / options.rate_hz;
  const double t = static_cast<double>(scan) / options.rate_hz + time_s;
  const double spin = 2.0 * std::numbers::pi * 7.0 * std::numbers::phi * t;
  const double petal = 2.0 * std::numbers::pi * 100.3 * t;
  const double r = std::sin(petal + 0.35 * spin);
  const double tilt = 0.006 * (line - 2.5);
  const double azimuth = kAviaHalfWidth * r * std::cos(spin) + tilt * std::sin(spin);
  const double elevation = kAviaHalfHeight * r * std::sin(spin) - tilt * std::cos(spin);
  return {.direction = {std::cos(elevation) * std::cos(azimuth),
                        std::cos(elevation) * std::sin(azimuth),
                        std::sin(elevation)},
          .time_s = time_s,
          .ring = static_cast<std::uint16_t>(line)};
}

/// Chance that a return is strong enough: falls with range, dark surfaces and grazing incidence.
double detection_chance(const LidarModelOptions& options,
                        const Surface& surface,
                        double range_m,
                        double incidence_cosine) {
  if (surface.material == Material::kGlass) return incidence_cosine > 0.96 ? 0.5 : 0.12;
  if (incidence_cosine < 0.03) return 0.1;
  const double white = 0.8;
  const double echo = surface.lidar_reflectivity / white * std::min(1.0, 1.6 * incidence_cosine);
  const double ratio = options.max_range_m / range_m;
  const double strength = echo * ratio * ratio;
  return 0.985 * strength * strength / (strength * strength + 0.35);
}

constexpr float kNear_m = 0.2F;
/// Share of the returns whose beam is looked at for a second surface under its rim.
constexpr double kRimShare = 0.2;

struct Ray {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;
};

/// The rim of the beam may touch something else: a few such returns mix the two ranges.
/// @param edge Draw in [0, kRimShare): which side of the beam, and how much of the other surface.
double rim_error_m(
    const RayTracer& tracer, const Ray& ray, double range_m, double edge, float far_m) {
  const Eigen::Vector3f side = ray.direction.unitOrthogonal();
  const auto angle = static_cast<float>(2.0 * std::numbers::pi * edge / kRimShare);
  const Eigen::Vector3f rim =
      (ray.direction +
       kDivergence_rad * (std::cos(angle) * side + std::sin(angle) * ray.direction.cross(side)))
          .normalized();
  const RayHit other = tracer.cast(ray.origin, rim, kNear_m, far_m);
  const double gap = static_cast<double>(other.distance_m) - range_m;
  const bool mixes = other.face != kNoFace && std::abs(gap) > 0.15 && std::abs(gap) < 2.0;
  return mixes ? gap * (0.15 + 3.5 * edge) : 0.0;
}

}  // namespace

bool in_field_of_view(const LidarModelOptions& options, const Eigen::Vector3d& point) {
  const double range = point.norm();
  if (range < options.min_range_m || range > options.max_range_m) return false;
  const double elevation = std::asin(std::clamp(point.z() / range, -1.0, 1.0));
  if (options.model == "spinning") {
    return elevation >= kDegree * (options.lowest_deg - 0.6) &&
           elevation <= kDegree * (options.highest_deg + 0.6);
  }
  const double azimuth = std::atan2(point.y(), point.x());
  const double across = azimuth / kAviaHalfWidth;
  const double up = elevation / kAviaHalfHeight;
  return across * across + up * up <= 1.0;
}

std::vector<LidarReturn> scan_scene(const Scene& scene,
                                    const RayTracer& tracer,
                                    const VehicleMotion& motion,
                                    const LidarSetup& setup,
                                    std::uint64_t scan,
                                    double start_s) {
  const LidarModelOptions& options = setup.options;
  Random random(setup.seed, "lidar/noise", (setup.drive << 32U) + scan);
  const bool spinning = options.model == "spinning";
  const int rays =
      spinning ? options.beams * options.columns : options.avia_rays / kAviaLines * kAviaLines;
  std::vector<LidarReturn> returns;
  returns.reserve(static_cast<std::size_t>(rays));
  double pose_time = -1.0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();
  for (int index = 0; index < rays; ++index) {
    const Beam beam = spinning ? spinning_beam(options, index) : avia_beam(options, scan, index);
    if (beam.time_s != pose_time) {
      pose_time = beam.time_s;
      const Rigid3 pose = motion.at(start_s + pose_time).world_from_body * setup.body_from_lidar;
      rotation = pose.rotation.toRotationMatrix();
      origin = pose.translation.cast<float>();
    }
    // The same number of draws for every ray keeps the stream in step with the beams.
    const double noise = random.normal();
    const double chance = random.uniform();
    const double edge = random.uniform();
    const double flicker = random.uniform(0.9, 1.1);
    const Eigen::Vector3f direction = (rotation * beam.direction).cast<float>().normalized();
    const auto far = static_cast<float>(options.max_range_m);
    const RayHit hit = tracer.cast(origin, direction, kNear_m, far);
    if (hit.face == kNoFace || hit.distance_m < options.min_range_m) continue;
    const Surface& surface = scene.surfaces[scene.face_surface[hit.face]];
    const double cosine =
        std::min(1.0, static_cast<double>(std::abs(face_normal(scene, hit.face).dot(direction))));
    double range = static_cast<double>(hit.distance_m);
    if (chance > detection_chance(options, surface, range, cosine)) continue;
    if (edge < kRimShare) range += rim_error_m(tracer, {origin, direction}, range, edge, far);
    range += options.range_sd_m * noise;
    const Eigen::Vector3d point = range * beam.direction;
    LidarReturn out;
    // Drivers send a fixed grid; 1/256 m.
    out.point = (256.0 * point).array().round().matrix().cast<float>() / 256.0F;
    out.intensity = static_cast<float>(
        std::clamp(std::round(255.0 * static_cast<double>(surface.lidar_reflectivity) *
                              (0.35 + 0.65 * cosine) * flicker),
                   1.0,
                   255.0));
    out.offset_ns = static_cast<std::int32_t>(std::lround(1e9 * beam.time_s));
    out.ring = beam.ring;
    returns.push_back(out);
  }
  return returns;
}

}  // namespace hybridfusion
