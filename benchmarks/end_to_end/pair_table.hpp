#pragma once

#include "pair_cases.hpp"

#include <hybridfusion/evaluation/registration_error.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace hybridfusion::benchmark {

/// One registration.
struct Outcome {
  std::string group;
  std::uint64_t seed = 0;
  std::string method;
  bool ok = false;     ///< The method vouches for its pose.
  bool right = false;  ///< Within 1 m and 2 degrees of the truth, whether refused or not.
  RegistrationErrors errors = {};
  double yaw_deg = 0.0;  ///< Of the error, about the vertical.
  double floor_m = 0.0;
  double places_m =
      0.0;  ///< Root mean square distance of the straightened LiDAR cloud to its place.
  double scale_error = 0.0;
  double confidence = 0.0;
  double cpu_s = 0.0;
  double memory_mb = 0.0;  ///< Peak of the registration alone; 0: not measured.
  std::string reason = {};
  std::vector<RegistrationScore> scores = {};
};

/// One table a method, one row a group, as Markdown.
void print_table(const std::vector<Outcome>& outcomes, const std::vector<std::string>& methods);

/// The goals of the benchmark with what one method reached.
void print_goals(const std::vector<Outcome>& outcomes, const std::string& method);

/// How often poses of a confidence are right, one row a method.
void print_calibration(const std::vector<Outcome>& outcomes,
                       const std::vector<std::string>& methods);

/// The outcomes of a file that write_json wrote; without the columns of later versions.
[[nodiscard]] Expected<std::vector<Outcome>> read_json(const std::string& path);

/// Every single outcome with its scores. A failed or interrupted write leaves the file as it was.
[[nodiscard]] Expected<void> write_json(const std::vector<Outcome>& outcomes,
                                        const std::string& path);

}  // namespace hybridfusion::benchmark
