#include "photo_cache_files.hpp"

#include "digest.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <atomic>
#include <fstream>
#include <memory>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kFolder = "vision/cache";
constexpr std::uint64_t kMaxEntryBytes = 256U << 20U;

/// Not flushed to the disk as results are: a torn file shows by its checksum and costs time only.
bool put(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path part = path;
  part += ".new";
  std::error_code error;
  {
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
      std::filesystem::remove(part, error);
      return false;
    }
  }
  std::filesystem::rename(part, path, error);
  return !error;
}

}  // namespace

std::string photo_cache_key(const std::string& photo_sha256, const ReconstructionOptions& options) {
  std::string text = fmt::format("{} {}\n", program_version(), photo_sha256);
  append_reference(text, options.features);
  append_reference(text, options.matching);
  return sha256_of(text).substr(0, 32);
}

PhotoCache open_photo_cache(const Workspace& workspace, const RunContext& ctx) {
  if (auto made = workspace.make_folder(kFolder); !made) {
    ctx.warn(fmt::format("features are not kept: {}", made.error().message));
    return {};
  }
  const std::filesystem::path folder = workspace.path(kFolder);
  const auto full = std::make_shared<std::atomic<bool>>(false);
  PhotoCache cache;
  cache.load = [folder](const std::string& name) -> std::optional<std::string> {
    auto bytes = read_text_file(folder / name, kMaxEntryBytes);
    if (!bytes) return std::nullopt;
    return *std::move(bytes);
  };
  cache.save = [folder, full, warn = ctx.log](const std::string& name, std::string_view bytes) {
    if (*full || put(folder / name, bytes) || full->exchange(true) || !warn) return;
    std::string message = folder.string();
    message += " cannot be written: features are not kept from here on";
    warn(LogLevel::kWarning, message);
  };
  return cache;
}

void remove_photo_cache(const Workspace& workspace) {
  std::error_code ignored;
  std::filesystem::remove_all(workspace.path(kFolder), ignored);
}

}  // namespace hybridfusion
