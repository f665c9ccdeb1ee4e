#include <hybridfusion/pipeline/stages.hpp>

namespace hybridfusion {

std::string_view program_version() {
  return HF_VERSION;
}

}  // namespace hybridfusion
