#include "truth_json.hpp"

namespace hybridfusion {
namespace {

Json json_of(const RelativeErrors& errors) {
  return {{"num_pairs", errors.num_pairs},
          {"translation_rmse_m", errors.translation_rmse_m},
          {"rotation_rmse_deg", errors.rotation_rmse_deg}};
}

}  // namespace

Json json_of(const CameraErrors& errors) {
  return {{"num_cameras", errors.num_cameras},
          {"absolute_rmse_m", errors.absolute_rmse_m},
          {"absolute_horizontal_rmse_m", errors.absolute_horizontal_rmse_m},
          {"absolute_vertical_rmse_m", errors.absolute_vertical_rmse_m},
          {"rigid_rmse_m", errors.rigid_rmse_m},
          {"similarity_rmse_m", errors.similarity_rmse_m},
          {"scale_error", errors.scale_error},
          {"tilt_deg", errors.tilt_deg},
          {"rotation_median_deg", errors.rotation_median_deg},
          {"rotation_max_deg", errors.rotation_max_deg}};
}

Json json_of(const TrajectoryErrors& errors) {
  return {{"num_poses", errors.num_poses},
          {"path_m", errors.path_m},
          {"ate_rmse_m", errors.ate_rmse_m},
          {"ate_max_m", errors.ate_max_m},
          {"rotation_rmse_deg", errors.rotation_rmse_deg},
          {"tilt_deg", errors.tilt_deg},
          {"scale_error", errors.scale_error},
          {"rpe_1s", json_of(errors.over_1_s)},
          {"rpe_50m", json_of(errors.over_50_m)}};
}

}  // namespace hybridfusion
