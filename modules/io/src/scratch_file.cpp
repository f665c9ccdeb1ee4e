#include "scratch_file.hpp"

#include "input_file.hpp"
#include "zstd_stream.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kPrefix = ".hybridfusion-";

}  // namespace

Expected<ScratchFile> ScratchFile::create(const std::filesystem::path& folder) {
  constexpr mode_t kOwnerOnly = 0600;
  std::string name;
  int descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kOwnerOnly);
  if (descriptor < 0 && (errno == EOPNOTSUPP || errno == EISDIR)) {
    name = (folder / (std::string(kPrefix) + "XXXXXX")).string();
    descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  }
  if (descriptor < 0) {
    return fail(
        ErrorCode::kIo,
        fmt::format("{}: no temporary file can be made: {}; set lidar.recording.scratch_folder "
                    "to a folder that can be written",
                    folder.string(),
                    std::strerror(errno)));
  }
  return ScratchFile(folder, descriptor, std::move(name));
}

ScratchFile::ScratchFile(ScratchFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      written_(other.written_),
      name_(std::exchange(other.name_, {})) {}

ScratchFile& ScratchFile::operator=(ScratchFile&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(written_, other.written_);
  std::swap(name_, other.name_);
  return *this;
}

ScratchFile::~ScratchFile() {
  drop_name();
  if (descriptor_ >= 0) ::close(descriptor_);
}

Expected<std::filesystem::path> ScratchFile::give_name() {
  if (!name_.empty()) return name_;
  const std::string own = fmt::format("/proc/self/fd/{}", descriptor_);
  // A name may be taken by a process of the same number that was killed.
  constexpr int kMaxTries = 100;
  for (int i = 0; i < kMaxTries; ++i) {
    std::string name = (folder_ / fmt::format("{}{}-{}", kPrefix, ::getpid(), i)).string();
    if (::linkat(AT_FDCWD, own.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      name_ = std::move(name);
      return name_;
    }
    if (errno != EEXIST) break;
  }
  return fail(ErrorCode::kIo,
              fmt::format("{}: the unpacked recording cannot be opened: {}; set "
                          "lidar.recording.scratch_folder to another folder",
                          folder_.string(),
                          std::strerror(errno)));
}

void ScratchFile::drop_name() {
  if (!name_.empty()) ::unlink(name_.c_str());
  name_.clear();
}

Expected<void> ScratchFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) {
      return fail(ErrorCode::kIo,
                  fmt::format("{}: unpacking stopped after {} bytes: {}; free space there or set "
                              "lidar.recording.scratch_folder to a larger disk",
                              folder_.string(),
                              written_,
                              std::strerror(errno)));
    }
    written_ += static_cast<std::uint64_t>(done);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
  return {};
}

Expected<UnpackedFile> unpack_zstd_file(const std::filesystem::path& path,
                                        const std::filesystem::path& folder,
                                        const RunContext& ctx) {
  constexpr std::uint64_t kPiece = std::uint64_t{1} << 20;
  // Recordings shrink to a half or a tenth; a few bytes that fill the disk are no recording.
  constexpr std::uint64_t kMaxRatio = 1000;
  HF_TRY(InputFile packed, InputFile::open(path));
  HF_TRY(ScratchFile file, ScratchFile::create(folder));
  UnpackedFile unpacked = {.file = std::move(file)};
  ZstdStream stream;
  bool any = false;
  while (packed.remaining() > 0 && stream.problem().empty()) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while unpacking the recording");
    ctx.report({.stage = "map/unpack",
                .done = static_cast<std::int64_t>(packed.position() >> 20U),
                .total = static_cast<std::int64_t>(packed.size() >> 20U)});
    HF_TRY(std::span<const std::byte> piece, packed.take(std::min(kPiece, packed.remaining())));
    while (!piece.empty() || stream.has_more()) {
      const std::span<const std::byte> bytes = stream.unpack(piece);
      if (!stream.problem().empty()) break;
      any = any || !bytes.empty();
      if (unpacked.file.size() > kMaxRatio * (packed.size() + kPiece)) {
        return packed.malformed(fmt::format("it unpacks to more than {} times its size", kMaxRatio),
                                "give a recording");
      }
      if (auto written = unpacked.file.write(bytes); !written) {
        return std::unexpected(written.error());
      }
    }
  }
  unpacked.problem = stream.problem();
  if (unpacked.problem.empty() && !stream.complete()) unpacked.problem = "its zstd data end early";
  if (!any) {
    return packed.malformed(unpacked.problem.empty() ? "nothing is inside" : unpacked.problem,
                            "copy the recording again");
  }
  return unpacked;
}

}  // namespace hybridfusion
