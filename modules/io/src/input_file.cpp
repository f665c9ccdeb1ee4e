#include "input_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr std::size_t kMaxLineBytes = std::size_t{1} << 26;

[[nodiscard]] bool is_space(std::byte byte) {
  const auto c = static_cast<char>(byte);
  return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\v' || c == '\f';
}

}  // namespace

InputFile::InputFile(std::filesystem::path path, int descriptor, std::uint64_t size)
    : path_(std::move(path)), descriptor_(descriptor), size_(size) {}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      position_(other.position_),
      buffer_(std::move(other.buffer_)),
      begin_(other.begin_),
      end_(other.end_) {}

InputFile& InputFile::operator=(InputFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  std::swap(position_, other.position_);
  std::swap(buffer_, other.buffer_);
  std::swap(begin_, other.begin_);
  std::swap(end_, other.end_);
  return *this;
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Expected<InputFile> InputFile::open(const std::filesystem::path& path,
                                    const std::filesystem::path& name) {
  // O_NONBLOCK: opening a pipe by mistake must not hang.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    const int reason = errno;
    const bool missing = reason == ENOENT || reason == ENOTDIR;
    return fail(missing ? ErrorCode::kNotFound : ErrorCode::kIo,
                fmt::format("{}: {}; check the path{}",
                            path.string(),
                            missing ? "no such file" : std::strerror(reason),
                            missing ? "" : " and its permissions"));
  }
  struct stat status = {};
  const bool known = ::fstat(descriptor, &status) == 0;
  InputFile file(name.empty() ? path : name,
                 descriptor,
                 known ? static_cast<std::uint64_t>(status.st_size) : 0);
  if (!known || !S_ISREG(status.st_mode)) {
    return file.malformed("not a regular file", "give the path of a file");
  }
  if (file.size_ == 0) return file.malformed("the file is empty", "copy or record it again");
  HF_TRY(const bool pointer, file.is_lfs_pointer());
  if (pointer) {
    return file.malformed("a pointer of Git LFS, not the file itself",
                          "fetch it with 'git lfs pull' in its repository");
  }
  return file;
}

std::unexpected<Error> InputFile::malformed(std::string_view cause,
                                            std::string_view remedy,
                                            std::source_location where) const {
  return fail(ErrorCode::kParse, fmt::format("{}: {}; {}", path_.string(), cause, remedy), where);
}

/// What a repository holds in place of a large file that was not fetched: three lines of text.
Expected<bool> InputFile::is_lfs_pointer() {
  constexpr std::string_view kStart = "version https://git-lfs.github.com/spec/";
  constexpr std::uint64_t kMaxBytes = 1024;  // github.com/git-lfs, docs/spec.md
  if (size_ < kStart.size() || size_ >= kMaxBytes) return false;
  HF_TRY(const auto bytes, fill(kStart.size()));
  return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()) == kStart;
}

Expected<std::span<const std::byte>> InputFile::fill(std::size_t count) {
  const auto available = [this] { return end_ - begin_; };
  if (available() < count && available() < remaining()) {
    const std::uint64_t wanted =
        std::min<std::uint64_t>(remaining(), std::max<std::uint64_t>(count, kBufferBytes));
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_),
              buffer_.begin());
    end_ -= std::exchange(begin_, 0);
    if (buffer_.size() < wanted) buffer_.resize(wanted);
    while (end_ < wanted) {
      const ssize_t got = ::pread(
          descriptor_, buffer_.data() + end_, wanted - end_, static_cast<off_t>(position_ + end_));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) {
        return fail(ErrorCode::kIo,
                    fmt::format("{}: reading at byte {}: {}; check the disk",
                                path_.string(),
                                position_ + end_,
                                std::strerror(errno)));
      }
      if (got == 0) {
        size_ = position_ + end_;  // the file became shorter while it was read
        break;
      }
      end_ += static_cast<std::size_t>(got);
    }
  }
  return std::span(buffer_).subspan(begin_, std::min(available(), count));
}

Expected<std::span<const std::byte>> InputFile::take(std::uint64_t count) {
  if (count > remaining()) {
    return malformed(
        fmt::format(
            "truncated: {} bytes expected at byte {}, {} left", count, position_, remaining()),
        "copy or export the file again");
  }
  HF_TRY(const auto bytes, fill(count));
  if (bytes.size() < count) return malformed("the file became shorter while it was read");
  begin_ += count;
  position_ += count;
  return bytes;
}

Expected<std::optional<std::string_view>> InputFile::line() {
  if (remaining() == 0) return std::nullopt;
  for (std::size_t window = 256;; window *= 4) {
    HF_TRY(const auto bytes, fill(std::min(window, kMaxLineBytes)));
    const auto newline = std::ranges::find(bytes, std::byte{'\n'});
    const bool complete = newline != bytes.end();
    if (!complete && bytes.size() < remaining()) {
      if (window >= kMaxLineBytes) {
        return malformed(
            fmt::format("a line of more than {} bytes at byte {}", kMaxLineBytes, position_),
            "check that this is a text file of the expected format");
      }
      continue;
    }
    const auto length = static_cast<std::size_t>(newline - bytes.begin());
    begin_ += length + (complete ? 1 : 0);
    position_ += length + (complete ? 1 : 0);
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), length);
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }
}

Expected<std::optional<std::string_view>> InputFile::token() {
  while (remaining() > 0) {
    HF_TRY(const auto bytes, fill(256));
    const auto first = std::ranges::find_if_not(bytes, is_space);
    const auto last = std::find_if(first, bytes.end(), is_space);
    const bool complete = last != bytes.end() || bytes.size() == remaining();
    const auto skipped = static_cast<std::size_t>(first - bytes.begin());
    const auto length = static_cast<std::size_t>(last - first);
    if (length > 0 && !complete && skipped == 0) {
      return malformed(fmt::format("a word of more than 255 characters at byte {}", position_),
                       "check that this is a text file of the expected format");
    }
    begin_ += skipped;
    position_ += skipped;
    if (length == 0 || !complete) continue;
    begin_ += length;
    position_ += length;
    return std::string_view(reinterpret_cast<const char*>(&*first), length);
  }
  return std::nullopt;
}

void InputFile::seek(std::uint64_t position) {
  position_ = std::min(position, size_);
  begin_ = end_ = 0;
}

Expected<void> InputFile::skip(std::uint64_t count) {
  if (count > remaining()) {
    return malformed(
        fmt::format(
            "truncated: {} bytes expected at byte {}, {} left", count, position_, remaining()),
        "copy or export the file again");
  }
  const std::uint64_t buffered = std::min<std::uint64_t>(count, end_ - begin_);
  begin_ += buffered;
  position_ += count;
  if (buffered < count) begin_ = end_ = 0;
  return {};
}

}  // namespace hybridfusion
