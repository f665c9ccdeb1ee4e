#pragma once

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/pipeline/watch.hpp>
#include <hybridfusion/vision/streaming_reconstruction.hpp>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// What a watch writes.
inline constexpr std::array<std::string_view, 3> kWatchFiles = {
    workspace_file::kLiveCameras, workspace_file::kPreview, workspace_file::kPreviewOrigin};

/// vision/preview.ply and, once there is a place, vision/preview_origin.json.
[[nodiscard]] Expected<void> write_preview(const Workspace& workspace,
                                           const PointCloud& preview,
                                           const StreamingReconstruction& stream);

/// vision/cameras.csv: name,arrived_s,latency_s,registered,x,y,z,qx,qy,qz,qw,reason, one row per
/// photo in order of arrival; enu_from_camera, empty without a pose.
[[nodiscard]] Expected<void> write_cameras(const Workspace& workspace,
                                           std::span<const WatchedPhoto> photos,
                                           std::span<const LivePhoto> live);

/// The result of a watch, as JSON and for a person. @pre not empty
[[nodiscard]] std::string watch_json(std::span<const WatchedPhoto> photos,
                                     const StreamingReconstruction& stream);
[[nodiscard]] std::vector<std::string> watch_summary(std::span<const WatchedPhoto> photos,
                                                     const StreamingReconstruction& stream);

}  // namespace hybridfusion
