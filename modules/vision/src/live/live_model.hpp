#pragma once

#include "features.hpp"
#include "intrinsics_prior.hpp"
#include "live/live_tracks.hpp"
#include "pair_verification.hpp"
#include "sfm_model.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/photo_cache.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>
#include <hybridfusion/vision/streaming_options.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hybridfusion {

/// Partners of the last photo: the two next in time, then the nearest by position (in time, for
/// photos without one).
/// @param usable  Per photo: has features.
[[nodiscard]] std::vector<std::uint32_t> live_partners(std::span<const PhotoMetadata> photos,
                                                       const GnssIngest& gnss,
                                                       const std::vector<bool>& usable,
                                                       const PairOptions& options,
                                                       int max_count);

/// Poses and sparse points of photos in their order of arrival.
class LiveModel {
 public:
  struct Step {
    std::size_t num_pairs = 0;
    std::vector<std::uint32_t> registered = {};  ///< Views that have a pose since.
    bool moved = false;                          ///< All poses changed.
    double scale = 1.0;                          ///< Lengths by which they did.
  };

  LiveModel(const ReconstructionOptions& options, const StreamingOptions& live, PhotoCache cache);

  /// @param features  Empty for a photo that cannot be read. @param error  Then: why.
  /// @returns kCancelled.
  [[nodiscard]] Expected<Step> add(const PhotoMetadata& photo,
                                   FeatureSet features,
                                   const std::string& key,
                                   const std::string& error,
                                   const RunContext& ctx);

  [[nodiscard]] const SfmModel& model() const { return model_; }
  [[nodiscard]] const std::vector<FeatureSet>& features() const { return features_; }
  [[nodiscard]] const std::vector<PhotoMetadata>& photos() const { return metadata_; }
  [[nodiscard]] const std::vector<std::string>& reasons() const { return reasons_; }
  [[nodiscard]] bool georeferenced() const { return georeferenced_; }
  [[nodiscard]] const GeodeticOrigin& origin() const { return gnss_.origin; }

 private:
  void take_positions();
  void take_camera();
  [[nodiscard]] Expected<std::vector<VerifiedPair>> match_last(const RunContext& ctx);
  [[nodiscard]] Expected<void> probe_once(std::vector<VerifiedPair>& fresh, const RunContext& ctx);
  [[nodiscard]] std::size_t num_visible(std::uint32_t view) const;
  [[nodiscard]] std::vector<bool> candidates() const;
  [[nodiscard]] Expected<void> register_waiting(const RunContext& ctx);
  [[nodiscard]] Expected<bool> adjust_if_grown(const RunContext& ctx);
  [[nodiscard]] std::optional<double> place(const RunContext& ctx);

  ReconstructionOptions options_;
  StreamingOptions live_;
  PhotoCache cache_;
  std::vector<PhotoMetadata> metadata_ = {};
  std::vector<FeatureSet> features_ = {};
  std::vector<std::string> reasons_ = {};
  std::vector<std::size_t> tried_with_ = {};  // per view: visible points at its last trial
  GnssIngest gnss_ = {};
  std::optional<GeodeticOrigin> origin_ = {};
  CameraSetup cameras_ = {};  // their intrinsics follow the model's
  SfmModel model_ = {};
  LiveTracks tracks_ = {};
  std::vector<RawPair> raw_ = {};         // until the lens was probed
  std::vector<VerifiedPair> pairs_ = {};  // until there is a model
  bool probed_ = false;
  bool georeferenced_ = false;
  bool in_any_frame_ = false;  // without positions: placed once, as level photos hold it
  std::size_t adjusted_views_ = 0;
};

}  // namespace hybridfusion
