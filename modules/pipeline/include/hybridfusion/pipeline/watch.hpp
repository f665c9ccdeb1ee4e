#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <cstddef>
#include <functional>
#include <string>

namespace hybridfusion {

/// What became of one photo, when it was worked off.
struct WatchedPhoto {
  std::string name = {};
  double arrived_s = 0.0;  ///< Since the watch began.
  double latency_s = 0.0;  ///< From its arrival until poses and preview were written.
  double cpu_s = 0.0;      ///< That the program took since the last photo.
  bool registered = false;
  std::string reason = {};  ///< Why it is not.
  std::size_t num_features = 0;
  std::size_t num_pairs = 0;           ///< Earlier photos that it matches.
  std::size_t total_photos = 0;        ///< That came so far.
  std::size_t total_registered = 0;    ///< Of those.
  std::size_t num_preview_points = 0;  ///< Of the cloud so far.
  bool georeferenced = false;
};

struct WatchRequest {
  PhotoInputs inputs = {};  ///< `images` is watched.
  double idle_s = 30.0;     ///< The watch ends when no photo came for so long.
  std::function<void(const WatchedPhoto&)> on_photo = {};
};

/// Poses and a preview cloud of photos while they arrive in a folder: vision/cameras.csv,
/// vision/preview.ply and vision/preview_origin.json, replaced after each photo. Features and
/// matches are kept for reconstruct_stage and for a watch that takes up an interrupted one.
/// @returns kNotFound when the folder is missing or nothing arrives; kCancelled; kIo.
[[nodiscard]] Expected<StageOutcome> watch_stage(Project& project,
                                                 const WatchRequest& request,
                                                 const RunContext& ctx);

}  // namespace hybridfusion
