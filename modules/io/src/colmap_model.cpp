#include "colmap_formats.hpp"
#include "text.hpp"
#include "text_lines.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/colmap_model.hpp>

#include <array>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr std::string_view kAgain = "export the model again";
constexpr std::string_view kNoPoint = "-1";

/// Reads the words of one line as numbers; a word of another kind fails the whole line.
class Words {
 public:
  explicit Words(std::string_view line) : line_(trimmed(line)), words_(split_words(line)) {}

  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] bool done() const { return next_ == words_.size(); }
  [[nodiscard]] std::size_t left() const { return words_.size() - next_; }
  [[nodiscard]] std::string_view word() {
    return failed_ || done() ? fail_word() : words_[next_++];
  }
  /// All that is left, blanks inside as they are.
  [[nodiscard]] std::string_view rest() {
    if (failed_ || done()) return fail_word();
    const std::string_view word = words_[next_];
    next_ = words_.size();
    return line_.substr(static_cast<std::size_t>(word.data() - line_.data()));
  }
  template <class Number>
  [[nodiscard]] Number number() {
    const auto value = parse_number<Number>(word());
    if (!value) failed_ = true;
    if constexpr (std::is_floating_point_v<Number>) {
      if (value && !std::isfinite(*value)) failed_ = true;
    }
    return value.value_or(Number{});
  }

 private:
  std::string_view fail_word() {
    failed_ = true;
    return {};
  }
  std::string_view line_;
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
  bool failed_ = false;
};

[[nodiscard]] Eigen::Vector3d read_vector(Words& words) {
  const auto x = words.number<double>();
  const auto y = words.number<double>();
  return {x, y, words.number<double>()};
}

[[nodiscard]] bool is_comment(std::string_view line) {
  return trimmed(line).starts_with('#');
}

Expected<std::vector<ColmapCamera>> read_cameras(const std::filesystem::path& path) {
  HF_TRY(TextLines lines, TextLines::open(path));
  std::vector<ColmapCamera> cameras;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) return cameras;
    if (is_comment(*line) || trimmed(*line).empty()) continue;
    Words words(*line);
    ColmapCamera camera;
    camera.id = words.number<std::uint32_t>();
    camera.model = words.word();
    camera.width_px = words.number<int>();
    camera.height_px = words.number<int>();
    while (!words.failed() && !words.done()) camera.params.push_back(words.number<double>());
    if (words.failed()) return lines.malformed("no camera", kAgain);
    cameras.push_back(std::move(camera));
  }
}

/// "x y id" triplets; id -1 says that the feature has no point.
[[nodiscard]] std::optional<std::vector<ColmapPoint2D>> parse_features(std::string_view line) {
  Words words(line);
  std::vector<ColmapPoint2D> points;
  points.reserve(words.left() / 3);
  while (!words.done()) {
    ColmapPoint2D point;
    point.pixel.x() = words.number<double>();
    point.pixel.y() = words.number<double>();
    const std::string_view id = words.word();
    if (id != kNoPoint) point.point3d = parse_number<std::uint64_t>(id);
    if (words.failed() || (id != kNoPoint && !point.point3d)) return std::nullopt;
    points.push_back(point);
  }
  return points;
}

Expected<std::vector<ColmapImage>> read_images(const std::filesystem::path& path) {
  HF_TRY(TextLines lines, TextLines::open(path));
  std::vector<ColmapImage> images;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) return images;
    if (is_comment(*line) || trimmed(*line).empty()) continue;
    Words words(*line);
    ColmapImage image;
    image.id = words.number<std::uint32_t>();
    const auto w = words.number<double>();
    const Eigen::Vector3d xyz = read_vector(words);
    image.camera_from_world = Eigen::Quaterniond(w, xyz.x(), xyz.y(), xyz.z());
    image.camera_from_world_translation = read_vector(words);
    image.camera = words.number<std::uint32_t>();
    image.name = words.rest();
    if (words.failed() || !(image.camera_from_world.norm() > 1e-3))
      return lines.malformed("no image", kAgain);
    image.camera_from_world.normalize();
    HF_TRY(const auto features, lines.next());
    auto points = parse_features(features.value_or(""));
    if (!points) return lines.malformed("no list of 'x y point' triplets", kAgain);
    image.points = std::move(*points);
    images.push_back(std::move(image));
  }
}

Expected<std::vector<ColmapPoint3D>> read_points(const std::filesystem::path& path) {
  HF_TRY(TextLines lines, TextLines::open(path));
  std::vector<ColmapPoint3D> points;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) return points;
    if (is_comment(*line) || trimmed(*line).empty()) continue;
    Words words(*line);
    ColmapPoint3D point;
    point.id = words.number<std::uint64_t>();
    point.point_in_world = read_vector(words);
    for (std::uint8_t& channel : point.color) channel = words.number<std::uint8_t>();
    point.error_px = words.number<double>();
    while (!words.failed() && !words.done()) {
      const auto image = words.number<std::uint32_t>();
      point.track.push_back({.image = image, .point2d = words.number<std::uint32_t>()});
    }
    if (words.failed()) return lines.malformed("no point", kAgain);
    points.push_back(std::move(point));
  }
}

Expected<void> write_cameras(const std::filesystem::path& path, const ColmapModel& model) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  file.write("# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n");
  for (const ColmapCamera& camera : model.cameras) {
    file.write(fmt::format("{} {} {} {} {}\n",
                           camera.id,
                           camera.model,
                           camera.width_px,
                           camera.height_px,
                           fmt::join(camera.params, " ")));
  }
  return file.commit();
}

Expected<void> write_images(const std::filesystem::path& path, const ColmapModel& model) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  file.write(
      "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n"
      "# POINTS2D[] as (X, Y, POINT3D_ID)\n");
  for (const ColmapImage& image : model.images) {
    const Eigen::Quaterniond& q = image.camera_from_world;
    const Eigen::Vector3d& t = image.camera_from_world_translation;
    file.write(fmt::format("{} {} {} {} {} {} {} {} {} {}\n",
                           image.id,
                           q.w(),
                           q.x(),
                           q.y(),
                           q.z(),
                           t.x(),
                           t.y(),
                           t.z(),
                           image.camera,
                           image.name));
    std::string features;
    for (const ColmapPoint2D& point : image.points) {
      fmt::format_to(std::back_inserter(features),
                     "{}{:.3f} {:.3f} {}",
                     features.empty() ? "" : " ",
                     point.pixel.x(),
                     point.pixel.y(),
                     point.point3d ? fmt::format("{}", *point.point3d) : std::string(kNoPoint));
    }
    file.write(features + "\n");
  }
  return file.commit();
}

Expected<void> write_points(const std::filesystem::path& path, const ColmapModel& model) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  file.write("# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n");
  for (const ColmapPoint3D& point : model.points) {
    const Eigen::Vector3d& at = point.point_in_world;
    std::string line = fmt::format("{} {:.6f} {:.6f} {:.6f} {} {} {} {:.4f}",
                                   point.id,
                                   at.x(),
                                   at.y(),
                                   at.z(),
                                   point.color[0],
                                   point.color[1],
                                   point.color[2],
                                   point.error_px);
    for (const ColmapTrackElement& seen : point.track) {
      fmt::format_to(std::back_inserter(line), " {} {}", seen.image, seen.point2d);
    }
    file.write(line + "\n");
  }
  return file.commit();
}

}  // namespace

Expected<void> write_colmap_model(const std::filesystem::path& folder, const ColmapModel& model) {
  if (auto written = write_cameras(folder / "cameras.txt", model); !written) return written;
  if (auto written = write_images(folder / "images.txt", model); !written) return written;
  return write_points(folder / "points3D.txt", model);
}

Expected<ColmapModel> read_colmap_text(const std::filesystem::path& folder) {
  ColmapModel model;
  HF_TRY(model.cameras, read_cameras(folder / "cameras.txt"));
  HF_TRY(model.images, read_images(folder / "images.txt"));
  HF_TRY(model.points, read_points(folder / "points3D.txt"));
  return model;
}

}  // namespace hybridfusion
