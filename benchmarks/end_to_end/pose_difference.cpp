// How far the cameras of two COLMAP text models of the same photos lie apart, as one JSON object.
// See --help.
#include <hybridfusion/evaluation/pose_error.hpp>
#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/io/dataset_truth.hpp>

#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace {

using namespace hybridfusion;  // NOLINT(google-build-using-namespace): a program

using Poses = std::map<std::string, Rigid3, std::less<>>;  // world_from_camera by photo

Poses poses_of(const ColmapModel& model) {
  Poses poses;
  for (const ColmapImage& image : model.images) {
    const Rigid3 camera_from_world{image.camera_from_world, image.camera_from_world_translation};
    poses.try_emplace(image.name, camera_from_world.inverse());
  }
  return poses;
}

/// Of the photos that both know.
Expected<CameraErrors> difference(const Poses& first, const Poses& second) {
  std::vector<Rigid3> first_from_camera;
  std::vector<Rigid3> second_from_camera;
  for (const auto& [name, pose] : first) {
    const auto found = second.find(name);
    if (found == second.end()) continue;
    first_from_camera.push_back(pose);
    second_from_camera.push_back(found->second);
  }
  return camera_errors(first_from_camera, second_from_camera);
}

Expected<nlohmann::ordered_json> compare(const std::string& metric,
                                         const std::string& other,
                                         const std::string& truth) {
  HF_TRY(const ColmapModel first, read_colmap_model(metric));
  HF_TRY(const ColmapModel second, read_colmap_model(other));
  HF_TRY(const CameraErrors errors, difference(poses_of(first), poses_of(second)));
  nlohmann::ordered_json json{{"cameras", errors.num_cameras},
                              {"similarity_rmse_m", errors.similarity_rmse_m},
                              {"rotation_median_deg", errors.rotation_median_deg},
                              {"rotation_max_deg", errors.rotation_max_deg}};
  if (truth.empty()) return json;
  HF_TRY(const auto photos, read_true_photo_poses(truth));
  Poses true_poses;
  for (const TruePhotoPose& photo : photos)
    true_poses.try_emplace(photo.name, photo.enu_from_camera);
  HF_TRY(const CameraErrors first_errors, difference(true_poses, poses_of(first)));
  HF_TRY(const CameraErrors second_errors, difference(true_poses, poses_of(second)));
  json["model_to_truth_m"] = first_errors.similarity_rmse_m;
  json["other_to_truth_m"] = second_errors.similarity_rmse_m;
  return json;
}

}  // namespace

int main(int argc, char** argv) {
  std::string metric;
  std::string other;
  std::string truth;
  CLI::App app(
      "Distance of the camera centres (in the first model's unit) and of the orientations of two "
      "COLMAP text models, after the similarity that fits the second to the first, as JSON.");
  app.add_option("MODEL", metric, "The model in metres")->required();
  app.add_option("OTHER", other, "The model it is compared with, in any frame")->required();
  app.add_option("--truth", truth, "cameras.csv of a truth folder: distance of both from it");
  CLI11_PARSE(app, argc, argv);
  const auto json = compare(metric, other, truth);
  if (!json) {
    std::cerr << json.error().message << '\n';
    return 1;
  }
  std::cout << json->dump(1) << '\n';
  return 0;
}
