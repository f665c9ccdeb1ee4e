#include "rendered_flight.hpp"

#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/vision/reconstruct.hpp>

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;

using testing::fly;
using testing::ground_height_m;
using testing::kFocal_px;
using testing::kHeight;
using testing::kWidth;
using Flight = testing::RenderedFlight;

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
