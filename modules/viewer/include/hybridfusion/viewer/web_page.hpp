#pragma once

#include <hybridfusion/viewer/viewer_server.hpp>

#include <vector>

namespace hybridfusion {

/// The viewer's page, script and style, as built into the library.
[[nodiscard]] std::vector<ServedFile> viewer_page();

}  // namespace hybridfusion
