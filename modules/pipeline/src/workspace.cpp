#include <hybridfusion/pipeline/workspace.hpp>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

Expected<void> create_folder(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (!code) return {};
  return fail(ErrorCode::kIo,
              fmt::format("{}: the folder cannot be created ({}); choose another --output",
                          folder.string(),
                          code.message()));
}

}  // namespace

Expected<Workspace> Workspace::open(const std::filesystem::path& root) {
  if (const auto created = create_folder(root); !created) return std::unexpected(created.error());
  const std::filesystem::path lock_path = root / ".lock";
  const int lock = ::open(lock_path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
  if (lock < 0) {
    return fail(ErrorCode::kIo,
                fmt::format("{}: cannot be written ({}); check the permissions of the workspace",
                            lock_path.string(),
                            std::strerror(errno)));
  }
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock);
    return fail(ErrorCode::kIo,
                fmt::format("{}: another hybridfusion process works in this workspace; wait for it "
                            "or choose another --output",
                            root.string()));
  }
  return Workspace(root, lock);
}

Workspace::Workspace(Workspace&& other) noexcept
    : root_(std::move(other.root_)), lock_(std::exchange(other.lock_, -1)) {}

Workspace& Workspace::operator=(Workspace&& other) noexcept {
  std::swap(root_, other.root_);
  std::swap(lock_, other.lock_);
  return *this;
}

Workspace::~Workspace() {
  if (lock_ >= 0) ::close(lock_);
}

bool Workspace::has(std::string_view relative) const {
  std::error_code code;
  return std::filesystem::is_regular_file(root_ / relative, code);
}

Expected<void> Workspace::make_folder(std::string_view relative) const {
  return create_folder(root_ / relative);
}

void Workspace::remove(std::string_view relative) const {
  std::error_code code;
  std::filesystem::remove(root_ / relative, code);
}

}  // namespace hybridfusion
