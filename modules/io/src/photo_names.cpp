#include "text.hpp"

#include <hybridfusion/io/photo_names.hpp>

#include <algorithm>

namespace hybridfusion {
namespace {

/// Folders of Windows too, none in front ("./A.JPG").
std::string slashed(std::string_view name) {
  std::string result(name);
  std::ranges::replace(result, '\\', '/');
  while (result.starts_with("./")) result.erase(0, 2);
  return result;
}

std::string file_of(const std::string& name) {
  return name.substr(name.rfind('/') + 1);  // npos + 1 is 0
}

std::string stem_of(const std::string& file) {
  const std::size_t dot = file.rfind('.');
  return lower_case(dot == std::string::npos || dot == 0 ? file : file.substr(0, dot));
}

}  // namespace

PhotoNames::PhotoNames(std::span<const std::string> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string whole = slashed(names[i]);
    const std::string file = file_of(whole);
    whole_[whole].push_back(i);
    file_[file].push_back(i);
    any_case_[lower_case(file)].push_back(i);
    stem_[stem_of(file)].push_back(i);
  }
}

std::optional<std::size_t> PhotoNames::find(std::string_view written) const {
  const std::string whole = slashed(written);
  const std::string file = file_of(whole);
  const auto only = [](const Index& index, const std::string& key) -> std::optional<std::size_t> {
    const auto found = index.find(key);
    if (found == index.end() || found->second.size() != 1) return std::nullopt;
    return found->second.front();
  };
  if (const auto at = only(whole_, whole)) return at;
  if (file_.contains(file)) return only(file_, file);
  if (any_case_.contains(lower_case(file))) return only(any_case_, lower_case(file));
  // A label has no extension: "A.tif" is not the photo A.JPG.
  return file.find('.') == std::string::npos ? only(stem_, stem_of(file)) : std::nullopt;
}

bool PhotoNames::ambiguous(std::string_view written) const {
  const auto found = any_case_.find(lower_case(file_of(slashed(written))));
  return found != any_case_.end() && found->second.size() > 1 && !find(written);
}

}  // namespace hybridfusion
