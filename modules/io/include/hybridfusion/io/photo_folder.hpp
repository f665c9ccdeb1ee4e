#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hybridfusion {

/// A file that looks like a photo by its name but cannot be used.
struct QuarantinedPhoto {
  std::string name = {};    ///< File name without folder.
  std::string reason = {};  ///< For a person: "empty file", "truncated or damaged: ...".
};

struct PhotoFolder {
  std::filesystem::path folder = {};
  std::vector<Photo> photos = {};  ///< Sorted by name; pixels are decoded by Photo::load.
  std::vector<QuarantinedPhoto> quarantined = {};  ///< Sorted by name.
};

/// One photo, its metadata read. @returns kNotFound; kParse for a file that is empty, truncated or
/// no JPEG. Damage inside the pixel data shows when it is loaded.
[[nodiscard]] Expected<Photo> open_photo(const std::filesystem::path& path);

/// Opens the *.jpg and *.jpeg files (any case) directly in `folder` and reads their metadata.
/// Empty, truncated and non-JPEG files are quarantined; damage inside the pixel data shows when a
/// photo is loaded.
/// @returns kNotFound for a missing folder or one without any JPEG, kInsufficient when every JPEG
/// is quarantined; the message names the folder, the cause and the next step.
[[nodiscard]] Expected<PhotoFolder> open_photo_folder(const std::filesystem::path& folder);

}  // namespace hybridfusion
