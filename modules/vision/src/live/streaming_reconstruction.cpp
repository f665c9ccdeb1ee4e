#include "cached_features.hpp"
#include "dense/image_warp.hpp"
#include "live/live_depth.hpp"
#include "live/live_model.hpp"
#include "live/preview_cloud.hpp"
#include "model_export.hpp"

#include <hybridfusion/vision/streaming_reconstruction.hpp>

#include <algorithm>
#include <deque>
#include <exception>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {

struct PreparedPhoto::Pixels {
  FeatureSet features = {};
  std::shared_ptr<const Image8> reduced = {};  ///< Null without preview.
};

namespace {

constexpr std::size_t kDepthsPerPhoto = 2;  // so that a first model's do not come all at once

/// The photo at preview size.
std::shared_ptr<const Image8> reduced_copy(const Image8& photo, int max_size_px) {
  const CameraIntrinsics any{.width_px = photo.width, .height_px = photo.height, .focal_px = 1.0};
  const WorkImage small = reduce(photo, any, max_size_px);
  Image8 copy{.width = small.rgb.cols, .height = small.rgb.rows, .channels = 3};
  for (int y = 0; y < small.rgb.rows; ++y) {
    const auto* row = small.rgb.ptr<std::uint8_t>(y);
    copy.pixels.insert(copy.pixels.end(), row, row + 3 * static_cast<std::ptrdiff_t>(copy.width));
  }
  return std::make_shared<const Image8>(std::move(copy));
}

/// What the depth stage needs of the model: all poses, and the points that these views see.
Reconstruction sparse_part(const LiveModel& live, std::span<const std::uint32_t> views) {
  const SfmModel& model = live.model();
  std::vector<std::uint32_t> tracks;
  for (const std::uint32_t view : views) {
    for (const TrackReference& seen : model.tracks_of_view[view]) tracks.push_back(seen.track);
  }
  std::ranges::sort(tracks);
  const auto twice = std::ranges::unique(tracks);
  tracks.erase(twice.begin(), twice.end());
  Reconstruction result{.origin = live.origin(), .cameras = model.cameras};
  result.views.resize(live.photos().size());
  for (std::uint32_t v = 0; v < result.views.size(); ++v) {
    result.views[v].name = live.photos()[v].name;
    result.views[v].camera = model.camera_of_view[v];
    result.views[v].enu_from_camera = model.world_from_view[v];
  }
  export_points(model, tracks, live.features(), result);
  return result;
}

}  // namespace

struct StreamingReconstruction::State {
  explicit State(StreamingSetup given)
      : setup(std::move(given)),
        model(setup.reconstruction, setup.live, setup.cache),
        depth(setup.densify, setup.live),
        preview(static_cast<std::size_t>(setup.live.preview_max_points)) {}

  void move_preview(double scale);
  void grow_preview(const LiveModel::Step& step, const RunContext& ctx);

  StreamingSetup setup;
  LiveModel model;
  LiveDepth depth;
  PreviewCloud preview;
  std::vector<std::uint32_t> in_preview = {};    // views, in the order that the cloud took them
  std::deque<std::uint32_t> without_depth = {};  // registered views
};

void StreamingReconstruction::State::move_preview(double scale) {
  depth.scale(scale);
  constexpr double kSameUnit = 1.1;  // more: the model had no metres before
  const bool new_unit = scale > kSameUnit || scale < 1.0 / kSameUnit;
  if (new_unit && preview.has_voxel() && !(setup.live.preview_voxel_m > 0.0)) {
    preview.set_voxel(preview.voxel_m() * scale);
  }
  std::vector<Rigid3> poses;
  for (const std::uint32_t view : in_preview) poses.push_back(*model.model().world_from_view[view]);
  if (!poses.empty()) preview.move(poses, scale);
}

void StreamingReconstruction::State::grow_preview(const LiveModel::Step& step,
                                                  const RunContext& ctx) {
  if (!setup.live.preview) return;
  without_depth.insert(without_depth.end(), step.registered.begin(), step.registered.end());
  if (step.moved) move_preview(step.scale);
  if (without_depth.empty()) return;
  std::vector<std::uint32_t> views;
  while (!without_depth.empty() && views.size() < kDepthsPerPhoto) {
    views.push_back(without_depth.front());
    without_depth.pop_front();
  }
  const Reconstruction reconstruction = sparse_part(model, views);
  for (const std::uint32_t view : views) {
    if (ctx.stopped()) return;
    auto points = depth.points_of(reconstruction, view, ctx);
    if (!points) continue;
    if (!preview.has_voxel()) {
      const double given_m = setup.live.preview_voxel_m;
      preview.set_voxel(given_m > 0.0 ? given_m : depth.default_voxel_m());
    }
    preview.add(*std::move(points), *model.model().world_from_view[view]);
    in_preview.push_back(view);
  }
}

StreamingReconstruction::StreamingReconstruction(StreamingSetup setup)
    : state_(std::make_unique<State>(std::move(setup))) {}
StreamingReconstruction::StreamingReconstruction(StreamingReconstruction&&) noexcept = default;
StreamingReconstruction& StreamingReconstruction::operator=(StreamingReconstruction&&) noexcept =
    default;
StreamingReconstruction::~StreamingReconstruction() = default;

PreparedPhoto StreamingReconstruction::prepare(const Photo& photo, const std::string& key) const {
  const StreamingSetup& setup = state_->setup;
  PreparedPhoto result{.metadata = photo.metadata, .key = key};
  auto pixels = std::make_shared<PreparedPhoto::Pixels>();
  try {
    const Expected<Image8> image = photo.load();
    if (!image) {
      result.error = image.error().message;
      return result;
    }
    PhotoCache cache = setup.cache;
    cache.keys = {cache.load ? key : std::string()};
    const Photo decoded{.metadata = photo.metadata,
                        .load = [&]() -> Expected<Image8> { return *image; }};
    auto features = photo_features(decoded, 0, setup.reconstruction.features, &cache);
    if (!features) {
      result.error = features.error().message;
      return result;
    }
    pixels->features = *std::move(features);
    if (setup.live.preview) pixels->reduced = reduced_copy(*image, setup.live.preview_size_px);
  } catch (const std::exception& error) {
    result.error = error.what();
    return result;
  }
  result.pixels = std::move(pixels);
  return result;
}

Expected<PhotoUpdate> StreamingReconstruction::add(const PreparedPhoto& photo,
                                                   const RunContext& ctx) {
  try {
    FeatureSet features = photo.pixels ? photo.pixels->features : FeatureSet{};
    PhotoUpdate update{.num_features = features.size()};
    std::string error = photo.error;
    if (error.empty() && features.size() == 0) error = "no feature found in it";
    state_->depth.add_photo(photo.metadata, photo.pixels ? photo.pixels->reduced : nullptr);
    HF_TRY(LiveModel::Step step,
           state_->model.add(photo.metadata, std::move(features), photo.key, error, ctx));
    state_->grow_preview(step, ctx);
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    update.num_pairs = step.num_pairs;
    update.registered = std::move(step.registered);
    update.moved = step.moved;
    update.num_preview_points = state_->preview.size();
    return update;
  } catch (const std::exception& error) {
    return fail(
        ErrorCode::kDegenerate,
        fmt::format("{}: structure from motion failed: {}", photo.metadata.name, error.what()));
  }
}

std::vector<LivePhoto> StreamingReconstruction::photos() const {
  const LiveModel& model = state_->model;
  std::vector<LivePhoto> photos;
  for (std::size_t v = 0; v < model.photos().size(); ++v) {
    photos.push_back({.name = model.photos()[v].name,
                      .enu_from_camera = model.model().world_from_view[v],
                      .reason = model.reasons()[v]});
  }
  return photos;
}

bool StreamingReconstruction::georeferenced() const {
  return state_->model.georeferenced();
}

const GeodeticOrigin& StreamingReconstruction::origin() const {
  return state_->model.origin();
}

PointCloud StreamingReconstruction::preview() const {
  return state_->preview.cloud();
}

}  // namespace hybridfusion
