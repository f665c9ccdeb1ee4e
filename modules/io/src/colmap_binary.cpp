#include "byte_reader.hpp"
#include "colmap_formats.hpp"
#include "input_file.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

// The layout is that of COLMAP's documentation ("Binary file format"): little-endian, counts as
// uint64, names ended by a zero byte, the point of a feature without one all bits set.

namespace hybridfusion {
namespace {

constexpr std::uint64_t kNoPoint = std::numeric_limits<std::uint64_t>::max();
constexpr std::string_view kAgain = "export the model again";

struct CameraModel {
  std::string_view name;
  std::size_t num_params;
};
/// By their numbers.
constexpr std::array<CameraModel, 12> kModels = {{{"SIMPLE_PINHOLE", 3},
                                                  {"PINHOLE", 4},
                                                  {"SIMPLE_RADIAL", 4},
                                                  {"RADIAL", 5},
                                                  {"OPENCV", 8},
                                                  {"OPENCV_FISHEYE", 8},
                                                  {"FULL_OPENCV", 12},
                                                  {"FOV", 5},
                                                  {"SIMPLE_RADIAL_FISHEYE", 4},
                                                  {"RADIAL_FISHEYE", 5},
                                                  {"THIN_PRISM_FISHEYE", 12},
                                                  {"RAD_TAN_THIN_PRISM_FISHEYE", 16}}};

template <class Number>
Expected<Number> read(InputFile& file) {
  HF_TRY(const auto bytes, file.take(sizeof(Number)));
  return load<Number>(bytes.data());
}

/// A count of items of at least `least_bytes` each, which the file can hold.
Expected<std::uint64_t> read_count(InputFile& file, std::uint64_t least_bytes) {
  HF_TRY(const auto count, read<std::uint64_t>(file));
  if (count > file.remaining() / least_bytes) {
    return file.malformed(
        fmt::format("{} items at byte {} are more than the file can hold", count, file.position()),
        kAgain);
  }
  return count;
}

template <std::size_t Count>
Expected<std::array<double, Count>> read_numbers(InputFile& file) {
  HF_TRY(const auto bytes, file.take(Count * sizeof(double)));
  std::array<double, Count> numbers;
  for (std::size_t i = 0; i < Count; ++i) {
    numbers[i] = load<double>(bytes.data() + i * sizeof(double));
    if (!std::isfinite(numbers[i])) {
      return file.malformed(fmt::format("no finite number before byte {}", file.position()),
                            kAgain);
    }
  }
  return numbers;
}

Expected<std::vector<ColmapCamera>> read_cameras(const std::filesystem::path& path) {
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const std::uint64_t count, read_count(file, 24));
  std::vector<ColmapCamera> cameras;
  for (std::uint64_t i = 0; i < count; ++i) {
    ColmapCamera camera;
    HF_TRY(camera.id, read<std::uint32_t>(file));
    HF_TRY(const auto model, read<std::int32_t>(file));
    HF_TRY(const auto width, read<std::uint64_t>(file));
    HF_TRY(const auto height, read<std::uint64_t>(file));
    constexpr std::uint64_t kMaxSide_px = 1U << 20U;
    if (model < 0 || model >= static_cast<std::int32_t>(kModels.size())) {
      return file.malformed(
          fmt::format("camera {} is of model number {}, which is not known here", camera.id, model),
          "undistort the photos and give their model");
    }
    if (width > kMaxSide_px || height > kMaxSide_px) return file.malformed("no camera", kAgain);
    camera.model = kModels[static_cast<std::size_t>(model)].name;
    camera.width_px = static_cast<int>(width);
    camera.height_px = static_cast<int>(height);
    for (std::size_t k = 0; k < kModels[static_cast<std::size_t>(model)].num_params; ++k) {
      HF_TRY(const auto number, read_numbers<1>(file));
      camera.params.push_back(number[0]);
    }
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

Expected<std::string> read_name(InputFile& file) {
  constexpr std::size_t kMaxName = 4096;
  std::string name;
  while (name.size() <= kMaxName) {
    HF_TRY(const char letter, read<char>(file));
    if (letter == '\0') return name;
    name += letter;
  }
  return file.malformed(fmt::format("a name without end before byte {}", file.position()), kAgain);
}

Expected<std::vector<ColmapPoint2D>> read_features(InputFile& file) {
  HF_TRY(const std::uint64_t count, read_count(file, 24));
  std::vector<ColmapPoint2D> points;
  points.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    HF_TRY(const auto at, read_numbers<2>(file));
    HF_TRY(const auto point, read<std::uint64_t>(file));
    points.push_back({.pixel = {at[0], at[1]},
                      .point3d = point == kNoPoint ? std::nullopt : std::optional(point)});
  }
  return points;
}

Expected<std::vector<ColmapImage>> read_images(const std::filesystem::path& path) {
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const std::uint64_t count, read_count(file, 73));
  std::vector<ColmapImage> images;
  for (std::uint64_t i = 0; i < count; ++i) {
    ColmapImage image;
    HF_TRY(image.id, read<std::uint32_t>(file));
    HF_TRY(const auto pose, read_numbers<7>(file));
    image.camera_from_world = Eigen::Quaterniond(pose[0], pose[1], pose[2], pose[3]);
    if (!(image.camera_from_world.norm() > 1e-3)) return file.malformed("no rotation", kAgain);
    image.camera_from_world.normalize();
    image.camera_from_world_translation = {pose[4], pose[5], pose[6]};
    HF_TRY(image.camera, read<std::uint32_t>(file));
    HF_TRY(image.name, read_name(file));
    HF_TRY(image.points, read_features(file));
    images.push_back(std::move(image));
  }
  return images;
}

Expected<std::vector<ColmapPoint3D>> read_points(const std::filesystem::path& path) {
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const std::uint64_t count, read_count(file, 51));
  std::vector<ColmapPoint3D> points;
  for (std::uint64_t i = 0; i < count; ++i) {
    ColmapPoint3D point;
    HF_TRY(point.id, read<std::uint64_t>(file));
    HF_TRY(const auto at, read_numbers<3>(file));
    point.point_in_world = {at[0], at[1], at[2]};
    for (std::uint8_t& channel : point.color) {
      HF_TRY(channel, read<std::uint8_t>(file));
    }
    HF_TRY(const auto error, read<double>(file));  // -1 or not a number where it is not known
    point.error_px = std::isfinite(error) ? error : -1.0;
    HF_TRY(const std::uint64_t length, read_count(file, 8));
    for (std::uint64_t k = 0; k < length; ++k) {
      ColmapTrackElement element;
      HF_TRY(element.image, read<std::uint32_t>(file));
      HF_TRY(element.point2d, read<std::uint32_t>(file));
      point.track.push_back(element);
    }
    points.push_back(std::move(point));
  }
  return points;
}

class BinaryFile {
 public:
  [[nodiscard]] static Expected<BinaryFile> create(const std::filesystem::path& path) {
    HF_TRY(AtomicFile file, AtomicFile::create(path));
    return BinaryFile(std::move(file));
  }
  template <class Number>
  void put(Number number) {
    const auto bytes = std::bit_cast<std::array<std::byte, sizeof(Number)>>(number);
    file_.write(bytes);
  }
  void put_name(const std::string& name) {
    file_.write(std::string_view(name.c_str(), name.size() + 1));
  }
  [[nodiscard]] Expected<void> commit() { return file_.commit(); }

 private:
  explicit BinaryFile(AtomicFile file) : file_(std::move(file)) {}
  AtomicFile file_;
};

Expected<void> write_cameras(const std::filesystem::path& path, const ColmapModel& model) {
  HF_TRY(BinaryFile file, BinaryFile::create(path));
  file.put<std::uint64_t>(model.cameras.size());
  for (const ColmapCamera& camera : model.cameras) {
    const auto known = std::ranges::find(kModels, camera.model, &CameraModel::name);
    if (known == kModels.end() || known->num_params != camera.params.size()) {
      return fail(ErrorCode::kInvalidOptions,
                  fmt::format("{} with {} parameters is no camera model of COLMAP",
                              camera.model,
                              camera.params.size()));
    }
    file.put<std::uint32_t>(camera.id);
    file.put<std::int32_t>(static_cast<std::int32_t>(known - kModels.begin()));
    file.put<std::uint64_t>(static_cast<std::uint64_t>(camera.width_px));
    file.put<std::uint64_t>(static_cast<std::uint64_t>(camera.height_px));
    for (const double param : camera.params) file.put(param);
  }
  return file.commit();
}

Expected<void> write_images(const std::filesystem::path& path, const ColmapModel& model) {
  HF_TRY(BinaryFile file, BinaryFile::create(path));
  file.put<std::uint64_t>(model.images.size());
  for (const ColmapImage& image : model.images) {
    const Eigen::Quaterniond& q = image.camera_from_world;
    const Eigen::Vector3d& t = image.camera_from_world_translation;
    file.put<std::uint32_t>(image.id);
    for (const double number : {q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()}) file.put(number);
    file.put<std::uint32_t>(image.camera);
    file.put_name(image.name);
    file.put<std::uint64_t>(image.points.size());
    for (const ColmapPoint2D& point : image.points) {
      file.put(point.pixel.x());
      file.put(point.pixel.y());
      file.put<std::uint64_t>(point.point3d.value_or(kNoPoint));
    }
  }
  return file.commit();
}

Expected<void> write_points(const std::filesystem::path& path, const ColmapModel& model) {
  HF_TRY(BinaryFile file, BinaryFile::create(path));
  file.put<std::uint64_t>(model.points.size());
  for (const ColmapPoint3D& point : model.points) {
    file.put<std::uint64_t>(point.id);
    for (const double number : point.point_in_world) file.put(number);
    for (const std::uint8_t channel : point.color) file.put(channel);
    file.put(point.error_px);
    file.put<std::uint64_t>(point.track.size());
    for (const ColmapTrackElement& seen : point.track) {
      file.put<std::uint32_t>(seen.image);
      file.put<std::uint32_t>(seen.point2d);
    }
  }
  return file.commit();
}

}  // namespace

Expected<void> write_colmap_binary(const std::filesystem::path& folder, const ColmapModel& model) {
  if (auto written = write_cameras(folder / "cameras.bin", model); !written) return written;
  if (auto written = write_images(folder / "images.bin", model); !written) return written;
  return write_points(folder / "points3D.bin", model);
}

Expected<ColmapModel> read_colmap_binary(const std::filesystem::path& folder) {
  ColmapModel model;
  HF_TRY(model.cameras, read_cameras(folder / "cameras.bin"));
  HF_TRY(model.images, read_images(folder / "images.bin"));
  HF_TRY(model.points, read_points(folder / "points3D.bin"));
  return model;
}

}  // namespace hybridfusion
