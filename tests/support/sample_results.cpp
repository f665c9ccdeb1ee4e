#include "sample_results.hpp"

#include "sample_workspace.hpp"

#include <cmath>
#include <fstream>

namespace hybridfusion::testing {
namespace {

Json registration_json(const Rigid3& vision_from_lidar, double yaw_rad) {
  Rigid3 initial = vision_from_lidar;
  initial.translation += Eigen::Vector3d(2.5, -1.5, 0.8);
  initial.rotation = initial.rotation * Eigen::AngleAxisd(0.06, Eigen::Vector3d::UnitZ());
  Json covariance = Json::array();
  for (int i = 0; i < 36; ++i) covariance.push_back(i % 7 == 0 ? 1e-4 : 0.0);
  Json yaws = Json::array();
  for (int i = -30; i <= 30; ++i) {
    yaws.push_back({{"yaw_rad", yaw_rad + 0.01 * i}, {"score", 100.0 * std::exp(-0.02 * i * i)}});
  }
  const Json patch = {{"lidar_cell", {1, 2}},
                      {"vision_cell", {3, 4}},
                      {"outcome", "in_cluster"},
                      {"centroid_in_vision", {0.0, 0.0, 1.0}},
                      {"num_points", 500},
                      {"num_candidates", 9},
                      {"num_correlated", 4},
                      {"num_similar", 1},
                      {"correlation", 0.8},
                      {"neighbour_score", 0.7},
                      {"score_2d_m", 0.2},
                      {"score_3d_m", 0.1},
                      {"vision_from_lidar", matrix(vision_from_lidar)}};
  return {{"status", "ok"},
          {"vision_from_lidar", matrix(vision_from_lidar)},
          {"covariance", covariance},
          {"confidence", 0.97},
          {"reason", ""},
          {"patches", {patch}},
          {"scores", {{"peak_ratio", 0.3}}},
          {"method", "hybrid"},
          {"candidates", {{{"vision_from_lidar", matrix(vision_from_lidar)}, {"score", 100.0}}}},
          {"yaw_scores", yaws},
          {"vision_scale", 1.0},
          {"vision_scale_sigma", 0.001},
          {"vision_scale_supported", true},
          {"initial", matrix(initial)},
          {"coarse_pose", "GNSS"}};
}

Json metrics_json() {
  return {{"supplement",
           {{{"leaf_m", 0.5},
             {"vision_volume_m3", 100.0},
             {"result_volume_m3", 125.0},
             {"supplement_degree", 0.25}}}},
          {"boundary",
           {{"accuracy_m", 0.4},
            {"share_with_partner", 0.9},
            {"histogram", {{"bin_m", 0.1}, {"counts", {5, 9, 6, 3, 1}}}}}},
          {"boundary_accuracy_m", 0.4},
          {"method", "hybrid"},
          {"seconds", 1.5},
          {"baselines", {{"gicp", {{"converged", true}, {"seconds", 9.0}, {"accuracy_m", 0.9}}}}}};
}

Json run_record(const Json& registration) {
  const auto stage = [](const Json& result) {
    return Json{{"seconds", 2.5},
                {"cpu_seconds", 4.0},
                {"peak_memory_mib", 321.0},
                {"seed", 0},
                {"threads", 2},
                {"key", ""},
                {"inputs", Json::array()},
                {"outputs", Json::array()},
                {"result", {{"refused", false}, {"summary", Json::array()}, {"result", result}}}};
  };
  return {{"stages",
           {{"reconstruct",
             stage({{"num_photos", 13},
                    {"num_registered", 12},
                    {"initial_focal_px", 790.0},
                    {"focal_px", 800.0},
                    {"focal_change", 0.0127},
                    {"gnss_horizontal_rms_m", 1.3},
                    {"gnss_vertical_rms_m", 1.9},
                    {"gnss_sigma_horizontal_m", 1.0},
                    {"gnss_sigma_vertical_m", 2.0},
                    {"not_registered", {kHostilePhoto}}})},
            {"map",
             stage({{"num_scans", 200},
                    {"num_flagged_scans", 1},
                    {"mean_residual_m", 0.025},
                    {"num_imu_gaps", 1},
                    {"num_lidar_gaps", 0}})},
            {"register", stage(registration)}}}};
}

}  // namespace

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

Json matrix(const Rigid3& pose) {
  Json numbers = Json::array();
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) numbers.push_back(pose.matrix()(r, c));
  }
  return numbers;
}

void write_sample_results(const std::filesystem::path& root,
                          const Rigid3& vision_from_lidar,
                          double yaw_rad) {
  const Json registration = registration_json(vision_from_lidar, yaw_rad);
  write_text(root / "registration/registration.json", registration.dump());
  write_text(root / "evaluation/metrics.json", metrics_json().dump());
  write_text(root / "run.json", run_record(registration).dump());
}

}  // namespace hybridfusion::testing
