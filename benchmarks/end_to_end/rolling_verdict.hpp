#pragma once

#include "drive_errors.hpp"
#include "rolling_cases.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace hybridfusion::benchmark {

/// Null when the file is missing or no JSON.
[[nodiscard]] nlohmann::json read_json(const std::filesystem::path& path);

/// Where the truth differs from what the workspace claims, over the sigma claimed.
void add_claims(const std::filesystem::path& workspace,
                const DriveErrors& errors,
                nlohmann::json& row);

/// "right", "coarse", "wrong" (claimed and far off), "refused", or "failed" (another exit code).
[[nodiscard]] std::string verdict(const RollingCase& drive,
                                  const nlohmann::json& row,
                                  const std::optional<DriveErrors>& errors);

/// Markdown, one line a case.
[[nodiscard]] std::string table(const std::vector<nlohmann::json>& rows);
/// How many were wrong and how many right, beside the goals.
[[nodiscard]] std::string totals(const std::vector<nlohmann::json>& rows);

}  // namespace hybridfusion::benchmark
