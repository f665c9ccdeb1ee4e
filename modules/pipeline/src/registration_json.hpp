#pragma once

#include "json_text.hpp"

#include <hybridfusion/registration/register_cross_source.hpp>

namespace hybridfusion {

/// The part of registration.json that comes from the registration itself.
[[nodiscard]] Json registration_json(const RegistrationResult& result);

}  // namespace hybridfusion
