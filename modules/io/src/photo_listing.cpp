#include "text.hpp"

#include <hybridfusion/io/photo_folder.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hybridfusion {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxDepth = 12;  // a card has 2 levels
constexpr std::array<std::string_view, 4> kJpegs = {".jpg", ".jpeg", ".jpe", ".jfif"};
constexpr std::array<std::string_view, 22> kOtherImages = {
    ".png", ".tif", ".tiff", ".dng", ".heic", ".heif", ".webp", ".bmp", ".jp2", ".jxl", ".avif",
    ".gif", ".cr2", ".cr3",  ".nef", ".arw",  ".rw2",  ".orf",  ".raf", ".pef", ".srw", ".raw"};
constexpr std::array<std::string_view, 6> kNoPhotos = {
    "thumbs", "thumbnails", "thumbnail", "@eadir", "__macosx", "$recycle.bin"};

bool is_one_of(std::string_view word, std::span<const std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

class Walk {
 public:
  /// @param below  Names of the folders between, with a slash behind each.
  bool look(const fs::path& folder, const std::string& below, int depth, std::error_code& error) {
    std::error_code ignored;
    // A link may lead back up.
    if (!seen_.insert(fs::canonical(folder, ignored)).second) return true;
    fs::directory_iterator entry(folder, error);
    if (error) return false;
    for (; entry != fs::directory_iterator(); entry.increment(error)) {
      take(*entry, below, depth);
      if (error) return false;
    }
    return true;
  }

  PhotoListing listing = {};

 private:
  void take(const fs::directory_entry& entry, const std::string& below, int depth) {
    const std::string name = entry.path().filename().string();
    std::error_code ignored;
    if (name.starts_with('.')) return;  // hidden, or the second half of a file of macOS (._A.JPG)
    if (entry.is_directory(ignored)) {
      ++listing.num_folders;
      const bool holds_photos =
          depth < kMaxDepth && !is_one_of(lower_case(name), kNoPhotos) &&
          !fs::exists(entry.path() / "run.json", ignored);  // a workspace of this program
      std::error_code error;
      if (!holds_photos || !look(entry.path(), below + name + '/', depth + 1, error)) {
        listing.skipped_folders.push_back(below + name);
      }
      return;
    }
    const std::string extension = lower_case(entry.path().extension().string());
    if (is_one_of(extension, kJpegs)) {
      listing.photos.push_back(below + name);
    } else if (is_one_of(extension, kOtherImages)) {
      listing.other_images.push_back(below + name);
    } else {
      ++listing.num_other_files;
    }
  }

  std::set<fs::path> seen_ = {};
};

std::string without_extension(const std::string& name) {
  return lower_case(name.substr(0, name.rfind('.')));
}

}  // namespace

Expected<PhotoListing> list_photos(const fs::path& folder) {
  std::error_code error;
  if (fs::is_regular_file(folder, error)) {
    return fail(ErrorCode::kNotFound,
                fmt::format("{} is a file; give the folder that holds the photos, {}",
                            folder.string(),
                            folder.has_parent_path() ? folder.parent_path().string() : "."));
  }
  error.clear();
  Walk walk;
  if (!walk.look(folder, "", 0, error)) {
    const bool missing = error == std::errc::no_such_file_or_directory;
    return fail(missing ? ErrorCode::kNotFound : ErrorCode::kIo,
                fmt::format("{}: {}; give the folder that holds the photos",
                            folder.string(),
                            missing ? "no such folder" : error.message()));
  }
  PhotoListing& listing = walk.listing;
  for (auto* names : {&listing.photos, &listing.other_images, &listing.skipped_folders}) {
    std::ranges::sort(*names);
  }
  return std::move(listing);
}

PhotoFolderNotes notes_of(const PhotoListing& listing) {
  PhotoFolderNotes notes;
  std::map<std::string, std::size_t> folders;
  std::size_t below = 0;
  std::set<std::string> read;
  for (const std::string& photo : listing.photos) {
    read.insert(without_extension(photo));
    const std::size_t slash = photo.rfind('/');
    if (slash == std::string::npos) continue;
    ++folders[photo.substr(0, slash)];
    ++below;
  }
  if (below > 0) {
    std::vector<std::string> parts;
    for (const auto& [name, count] : folders) parts.push_back(fmt::format("{} ({})", name, count));
    notes.facts.push_back(fmt::format("{} of {} photos lie in subfolders: {}",
                                      below,
                                      listing.photos.size(),
                                      fmt::join(parts, ", ")));
  }
  if (!listing.skipped_folders.empty()) {
    notes.facts.push_back(fmt::format("subfolders that are not searched: {}",
                                      fmt::join(listing.skipped_folders, ", ")));
  }
  std::size_t copies = 0;
  for (const std::string& image : listing.other_images) {
    if (read.contains(without_extension(image))) {
      ++copies;
    } else {
      notes.left_out.push_back(image);
    }
  }
  if (copies > 0) {
    notes.facts.push_back(
        fmt::format("{} image files that are no JPEG stand beside a JPEG of the same name, which "
                    "is read instead",
                    copies));
  }
  return notes;
}

}  // namespace hybridfusion
