#include "watch_files.hpp"

#include "json_text.hpp"
#include "positions_csv.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

struct Latency {
  double median_s = 0.0;
  double p90_s = 0.0;
  double max_s = 0.0;
};

Latency latency_of(std::span<const WatchedPhoto> photos) {
  if (photos.empty()) return {};
  std::vector<double> seconds(photos.size());
  std::ranges::transform(photos, seconds.begin(), &WatchedPhoto::latency_s);
  std::ranges::sort(seconds);
  return {.median_s = seconds[seconds.size() / 2],
          .p90_s = seconds[seconds.size() * 9 / 10],
          .max_s = seconds.back()};
}

/// As the files say it: what registered since a photo was told of counts.
std::vector<std::string> not_registered(std::span<const WatchedPhoto> photos,
                                        std::span<const LivePhoto> live) {
  std::vector<std::string> lines;
  for (const WatchedPhoto& photo : photos) {
    const auto now = std::ranges::find(live, photo.name, &LivePhoto::name);
    const bool known = now != live.end();
    if (known && now->enu_from_camera) continue;
    lines.push_back(photo.name + ": " + (known ? now->reason : photo.reason));
  }
  return lines;
}

}  // namespace

Expected<void> write_preview(const Workspace& workspace,
                             const PointCloud& preview,
                             const StreamingReconstruction& stream) {
  if (preview.empty()) return {};
  if (stream.georeferenced()) {
    const auto path = workspace.path(workspace_file::kPreviewOrigin);
    if (auto written = write_origin(path, stream.origin()); !written) return written;
  }
  return write_ply(workspace.path(workspace_file::kPreview), preview);
}

Expected<void> write_cameras(const Workspace& workspace,
                             std::span<const WatchedPhoto> photos,
                             std::span<const LivePhoto> live) {
  std::map<std::string_view, const LivePhoto*> by_name;
  for (const LivePhoto& photo : live) by_name.try_emplace(photo.name, &photo);
  std::string text = "name,arrived_s,latency_s,registered,x,y,z,qx,qy,qz,qw,reason\n";
  for (const WatchedPhoto& photo : photos) {
    const auto found = by_name.find(photo.name);
    const LivePhoto* now = found == by_name.end() ? nullptr : found->second;
    const bool placed = now != nullptr && now->enu_from_camera.has_value();
    text += fmt::format("{},{:.2f},{:.2f},{},",
                        csv_text(photo.name),
                        photo.arrived_s,
                        photo.latency_s,
                        placed ? 1 : 0);
    if (placed) {
      const Eigen::Vector3d& c = now->enu_from_camera->translation;
      const Eigen::Quaterniond& q = now->enu_from_camera->rotation;
      text += fmt::format("{:.4f},{:.4f},{:.4f},{:.7f},{:.7f},{:.7f},{:.7f},\n",
                          c.x(),
                          c.y(),
                          c.z(),
                          q.x(),
                          q.y(),
                          q.z(),
                          q.w());
    } else {
      text += fmt::format(",,,,,,,{}\n", csv_text(now != nullptr ? now->reason : photo.reason));
    }
  }
  return write_file_atomically(workspace.path(workspace_file::kLiveCameras), text);
}

std::string watch_json(std::span<const WatchedPhoto> photos,
                       const StreamingReconstruction& stream) {
  const Latency latency = latency_of(photos);
  const WatchedPhoto& last = photos.back();
  return to_text(Json{{"num_photos", photos.size()},
                      {"num_registered", last.total_registered},
                      {"georeferenced", last.georeferenced},
                      {"not_registered", not_registered(photos, stream.photos())},
                      {"num_preview_points", last.num_preview_points},
                      {"latency_median_s", latency.median_s},
                      {"latency_p90_s", latency.p90_s},
                      {"latency_max_s", latency.max_s},
                      {"lag_s", last.latency_s}});
}

std::vector<std::string> watch_summary(std::span<const WatchedPhoto> photos,
                                       const StreamingReconstruction& stream) {
  const Latency latency = latency_of(photos);
  const WatchedPhoto& last = photos.back();
  std::vector<std::string> lines = {
      fmt::format("{} of {} photos have a pose, {} preview points{}",
                  last.total_registered,
                  photos.size(),
                  last.num_preview_points,
                  last.georeferenced ? "" : ", in an arbitrary frame"),
      fmt::format("latency {:.2f} s median, {:.2f} s of nine in ten, {:.2f} s at most; {:.2f} s of "
                  "the last",
                  latency.median_s,
                  latency.p90_s,
                  latency.max_s,
                  last.latency_s)};
  for (const std::string& line : not_registered(photos, stream.photos())) {
    lines.push_back("without a pose: " + line);
  }
  return lines;
}

}  // namespace hybridfusion
