#include "cloud_losses.hpp"

#include "crs_units.hpp"
#include "las_attributes.hpp"
#include "las_output.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kExactIntegers = 9007199254740992.0;  // 2^53: doubles hold all integers below

[[nodiscard]] std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + printable(name);
  return text;
}

[[nodiscard]] bool has(const CloudSurvey& survey, std::string_view channel) {
  return std::ranges::find(survey.channels, channel) != survey.channels.end();
}

void add_text_losses(const CloudSurvey& survey, std::vector<std::string>& losses) {
  std::vector<std::string> names;
  for (const std::string& channel : survey.channels) {
    if (channel != "intensity" && channel != "colours") names.push_back(channel);
  }
  for (const SurveyedScalar& scalar : survey.scalars) names.push_back(scalar.name);
  if (names.empty()) return;
  losses.push_back(
      fmt::format(".xyz holds positions, intensities and colours; left out: {}", joined(names)));
}

void add_intensity_losses(const CloudSurvey& survey, std::vector<std::string>& losses) {
  if (!has(survey, "intensity")) return;
  const float factor = las_intensity_factor(survey.largest_intensity);
  if (factor != 1.0F) {
    losses.push_back(
        fmt::format("intensities are multiplied by {:g} to fit the 16 bits of LAS", factor));
  } else if (survey.fractional_intensity) {
    losses.emplace_back("intensities are rounded to whole numbers for LAS");
  }
  if (survey.smallest_intensity < 0.0F) {
    losses.emplace_back("negative intensities become 0: LAS has none");
  }
}

/// What the old point formats hold less of.
void add_old_format_losses(const SurveyedScalar& scalar, std::vector<std::string>& losses) {
  const auto tell = [&](std::string_view what) {
    losses.push_back(fmt::format("{}: {} before LAS 1.4", scalar.name, what));
  };
  const auto member = las_attribute(scalar.name);
  if (member == &LasAttributes::classification && scalar.largest > 31.0) {
    tell("classes above 31 become 1 (unclassified); there are none");
  }
  if ((member == &LasAttributes::return_number || member == &LasAttributes::number_of_returns) &&
      scalar.largest > 7.0) {
    tell("numbers above 7 become 7; there are none");
  }
  if (member == &LasAttributes::scan_angle_deg) tell("rounded to whole degrees as");
  if (member == &LasAttributes::overlap || member == &LasAttributes::scanner_channel) {
    tell("left out; there is no such field");
  }
}

void add_las_losses(const CloudSurvey& survey,
                    const CloudFormat& format,
                    std::vector<std::string>& losses) {
  if (has(survey, "normals"))
    losses.emplace_back("normals are left out: LAS has no field for them");
  add_intensity_losses(survey, losses);
  constexpr std::size_t kMaxName = 32;
  for (const SurveyedScalar& scalar : survey.scalars) {
    if (format.las_version != LasVersion::k14) add_old_format_losses(scalar, losses);
    if (scalar.name.size() > kMaxName) {
      losses.push_back(fmt::format("the name of '{}' is cut to 32 letters for LAS", scalar.name));
    }
  }
}

}  // namespace

std::vector<std::string> cloud_losses(const CloudSurvey& survey,
                                      const std::filesystem::path& out,
                                      const CloudFormat& format) {
  std::vector<std::string> losses;
  const std::string extension = lower_case(out.extension().string());
  if (extension == ".xyz") add_text_losses(survey, losses);
  if (extension == ".las") add_las_losses(survey, format, losses);
  if (extension != ".pcd" && survey.viewpoint != kNoViewpoint) {
    losses.push_back(
        fmt::format("the viewpoint of the sensor (VIEWPOINT) is left out: {} has none", extension));
  }
  for (const SurveyedScalar& scalar : survey.scalars) {
    const bool wide = scalar.type == ScalarType::kInt64 || scalar.type == ScalarType::kUint64;
    if (wide && std::max(-scalar.smallest, scalar.largest) > kExactIntegers &&
        extension != ".xyz") {
      losses.push_back(
          fmt::format("values of '{}' above 2^53 are rounded to the next double", scalar.name));
    }
  }
  const CrsDescription& crs = survey.crs;
  const bool metric = crs.metres_per_unit == 1.0 && crs.vertical_metres_per_unit == 1.0;
  const bool keeps_units = extension == ".las" || (extension == ".xyz" && format.text_in_crs_units);
  if (!metric && !keeps_units) {
    losses.push_back(
        fmt::format("coordinates became metres; its system counts in {} (heights in {})",
                    unit_name(crs.metres_per_unit),
                    unit_name(crs.vertical_metres_per_unit)));
  }
  return losses;
}

}  // namespace hybridfusion
