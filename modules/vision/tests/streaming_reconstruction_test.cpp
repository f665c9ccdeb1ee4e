#include "live/live_model.hpp"
#include "live/preview_cloud.hpp"
#include "rendered_flight.hpp"

#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/vision/streaming_reconstruction.hpp>

#include <algorithm>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;
using testing::RenderedFlight;

struct Outcome {
  StreamingReconstruction stream;
  std::vector<std::size_t> order;  // photo of each arrival
};

StreamingSetup small_setup() {
  StreamingSetup setup;
  setup.live.preview_size_px = 300;
  setup.reconstruction.features.min_keypoints = 800;  // quick
  setup.reconstruction.features.max_keypoints = 1600;
  return setup;
}

Outcome stream(const RenderedFlight& flight,
               std::vector<std::size_t> order,
               const RunContext& ctx = {},
               StreamingSetup setup = small_setup()) {
  Outcome outcome{.stream = StreamingReconstruction(std::move(setup)), .order = std::move(order)};
  for (const std::size_t i : outcome.order) {
    const auto update = outcome.stream.add(outcome.stream.prepare(flight.photos[i], ""), ctx);
    EXPECT_TRUE(update) << update.error().message;
  }
  return outcome;
}

std::vector<std::size_t> in_order(const RenderedFlight& flight) {
  std::vector<std::size_t> order(flight.photos.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

/// Largest distance of a camera from where it was.
double worst_error_m(const Outcome& outcome, const RenderedFlight& flight) {
  const std::vector<LivePhoto> photos = outcome.stream.photos();
  double worst = 0.0;
  for (std::size_t k = 0; k < photos.size(); ++k) {
    if (!photos[k].enu_from_camera) continue;
    const GeodeticPosition at =
        geodetic_from_enu(outcome.stream.origin(), photos[k].enu_from_camera->translation);
    const Eigen::Vector3d truth = flight.enu_from_camera[outcome.order[k]].translation;
    worst = std::max(worst, (enu_from_geodetic(flight.start, at) - truth).norm());
  }
  return worst;
}

long registered(const Outcome& outcome) {
  return std::ranges::count_if(outcome.stream.photos(),
                               [](const LivePhoto& p) { return p.enu_from_camera.has_value(); });
}

TEST(StreamingReconstruction, PosesAndPreviewGrowWithThePhotos) {
  const RenderedFlight flight = testing::fly();
  StreamingReconstruction stream(small_setup());
  std::vector<std::size_t> points;
  for (const Photo& photo : flight.photos) {
    const auto update = stream.add(stream.prepare(photo, ""), {});
    ASSERT_TRUE(update) << update.error().message;
    points.push_back(update->num_preview_points);
  }
  EXPECT_EQ(points.front(), 0U);
  EXPECT_GT(points.back(), 3000U);
  EXPECT_TRUE(stream.georeferenced());
  const PointCloud preview = stream.preview();
  ASSERT_EQ(preview.size(), points.back());
  // On the ground, whose height is known everywhere.
  std::vector<double> gaps;
  for (const Eigen::Vector3f& point : preview.points) {
    const Eigen::Vector3d at =
        enu_from_geodetic(flight.start, geodetic_from_enu(stream.origin(), point.cast<double>()));
    gaps.push_back(std::abs(at.z() - testing::ground_height_m(at.x(), at.y())));
  }
  std::ranges::sort(gaps);
  // Six photos place the whole by GNSS tags of 0.3 m.
  EXPECT_LT(gaps[gaps.size() / 2], 0.5);
  EXPECT_LT(gaps[gaps.size() * 9 / 10], 1.0);
}

TEST(StreamingReconstruction, EveryPhotoIsPlacedWhateverTheOrder) {
  const RenderedFlight flight = testing::fly();
  const std::vector<std::vector<std::size_t>> orders = {{5, 4, 3, 2, 1, 0}, {2, 0, 1, 4, 5, 3}};
  for (const auto& order : orders) {
    const Outcome outcome = stream(flight, order);
    EXPECT_EQ(registered(outcome), 6) << order[0];
    EXPECT_LT(worst_error_m(outcome, flight), 0.8) << order[0];
  }
}

TEST(StreamingReconstruction, ResultDoesNotDependOnThreads) {
  const RenderedFlight flight = testing::fly();
  RunContext one;
  one.num_threads = 1;
  RunContext three;
  three.num_threads = 3;
  const Outcome a = stream(flight, in_order(flight), one);
  const Outcome b = stream(flight, in_order(flight), three);
  EXPECT_EQ(a.stream.preview().points, b.stream.preview().points);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(a.stream.photos()[k].enu_from_camera->translation,
              b.stream.photos()[k].enu_from_camera->translation);
  }
}

TEST(StreamingReconstruction, UnreadableBlankAndRepeatedPhotosKeepTheirReasons) {
  RenderedFlight flight = testing::fly();
  flight.photos[1].load = []() -> Expected<Image8> {
    return fail(ErrorCode::kParse, "IMG_1.JPG is cut off");
  };
  Photo blank = flight.photos[2];
  blank.metadata.name = "IMG_9.JPG";
  blank.load = []() -> Expected<Image8> {
    Image8 image{.width = testing::kWidth, .height = testing::kHeight, .channels = 3};
    image.pixels.assign(static_cast<std::size_t>(image.width) * image.height * 3, 90);
    return image;
  };
  flight.photos.push_back(blank);
  flight.enu_from_camera.push_back(flight.enu_from_camera[2]);
  Photo repeated = flight.photos[4];
  repeated.metadata.name = "IMG_4 (copy).JPG";
  flight.photos.push_back(repeated);
  flight.enu_from_camera.push_back(flight.enu_from_camera[4]);
  const Outcome outcome = stream(flight, in_order(flight));
  const std::vector<LivePhoto> photos = outcome.stream.photos();
  EXPECT_FALSE(photos[1].enu_from_camera);
  EXPECT_THAT(photos[1].reason, HasSubstr("cut off"));
  EXPECT_FALSE(photos[6].enu_from_camera);
  EXPECT_FALSE(photos[6].reason.empty());
  for (const std::size_t k : {0U, 2U, 3U, 4U, 5U}) EXPECT_TRUE(photos[k].enu_from_camera) << k;
  EXPECT_LT(worst_error_m(outcome, flight), 0.8);
}

TEST(StreamingReconstruction, AMemberWithoutGnssIsPlacedByItsNeighbours) {
  RenderedFlight flight = testing::fly();
  flight.photos[3].metadata.latitude_deg.reset();
  const Outcome outcome = stream(flight, in_order(flight));
  EXPECT_TRUE(outcome.stream.georeferenced());
  EXPECT_EQ(registered(outcome), 6);
  EXPECT_LT(worst_error_m(outcome, flight), 0.8);
}

TEST(StreamingReconstruction, PhotosWithoutGnssComeInAFrameOfTheirOwn) {
  RenderedFlight flight = testing::fly();
  for (Photo& photo : flight.photos) photo.metadata.latitude_deg.reset();
  const Outcome outcome = stream(flight, in_order(flight));
  EXPECT_FALSE(outcome.stream.georeferenced());
  EXPECT_EQ(registered(outcome), 6);
  EXPECT_GT(outcome.stream.preview().size(), 1000U);
}

TEST(StreamingReconstruction, AStopEndsIt) {
  const RenderedFlight flight = testing::fly();
  StreamingReconstruction stream(small_setup());
  ASSERT_TRUE(stream.add(stream.prepare(flight.photos[0], ""), {}));
  std::stop_source source;
  source.request_stop();
  RunContext ctx;
  ctx.stop = source.get_token();
  EXPECT_EQ(stream.add(stream.prepare(flight.photos[1], ""), ctx).error().code,
            ErrorCode::kCancelled);
}

TEST(LivePartners, AreTheNextInTimeThenTheNearest) {
  constexpr std::size_t kPhotos = 30;
  std::vector<PhotoMetadata> photos(kPhotos);
  GnssIngest gnss;
  gnss.fixes.resize(kPhotos);
  // Two strips of fifteen, flown there and back, 10 m apart.
  for (std::size_t i = 0; i < kPhotos; ++i) {
    const double x = i < 15 ? 10.0 * static_cast<double>(i) : 10.0 * static_cast<double>(29 - i);
    gnss.fixes[i].position_in_enu = Eigen::Vector3d(x, i < 15 ? 0.0 : 10.0, 60.0);
    gnss.by_time.push_back(i);
  }
  std::vector<bool> usable(kPhotos, true);
  EXPECT_EQ(live_partners(photos, gnss, usable, {}, 4), (std::vector<std::uint32_t>{0, 1, 27, 28}));
  usable[0] = false;
  EXPECT_EQ(live_partners(photos, gnss, usable, {}, 3), (std::vector<std::uint32_t>{1, 27, 28}));
}

PhotoPoints cube(int side) {
  PhotoPoints points;
  for (int i = 0; i < side * side * side; ++i) {
    points.in_camera.emplace_back(i % side, i / side % side, i / side / side);
    points.colors.push_back({10, 20, 30});
  }
  return points;
}

TEST(PreviewCloud, FollowsItsPhotosAndTheScaleOfTheModel) {
  PreviewCloud preview(100000);
  preview.set_voxel(0.25);
  preview.add(cube(4), {});
  ASSERT_EQ(preview.size(), 64U);
  const Rigid3 moved{.rotation = Eigen::Quaterniond::Identity(), .translation = {100, 0, 5}};
  preview.move({moved}, 2.0);
  const PointCloud cloud = preview.cloud();
  ASSERT_EQ(cloud.size(), 64U);
  EXPECT_LT((cloud.points.front() - Eigen::Vector3f(100, 0, 5)).norm(), 1e-4F);
  EXPECT_LT((cloud.points.back() - Eigen::Vector3f(106, 6, 11)).norm(), 1e-4F);
  EXPECT_EQ(cloud.colors.front(), (Rgb8{10, 20, 30}));
}

TEST(PreviewCloud, StaysBelowItsLimitByCoarserVoxels) {
  PreviewCloud preview(300);
  preview.set_voxel(0.5);
  preview.add(cube(8), {});  // 512 points a metre apart
  EXPECT_LE(preview.size(), 300U);
  EXPECT_GE(preview.size(), 30U);
  EXPECT_GT(preview.voxel_m(), 0.5);
  const PointCloud cloud = preview.cloud();
  EXPECT_EQ(std::accumulate(cloud.confidences.begin(), cloud.confidences.end(), 0.0F), 512.0F);
}

}  // namespace
}  // namespace hybridfusion
