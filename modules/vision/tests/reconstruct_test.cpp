#include "synthetic_flight.hpp"

#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/vision/reconstruct.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;

constexpr int kWidth = 400;
constexpr int kHeight = 300;
constexpr double kFocal_px = 330.0;

/// Noise of a lattice point, 0..1.
double lattice(int x, int y) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ static_cast<std::uint32_t>(y) * 0x85EBCA77U;
  h ^= h >> 15U;
  h *= 0x2C1B3C6DU;
  h ^= h >> 13U;
  return (h & 0xFFFFU) / 65535.0;
}

/// Smoothly interpolated lattice noise.
double noise(double x, double y) {
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double u = smooth(x - x0);
  const double v = smooth(y - y0);
  return (1 - v) * ((1 - u) * lattice(x0, y0) + u * lattice(x0 + 1, y0)) +
         v * ((1 - u) * lattice(x0, y0 + 1) + u * lattice(x0 + 1, y0 + 1));
}

double ground_height_m(double x, double y) {
  return 4.0 * std::sin(0.21 * x) * std::cos(0.17 * y);
}

/// Photo of rolling textured ground, by fixed-point intersection of each ray with the height field.
Image8 render(const Rigid3& enu_from_camera) {
  Image8 image{.width = kWidth, .height = kHeight, .channels = 3};
  image.pixels.reserve(static_cast<std::size_t>(kWidth) * kHeight * 3);
  const Eigen::Vector3d centre = enu_from_camera.translation;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray =
          enu_from_camera.rotation * Eigen::Vector3d((u - 0.5 * (kWidth - 1)) / kFocal_px,
                                                     (v - 0.5 * (kHeight - 1)) / kFocal_px,
                                                     1.0);
      double height = 0.0;
      Eigen::Vector3d point = centre;
      for (int k = 0; k < 8; ++k) {
        point = centre + ray * ((height - centre.z()) / ray.z());
        height = ground_height_m(point.x(), point.y());
      }
      const double gray = 0.5 * noise(1.3 * point.x(), 1.3 * point.y()) +
                          0.3 * noise(3.1 * point.x() + 50.0, 3.1 * point.y()) +
                          0.2 * noise(0.5 * point.x(), 0.5 * point.y() + 90.0);
      image.pixels.insert(image.pixels.end(), 3, static_cast<std::uint8_t>(20.0 + 215.0 * gray));
    }
  }
  return image;
}

struct Flight {
  std::vector<Photo> photos;
  std::vector<Rigid3> enu_from_camera;  // relative to `start`
  GeodeticOrigin start{.latitude_deg = 48.0, .longitude_deg = 11.0, .altitude_m = 500.0};
};

Flight render_flight() {
  Flight flight;
  for (int i = 0; i < 6; ++i) {
    const int row = i / 3;
    const int column = row == 0 ? i : 5 - i;
    const Rigid3 pose{
        .rotation = testing::looking_down(row == 0 ? 0.05 : M_PI, i % 2 == 0 ? 0.12 : -0.1),
        .translation = {8.0 * column, 8.0 * row, 30.0 + 0.5 * column}};
    const auto image = std::make_shared<const Image8>(render(pose));
    const GeodeticPosition at = geodetic_from_enu(flight.start, pose.translation);
    Photo photo;
    photo.metadata.name = "IMG_" + std::to_string(i) + ".JPG";
    photo.metadata.width = kWidth;
    photo.metadata.height = kHeight;
    photo.metadata.focal_35mm = 43.2666 * 1.01 * kFocal_px / std::hypot(kWidth, kHeight);
    photo.metadata.time = from_seconds(100.0 + 2.0 * i);
    photo.metadata.latitude_deg = at.latitude_deg;
    photo.metadata.longitude_deg = at.longitude_deg;
    photo.metadata.altitude_m = at.altitude_m;
    photo.metadata.gps_horizontal_error_m = 0.3;
    photo.load = [image]() -> Expected<Image8> { return *image; };
    flight.photos.push_back(std::move(photo));
    flight.enu_from_camera.push_back(pose);
  }
  return flight;
}

/// Two strips of three photos, 30 m above ground, GNSS exact; rendered once.
Flight fly() {
  static const Flight flight = render_flight();
  return flight;
}

double rms_after_similarity_m(const Reconstruction& result, const Flight& flight) {
  std::vector<Eigen::Vector3d> target;
  std::vector<Eigen::Vector3d> source;
  for (std::size_t v = 0; v < result.views.size(); ++v) {
    if (!result.views[v].enu_from_camera) continue;
    target.push_back(flight.enu_from_camera[v].translation);
    source.push_back(result.views[v].enu_from_camera->translation);
  }
  const Sim3 sim = fit_sim3(target, source).value();
  double sum2 = 0.0;
  for (std::size_t i = 0; i < target.size(); ++i)
    sum2 += (sim * source[i] - target[i]).squaredNorm();
  return std::sqrt(sum2 / static_cast<double>(target.size()));
}

TEST(Reconstruct, RenderedFlightComesBackTheSameAtAnyNumberOfThreads) {
  const Flight flight = fly();
  RunContext one;
  one.num_threads = 1;
  const auto result = reconstruct(flight.photos, {}, one);
  ASSERT_TRUE(result) << result.error().message;
  for (const View& view : result->views) EXPECT_TRUE(view.enu_from_camera) << view.reason;
  // 0.2 px at 30 m and f = 330 px is 2 cm.
  EXPECT_LT(rms_after_similarity_m(*result, flight), 0.06);
  EXPECT_LT(result->quality.mean_reprojection_px, 0.8);
  EXPECT_LT(result->quality.gnss_horizontal_rms_m, 0.3);
  // In metres east-north-up at the origin that was chosen.
  const Eigen::Vector3d shift = enu_from_geodetic(flight.start, result->origin);
  EXPECT_LT((result->views[2].enu_from_camera->translation + shift -
             flight.enu_from_camera[2].translation)
                .norm(),
            0.5);
  for (const ScenePoint& point : result->points) {
    for (const ViewObservation& seen : point.track) {
      EXPECT_EQ(&result->points[result->views[seen.view].observations[seen.observation].point],
                &point);
    }
  }
  RunContext three;
  three.num_threads = 3;
  const auto again = reconstruct(flight.photos, {}, three);
  ASSERT_TRUE(again);
  ASSERT_EQ(again->points.size(), result->points.size());
  for (std::size_t v = 0; v < result->views.size(); ++v) {
    EXPECT_EQ(again->views[v].enu_from_camera->translation,
              result->views[v].enu_from_camera->translation);
  }
}

TEST(Reconstruct, UnreadablePhotoIsLeftOutWithItsReason) {
  Flight flight = fly();
  flight.photos[3].load = []() -> Expected<Image8> {
    return fail(ErrorCode::kIo, "IMG_3.JPG is cut off");
  };
  const auto result = reconstruct(flight.photos, {});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_FALSE(result->views[3].enu_from_camera);
  EXPECT_THAT(result->views[3].reason, HasSubstr("cut off"));
  EXPECT_TRUE(result->views[2].enu_from_camera);
}

TEST(Reconstruct, PhotosWithoutGnssComeBackInAFrameOfTheirOwn) {
  Flight flight = fly();
  for (Photo& photo : flight.photos) photo.metadata.latitude_deg.reset();
  const auto result = reconstruct(flight.photos, {});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_FALSE(result->georeferenced);
  EXPECT_EQ(result->quality.georeference, GeoreferenceVerdict::kUnusable);
  for (const View& view : result->views) EXPECT_TRUE(view.enu_from_camera) << view.reason;
  EXPECT_LT(rms_after_similarity_m(*result, flight), 0.1);
}

/// Points on the ground with their marks in all photos that see them.
std::vector<ControlPoint> surveyed_points(const Flight& flight) {
  const CameraIntrinsics camera{.width_px = kWidth,
                                .height_px = kHeight,
                                .focal_px = kFocal_px,
                                .principal_point_px = {0.5 * (kWidth - 1), 0.5 * (kHeight - 1)}};
  std::vector<ControlPoint> points;
  for (const auto& [x, y] :
       {std::pair{0.0, 0.0}, {16.0, 0.0}, {16.0, 9.0}, {1.0, 8.0}, {8.0, 4.0}, {5.0, 2.0}}) {
    ControlPoint point{.name = "p" + std::to_string(points.size())};
    const Eigen::Vector3d at(x, y, ground_height_m(x, y));
    point.position = geodetic_from_enu(flight.start, at);
    for (std::size_t v = 0; v < flight.enu_from_camera.size(); ++v) {
      const Eigen::Vector3d in_camera = flight.enu_from_camera[v].inverse() * at;
      const Eigen::Vector2d pixel = project(camera, in_camera);
      const bool inside =
          pixel.x() > 0 && pixel.y() > 0 && pixel.x() < kWidth - 1 && pixel.y() < kHeight - 1;
      if (inside) point.marks.push_back({.photo = v, .pixel = pixel});
    }
    points.push_back(point);
  }
  points.back().check = true;
  return points;
}

TEST(Reconstruct, GroundControlPlacesPhotosWithoutGnss) {
  Flight flight = fly();
  for (Photo& photo : flight.photos) photo.metadata.latitude_deg.reset();
  const auto result = reconstruct(flight.photos, {}, {}, surveyed_points(flight));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->georeferenced);
  const Eigen::Vector3d shift = enu_from_geodetic(flight.start, result->origin);
  for (std::size_t v = 0; v < result->views.size(); ++v) {
    EXPECT_LT((result->views[v].enu_from_camera->translation + shift -
               flight.enu_from_camera[v].translation)
                  .norm(),
              0.15);
  }
  ASSERT_EQ(result->control.size(), 6U);
  EXPECT_TRUE(result->control[0].used);
  EXPECT_FALSE(result->control[5].used);
  EXPECT_LT(result->control[5].residual_m.norm(), 0.15);
  EXPECT_LT(result->control[0].held_out_m.norm(), 0.3);
}

TEST(Reconstruct, GroundControlOverrulesGnssThatIsMetresOff) {
  Flight flight = fly();
  for (Photo& photo : flight.photos) *photo.metadata.altitude_m += 12.0;
  const auto result = reconstruct(flight.photos, {}, {}, surveyed_points(flight));
  ASSERT_TRUE(result) << result.error().message;
  const double height_m = enu_from_geodetic(flight.start, result->origin).z() +
                          result->views[0].enu_from_camera->translation.z();
  EXPECT_NEAR(height_m, flight.enu_from_camera[0].translation.z(), 0.15);
}

TEST(Reconstruct, AWrongGroundControlPointIsNamed) {
  const Flight flight = fly();
  std::vector<ControlPoint> points = surveyed_points(flight);
  points[3].position.altitude_m += 25.0;
  const auto result = reconstruct(flight.photos, {}, {}, points);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kDegenerate);
  EXPECT_THAT(result.error().message, HasSubstr("p3"));
}

TEST(Reconstruct, TwoGroundControlPointsAreRefused) {
  const Flight flight = fly();
  std::vector<ControlPoint> points = surveyed_points(flight);
  points.resize(2);
  const auto result = reconstruct(flight.photos, {}, {}, points);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kInsufficient);
}

TEST(Reconstruct, TwoPhotosAreRefused) {
  const Flight flight = fly();
  const auto result = reconstruct(std::span(flight.photos).first(2), {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kInsufficient);
}

TEST(Reconstruct, BlankPhotosAreRefusedNotPlacedAnywhere) {
  Flight flight = fly();
  Image8 blank{.width = kWidth, .height = kHeight, .channels = 3};
  blank.pixels.assign(static_cast<std::size_t>(kWidth) * kHeight * 3, 100);
  for (Photo& photo : flight.photos) photo.load = [blank]() -> Expected<Image8> { return blank; };
  const auto result = reconstruct(flight.photos, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kInsufficient);
}

TEST(Reconstruct, StopTokenCancels) {
  const Flight flight = fly();
  std::stop_source source;
  source.request_stop();
  RunContext ctx;
  ctx.stop = source.get_token();
  EXPECT_EQ(reconstruct(flight.photos, {}, ctx).error().code, ErrorCode::kCancelled);
}

TEST(Reconstruct, OptionOutOfRangeIsRefusedByItsFullName) {
  ReconstructionOptions options;
  options.matching.ratio = 2.0;
  const auto result = reconstruct(fly().photos, options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidOptions);
  EXPECT_THAT(result.error().message, HasSubstr("vision.matching.ratio"));
}

}  // namespace
}  // namespace hybridfusion
