#pragma once

#include "report_data.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// One line of the verdict at the top of the report.
struct Light {
  std::string what = {};
  std::string_view color = {};  ///< "green", "amber" or "red".
  std::string value = {};       ///< HTML; its numbers name their source.
  std::string limits = {};      ///< What is green and what amber.
};

/// The checks that the stages which ran allow, in their order.
[[nodiscard]] std::vector<Light> traffic_lights(const ReportData& data);

/// "GREEN", "AMBER", "RED" or "REFUSED" for the whole, with the worst check as its reason.
struct Verdict {
  std::string_view word = {};
  std::string_view color = {};
  std::string reason = {};  ///< HTML.
};
[[nodiscard]] Verdict overall_verdict(const ReportData& data, const std::vector<Light>& lights);

}  // namespace hybridfusion
