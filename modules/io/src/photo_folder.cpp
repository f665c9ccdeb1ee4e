#include "jpeg_segments.hpp"
#include "text.hpp"

#include <hybridfusion/io/jpeg.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/io/photo_metadata.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

namespace fs = std::filesystem;

struct Listing {
  std::vector<fs::path> photos = {};
  std::size_t num_other_files = 0;
  std::size_t num_folders = 0;
};

Expected<Listing> list_folder(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  if (error) {
    const bool missing = error == std::errc::no_such_file_or_directory;
    return fail(missing ? ErrorCode::kNotFound : ErrorCode::kIo,
                fmt::format("{}: {}; give the folder that holds the photos",
                            folder.string(),
                            missing ? "no such folder" : error.message()));
  }
  Listing listing;
  for (; entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string extension = lower_case(entry->path().extension().string());
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      ++listing.num_folders;
    } else if (extension == ".jpg" || extension == ".jpeg") {
      listing.photos.push_back(entry->path());
    } else {
      ++listing.num_other_files;
    }
    if (error) break;
  }
  std::ranges::sort(listing.photos);
  return listing;
}

/// The message without the path, which the reader of the report knows.
[[nodiscard]] std::string reason_of(const Error& error, const fs::path& path) {
  const std::string prefix = path.string() + ": ";
  return error.message.starts_with(prefix) ? error.message.substr(prefix.size()) : error.message;
}

[[nodiscard]] std::unexpected<Error> no_photos(const fs::path& folder, const Listing& listing) {
  std::string cause = "the folder is empty";
  if (listing.num_other_files > 0 || listing.num_folders > 0) {
    cause = fmt::format(
        "no .jpg or .jpeg files among its {} files and {} subfolders (which are not searched)",
        listing.num_other_files,
        listing.num_folders);
  }
  return fail(
      ErrorCode::kNotFound,
      fmt::format("{}: {}; give the folder that holds the photos as JPEG", folder.string(), cause));
}

}  // namespace

Expected<Photo> open_photo(const fs::path& path) {
  HF_TRY(PhotoMetadata metadata, read_photo_metadata(path));
  HF_TRY(const JpegSegments segments, read_jpeg_segments(path));
  HF_TRY(const bool has_end, has_end_marker(path, segments.scan_begin));
  if (!has_end) {  // only then a whole decoding is spent
    if (auto image = decode_jpeg(path); !image) return std::unexpected(image.error());
  }
  return Photo{.metadata = std::move(metadata), .load = [path] { return decode_jpeg(path); }};
}

Expected<PhotoFolder> open_photo_folder(const fs::path& folder) {
  HF_TRY(const Listing listing, list_folder(folder));
  if (listing.photos.empty()) return no_photos(folder, listing);
  PhotoFolder result = {.folder = folder};
  for (const fs::path& path : listing.photos) {
    auto photo = open_photo(path);
    if (photo) {
      result.photos.push_back(std::move(*photo));
    } else {
      result.quarantined.push_back(
          {.name = path.filename().string(), .reason = reason_of(photo.error(), path)});
    }
  }
  if (result.photos.empty()) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{}: none of the {} JPEG files can be used; the first, {}: {}",
                            folder.string(),
                            result.quarantined.size(),
                            result.quarantined.front().name,
                            result.quarantined.front().reason));
  }
  return result;
}

}  // namespace hybridfusion
