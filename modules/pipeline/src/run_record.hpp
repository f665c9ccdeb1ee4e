#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// A file as it was when a stage read or wrote it.
struct FileRecord {
  std::string path = {};
  std::uint64_t size = 0;
  std::int64_t mtime_ns = 0;
  std::string sha256 = {};
};

/// What is known of the last complete run of a stage.
struct StageRecord {
  std::string key = {};  ///< Digest of version, options, seed and input contents.
  std::vector<FileRecord> inputs = {};
  std::vector<FileRecord> outputs = {};  ///< Paths relative to the workspace.
  StageCost cost = {};
  std::uint64_t seed = 0;
  int threads = 0;
  std::string result_json = {};
};

/// run.json: provenance for people, memory for the stage cache.
struct RunRecord {
  std::map<std::string, StageRecord> stages = {};

  /// An unreadable or foreign file counts as no record: the stages then run again.
  [[nodiscard]] static RunRecord load(const std::filesystem::path& path);
  [[nodiscard]] Expected<void> save(const std::filesystem::path& path) const;
};

/// Size, time and digest of each file. The digest of a file whose path, size and time are in
/// `known` is taken from there instead of reading the file again.
/// @returns kNotFound for a file that cannot be read.
[[nodiscard]] Expected<std::vector<FileRecord>> describe_files(
    std::span<const std::filesystem::path> paths, const RunRecord& known);

/// Same size and modification time as recorded.
[[nodiscard]] bool is_unchanged(const FileRecord& record, const std::filesystem::path& path);

}  // namespace hybridfusion
