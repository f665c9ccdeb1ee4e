#include "input_file.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;

[[nodiscard]] std::filesystem::path part_path(std::filesystem::path path) {
  path += ".part";
  return path;
}

/// Makes the new name itself survive a power cut. A file system that cannot do it is no error.
void sync_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path, int descriptor)
    : path_(std::move(path)), descriptor_(descriptor) {
  buffer_.reserve(kBufferBytes);
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      error_number_(other.error_number_),
      written_(other.written_),
      buffer_(std::move(other.buffer_)) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(error_number_, other.error_number_);
  std::swap(written_, other.written_);
  std::swap(buffer_, other.buffer_);
  return *this;
}

AtomicFile::~AtomicFile() {
  discard();
}

Expected<AtomicFile> AtomicFile::create(const std::filesystem::path& path) {
  const std::filesystem::path part = part_path(path);
  // O_NOFOLLOW: a link planted under the temporary name must not redirect the output.
  const int descriptor =
      ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor < 0) {
    return fail(ErrorCode::kIo,
                fmt::format("cannot create {}: {}; check that the folder exists and is writable",
                            part.string(),
                            std::strerror(errno)));
  }
  return AtomicFile(path, descriptor);
}

void AtomicFile::discard() noexcept {
  if (descriptor_ < 0) return;
  ::close(std::exchange(descriptor_, -1));
  std::error_code ignored;
  std::filesystem::remove(part_path(path_), ignored);
}

void AtomicFile::flush() {
  std::size_t done = 0;
  while (error_number_ == 0 && done < buffer_.size()) {
    const ssize_t count = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      error_number_ = errno;
    }
  }
  written_ += done;
  buffer_.clear();
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty() && error_number_ == 0) {
    const std::size_t count = std::min(bytes.size(), kBufferBytes - buffer_.size());
    buffer_.insert(
        buffer_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    bytes = bytes.subspan(count);
    if (buffer_.size() == kBufferBytes) flush();
  }
}

void AtomicFile::write(std::string_view text) {
  write(std::as_bytes(std::span(text)));
}

void AtomicFile::overwrite_start(std::string_view text) {
  flush();
  HF_CHECK(text.size() <= written_ || error_number_ != 0);
  for (std::size_t done = 0; error_number_ == 0 && done < text.size();) {
    const ssize_t count =
        ::pwrite(descriptor_, text.data() + done, text.size() - done, static_cast<off_t>(done));
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      error_number_ = errno;
    }
  }
}

Expected<void> AtomicFile::commit() {
  HF_CHECK(descriptor_ >= 0);
  flush();
  if (error_number_ == 0 && ::fsync(descriptor_) != 0) error_number_ = errno;
  const std::filesystem::path part = part_path(path_);
  if (error_number_ == 0 && ::rename(part.c_str(), path_.c_str()) != 0) error_number_ = errno;
  if (error_number_ != 0) {
    discard();
    return fail(ErrorCode::kIo,
                fmt::format("cannot write {} ({} bytes written): {}; free space or choose another "
                            "output folder",
                            path_.string(),
                            written_,
                            std::strerror(error_number_)));
  }
  ::close(std::exchange(descriptor_, -1));
  sync_folder_of(path_);
  return {};
}

Expected<void> write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  file.write(bytes);
  return file.commit();
}

Expected<std::string> read_text_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
  HF_TRY(InputFile file, InputFile::open(path));
  if (file.size() > max_bytes) {
    return file.malformed(
        fmt::format("{} bytes are more than a file of this kind has ({})", file.size(), max_bytes),
        "check that this is the right file");
  }
  HF_TRY(const auto bytes, file.take(file.size()));
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

}  // namespace hybridfusion
