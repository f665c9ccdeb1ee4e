#include "colmap_formats.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hybridfusion {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool holds_model(const fs::path& folder) {
  return is_file(folder / "cameras.bin") || is_file(folder / "cameras.txt");
}

/// Folders below that hold a model: "sparse/0".
std::vector<std::string> models_below(const fs::path& folder) {
  constexpr int kMaxDepth = 2;
  constexpr std::size_t kMaxLooked = 10000;
  std::vector<std::string> found;
  std::error_code error;
  std::size_t looked = 0;
  fs::recursive_directory_iterator entry(
      folder, fs::directory_options::skip_permission_denied, error);
  while (!error && entry != fs::recursive_directory_iterator() && ++looked < kMaxLooked) {
    if (entry.depth() >= kMaxDepth) entry.disable_recursion_pending();
    std::error_code ignored;
    if (entry->is_directory(ignored) && holds_model(entry->path())) {
      found.push_back(entry->path().string());
    }
    entry.increment(error);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

std::vector<fs::path> colmap_files(const fs::path& folder) {
  const char* const extension = is_file(folder / "cameras.bin") ? ".bin" : ".txt";
  std::vector<fs::path> files;
  for (const char* name : {"cameras", "images", "points3D"}) {
    files.push_back(folder / (std::string(name) + extension));
  }
  return files;
}

Expected<ColmapModel> read_colmap_model(const fs::path& folder) {
  if (!holds_model(folder)) {
    const std::vector<std::string> below = models_below(folder);
    return fail(ErrorCode::kNotFound,
                fmt::format("{}: no COLMAP model (cameras.bin or cameras.txt); {}",
                            folder.string(),
                            below.empty() ? std::string("give the folder that holds one")
                                          : fmt::format("give {}", fmt::join(below, " or "))));
  }
  return is_file(folder / "cameras.bin") ? read_colmap_binary(folder) : read_colmap_text(folder);
}

}  // namespace hybridfusion
