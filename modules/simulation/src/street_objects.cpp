#include "street_objects.hpp"

#include <hybridfusion/core/random.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace hybridfusion {
namespace {

Surface plain_surface(Material material,
                      FaceLabel label,
                      Eigen::Vector3f color,
                      std::uint64_t seed,
                      float reflectivity) {
  Surface surface{.material = material, .label = label, .color = color};
  surface.seed = static_cast<std::uint32_t>(seed * 31U) + static_cast<std::uint32_t>(material);
  surface.lidar_reflectivity = reflectivity;
  return surface;
}

/// A leaf cluster: square of `size` around `center` with the given normal.
void build_leaf(const Eigen::Vector3d& center,
                const Eigen::Vector3d& normal,
                double size,
                std::uint32_t surface,
                MeshBuilder& builder) {
  const Eigen::Vector3d u = 0.5 * size * normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  builder.quad(center - u - v, center + u - v, center + u + v, center - u + v, surface);
}

Eigen::Vector3d random_direction(Random& random) {
  const double z = random.uniform(-1.0, 1.0);
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Above this height the sides of a car lean in to its roof.
constexpr double kCarWaist_m = 1.2;

Eigen::Vector3f car_paint(Random& random) {
  static constexpr std::array<std::array<float, 3>, 7> kPaints = {{{0.55F, 0.55F, 0.54F},
                                                                   {0.3F, 0.31F, 0.32F},
                                                                   {0.04F, 0.1F, 0.42F},
                                                                   {0.45F, 0.04F, 0.04F},
                                                                   {0.05F, 0.3F, 0.14F},
                                                                   {0.05F, 0.05F, 0.06F},
                                                                   {0.35F, 0.3F, 0.2F}}};
  const auto& paint = kPaints[random.index(kPaints.size())];
  return {paint[0], paint[1], paint[2]};
}

/// A side profile (x forward, y up) drawn out across the car; half widths below and above the
/// waist.
struct CarProfile {
  std::vector<Eigen::Vector2d> corners;
  double low_half_m = 0.0;
  double high_half_m = 0.0;

  [[nodiscard]] Eigen::Vector3d corner(std::size_t i, double side) const {
    const Eigen::Vector2d& p = corners[i % corners.size()];
    return {p.x(), side * (p.y() > kCarWaist_m ? high_half_m : low_half_m), p.y()};
  }
};

/// @param edges  Surface of the strip from each corner to the next.
void extrude(const CarProfile& profile,
             const GroundFrame& frame,
             const std::vector<std::uint32_t>& edges,
             std::uint32_t sides,
             MeshBuilder& builder) {
  const std::size_t count = profile.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    builder.quad(frame * profile.corner(i, -1.0),
                 frame * profile.corner(i, 1.0),
                 frame * profile.corner(i + 1, 1.0),
                 frame * profile.corner(i + 1, -1.0),
                 edges[i]);
  }
  for (const double s : {-1.0, 1.0}) {
    for (std::size_t i = 1; i + 1 < count; ++i) {
      builder.triangle(frame * profile.corner(0, s),
                       frame * profile.corner(s < 0 ? i : i + 1, s),
                       frame * profile.corner(s < 0 ? i + 1 : i, s),
                       sides);
    }
  }
}

void build_wheels(const GroundFrame& frame,
                  double half_length_m,
                  double half_width_m,
                  std::uint32_t tyre,
                  MeshBuilder& builder) {
  constexpr double kRadius_m = 0.31;
  constexpr double kWidth_m = 0.22;
  for (const double x : {-half_length_m + 0.8, half_length_m - 0.85}) {
    for (const double y : {-half_width_m, half_width_m}) {
      const double in = y < 0 ? kWidth_m : -kWidth_m;
      builder.tube(frame * Eigen::Vector3d(x, y + in, kRadius_m),
                   frame * Eigen::Vector3d(x, y, kRadius_m),
                   kRadius_m,
                   kRadius_m,
                   10,
                   tyre);
    }
  }
}

}  // namespace

void build_car(const GroundFrame& frame, std::uint64_t seed, float contrast, MeshBuilder& builder) {
  Random random(seed, "world/car");
  Surface body =
      plain_surface(Material::kCarPaint, FaceLabel::kOther, car_paint(random), seed, 0.4F);
  body.contrast = contrast;
  const std::uint32_t painted = builder.add_surface(body, frame);
  const std::uint32_t glass = builder.add_surface(
      plain_surface(Material::kGlass, FaceLabel::kOther, {0.04F, 0.05F, 0.05F}, seed, 0.05F),
      frame);
  const std::uint32_t tyre = builder.add_surface(
      plain_surface(Material::kRubber, FaceLabel::kOther, {0.03F, 0.03F, 0.03F}, seed, 0.08F),
      frame);
  const double half = 0.5 * random.uniform(3.9, 4.7);
  const double wide = 0.5 * random.uniform(1.65, 1.82);
  const double roof = random.uniform(1.42, 1.7);
  const bool estate = random.uniform() < 0.4;
  const CarProfile lower{.corners = {{-half, 0.3},
                                     {half, 0.3},
                                     {half, 0.62},
                                     {half - 0.9, 0.86},
                                     {-half + 0.5, 0.92},
                                     {-half, 0.7}},
                         .low_half_m = wide,
                         .high_half_m = wide};
  const double rear = estate ? -half + 0.35 : -half + 0.9;
  const CarProfile cabin{
      .corners = {{rear - 0.3, 0.9}, {half - 1.1, 0.86}, {half - 1.9, roof}, {rear + 0.25, roof}},
      .low_half_m = wide - 0.06,
      .high_half_m = wide - 0.22};
  extrude(lower, frame, std::vector(lower.corners.size(), painted), painted, builder);
  extrude(cabin, frame, {painted, glass, painted, glass}, glass, builder);
  build_wheels(frame, half, wide, tyre, builder);
}

void build_tree(const GroundFrame& frame,
                double height_m,
                std::uint64_t seed,
                MeshBuilder& builder) {
  Random random(seed, "world/tree");
  const auto green = static_cast<float>(random.uniform(0.13, 0.24));
  const auto warmth = static_cast<float>(random.uniform(0.35, 0.85));
  Surface leaves = plain_surface(
      Material::kLeaf, FaceLabel::kVegetation, {green * warmth, green, 0.22F * green}, seed, 0.45F);
  const std::uint32_t leaf = builder.add_surface(leaves, frame);
  const std::uint32_t bark = builder.add_surface(
      plain_surface(Material::kBark, FaceLabel::kVegetation, {0.13F, 0.1F, 0.07F}, seed, 0.25F),
      frame);
  const double crown = 0.32 * height_m;
  const Eigen::Vector3d lean(random.uniform(-0.25, 0.25), random.uniform(-0.25, 0.25), 0.0);
  const Eigen::Vector3d fork = frame * (Eigen::Vector3d(0, 0, 0.45 * height_m) + lean);
  builder.tube(frame * Eigen::Vector3d(0, 0, -0.3),
               fork,
               0.02 * height_m + 0.04,
               0.014 * height_m + 0.02,
               7,
               bark);
  const int blobs = 4 + static_cast<int>(random.index(4));
  for (int blob = 0; blob < blobs; ++blob) {
    const Eigen::Vector3d offset = random_direction(random).cwiseProduct(
        Eigen::Vector3d(0.75 * crown, 0.75 * crown, 0.5 * crown));
    const Eigen::Vector3d center = fork + Eigen::Vector3d(0, 0, 0.28 * height_m) + offset;
    const double radius = crown * random.uniform(0.5, 0.85);
    builder.tube(fork, center, 0.012 * height_m, 0.02, 5, bark);
    const int count = static_cast<int>(85.0 * radius * radius) + 50;
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d out = random_direction(random);
      const double r = radius * std::cbrt(random.uniform(0.35, 1.0));
      const Eigen::Vector3d normal = (out + 0.7 * random_direction(random)).normalized();
      build_leaf(center + r * out.cwiseProduct(Eigen::Vector3d(1, 1, 0.85)),
                 normal,
                 random.uniform(0.22, 0.4),
                 leaf,
                 builder);
    }
  }
}

void build_lamp_post(const GroundFrame& frame, std::uint64_t seed, MeshBuilder& builder) {
  Random random(seed, "world/lamp");
  const std::uint32_t metal = builder.add_surface(
      plain_surface(Material::kPlain,
                    FaceLabel::kOther,
                    Eigen::Vector3f::Constant(static_cast<float>(random.uniform(0.1, 0.3))),
                    seed,
                    0.35F),
      frame);
  const double height = random.uniform(6.0, 7.5);
  const double arm = random.uniform(1.2, 1.9);
  builder.tube(frame * Eigen::Vector3d(0, 0, -0.2),
               frame * Eigen::Vector3d(0, 0, height),
               0.09,
               0.06,
               8,
               metal);
  builder.tube(frame * Eigen::Vector3d(0, 0, height - 0.05),
               frame * Eigen::Vector3d(0, arm, height + 0.25),
               0.045,
               0.045,
               6,
               metal);
  builder.box(frame, {-0.14, arm - 0.1, height + 0.2}, {0.14, arm + 0.6, height + 0.36}, metal);
}

void build_street_furniture(const GroundFrame& frame,
                            std::uint64_t seed,
                            float contrast,
                            MeshBuilder& builder) {
  Random random(seed, "world/furniture");
  static constexpr std::array<std::array<float, 3>, 5> kColors = {{{0.12F, 0.12F, 0.13F},
                                                                   {0.25F, 0.26F, 0.26F},
                                                                   {0.06F, 0.16F, 0.09F},
                                                                   {0.05F, 0.10F, 0.28F},
                                                                   {0.24F, 0.15F, 0.08F}}};
  const auto& c = kColors[random.index(kColors.size())];
  Surface body =
      plain_surface(Material::kCarPaint, FaceLabel::kOther, {c[0], c[1], c[2]}, seed, 0.4F);
  body.contrast = contrast;
  const std::uint32_t surface = builder.add_surface(body, frame);
  switch (random.index(4)) {
    case 0: {
      const double height = random.uniform(2.3, 2.8);
      builder.tube(frame * Eigen::Vector3d(0, 0, -0.2),
                   frame * Eigen::Vector3d(0, 0, height),
                   0.04,
                   0.04,
                   6,
                   surface);
      builder.box(frame, {-0.35, -0.07, height - 0.65}, {0.35, -0.04, height}, surface);
      return;
    }
    case 1:
      builder.box(frame, {-0.3, -0.3, -0.1}, {0.3, 0.3, 1.1}, surface, 16);
      return;
    case 2:
      builder.box(frame, {-0.6, -0.22, -0.1}, {0.6, 0.22, 1.35}, surface, 16);
      return;
    default:
      builder.box(frame, {-0.9, -0.22, 0.38}, {0.9, 0.22, 0.46}, surface);
      builder.box(frame, {-0.75, -0.18, -0.1}, {-0.65, 0.18, 0.38}, surface, 16 | 32);
      builder.box(frame, {0.65, -0.18, -0.1}, {0.75, 0.18, 0.38}, surface, 16 | 32);
      return;
  }
}

}  // namespace hybridfusion
