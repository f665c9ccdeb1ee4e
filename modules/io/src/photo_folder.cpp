#include "jpeg_segments.hpp"

#include <hybridfusion/io/jpeg.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/io/photo_metadata.hpp>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

namespace fs = std::filesystem;

/// The message without the path, which the reader of the report knows.
[[nodiscard]] std::string reason_of(const Error& error, const fs::path& path) {
  const std::string prefix = path.string() + ": ";
  return error.message.starts_with(prefix) ? error.message.substr(prefix.size()) : error.message;
}

[[nodiscard]] std::unexpected<Error> no_photos(const fs::path& folder,
                                               const PhotoListing& listing) {
  std::string cause = "the folder is empty";
  if (!listing.other_images.empty()) {
    cause = fmt::format(
        "no JPEG, but {} images of other formats, the first {}; convert them with "
        "their metadata",
        listing.other_images.size(),
        listing.other_images.front());
  } else if (listing.num_other_files > 0 || listing.num_folders > 0) {
    cause = fmt::format("no .jpg or .jpeg files among its {} files and {} subfolders",
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
  HF_TRY(PhotoListing listing, list_photos(folder));
  if (listing.photos.empty()) return no_photos(folder, listing);
  PhotoFolder result = {.folder = folder, .listing = std::move(listing)};
  for (const std::string& name : result.listing.photos) {
    const fs::path path = folder / name;
    auto photo = open_photo(path);
    if (photo) {
      photo->metadata.name = name;
      result.photos.push_back(std::move(*photo));
    } else {
      result.quarantined.push_back({.name = name, .reason = reason_of(photo.error(), path)});
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
