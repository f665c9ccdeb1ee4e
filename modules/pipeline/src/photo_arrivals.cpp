#include "photo_arrivals.hpp"

#include "digest.hpp"

#include <hybridfusion/io/photo_folder.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {

PhotoArrivals::PhotoArrivals(std::filesystem::path folder, double settle_s, double give_up_s)
    : folder_(std::move(folder)), settle_(settle_s), give_up_(give_up_s) {}

Expected<std::vector<std::filesystem::path>> PhotoArrivals::list() const {
  HF_TRY(const PhotoListing listing, list_photos(folder_));
  std::vector<std::filesystem::path> paths;
  for (const std::string& name : listing.photos) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(folder_ / name, ignored)) paths.push_back(folder_ / name);
  }
  return paths;
}

/// Takes a file that has not changed for a while.
void PhotoArrivals::settle(const std::filesystem::path& path,
                           Clock::time_point now,
                           std::vector<PhotoArrival>& arrived) {
  File& file = files_[path];
  PhotoArrival arrival{
      .path = path, .name = path.lexically_relative(folder_).generic_string(), .seen = file.since};
  auto photo = open_photo(path);
  auto sha256 =
      photo ? sha256_of_file(path) : Expected<std::string>(std::unexpected(photo.error()));
  if (!sha256) {
    if (now - file.since < give_up_) return;  // still on its way, it seems
    file.done = true;
    arrival.reason = sha256.error().message;
    arrived.push_back(std::move(arrival));
    return;
  }
  file.done = true;
  file.arrived = true;
  arrival.sha256 = *std::move(sha256);
  const auto [former, is_new] = name_of_content_.try_emplace(arrival.sha256, arrival.name);
  if (is_new) {
    arrival.photo = *std::move(photo);
    arrival.photo->metadata.name = arrival.name;
  } else {
    arrival.reason = fmt::format("the same photo as {}", former->second);
  }
  arrived.push_back(std::move(arrival));
}

Expected<std::vector<PhotoArrival>> PhotoArrivals::look(Clock::time_point now) {
  HF_TRY(const std::vector<std::filesystem::path> paths, list());
  std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> ready;
  for (const std::filesystem::path& path : paths) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    const auto changed =
        error ? std::filesystem::file_time_type{} : std::filesystem::last_write_time(path, error);
    if (error) continue;  // gone again
    const auto [entry, is_new] = files_.try_emplace(path);
    File& file = entry->second;
    if (file.arrived) continue;
    if (is_new || file.size != size || file.changed != changed) {
      file = {.size = size, .changed = changed, .since = now};
      continue;
    }
    if (!file.done && now - file.since >= settle_) ready.emplace_back(changed, path);
  }
  std::ranges::sort(ready);
  std::vector<PhotoArrival> arrived;
  for (const auto& [changed, path] : ready) settle(path, now, arrived);
  return arrived;
}

bool PhotoArrivals::expects_more() const {
  return std::ranges::any_of(files_, [](const auto& entry) {
    std::error_code ignored;
    return !entry.second.done && std::filesystem::exists(entry.first, ignored);
  });
}

}  // namespace hybridfusion
