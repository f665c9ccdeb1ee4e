#include "render.hpp"

#include "noise.hpp"
#include "shading.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

const Eigen::Vector3f kSunLight(2.05F, 1.95F, 1.78F);
const Eigen::Vector3f kSkyLight(0.52F, 0.58F, 0.70F);
const Eigen::Vector3f kBounce(0.20F, 0.185F, 0.165F);
constexpr float kSunRadius = 0.0055F;  ///< Half angle with some haze [rad].
constexpr float kExposure = 0.80F;

/// One row of a photo; everything constant over the photo is worked out once.
class Renderer {
 public:
  Renderer(const Scene& scene,
           const RayTracer& tracer,
           const PinholeCamera& camera,
           const Rigid3& world_from_camera,
           const RenderSettings& settings)
      : scene_(scene),
        tracer_(tracer),
        camera_(camera),
        settings_(settings),
        rotation_(world_from_camera.rotation.toRotationMatrix()),
        origin_(world_from_camera.translation.cast<float>()),
        sun_u_(scene.sun_direction.unitOrthogonal()),
        sun_v_(scene.sun_direction.cross(sun_u_)) {
    strata_ = std::max(1, static_cast<int>(std::lround(std::sqrt(settings.samples_per_pixel))));
  }

  void render_row(int y, Image8& image) const {
    Random noise(
        settings_.seed, "camera/noise", settings_.index * 65536U + static_cast<std::uint64_t>(y));
    for (int x = 0; x < camera_.width_px; ++x) {
      const Eigen::Vector3f light = kExposure * falloff(x, y) * pixel_light(x, y);
      auto* out = &image.pixels[3U * (static_cast<std::size_t>(y) * camera_.width_px + x)];
      for (int channel = 0; channel < 3; ++channel) {
        out[channel] = develop(light[channel], noise);
      }
    }
  }

 private:
  [[nodiscard]] float falloff(int x, int y) const {
    const double dx = (x - camera_.principal_px.x()) / (0.5 * camera_.width_px);
    const double dy = (y - camera_.principal_px.y()) / (0.5 * camera_.height_px);
    return static_cast<float>(1.0 -
                              settings_.vignetting * std::min(1.2, 0.5 * (dx * dx + dy * dy)));
  }

  /// Shot noise grows with the root of the light; the tone curve is a plain gamma with a shoulder.
  [[nodiscard]] std::uint8_t develop(float light, Random& noise) const {
    const auto sd = static_cast<float>(settings_.noise_sd);
    const float curved = 1.22F * light / (1.0F + 0.62F * light);
    const float level = 255.0F * std::pow(std::clamp(curved, 0.0F, 1.0F), 1.0F / 2.1F);
    const float grain = sd * (0.6F + 0.4F * std::sqrt(level / 128.0F));
    const float value = level + grain * static_cast<float>(noise.normal());
    return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
  }

  [[nodiscard]] Eigen::Vector3f pixel_light(int x, int y) const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    const int total = strata_ * strata_;
    for (int first = 0; first < total; first += 4) {
      sum += packet_light(x, y, first, std::min(4, total - first));
    }
    return sum / static_cast<float>(total);
  }

  [[nodiscard]] float jitter(int x, int y, int sample, std::uint32_t purpose) const {
    return cell_value(x * 64 + sample,
                      y * 8 + static_cast<std::int32_t>(purpose),
                      static_cast<std::uint32_t>(settings_.seed + 7919U * settings_.index));
  }

  /// Sum of the light of up to four samples of a pixel. Samples on the same surface share one
  /// texture lookup (the texture is averaged over the pixel anyway); shadows are traced for each.
  [[nodiscard]] Eigen::Vector3f packet_light(int x, int y, int first, int count) const {
    std::array<Eigen::Vector3f, 4> directions;
    std::array<Eigen::Vector3f, 4> shadow_from;
    std::array<Eigen::Vector3f, 4> shadow_to;
    for (int i = 0; i < 4; ++i) {
      const int sample = first + std::min(i, count - 1);
      const double sx = (sample % strata_ + double{jitter(x, y, sample, 0)}) / strata_ - 0.5;
      const double sy = (sample / strata_ + double{jitter(x, y, sample, 1)}) / strata_ - 0.5;
      directions[i] = (rotation_ * camera_.direction(x + sx, y + sy)).normalized().cast<float>();
    }
    const std::array<RayHit, 4> hits = tracer_.cast4(origin_, directions, count);
    std::array<Eigen::Vector3f, 4> points;
    std::array<Eigen::Vector3f, 4> normals;
    std::array<float, 4> facing{};
    unsigned wanted = 0;
    for (int i = 0; i < count; ++i) {
      if (hits[i].face == kNoFace) continue;
      points[i] = origin_ + hits[i].distance_m * directions[i];
      normals[i] = face_normal(scene_, hits[i].face);
      if (normals[i].dot(directions[i]) > 0.0F) normals[i] = -normals[i];
      facing[i] = normals[i].dot(scene_.sun_direction);
      if (facing[i] <= 0.0F && !is_leaf(hits[i])) continue;
      wanted |= 1U << static_cast<unsigned>(i);
      shadow_from[i] = points[i] + 0.004F * normals[i];
      shadow_to[i] = sun_ray(x, y, first + i);
    }
    const unsigned shadowed = tracer_.blocked4(shadow_from, shadow_to, wanted);
    return gather(hits, directions, points, normals, facing, wanted & ~shadowed, count);
  }

  [[nodiscard]] Eigen::Vector3f sun_ray(int x, int y, int sample) const {
    const float r = kSunRadius * std::sqrt(jitter(x, y, sample, 2));
    const float angle = 2.0F * std::numbers::pi_v<float> * jitter(x, y, sample, 3);
    return (scene_.sun_direction + r * std::cos(angle) * sun_u_ + r * std::sin(angle) * sun_v_)
        .normalized();
  }

  [[nodiscard]] bool is_leaf(const RayHit& hit) const {
    return scene_.surfaces[scene_.face_surface[hit.face]].material == Material::kLeaf;
  }

  [[nodiscard]] Eigen::Vector3f gather(const std::array<RayHit, 4>& hits,
                                       const std::array<Eigen::Vector3f, 4>& directions,
                                       const std::array<Eigen::Vector3f, 4>& points,
                                       const std::array<Eigen::Vector3f, 4>& normals,
                                       const std::array<float, 4>& facing,
                                       unsigned lit,
                                       int count) const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    std::array<bool, 4> done{};
    for (int i = 0; i < count; ++i) {
      if (hits[i].face == kNoFace) sum += sky_color(directions[i]);
      if (done[i] || hits[i].face == kNoFace) continue;
      const std::uint32_t id = scene_.face_surface[hits[i].face];
      Eigen::Vector3f light = Eigen::Vector3f::Zero();
      Eigen::Vector3f center = Eigen::Vector3f::Zero();
      float members = 0.0F;
      for (int j = i; j < count; ++j) {
        if (hits[j].face == kNoFace || scene_.face_surface[hits[j].face] != id ||
            normals[j].dot(normals[i]) < 0.95F) {
          continue;
        }
        done[j] = true;
        members += 1.0F;
        center += points[j];
        light += sample_light(
            hits[j], normals[j], facing[j], (lit >> static_cast<unsigned>(j) & 1U) != 0);
      }
      const float slant = std::max(0.25F, std::abs(normals[i].dot(directions[i])));
      const auto footprint =
          hits[i].distance_m / static_cast<float>(camera_.focal_px) / std::sqrt(slant);
      const Eigen::Vector3f color = surface_color(
          scene_.surfaces[id], center / members, normals[i], -directions[i], footprint);
      sum += color.cwiseProduct(tint_at(scene_, hits[i])).cwiseProduct(light);
    }
    return sum;
  }

  [[nodiscard]] Eigen::Vector3f sample_light(const RayHit& hit,
                                             const Eigen::Vector3f& normal,
                                             float facing,
                                             bool lit) const {
    const float open = ambient_at(scene_, hit);
    const float up = 0.5F + 0.5F * normal.z();
    Eigen::Vector3f light = open * (0.35F + 0.65F * up) * kSkyLight +
                            (1.0F - 0.6F * open) * kBounce + 0.25F * (1.0F - up) * kBounce;
    if (lit) {
      // Leaves let light through: no side of them is black.
      const float strength = is_leaf(hit) ? 0.35F + 0.55F * std::abs(facing) : facing;
      light += strength * kSunLight;
    }
    return light;
  }

  const Scene& scene_;
  const RayTracer& tracer_;
  const PinholeCamera& camera_;
  const RenderSettings& settings_;
  Eigen::Matrix3d rotation_;
  Eigen::Vector3f origin_;
  Eigen::Vector3f sun_u_;
  Eigen::Vector3f sun_v_;
  int strata_ = 2;
};

}  // namespace

Expected<Image8> render_photo(const Scene& scene,
                              const RayTracer& tracer,
                              const PinholeCamera& camera,
                              const Rigid3& world_from_camera,
                              const RenderSettings& settings,
                              const RunContext& ctx) {
  Image8 image{.width = camera.width_px, .height = camera.height_px, .channels = 3};
  image.pixels.resize(3U * static_cast<std::size_t>(camera.width_px) * camera.height_px);
  const Renderer renderer(scene, tracer, camera, world_from_camera, settings);
  parallel_for(
      ctx, static_cast<std::size_t>(camera.height_px), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end && !ctx.stopped(); ++y) {
          renderer.render_row(static_cast<int>(y), image);
        }
      });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while rendering a photo");
  return image;
}

}  // namespace hybridfusion
