#include "served_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

bool lies_in(const std::filesystem::path& root, const std::filesystem::path& path) {
  return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

Expected<OpenContent> OpenContent::open(const std::filesystem::path& root, const ServedFile& file) {
  OpenContent content;
  if (const auto* bytes = std::get_if<std::string_view>(&file.content)) {
    content.bytes_ = *bytes;
    content.size_ = bytes->size();
    return content;
  }
  const auto& path = std::get<std::filesystem::path>(file.content);
  const auto refused = [&](std::string_view why) {
    return fail(ErrorCode::kNotFound, fmt::format("{}: {}; it is not shown", path.string(), why));
  };
  std::error_code code;
  const std::filesystem::path real_root = std::filesystem::canonical(root, code);
  if (code) return refused(code.message());
  const std::filesystem::path real = std::filesystem::canonical(path, code);
  if (code) return refused(code.message());
  if (!lies_in(real_root, real)) return refused("lies outside of " + root.string());
  // Without O_NONBLOCK a pipe in the place of the file would wait for a writer.
  content.descriptor_ = ::open(real.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (content.descriptor_ < 0) return refused(std::strerror(errno));
  struct stat status = {};
  if (::fstat(content.descriptor_, &status) != 0) return refused(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) return refused("is no regular file");
  content.size_ = static_cast<std::uint64_t>(status.st_size);
  return content;
}

OpenContent::OpenContent(OpenContent&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), bytes_(other.bytes_), size_(other.size_) {}

OpenContent& OpenContent::operator=(OpenContent&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(bytes_, other.bytes_);
  std::swap(size_, other.size_);
  return *this;
}

OpenContent::~OpenContent() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t OpenContent::read(std::uint64_t offset, std::span<char> buffer) const {
  if (offset >= size_) return 0;
  const std::size_t wanted = std::min<std::uint64_t>(buffer.size(), size_ - offset);
  if (descriptor_ < 0) {
    std::memcpy(buffer.data(), bytes_.data() + offset, wanted);
    return wanted;
  }
  const ssize_t got = ::pread(descriptor_, buffer.data(), wanted, static_cast<off_t>(offset));
  return got > 0 ? static_cast<std::size_t>(got) : 0;
}

std::optional<ByteRange> parse_range(std::string_view header, std::uint64_t size) {
  constexpr std::string_view kUnit = "bytes=";
  if (!header.starts_with(kUnit) || size == 0) return std::nullopt;
  const std::string_view spec = header.substr(kUnit.size());
  const std::size_t dash = spec.find('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const auto first = number(spec.substr(0, dash));
  const auto last = number(spec.substr(dash + 1));
  if (dash == 0) {
    if (!last || *last == 0) return std::nullopt;
    return ByteRange{.first = size - std::min(size, *last), .last = size - 1};
  }
  const bool open_end = dash + 1 == spec.size();
  if (!first || *first >= size || (!last && !open_end)) return std::nullopt;
  if (last && *last < *first) return std::nullopt;
  return ByteRange{.first = *first, .last = open_end ? size - 1 : std::min(*last, size - 1)};
}

}  // namespace hybridfusion
