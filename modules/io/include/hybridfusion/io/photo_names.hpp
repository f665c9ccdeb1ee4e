#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// Finds photos by the names that other files give them. In this order, each only where it leaves
/// one photo: the name as it is, the file name without folders, the same in any case, the same
/// without extension (as labels are exported).
class PhotoNames {
 public:
  /// @param names  Of the photos, with the folders below the one that was given.
  explicit PhotoNames(std::span<const std::string> names);

  /// Index of the photo; nothing when no photo or more than one is meant.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view written) const;
  /// Whether several photos in different folders have this file name, so that it finds none.
  [[nodiscard]] bool ambiguous(std::string_view written) const;

 private:
  using Index = std::map<std::string, std::vector<std::size_t>, std::less<>>;
  Index whole_ = {};
  Index file_ = {};
  Index any_case_ = {};
  Index stem_ = {};
};

}  // namespace hybridfusion
