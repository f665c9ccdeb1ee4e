#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

struct PipelineOptions;

enum class Severity : std::uint8_t {
  kWarning,  ///< The run goes on, with less or weaker data.
  kError,    ///< The run would fail or its result would be wrong.
};
[[nodiscard]] std::string_view to_string(Severity severity);

/// One thing that is wrong with the inputs or the machine.
struct Finding {
  std::string id = {};  ///< Stable, e.g. "photos.no_positions"; listed by findings_reference().
  Severity severity = Severity::kWarning;
  std::string cause = {};                  ///< What was found, with its numbers.
  std::string remedy = {};                 ///< What to do about it.
  std::vector<std::string> subjects = {};  ///< Files or topics concerned, all of them.
};

/// What is to be examined; what is absent is not.
struct DoctorInputs {
  std::optional<std::filesystem::path> images = {};
  std::optional<std::filesystem::path> geo_tags = {};  ///< Absent: geo.txt among the photos.
  std::optional<std::filesystem::path> control = {};   ///< Absent: gcp_list.txt among the photos.
  std::optional<std::filesystem::path> bag = {};
  std::optional<std::filesystem::path> sensors = {};  ///< Absent: sensors.yaml beside the bag.
  std::optional<std::filesystem::path> workspace = {};
};

struct DoctorReport {
  std::vector<Finding> findings = {};   ///< Errors first.
  std::vector<std::string> facts = {};  ///< What the inputs hold, one line each, for a person.

  [[nodiscard]] bool has_errors() const;
  /// There are errors and all of them are of the machine or the output, none of the inputs.
  [[nodiscard]] bool only_resource_errors() const;
};

/// Looks for what would spoil a run: metadata and a sample of the pixels of the photos, every
/// message of the recording, the room in memory and on disk. Writes nothing that stays. The
/// findings are the result, however bad they are.
/// @returns kCancelled when stopped.
[[nodiscard]] Expected<DoctorReport> examine(const DoctorInputs& inputs,
                                             const PipelineOptions& options,
                                             const RunContext& ctx);

/// {"facts": [...], "findings": [{"id", "severity", "cause", "remedy", "subjects"}, ...]}
[[nodiscard]] std::string to_json(const DoctorReport& report);

/// Reference table in Markdown of every finding there can be: id, severity, meaning, remedy.
[[nodiscard]] std::string findings_reference();

}  // namespace hybridfusion
