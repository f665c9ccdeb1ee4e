#pragma once

#include <filesystem>

namespace hybridfusion::testing {

/// A small workspace in which every stage ran: a street between two rows of houses, twelve photos,
/// a drive of forty metres. Made by formula, so that figures and pictures have something to show
/// within a second. Names of photos hold HTML.
void write_sample_workspace(const std::filesystem::path& root);

/// The name of the first photo: hostile to pages that do not escape it.
inline constexpr const char* kHostilePhoto = "<script>alert('x')</script>&\".jpg";

}  // namespace hybridfusion::testing
