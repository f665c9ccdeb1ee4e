#include "registration_json.hpp"

#include <utility>

namespace hybridfusion {
namespace {

Json json_of(const PoseCovariance& covariance) {
  Json numbers = Json::array();
  for (Eigen::Index r = 0; r < 6; ++r) {
    for (Eigen::Index c = 0; c < 6; ++c) numbers.push_back(covariance(r, c));
  }
  return numbers;
}

Json json_of(const PatchMatch& patch) {
  const auto cell = [](const Eigen::Vector2i& index) { return Json{index.x(), index.y()}; };
  return {
      {"lidar_cell", cell(patch.lidar_cell)},
      {"vision_cell", cell(patch.vision_cell)},
      {"outcome", to_string(patch.outcome)},
      {"centroid_in_vision",
       {patch.centroid_in_vision.x(), patch.centroid_in_vision.y(), patch.centroid_in_vision.z()}},
      {"num_points", patch.num_points},
      {"num_candidates", patch.num_candidates},
      {"num_correlated", patch.num_correlated},
      {"num_similar", patch.num_similar},
      {"correlation", patch.correlation},
      {"neighbour_score", patch.neighbour_score},
      {"score_2d_m", patch.score_2d_m},
      {"score_3d_m", patch.score_3d_m},
      {"vision_from_lidar", matrix_json(patch.vision_from_lidar)}};
}

Json json_of(const DriftCorrection& drift) {
  const auto vector = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  Json knots = Json::array();
  for (const DriftKnot& knot : drift.knots) {
    knots.push_back({{"at", knot.at},
                     {"pivot", vector(knot.pivot)},
                     {"shift_m", vector(knot.shift_m)},
                     {"turn_rad", vector(knot.turn_rad)}});
  }
  return {{"corrected", drift.supported},
          {"along", drift.axis == DriftAxis::kTime ? "time_s" : "path_m"},
          {"size_m", drift.size_m},
          {"held_out_before_m", drift.held_out_before_m},
          {"held_out_after_m", drift.held_out_after_m},
          {"knots", std::move(knots)}};
}

}  // namespace

Json registration_json(const RegistrationResult& result) {
  Json scores = Json::object();
  for (const RegistrationScore& score : result.scores) scores[score.name] = score.value;
  Json candidates = Json::array();
  for (const PoseCandidate& candidate : result.candidates) {
    candidates.push_back({{"vision_from_lidar", matrix_json(candidate.vision_from_lidar)},
                          {"score", candidate.score}});
  }
  Json yaw_scores = Json::array();
  for (const YawScore& yaw : result.yaw_scores) {
    yaw_scores.push_back({{"yaw_rad", yaw.yaw_rad}, {"score", yaw.score}});
  }
  Json patches = Json::array();
  for (const PatchMatch& patch : result.patches) patches.push_back(json_of(patch));
  const bool ok = result.status == RegistrationStatus::kOk;
  return {{"status", ok ? "ok" : "refused"},
          {"vision_from_lidar", ok ? matrix_json(result.vision_from_lidar) : Json()},
          {"covariance", json_of(result.covariance)},
          {"confidence", result.confidence},
          {"reason", result.reason},
          {"patches", patches},
          {"scores", scores},
          {"method", result.method},
          {"candidates", candidates},
          {"yaw_scores", yaw_scores},
          {"drift", json_of(result.drift)},
          {"vision_scale", result.vision_scale},
          {"vision_scale_sigma", result.vision_scale_sigma},
          {"vision_scale_supported", result.vision_scale_supported}};
}

}  // namespace hybridfusion
