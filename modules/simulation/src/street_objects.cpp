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

}  // namespace

void build_car(const GroundFrame& frame, std::uint64_t seed, float contrast, MeshBuilder& builder) {
  Random random(seed, "world/car");
  static constexpr std::array<std::array<float, 3>, 7> kPaints = {{{0.55F, 0.55F, 0.54F},
                                                                   {0.3F, 0.31F, 0.32F},
                                                                   {0.04F, 0.1F, 0.42F},
                                                                   {0.45F, 0.04F, 0.04F},
                                                                   {0.05F, 0.3F, 0.14F},
                                                                   {0.05F, 0.05F, 0.06F},
                                                                   {0.35F, 0.3F, 0.2F}}};
  const auto& paint = kPaints[random.index(kPaints.size())];
  Surface body = plain_surface(
      Material::kCarPaint, FaceLabel::kOther, {paint[0], paint[1], paint[2]}, seed, 0.4F);
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
  // Side profile of the body, front to the right, and of the cabin above it.
  const std::vector<Eigen::Vector2d> body_profile = {{-half, 0.3},
                                                     {half, 0.3},
                                                     {half, 0.62},
                                                     {half - 0.9, 0.86},
                                                     {-half + 0.5, 0.92},
                                                     {-half, 0.7}};
  const double rear = estate ? -half + 0.35 : -half + 0.9;
  const std::vector<Eigen::Vector2d> cabin_profile = {
      {rear - 0.3, 0.9}, {half - 1.1, 0.86}, {half - 1.9, roof}, {rear + 0.25, roof}};
  const auto extrude = [&](const std::vector<Eigen::Vector2d>& profile,
                           double y_low,
                           double y_high,
                           auto surface_of_edge,
                           std::uint32_t side) {
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const Eigen::Vector2d& a = profile[i];
      const Eigen::Vector2d& b = profile[(i + 1) % profile.size()];
      const double ya = a.y() > 1.2 ? y_high : y_low;
      const double yb = b.y() > 1.2 ? y_high : y_low;
      builder.quad(frame * Eigen::Vector3d(a.x(), -ya, a.y()),
                   frame * Eigen::Vector3d(a.x(), ya, a.y()),
                   frame * Eigen::Vector3d(b.x(), yb, b.y()),
                   frame * Eigen::Vector3d(b.x(), -yb, b.y()),
                   surface_of_edge(i));
    }
    for (const double s : {-1.0, 1.0}) {
      for (std::size_t i = 1; i + 1 < profile.size(); ++i) {
        const auto corner = [&](const Eigen::Vector2d& p) -> Eigen::Vector3d {
          return frame * Eigen::Vector3d(p.x(), s * (p.y() > 1.2 ? y_high : y_low), p.y());
        };
        const std::size_t j = s < 0 ? i : i + 1;
        const std::size_t k = s < 0 ? i + 1 : i;
        builder.triangle(corner(profile[0]), corner(profile[j]), corner(profile[k]), side);
      }
    }
  };
  extrude(body_profile, wide, wide, [&](std::size_t) { return painted; }, painted);
  extrude(
      cabin_profile,
      wide - 0.06,
      wide - 0.22,
      [&](std::size_t edge) { return edge == 1 || edge == 3 ? glass : painted; },
      glass);
  for (const double x : {-half + 0.8, half - 0.85}) {
    for (const double y : {-wide, wide}) {
      const double in = y < 0 ? 0.22 : -0.22;
      builder.tube(frame * Eigen::Vector3d(x, y + in, 0.31),
                   frame * Eigen::Vector3d(x, y, 0.31),
                   0.31,
                   0.31,
                   10,
                   tyre);
    }
  }
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
