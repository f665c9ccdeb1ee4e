#include "bag_scan_source.hpp"
#include "recording_reader.hpp"
#include "recording_topics.hpp"
#include "scan_folder.hpp"

#include <hybridfusion/io/scan_source.hpp>

#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] RecordingSummary summarize(const RecordingReader& reader) {
  RecordingSummary summary;
  summary.format = std::visit([](const auto& bag) { return bag.format(); }, reader);
  summary.topics = recording_topics(connections_of(reader));
  return summary;
}

[[nodiscard]] RecordingSetup setup_for(const std::filesystem::path& path,
                                       const RecordingOptions& options,
                                       const RunContext& ctx) {
  RecordingSetup setup = {.scratch_folder = options.scratch_folder, .context = ctx};
  if (setup.scratch_folder.empty()) {
    setup.scratch_folder = std::filesystem::absolute(path).parent_path();
  }
  return setup;
}

}  // namespace

Expected<std::unique_ptr<ScanSource>> open_recording(const std::filesystem::path& path,
                                                     const RecordingOptions& options,
                                                     const RunContext& ctx) {
  if (auto valid = validate(options, "recording"); !valid) return std::unexpected(valid.error());
  HF_TRY(const Container container, container_of(path));
  if (container == Container::kScanFolder) return open_scan_folder(path, options);
  HF_TRY(RecordingReader reader,
         open_recording_reader(path, container, setup_for(path, options, ctx)));
  RecordingSummary summary = summarize(reader);
  if (auto chosen = choose_topics(path, options, Require::kLidar, summary); !chosen) {
    return std::unexpected(chosen.error());
  }
  std::vector<std::string> topics = {summary.lidar_topic, summary.imu_topic, summary.gnss_topic};
  std::erase(topics, "");
  std::visit([&topics](auto& bag) { bag.select_topics(topics); }, reader);
  return std::make_unique<BagScanSource>(std::move(reader), std::move(summary), options);
}

Expected<std::vector<std::filesystem::path>> recording_files(const std::filesystem::path& path) {
  HF_TRY(const Container container, container_of(path));
  if (container == Container::kScanFolder) return scan_folder_files(path);
  if (container == Container::kRos2Folder) return ros2_bag_files(path);
  return std::vector<std::filesystem::path>{path};
}

Expected<RecordingSummary> inspect_recording(const std::filesystem::path& path,
                                             const RecordingOptions& options,
                                             const RunContext& ctx) {
  HF_TRY(const Container container, container_of(path));
  if (container == Container::kScanFolder) return inspect_scan_folder(path);
  HF_TRY(const RecordingReader reader,
         open_recording_reader(path, container, setup_for(path, options, ctx)));
  RecordingSummary summary = summarize(reader);
  if (auto chosen = choose_topics(path, options, Require::kNothing, summary); !chosen) {
    return std::unexpected(chosen.error());
  }
  add_reading_notes(reader, summary);
  return summary;
}

}  // namespace hybridfusion
