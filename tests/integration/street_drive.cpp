#include "street_drive.hpp"

#include <hybridfusion/evaluation/trajectory_error.hpp>
#include <hybridfusion/io/tum.hpp>

#include <limits>
#include <sstream>
#include <stdexcept>

#include <unistd.h>

namespace hybridfusion::testing {

std::filesystem::path StreetTest::street_ = {};

void simulate_street(const std::filesystem::path& folder,
                     const std::vector<std::string>& settings) {
  std::vector<std::string> all = {"flight.enabled=false",
                                  "lidar.beams=16",
                                  "lidar.columns=180",
                                  "samples_per_m2=0.5",
                                  "world.ambient_rays=4",
                                  "drive.duration_s=18"};
  all.insert(all.end(), settings.begin(), settings.end());
  std::vector<std::string> arguments = {
      "simulate", "--output", folder.string(), "--seed", "3", "--quiet"};
  for (const std::string& setting : all) {
    arguments.insert(arguments.end(), {"--set", "simulation." + setting});
  }
  const ProgramResult result = run_program(arguments);
  if (result.exit_code != 0) throw std::runtime_error(result.err);
}

double drive_error_m(const std::filesystem::path& workspace,
                     const std::filesystem::path& data_set) {
  const auto trajectory = read_tum(workspace / "lidar/trajectory.tum");
  const auto truth = read_tum(data_set / "truth/trajectory_imu.tum");
  if (!trajectory || !truth) return std::numeric_limits<double>::infinity();
  const auto errors = trajectory_errors(*truth, *trajectory);
  return errors ? errors->ate_rmse_m : std::numeric_limits<double>::infinity();
}

std::set<std::string> quality_flags(const std::filesystem::path& workspace) {
  std::set<std::string> flags;
  std::istringstream csv(read_file(workspace / "lidar/quality.csv"));
  std::string line;
  std::getline(csv, line);  // the header
  while (std::getline(csv, line)) {
    std::istringstream of_scan(line.substr(line.rfind(',') + 1));
    for (std::string flag; std::getline(of_scan, flag, '|');) flags.insert(flag);
  }
  return flags;
}

void StreetTest::SetUpTestSuite() {
  street_ = std::filesystem::temp_directory_path() / ("hf_street_" + std::to_string(::getpid()));
  std::filesystem::remove_all(street_);
  simulate_street(street_);
}

void StreetTest::TearDownTestSuite() {
  std::filesystem::remove_all(street_);
}

ProgramResult StreetTest::map(const std::string& recording,
                              const std::string& name,
                              const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = {"map",
                                        "--bag",
                                        recording,
                                        "--sensors",
                                        (street_ / "sensors.yaml").string(),
                                        "--output",
                                        path(name)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

}  // namespace hybridfusion::testing
