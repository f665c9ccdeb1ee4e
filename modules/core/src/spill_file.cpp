#include <hybridfusion/core/spill_file.hpp>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

std::unexpected<Error> io_error(const std::filesystem::path& folder, const char* doing) {
  return fail(ErrorCode::kIo,
              fmt::format("{}: {} a temporary file: {}; room is needed there for what does not fit "
                          "into memory: 30 bytes a point of a recording, 14 a pixel of a depth map",
                          folder.string(),
                          doing,
                          std::strerror(errno)));
}

}  // namespace

Expected<SpillFile> SpillFile::create(const std::filesystem::path& folder) {
  std::string name = (folder / ".hybridfusion-XXXXXX").string();
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor < 0) return io_error(folder, "cannot create");
  (void)::unlink(name.c_str());
  SpillFile file;
  file.descriptor_ = descriptor;
  file.folder_ = folder;
  return file;
}

Expected<SpillFile> SpillFile::another() const {
  if (in_memory()) return SpillFile();
  return create(folder_);
}

SpillFile::SpillFile(SpillFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      folder_(std::move(other.folder_)),
      blocks_(std::move(other.blocks_)) {}

SpillFile& SpillFile::operator=(SpillFile&& other) noexcept {
  if (this == &other) return *this;
  close();
  descriptor_ = std::exchange(other.descriptor_, -1);
  size_ = other.size_;
  folder_ = std::move(other.folder_);
  blocks_ = std::move(other.blocks_);
  return *this;
}

SpillFile::~SpillFile() {
  close();
}

void SpillFile::close() noexcept {
  if (descriptor_ >= 0) (void)::close(descriptor_);
  descriptor_ = -1;
}

Expected<SpillFile::Block> SpillFile::append(std::span<const std::byte> bytes) {
  Block block{.at = size_, .size = static_cast<std::uint32_t>(bytes.size())};
  if (in_memory()) {
    block.at = blocks_.size();
    blocks_.emplace_back(bytes.begin(), bytes.end());
    return block;
  }
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::pwrite(
        descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(size_ + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return io_error(folder_, "cannot write");
    done += static_cast<std::size_t>(written);
  }
  size_ += bytes.size();
  return block;
}

Expected<void> SpillFile::read(const Block& block, std::vector<std::byte>& out) const {
  if (in_memory()) {
    out = blocks_[block.at];
    return {};
  }
  out.resize(block.size);
  for (std::size_t done = 0; done < out.size();) {
    const ssize_t count = ::pread(
        descriptor_, out.data() + done, out.size() - done, static_cast<off_t>(block.at + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return io_error(folder_, "cannot read");
    done += static_cast<std::size_t>(count);
  }
  return {};
}

void SpillFile::drop(const Block& block) {
  if (in_memory()) {
    std::vector<std::byte>().swap(blocks_[block.at]);
    return;
  }
  // Not every file system can; then the room comes back when the file goes.
  (void)::fallocate(descriptor_,
                    FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                    static_cast<off_t>(block.at),
                    static_cast<off_t>(block.size));
}

}  // namespace hybridfusion
