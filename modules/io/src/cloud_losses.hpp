#pragma once

#include <hybridfusion/io/cloud_stream.hpp>
#include <hybridfusion/io/cloud_writer.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hybridfusion {

/// What a file of this extension cannot hold of a cloud, each in words: nothing is left out or
/// changed without one.
[[nodiscard]] std::vector<std::string> cloud_losses(const CloudSurvey& survey,
                                                    const std::filesystem::path& out,
                                                    const CloudFormat& format);

}  // namespace hybridfusion
