#include "octree_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <nlohmann/json.hpp>

namespace hybridfusion {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kHierarchyNodeBytes = 22;  // type, child mask, count, offset, size

template <class T>
void append_value(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::uint16_t intensity_step(float intensity, float max_intensity) {
  // Potree's intensity is an integer; the full range of the cloud becomes the full range of it.
  if (!(intensity > 0.0F) || !(max_intensity > 0.0F)) return 0;
  return static_cast<std::uint16_t>(std::lround(std::min(1.0F, intensity / max_intensity) *
                                                std::numeric_limits<std::uint16_t>::max()));
}

Json numbers(const Eigen::Vector3d& values) {
  return {values.x(), values.y(), values.z()};
}

Json attribute(
    const char* name, int elements, int element_size, const char* type, const Json& range) {
  return {{"name", name},
          {"description", ""},
          {"size", elements * element_size},
          {"numElements", elements},
          {"elementSize", element_size},
          {"type", type},
          {"min", range[0]},
          {"max", range[1]},
          {"scale", std::vector<double>(elements, 1.0)},
          {"offset", std::vector<double>(elements, 0.0)}};
}

Json scalar_range(double max) {
  return {Json::array({0.0}), Json::array({max})};
}

}  // namespace

Expected<OctreeOutput> OctreeOutput::create(const std::filesystem::path& folder,
                                            const OctreeCube& root,
                                            const OctreeAttributes& attributes,
                                            const OctreeOptions& options) {
  HF_TRY(AtomicFile file, AtomicFile::create(folder / octree_file::kPoints));
  OctreeOutput output(std::move(file), folder);
  output.cube_ = root;
  output.attributes_ = attributes;
  output.options_ = options;
  // 32-bit steps must reach across the cube.
  output.options_.scale_m = std::max(options.scale_m, std::ldexp(root.side_m, -30));
  output.summary_.min_m.setConstant(std::numeric_limits<double>::infinity());
  output.summary_.max_m.setConstant(-std::numeric_limits<double>::infinity());
  return output;
}

void OctreeOutput::append(const OctreePoint& point, std::string& bytes) {
  const Eigen::Vector3d position = point.point.cast<double>();
  summary_.min_m = summary_.min_m.cwiseMin(position);
  summary_.max_m = summary_.max_m.cwiseMax(position);
  const Eigen::Vector3d steps = (position - cube_.min_m) / options_.scale_m;
  for (const double step : steps) append_value(bytes, static_cast<std::int32_t>(std::lround(step)));
  for (const std::uint8_t channel : point.color) {
    append_value(bytes, static_cast<std::uint16_t>(channel * 257));  // 255 becomes 65535
  }
  if (attributes_.has_intensity) {
    append_value(bytes, intensity_step(point.intensity, attributes_.max_intensity));
  }
  if (attributes_.has_source) append_value(bytes, static_cast<std::uint8_t>(point.source));
  if (attributes_.has_distance) append_value(bytes, point.distance_m);
}

std::size_t OctreeOutput::add_node(std::span<const OctreePoint> points, int depth) {
  constexpr std::size_t kFlush = std::size_t{1} << 20U;
  Node node{.offset = written_, .count = static_cast<std::uint32_t>(points.size())};
  std::string bytes;
  for (const OctreePoint& point : points) {
    append(point, bytes);
    if (bytes.size() < kFlush) continue;
    file_.write(bytes);
    bytes.clear();
  }
  file_.write(bytes);
  node.bytes = points.size() * attributes_.bytes_per_point();
  written_ += node.bytes;
  summary_.num_points += points.size();
  summary_.depth = std::max(summary_.depth, depth);
  nodes_.push_back(node);
  return nodes_.size() - 1;
}

void OctreeOutput::set_child(std::size_t parent, int octant, std::size_t child) {
  nodes_[parent].children[octant] = child;
}

std::string OctreeOutput::hierarchy(std::size_t root) const {
  std::string bytes;
  std::vector<std::size_t> queue = {root};  // breadth first, as readers expect it
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const Node& node = nodes_[queue[next]];
    std::uint8_t mask = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
      if (!node.children[octant]) continue;
      mask = static_cast<std::uint8_t>(mask | (1U << octant));
      queue.push_back(*node.children[octant]);
    }
    append_value(bytes, static_cast<std::uint8_t>(mask == 0 ? 1 : 0));  // 1: leaf
    append_value(bytes, mask);
    append_value(bytes, node.count);
    append_value(bytes, node.offset);
    append_value(bytes, node.bytes);
  }
  return bytes;
}

std::string OctreeOutput::metadata() const {
  const Eigen::Vector3d cube_max = cube_.min_m.array() + cube_.side_m;
  Json attributes = Json::array();
  attributes.push_back(
      attribute("position", 3, 4, "int32", Json{numbers(summary_.min_m), numbers(summary_.max_m)}));
  attributes.push_back(attribute(
      "rgb", 3, 2, "uint16", Json{Json::array({0, 0, 0}), Json::array({65535, 65535, 65535})}));
  if (attributes_.has_intensity) {
    Json intensity = attribute("intensity", 1, 2, "uint16", scalar_range(65535.0));
    intensity["description"] = "of the largest intensity of the cloud";
    attributes.push_back(std::move(intensity));
  }
  if (attributes_.has_source) {
    attributes.push_back(attribute("classification", 1, 1, "uint8", scalar_range(1.0)));
  }
  if (attributes_.has_distance) {
    attributes.push_back(
        attribute("distance", 1, 4, "float", scalar_range(attributes_.max_distance_m)));
  }
  const Json json = {{"version", "2.0"},
                     {"name", folder_.filename().string()},
                     {"description", ""},
                     {"points", summary_.num_points},
                     {"projection", ""},
                     {"hierarchy",
                      {{"firstChunkSize", nodes_.size() * kHierarchyNodeBytes},
                       {"stepSize", summary_.depth + 1},
                       {"depth", summary_.depth}}},
                     {"offset", numbers(cube_.min_m)},
                     {"scale", numbers(Eigen::Vector3d::Constant(options_.scale_m))},
                     {"spacing", cube_.side_m / options_.cells_per_side},
                     {"boundingBox", {{"min", numbers(cube_.min_m)}, {"max", numbers(cube_max)}}},
                     {"encoding", "DEFAULT"},
                     {"attributes", attributes}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Expected<OctreeSummary> OctreeOutput::finish(std::size_t root) {
  summary_.num_nodes = nodes_.size();
  if (auto written = file_.commit(); !written) return std::unexpected(written.error());
  auto written = write_file_atomically(folder_ / octree_file::kHierarchy, hierarchy(root));
  if (written) written = write_file_atomically(folder_ / octree_file::kMetadata, metadata());
  if (!written) return std::unexpected(written.error());
  return summary_;
}

}  // namespace hybridfusion
