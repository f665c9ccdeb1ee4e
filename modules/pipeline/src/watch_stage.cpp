#include "json_text.hpp"
#include "photo_arrivals.hpp"
#include "photo_cache_files.hpp"
#include "stage_meter.hpp"
#include "watch_files.hpp"

#include <hybridfusion/io/geo_tags.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/watch.hpp>
#include <hybridfusion/vision/streaming_reconstruction.hpp>

#include <algorithm>
#include <deque>
#include <future>
#include <iterator>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

using Clock = PhotoArrivals::Clock;

constexpr std::chrono::milliseconds kLookEvery{25};
constexpr std::size_t kPreparedAhead = 2;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// Each photo has the same steps: their bars would say nothing of the flight.
RunContext without_progress(RunContext ctx) {
  ctx.progress = {};
  return ctx;
}

/// A photo whose features are being extracted while others are worked off.
struct Pending {
  PhotoArrival arrival = {};
  std::future<PreparedPhoto> prepared = {};
};

class Watch {
 public:
  Watch(Project& project, const WatchRequest& request, const RunContext& ctx)
      : project_(project),
        request_(request),
        ctx_(without_progress(ctx)),
        cache_(open_photo_cache(project.workspace, ctx)),
        stream_({.reconstruction = project.options.vision.reconstruction,
                 .densify = project.options.vision.densify,
                 .live = project.options.watch,
                 .cache = cache_}),
        arrivals_(request.inputs.images) {}

  [[nodiscard]] Expected<StageOutcome> run();

 private:
  [[nodiscard]] Expected<void> look();
  void start_preparing();
  void tag(Photo& photo);
  [[nodiscard]] Expected<void> work_off(Pending& pending);
  [[nodiscard]] Expected<void> record(const PhotoArrival& arrival, WatchedPhoto photo);
  [[nodiscard]] StageOutcome outcome() const;

  Project& project_;
  const WatchRequest& request_;
  const RunContext ctx_;
  const StageMeter meter_ = {};
  const Clock::time_point start_ = Clock::now();
  PhotoCache cache_;
  StreamingReconstruction stream_;
  PhotoArrivals arrivals_;
  Clock::time_point last_arrival_ = Clock::now();
  std::deque<PhotoArrival> waiting_ = {};
  std::deque<Pending> pending_ = {};  // waits for its threads: before what they use is gone
  std::vector<WatchedPhoto> photos_ = {};
  double cpu_before_s_ = 0.0;
  bool preview_current_ = true;
};

Expected<void> Watch::look() {
  const Clock::time_point now = Clock::now();
  HF_TRY(std::vector<PhotoArrival> arrived, arrivals_.look(now));
  if (!arrived.empty() || arrivals_.expects_more()) last_arrival_ = now;
  std::ranges::move(arrived, std::back_inserter(waiting_));
  return {};
}

/// Positions of geo.txt replace those of the photo, as in reconstruct_stage.
void Watch::tag(Photo& photo) {
  std::error_code ignored;
  const std::filesystem::path beside = request_.inputs.images / "geo.txt";
  const std::filesystem::path path = request_.inputs.geo_tags.value_or(beside);
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  if (const auto file = read_geo_tags(path)) {
    (void)apply_geo_tags(file->tags, {&photo, 1});
  } else {
    ctx_.warn(file.error().message);
  }
}

void Watch::start_preparing() {
  while (pending_.size() < kPreparedAhead && !waiting_.empty()) {
    Pending next{.arrival = std::move(waiting_.front())};
    waiting_.pop_front();
    if (next.arrival.photo) {
      tag(*next.arrival.photo);
      std::string key =
          photo_cache_key(next.arrival.sha256, project_.options.vision.reconstruction);
      next.prepared =
          std::async(std::launch::async, [this, photo = *next.arrival.photo, key = std::move(key)] {
            return stream_.prepare(photo, key);
          });
    }
    pending_.push_back(std::move(next));
  }
}

Expected<void> Watch::work_off(Pending& pending) {
  WatchedPhoto photo{.name = pending.arrival.name, .reason = pending.arrival.reason};
  if (pending.prepared.valid()) {
    const PreparedPhoto prepared = pending.prepared.get();
    HF_TRY(const PhotoUpdate update, stream_.add(prepared, ctx_));
    photo.num_features = update.num_features;
    photo.num_pairs = update.num_pairs;
    preview_current_ = false;
  }
  return record(pending.arrival, std::move(photo));
}

/// Writes the files with the photo in them and tells of it.
Expected<void> Watch::record(const PhotoArrival& arrival, WatchedPhoto photo) {
  const Workspace& workspace = project_.workspace;
  const std::vector<LivePhoto> live = stream_.photos();
  const auto of_name = std::ranges::find(live, photo.name, &LivePhoto::name);
  if (of_name != live.end() && arrival.photo) {
    photo.registered = of_name->enu_from_camera.has_value();
    photo.reason = of_name->reason;
  }
  photo.arrived_s = seconds_between(start_, arrival.seen);
  // One that was given up before, and came whole later, counts once.
  std::erase_if(photos_, [&](const WatchedPhoto& former) { return former.name == photo.name; });
  photo.total_photos = photos_.size() + 1;
  photo.total_registered = static_cast<std::size_t>(std::ranges::count_if(
      live, [](const LivePhoto& p) { return p.enu_from_camera.has_value(); }));
  photo.georeferenced = stream_.georeferenced();
  if (!preview_current_) {
    const PointCloud preview = stream_.preview();
    photo.num_preview_points = preview.size();
    if (auto written = write_preview(workspace, preview, stream_); !written) return written;
    preview_current_ = true;
  } else if (!photos_.empty()) {
    photo.num_preview_points = photos_.back().num_preview_points;
  }
  photo.latency_s = seconds_between(arrival.seen, Clock::now());
  photos_.push_back(std::move(photo));
  if (auto written = write_cameras(workspace, photos_, live); !written) return written;
  const double cpu_s = meter_.cost().cpu_s;
  photos_.back().latency_s = seconds_between(arrival.seen, Clock::now());
  photos_.back().cpu_s = cpu_s - cpu_before_s_;
  cpu_before_s_ = cpu_s;
  if (request_.on_photo) request_.on_photo(photos_.back());
  return {};
}

Expected<StageOutcome> Watch::run() {
  while (true) {
    if (ctx_.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    if (auto done = look(); !done) return std::unexpected(done.error());
    start_preparing();
    if (pending_.empty()) {
      if (seconds_between(last_arrival_, Clock::now()) >= request_.idle_s) break;
      std::this_thread::sleep_for(kLookEvery);
      continue;
    }
    Pending& next = pending_.front();
    if (next.prepared.valid() && next.prepared.wait_for(kLookEvery) != std::future_status::ready) {
      continue;
    }
    if (auto done = work_off(next); !done) return std::unexpected(done.error());
    pending_.pop_front();
  }
  if (photos_.empty()) {
    return fail(ErrorCode::kNotFound,
                fmt::format("{}: no photo arrived within {:.0f} s (--idle-s)",
                            request_.inputs.images.string(),
                            request_.idle_s));
  }
  return outcome();
}

StageOutcome Watch::outcome() const {
  StageOutcome result{.stage = "watch", .cost = meter_.cost()};
  result.result_json = watch_json(photos_, stream_);
  result.summary = watch_summary(photos_, stream_);
  return result;
}

}  // namespace

Expected<StageOutcome> watch_stage(Project& project,
                                   const WatchRequest& request,
                                   const RunContext& ctx) {
  if (auto made = project.workspace.make_folder("vision"); !made) {
    return std::unexpected(made.error());
  }
  for (const std::string_view name : kWatchFiles) project.workspace.remove(name);
  return Watch(project, request, ctx).run();
}

}  // namespace hybridfusion
