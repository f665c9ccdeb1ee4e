#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/densify_options.hpp>
#include <hybridfusion/vision/photo_cache.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>
#include <hybridfusion/vision/streaming_options.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hybridfusion {

/// Everything that a streaming reconstruction is set up with.
struct StreamingSetup {
  ReconstructionOptions reconstruction = {};
  DensifyOptions densify = {};  ///< Of the preview: stereo, check and angles; sizes are `live`'s.
  StreamingOptions live = {};
  PhotoCache cache = {};  ///< `load` and `save`; the keys come with the photos. May be empty.
};

/// A photo whose pixels were read: features and a reduced copy.
struct PreparedPhoto {
  struct Pixels;
  PhotoMetadata metadata = {};
  std::string key = {};                       ///< As PhotoCache::keys.
  std::shared_ptr<const Pixels> pixels = {};  ///< Empty: the photo cannot be read.
  std::string error = {};                     ///< Why.
};

/// A photo that came, registered or not.
struct LivePhoto {
  std::string name = {};
  std::optional<Rigid3> enu_from_camera = {};  ///< Camera: x right, y down, z forward.
  std::string reason = {};                     ///< Why it has no pose (yet).
};

/// What a photo changed.
struct PhotoUpdate {
  std::size_t num_features = 0;
  std::size_t num_pairs = 0;                   ///< Earlier photos that it shares a geometry with.
  std::vector<std::uint32_t> registered = {};  ///< Photos that have a pose since, by arrival.
  bool moved = false;                          ///< All poses were adjusted or placed anew.
  std::size_t num_preview_points = 0;          ///< Of the cloud, after this photo.
};

/// Camera poses and a coarse dense cloud while photos arrive (the real-time reconstruction of
/// HybridFusion III-A): a photo is matched with a bounded number of near ones, resected, and
/// adjusted with its neighbourhood, so that it costs the same early and late in a flight. All poses
/// are adjusted and placed by GNSS again each time their number grew by a factor. The result is a
/// preview: reconstruct() of the same photos is more accurate and knows more pairs, and takes up
/// what the cache kept.
///
/// The same photos in the same order give the same result at any number of threads.
class StreamingReconstruction {
 public:
  explicit StreamingReconstruction(StreamingSetup setup);
  StreamingReconstruction(StreamingReconstruction&&) noexcept;
  StreamingReconstruction& operator=(StreamingReconstruction&&) noexcept;
  StreamingReconstruction(const StreamingReconstruction&) = delete;
  StreamingReconstruction& operator=(const StreamingReconstruction&) = delete;
  ~StreamingReconstruction();

  /// Decodes a photo and extracts its features. May run on another thread than add().
  /// @param key  As PhotoCache::keys; empty: nothing is kept.
  [[nodiscard]] PreparedPhoto prepare(const Photo& photo, const std::string& key) const;

  /// Takes a photo up. One that cannot be read or matched is kept with its reason.
  /// @returns kCancelled; kDegenerate when a solver fails in a way that leaves no model.
  [[nodiscard]] Expected<PhotoUpdate> add(const PreparedPhoto& photo, const RunContext& ctx);

  /// In order of arrival.
  [[nodiscard]] std::vector<LivePhoto> photos() const;
  /// Whether poses are east, north, up in metres at origin(); else their frame is arbitrary.
  [[nodiscard]] bool georeferenced() const;
  [[nodiscard]] const GeodeticOrigin& origin() const;
  /// Points with colours and `confidences` (depths merged), in ascending voxel order.
  [[nodiscard]] PointCloud preview() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hybridfusion
