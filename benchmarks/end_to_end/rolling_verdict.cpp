#include "rolling_verdict.hpp"

#include <cmath>
#include <fstream>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion::benchmark {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

// A drive is right within the first limits and wrong beyond the second; between them it is coarse.
struct Limits {
  double path_share;
  double tilt_deg;
  double ate_m;
};
constexpr Limits kRight = {.path_share = 0.02, .tilt_deg = 0.5, .ate_m = 0.1};
constexpr Limits kWrong = {.path_share = 0.05, .tilt_deg = 2.0, .ate_m = 0.5};

bool within(const DriveErrors& errors, const Limits& limits) {
  return std::abs(errors.path_ratio - 1.0) <= limits.path_share &&
         errors.tilt_deg <= limits.tilt_deg && errors.ate_m <= limits.ate_m;
}

std::string number(const Json& row, const char* key, int digits) {
  return row.contains(key) ? fmt::format("{:.{}f}", row[key].get<double>(), digits) : "-";
}

}  // namespace

Json read_json(const fs::path& path) {
  std::ifstream in(path);
  return in ? Json::parse(in, nullptr, false) : Json();
}

void add_claims(const fs::path& workspace, const DriveErrors& errors, Json& row) {
  const Json level = read_json(workspace / "lidar/level.json");
  if (level.contains("vertical_sigma_deg")) {
    row["tilt_over_sigma"] = errors.tilt_deg / level["vertical_sigma_deg"].get<double>();
  }
  const Json gnss = read_json(workspace / "lidar/gnss.json");
  row["placed_by_gnss"] = gnss.contains("enu_from_map");
  if (!gnss.contains("enu_from_map")) return;
  const auto m = gnss["enu_from_map"].get<std::vector<double>>();
  const Eigen::Matrix3d truth = errors.reference_from_map.rotation.toRotationMatrix();
  const double yaw = std::atan2(m.at(4), m.at(0)) - std::atan2(truth(1, 0), truth(0, 0));
  const double error_deg =
      std::abs(std::remainder(yaw, 2.0 * std::numbers::pi)) * 180.0 / std::numbers::pi;
  row["heading_error_deg"] = error_deg;
  row["heading_over_sigma"] = error_deg / gnss["heading_sigma_deg"].get<double>();
}

std::string verdict(const RollingCase& drive,
                    const Json& row,
                    const std::optional<DriveErrors>& e) {
  if (row["exit"] != 0) return row["exit"] == 4 || row["exit"] == 3 ? "refused" : "failed";
  if (!e) return "failed";
  // A track of twice the length places no map: the map may be right, but not its place.
  const bool misplaced =
      drive.simulation.faults.gnss_stretch != 1.0 && row.value("placed_by_gnss", false);
  if (misplaced || !within(*e, kWrong)) return "wrong";
  return within(*e, kRight) ? "right" : "coarse";
}

std::string table(const std::vector<Json>& rows) {
  std::string text =
      "| case | drive | fault | exit | verdict | path m | ratio | ATE m | tilt deg | tilt/sigma | "
      "heading/sigma | CPU ms a scan | MiB "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Json& row : rows) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                        row["case"].get<int>(),
                        row["text"].get<std::string>(),
                        row["fault"].get<std::string>(),
                        row["exit"].get<int>(),
                        row["verdict"].get<std::string>(),
                        number(row, "path_m", 1),
                        number(row, "path_ratio", 3),
                        number(row, "ate_m", 3),
                        number(row, "tilt_deg", 2),
                        number(row, "tilt_over_sigma", 1),
                        number(row, "heading_over_sigma", 1),
                        number(row, "cpu_ms", 0),
                        number(row, "peak_mib", 0));
  }
  return text;
}

std::string totals(const std::vector<Json>& rows) {
  int sound = 0;
  int right = 0;
  int wrong_sound = 0;
  int wrong_faulty = 0;
  for (const Json& row : rows) {
    const bool faulty = !row["fault"].get<std::string>().empty();
    const std::string said = row["verdict"];
    if (!faulty) ++sound;
    if (!faulty && said == "right") ++right;
    if (said == "wrong") ++(faulty ? wrong_faulty : wrong_sound);
  }
  return fmt::format(
      "{} drives; wrong with exit 0: {} ({} sound, {} faulty; goal 0); sound ones right: {} of {} "
      "({:.0f} %; goal 98 %)\n",
      rows.size(),
      wrong_sound + wrong_faulty,
      wrong_sound,
      wrong_faulty,
      right,
      sound,
      sound == 0 ? 0.0 : 100.0 * right / sound);
}

}  // namespace hybridfusion::benchmark
