#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hybridfusion {

/// A file that came to rest.
struct PhotoArrival {
  std::filesystem::path path = {};
  std::string name = {};  ///< Below the folder, as PhotoMetadata::name.
  std::string sha256 = {};
  std::optional<Photo> photo = {};                  ///< Empty: not usable.
  std::string reason = {};                          ///< Then: why.
  std::chrono::steady_clock::time_point seen = {};  ///< When its present content was first seen.
};

/// Notices JPEG files that appear in a folder. A file has arrived when size and time of change stay
/// the same from one look to the next, `settle_s` apart at least, and it is a whole JPEG. One that
/// is none after `give_up_s` is given up, and looked at again when it changes. Files whose content
/// came before under another name are told as such.
class PhotoArrivals {
 public:
  using Clock = std::chrono::steady_clock;

  explicit PhotoArrivals(std::filesystem::path folder,
                         double settle_s = 0.05,
                         double give_up_s = 5.0);

  /// @param now  Of this look; never before that of the last.
  /// @returns What arrived since, by time of change, then name; kNotFound, kIo for the folder.
  [[nodiscard]] Expected<std::vector<PhotoArrival>> look(Clock::time_point now);

  /// Whether a file is there that has not come to rest.
  [[nodiscard]] bool expects_more() const;

 private:
  struct File {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type changed = {};
    Clock::time_point since = {};
    bool done = false;  // arrived or given up
    bool arrived = false;
  };
  [[nodiscard]] Expected<std::vector<std::filesystem::path>> list() const;
  void settle(const std::filesystem::path& path,
              Clock::time_point now,
              std::vector<PhotoArrival>& arrived);

  std::filesystem::path folder_;
  std::chrono::duration<double> settle_;
  std::chrono::duration<double> give_up_;
  std::map<std::filesystem::path, File> files_ = {};
  std::map<std::string, std::string> name_of_content_ = {};  // by SHA-256
};

}  // namespace hybridfusion
