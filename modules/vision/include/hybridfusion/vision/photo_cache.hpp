#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// Features of photos and matches of pairs between runs. Results with and without it are the same,
/// byte for byte: entries that are missing, damaged or of other photos are computed again.
struct PhotoCache {
  /// One per photo: what its features depend on (its content and the options of features and
  /// matching), fit for a file name. Empty: nothing of this photo is kept.
  std::vector<std::string> keys = {};
  /// Bytes under a name that `save` was given; nothing when there are none. Thread-safe.
  std::function<std::optional<std::string>(const std::string& name)> load = {};
  /// Keeps bytes, or does not: a failure costs time, not the result. Thread-safe.
  std::function<void(const std::string& name, std::string_view bytes)> save = {};
};

}  // namespace hybridfusion
