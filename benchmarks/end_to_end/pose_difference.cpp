// How far the cameras of two COLMAP text models of the same photos lie apart, as one JSON object.
// See --help.
#include <hybridfusion/evaluation/pose_error.hpp>
#include <hybridfusion/io/colmap_model.hpp>

#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace {

using namespace hybridfusion;  // NOLINT(google-build-using-namespace): a program

std::map<std::string, Rigid3, std::less<>> poses_of(const ColmapModel& model) {
  std::map<std::string, Rigid3, std::less<>> poses;
  for (const ColmapImage& image : model.images) {
    const Rigid3 camera_from_world{image.camera_from_world, image.camera_from_world_translation};
    poses.try_emplace(image.name, camera_from_world.inverse());
  }
  return poses;
}

Expected<nlohmann::ordered_json> compare(const std::string& metric, const std::string& other) {
  HF_TRY(const ColmapModel first, read_colmap_model(metric));
  HF_TRY(const ColmapModel second, read_colmap_model(other));
  const auto second_poses = poses_of(second);
  std::vector<Rigid3> world_from_camera;
  std::vector<Rigid3> other_world_from_camera;
  for (const auto& [name, pose] : poses_of(first)) {
    const auto found = second_poses.find(name);
    if (found == second_poses.end()) continue;
    world_from_camera.push_back(pose);
    other_world_from_camera.push_back(found->second);
  }
  HF_TRY(const CameraErrors errors, camera_errors(world_from_camera, other_world_from_camera));
  return nlohmann::ordered_json{{"cameras", errors.num_cameras},
                                {"similarity_rmse_m", errors.similarity_rmse_m},
                                {"rotation_median_deg", errors.rotation_median_deg},
                                {"rotation_max_deg", errors.rotation_max_deg}};
}

}  // namespace

int main(int argc, char** argv) {
  std::string metric;
  std::string other;
  CLI::App app(
      "Distance of the camera centres (in the first model's unit) and of the orientations of two "
      "COLMAP text models, after the similarity that fits the second to the first, as JSON.");
  app.add_option("MODEL", metric, "The model in metres")->required();
  app.add_option("OTHER", other, "The model it is compared with, in any frame")->required();
  CLI11_PARSE(app, argc, argv);
  const auto json = compare(metric, other);
  if (!json) {
    std::cerr << json.error().message << '\n';
    return 1;
  }
  std::cout << json->dump(1) << '\n';
  return 0;
}
