#include "doctor_checks.hpp"
#include "json_text.hpp"

#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/pipeline/workspace.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

namespace fs = std::filesystem;

constexpr double kMiB = 1024.0 * 1024.0;
// Measured with the default options: 29 photos of 1.9 Mpx peak at 1.3 GiB, of which the dense
// matching takes about 11 MiB a photo and the rest does not grow with their number. The estimate
// stays below that, so that it only complains when it is right.
constexpr double kBaseMemory_bytes = 500.0 * kMiB;
constexpr double kMemoryPerPhoto_bytes = 11.0 * kMiB;
constexpr double kDecodedBytesPerPixel =
    8.0;  // the photo itself and its grey copy, a few at a time
// dense.ply, fused.ply and fused.las hold about a point for each 8 pixels of the matched size.
constexpr double kDiskPerPhoto_bytes = 6.0 * kMiB;
constexpr double kDiskPerBagByte = 0.5;  // map.ply against a compressed recording
constexpr double kBaseDisk_bytes = 20.0 * kMiB;

fs::path nearest_existing(const fs::path& path) {
  std::error_code ignored;
  fs::path folder = fs::absolute(path, ignored).lexically_normal();
  while (!fs::exists(folder, ignored) && folder.has_relative_path()) folder = folder.parent_path();
  return folder;
}

/// A number of bytes in a file of the control group; nothing for "max" or no such file.
std::optional<std::uint64_t> cgroup_bytes(const char* path) {
  std::ifstream file(path);
  std::uint64_t bytes = 0;
  return file >> bytes ? std::optional(bytes) : std::nullopt;
}

std::optional<std::uint64_t> free_memory() {
  std::ifstream info("/proc/meminfo");
  std::string word;
  std::optional<std::uint64_t> available;
  while (info >> word) {
    std::uint64_t kib = 0;
    if (word == "MemAvailable:" && info >> kib) {
      available = kib * 1024U;
      break;
    }
  }
  const auto lower = [&available](std::uint64_t bytes) {
    available = std::min(available.value_or(bytes), bytes);
  };
  const auto limit = cgroup_bytes("/sys/fs/cgroup/memory.max");
  const auto used = cgroup_bytes("/sys/fs/cgroup/memory.current");
  if (limit && used) lower(*limit - std::min(*limit, *used));
  rlimit space{};
  if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY) lower(space.rlim_cur);
  return available;
}

std::string gib(double bytes) {
  return fmt::format("{:.1f} GiB", bytes / (1024.0 * kMiB));
}

bool is_locked(const fs::path& workspace) {
  const int lock = ::open((workspace / ".lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (lock < 0) return false;
  const bool held = ::flock(lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(lock);
  return held;
}

void check_version(const fs::path& workspace, Diagnosis& diagnosis) {
  const fs::path path = workspace / workspace_file::kRun;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return;
  const auto json = read_json(path);
  const bool named =
      json && json->is_object() && json->contains("version") && (*json)["version"].is_string();
  const std::string version = named ? (*json)["version"].get<std::string>() : "an unknown version";
  if (version == program_version()) return;
  diagnosis.findings.add("output.other_version",
                         fmt::format("{} was written by {}, this is {}",
                                     path.string(),
                                     listed({&version, 1}),
                                     program_version()));
}

}  // namespace

MachineState machine_state(const std::optional<fs::path>& output) {
  MachineState state{.memory_bytes = free_memory()};
  if (!output) return state;
  std::error_code code;
  const fs::space_info space = fs::space(nearest_existing(*output), code);
  if (!code) state.disk_bytes = space.available;
  return state;
}

void check_machine(const MachineState& machine,
                   const PhotoEvidence& photos,
                   const RecordingEvidence& recording,
                   Diagnosis& diagnosis) {
  const auto count = static_cast<double>(photos.num_photos);
  if (machine.memory_bytes) {
    const auto free = static_cast<double>(*machine.memory_bytes);
    const double need = kBaseMemory_bytes + count * kMemoryPerPhoto_bytes +
                        kDecodedBytesPerPixel * photos.width_px * photos.height_px;
    diagnosis.facts.push_back(fmt::format("memory: {} free", gib(free)));
    if (photos.num_photos > 0 && need > free) {
      diagnosis.findings.add(
          "machine.memory",
          fmt::format(
              "{} photos need at least {}, {} is free", photos.num_photos, gib(need), gib(free)));
    }
  }
  if (machine.disk_bytes) {
    const auto free = static_cast<double>(*machine.disk_bytes);
    const double need = kBaseDisk_bytes + count * kDiskPerPhoto_bytes +
                        kDiskPerBagByte * static_cast<double>(recording.size_bytes);
    diagnosis.facts.push_back(fmt::format("disk: {} free at the output", gib(free)));
    if (need > free) {
      diagnosis.findings.add(
          "machine.disk",
          fmt::format("the result needs about {}, {} is free", gib(need), gib(free)));
    }
  }
}

void check_workspace(const fs::path& workspace, Diagnosis& diagnosis) {
  const fs::path folder = nearest_existing(workspace);
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    diagnosis.findings.add("output.not_writable", folder.string() + " is not a folder");
    return;
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    diagnosis.findings.add("output.not_writable",
                           fmt::format("{}: {}", folder.string(), std::strerror(errno)));
    return;
  }
  if (!fs::is_directory(workspace, ignored)) return;  // it will be made
  if (is_locked(workspace)) {
    diagnosis.findings.add("output.locked", workspace.string() + " is in use");
  }
  check_version(workspace, diagnosis);
}

}  // namespace hybridfusion
