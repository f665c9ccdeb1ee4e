#include "text.hpp"
#include "text_lines.hpp"
#include "time_text.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/tum.hpp>

#include <array>
#include <cmath>
#include <optional>

namespace hybridfusion {
namespace {

constexpr std::string_view kExpected = "write 'time x y z qx qy qz qw' on each line";

[[nodiscard]] std::optional<StampedPose> parse_pose(const std::vector<std::string_view>& words) {
  if (words.size() != 8) return std::nullopt;
  const auto time = parse_seconds(words[0]);
  std::array<double, 7> numbers = {};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto value = parse_number<double>(words[i + 1]);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    numbers[i] = *value;
  }
  if (!time) return std::nullopt;
  const Eigen::Quaterniond rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
  constexpr double kMinNorm = 1e-3;
  if (!(rotation.norm() > kMinNorm)) return std::nullopt;
  return StampedPose{.time = *time,
                     .map_from_body = {.rotation = rotation.normalized(),
                                       .translation = {numbers[0], numbers[1], numbers[2]}}};
}

}  // namespace

Expected<Trajectory> read_tum(const std::filesystem::path& path) {
  HF_TRY(TextLines lines, TextLines::open(path));
  Trajectory trajectory;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) return trajectory;
    const std::vector<std::string_view> words = split_words(*line);
    if (words.empty() || words[0].starts_with('#')) continue;
    const auto pose = parse_pose(words);
    if (!pose) return lines.malformed(fmt::format("'{}' is no pose", printable(*line)), kExpected);
    if (!trajectory.poses.empty() && pose->time <= trajectory.poses.back().time) {
      return lines.malformed("the times do not ascend",
                             "sort the poses by time and remove repetitions");
    }
    trajectory.poses.push_back(*pose);
  }
}

Expected<void> write_tum(const std::filesystem::path& path, const Trajectory& trajectory) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  file.write("# time[s] x y z qx qy qz qw\n");
  for (const StampedPose& pose : trajectory.poses) {
    const Eigen::Vector3d& at = pose.map_from_body.translation;
    const Eigen::Quaterniond& q = pose.map_from_body.rotation;
    file.write(fmt::format("{} {:.6f} {:.6f} {:.6f} {:.9f} {:.9f} {:.9f} {:.9f}\n",
                           seconds_text(pose.time),
                           at.x(),
                           at.y(),
                           at.z(),
                           q.x(),
                           q.y(),
                           q.z(),
                           q.w()));
  }
  return file.commit();
}

}  // namespace hybridfusion
