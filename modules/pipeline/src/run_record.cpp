#include "run_record.hpp"

#include "digest.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <chrono>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMaxRunJsonBytes = 256U << 20U;

Json json_of(const std::vector<FileRecord>& files) {
  Json result = Json::array();
  for (const FileRecord& file : files) {
    result.push_back({{"path", file.path},
                      {"size", file.size},
                      {"mtime_ns", file.mtime_ns},
                      {"sha256", file.sha256}});
  }
  return result;
}

std::vector<FileRecord> files_of(const Json& json) {
  std::vector<FileRecord> files;
  for (const Json& file : json) {
    files.push_back({.path = file.at("path"),
                     .size = file.at("size"),
                     .mtime_ns = file.at("mtime_ns"),
                     .sha256 = file.at("sha256")});
  }
  return files;
}

Json json_of(const StageRecord& stage) {
  return {{"seconds", stage.cost.wall_s},
          {"cpu_seconds", stage.cost.cpu_s},
          {"peak_memory_mib", stage.cost.peak_memory_mib},
          {"seed", stage.seed},
          {"threads", stage.threads},
          {"key", stage.key},
          {"inputs", json_of(stage.inputs)},
          {"outputs", json_of(stage.outputs)},
          {"result", Json::parse(stage.result_json)}};
}

StageRecord stage_of(const Json& json) {
  return {.key = json.at("key"),
          .inputs = files_of(json.at("inputs")),
          .outputs = files_of(json.at("outputs")),
          .cost = {.wall_s = json.at("seconds"),
                   .cpu_s = json.at("cpu_seconds"),
                   .peak_memory_mib = json.at("peak_memory_mib")},
          .seed = json.at("seed"),
          .threads = json.at("threads"),
          .result_json = json.at("result").dump()};
}

struct SizeAndTime {
  std::uint64_t size = 0;
  std::int64_t mtime_ns = 0;
};

std::optional<SizeAndTime> size_and_time(const std::filesystem::path& path) {
  std::error_code code;
  const auto size = std::filesystem::file_size(path, code);
  if (code) return std::nullopt;
  const auto time = std::filesystem::last_write_time(path, code);
  if (code) return std::nullopt;
  const auto since_epoch = std::chrono::file_clock::to_sys(time).time_since_epoch();
  return SizeAndTime{size, std::chrono::nanoseconds(since_epoch).count()};
}

std::optional<std::string> known_digest(const RunRecord& known,
                                        const std::string& path,
                                        const SizeAndTime& now) {
  for (const auto& [name, stage] : known.stages) {
    for (const FileRecord& file : stage.inputs) {
      if (file.path == path && file.size == now.size && file.mtime_ns == now.mtime_ns) {
        return file.sha256;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

RunRecord RunRecord::load(const std::filesystem::path& path) {
  RunRecord record;
  const auto text = read_text_file(path, kMaxRunJsonBytes);
  if (!text) return record;
  try {
    const Json json = Json::parse(*text);
    for (const auto& [name, stage] : json.at("stages").items()) {
      record.stages[name] = stage_of(stage);
    }
  } catch (const Json::exception&) {
    return {};
  }
  return record;
}

Expected<void> RunRecord::save(const std::filesystem::path& path) const {
  std::error_code code;
  const std::string own_folder =
      (std::filesystem::weakly_canonical(path, code).parent_path() / "").string();
  Json inputs = Json::array();
  Json seeds = Json::object();
  Json stage_json = Json::object();
  int threads = 0;
  for (const auto& [name, stage] : stages) {
    for (Json& file : json_of(stage.inputs)) {
      // What one stage hands to the next is no input of the run.
      const bool is_own = file["path"].get<std::string>().starts_with(own_folder);
      if (!is_own) inputs.push_back(file);
    }
    seeds[name] = stage.seed;
    threads = stage.threads;
    stage_json[name] = json_of(stage);
  }
  const Json json = {{"program", "hybridfusion"},
                     {"version", program_version()},
                     {"inputs", inputs},
                     {"seeds", seeds},
                     {"threads", threads},
                     {"stages", stage_json}};
  return write_file_atomically(path,
                               json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Expected<std::vector<FileRecord>> describe_files(std::span<const std::filesystem::path> paths,
                                                 const RunRecord& known) {
  std::vector<FileRecord> files;
  for (const std::filesystem::path& path : paths) {
    const auto now = size_and_time(path);
    if (!now) {
      return fail(ErrorCode::kNotFound,
                  fmt::format("{}: there is no such file or it cannot be read; check the path",
                              path.string()));
    }
    std::error_code code;
    const std::string absolute = std::filesystem::weakly_canonical(path, code).string();
    FileRecord file{.path = absolute, .size = now->size, .mtime_ns = now->mtime_ns};
    if (auto digest = known_digest(known, absolute, *now)) {
      file.sha256 = *std::move(digest);
    } else {
      HF_TRY(file.sha256, sha256_of_file(path));
    }
    files.push_back(std::move(file));
  }
  return files;
}

bool is_unchanged(const FileRecord& record, const std::filesystem::path& path) {
  const auto now = size_and_time(path);
  return now && now->size == record.size && now->mtime_ns == record.mtime_ns;
}

}  // namespace hybridfusion
