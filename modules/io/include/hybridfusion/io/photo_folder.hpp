#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hybridfusion {

/// A file that looks like a photo by its name but cannot be used.
struct QuarantinedPhoto {
  std::string name = {};    ///< As PhotoMetadata::name.
  std::string reason = {};  ///< For a person: "empty file", "truncated or damaged: ...".
};

/// Names of image files below a folder, with the folders between ("101MEDIA/IMG_0001.JPG"), sorted.
struct PhotoListing {
  std::vector<std::string> photos = {};           ///< *.jpg, *.jpeg, *.jpe, *.jfif in any case.
  std::vector<std::string> other_images = {};     ///< Of formats that are not read: PNG, TIFF, raw.
  std::vector<std::string> skipped_folders = {};  ///< Thumbnails, workspaces, what cannot be read.
  std::size_t num_other_files = 0;
  std::size_t num_folders = 0;
};

/// Looks through the folder and those below it. Hidden ones are passed over.
/// @returns kNotFound for a missing folder or a file in its place; kIo.
[[nodiscard]] Expected<PhotoListing> list_photos(const std::filesystem::path& folder);

struct PhotoFolder {
  std::filesystem::path folder = {};
  std::vector<Photo> photos = {};  ///< Sorted by name; pixels are decoded by Photo::load.
  std::vector<QuarantinedPhoto> quarantined = {};  ///< Sorted by name.
  PhotoListing listing = {};
};

/// What a person should know of a folder besides its photos.
struct PhotoFolderNotes {
  std::vector<std::string> facts = {};  ///< "3 of 8 photos lie in subfolders: 101MEDIA (3)".
  /// Image files that are left out although no photo is a copy of them; empty: none.
  std::vector<std::string> left_out = {};
};
[[nodiscard]] PhotoFolderNotes notes_of(const PhotoListing& listing);

/// One photo, its metadata read. @returns kNotFound; kParse for a file that is empty, truncated or
/// no JPEG. Damage inside the pixel data shows when it is loaded.
[[nodiscard]] Expected<Photo> open_photo(const std::filesystem::path& path);

/// Opens the JPEG files in `folder` and the folders below it and reads their metadata.
/// Empty, truncated and non-JPEG files are quarantined; damage inside the pixel data shows when a
/// photo is loaded.
/// @returns kNotFound for a missing folder or one without any JPEG, kInsufficient when every JPEG
/// is quarantined; the message names the folder, the cause and the next step.
[[nodiscard]] Expected<PhotoFolder> open_photo_folder(const std::filesystem::path& folder);

}  // namespace hybridfusion
