// Reads a .pcd or .ply file with PCL and compares it with the points that went in.
// Usage: check_pcl FILE POINTS.xyz   (POINTS.xyz: "x y z r g b" lines; exit 0: they agree)
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string file = argv[1];
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  const int status = file.ends_with(".pcd") ? pcl::io::loadPCDFile(file, cloud)
                                            : pcl::io::loadPLYFile(file, cloud);
  if (status != 0) {
    std::cout << file << ": PCL cannot read it\n";
    return 1;
  }
  std::vector<std::array<double, 6>> points;
  std::ifstream stream(argv[2]);
  std::array<double, 6> row{};
  while (stream >> row[0] >> row[1] >> row[2] >> row[3] >> row[4] >> row[5]) points.push_back(row);
  if (points.empty() || cloud.size() != points.size()) {
    std::cout << file << ": " << cloud.size() << " points instead of " << points.size() << '\n';
    return 1;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const pcl::PointXYZRGB& p = cloud[i];
    const std::array<double, 6> read = {p.x, p.y, p.z, 1.0 * p.r, 1.0 * p.g, 1.0 * p.b};
    for (std::size_t k = 0; k < read.size(); ++k) {
      if (std::abs(read[k] - points[i][k]) <= 1e-5) continue;
      std::cout << file << ": point " << i << ", value " << k << ": " << read[k] << " instead of "
                << points[i][k] << '\n';
      return 1;
    }
  }
  std::cout << file << ": " << cloud.size() << " points agree\n";
  return 0;
}
