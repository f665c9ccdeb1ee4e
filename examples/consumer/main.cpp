// register_clouds G.ply L.ply FUSED.ply: registers the LiDAR cloud L to the photo cloud G and
// writes both as one. Exit status 0 done, 1 error, 2 usage, 4 refused: no pose that the evidence
// supports.
#include <hybridfusion/evaluation/supplement_degree.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>
#include <hybridfusion/registration/fuse_clouds.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <cstdlib>
#include <iostream>

namespace hf = hybridfusion;

namespace {

int report(const hf::Error& error) {
  std::cerr << error.message << '\n';
  return EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: register_clouds G.ply L.ply FUSED.ply\n";
    return 2;
  }
  const auto vision = hf::read_point_cloud(argv[1]);
  if (!vision) return report(vision.error());
  const auto lidar = hf::read_point_cloud(argv[2]);
  if (!lidar) return report(lidar.error());

  const auto result = hf::register_cross_source(*vision, *lidar);
  if (!result) return report(result.error());
  if (result->status == hf::RegistrationStatus::kRefused) {
    std::cout << "refused: " << result->reason << '\n';
    return 4;
  }
  std::cout << "confidence " << result->confidence << "\nvision_from_lidar\n"
            << result->vision_from_lidar.matrix() << '\n';

  const auto fused = hf::fuse_clouds(*vision, *lidar, result->vision_from_lidar);
  if (!fused) return report(fused.error());
  const auto written = hf::write_point_cloud(argv[3], fused->cloud);
  if (!written) return report(written.error());

  const hf::PointCloud in_vision = hf::transformed(result->vision_from_lidar, *lidar);
  const auto volumes = hf::compare_volumes(*vision, in_vision, 0.5);
  if (!volumes) return report(volumes.error());
  std::cout << fused->cloud.size() << " points, supplement degree "
            << 100.0 * volumes->supplement_degree << " %\n";
}
