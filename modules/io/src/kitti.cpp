#include "text.hpp"
#include "text_lines.hpp"
#include "time_text.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/kitti.hpp>

#include <array>
#include <cmath>

namespace hybridfusion {
namespace {

using Matrix34 = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;

[[nodiscard]] std::optional<Rigid3> parse_pose(const std::vector<std::string_view>& words) {
  Matrix34 matrix;
  if (words.size() != static_cast<std::size_t>(matrix.size())) return std::nullopt;
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    const auto value = parse_number<double>(words[static_cast<std::size_t>(i)]);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    matrix.data()[i] = *value;
  }
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  // Published trajectories are rounded to six digits.
  constexpr double kTolerance = 1e-3;
  if (rotation.determinant() < 0.0 || !(rotation * rotation.transpose()).isIdentity(kTolerance)) {
    return std::nullopt;
  }
  return Rigid3{.rotation = Eigen::Quaterniond(rotation).normalized(),
                .translation = matrix.col(3)};
}

Expected<std::vector<Timestamp>> read_times(const std::filesystem::path& path) {
  HF_TRY(TextLines lines, TextLines::open(path));
  std::vector<Timestamp> times;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) return times;
    const std::string_view word = trimmed(*line);
    if (word.empty()) continue;
    const auto time = parse_seconds(word);
    if (!time) return lines.malformed("no time in seconds", "write one time on each line");
    if (!times.empty() && *time <= times.back()) {
      return lines.malformed("the times do not ascend", "sort the poses by time");
    }
    times.push_back(*time);
  }
}

}  // namespace

Expected<Trajectory> read_kitti(const std::filesystem::path& poses,
                                const std::filesystem::path& times_path) {
  HF_TRY(const std::vector<Timestamp> times, read_times(times_path));
  HF_TRY(TextLines lines, TextLines::open(poses));
  Trajectory trajectory;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) break;
    const std::vector<std::string_view> words = split_words(*line);
    if (words.empty()) continue;
    const auto pose = parse_pose(words);
    const std::size_t index = trajectory.poses.size();
    if (!pose || index >= times.size()) {
      return lines.malformed(
          pose
              ? fmt::format("more poses than the {} times of {}", times.size(), times_path.string())
              : std::string("no pose"),
          "write the 12 numbers of a 3 x 4 matrix on each line");
    }
    trajectory.poses.push_back({.time = times[index], .map_from_body = *pose});
  }
  if (trajectory.poses.size() < times.size()) {
    return lines.malformed(fmt::format("{} poses, but {} times in {}",
                                       trajectory.poses.size(),
                                       times.size(),
                                       times_path.string()),
                           "give the times of these poses");
  }
  return trajectory;
}

Expected<void> write_kitti(const std::filesystem::path& path, const Trajectory& trajectory) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  for (const StampedPose& pose : trajectory.poses) {
    const Eigen::Matrix3d rotation = pose.map_from_body.rotation.toRotationMatrix();
    const Eigen::Vector3d& at = pose.map_from_body.translation;
    std::string line;
    for (int row = 0; row < 3; ++row) {
      fmt::format_to(std::back_inserter(line),
                     "{:.9f} {:.9f} {:.9f} {:.6f}{}",
                     rotation(row, 0),
                     rotation(row, 1),
                     rotation(row, 2),
                     at[row],
                     row < 2 ? ' ' : '\n');
    }
    file.write(line);
  }
  return file.commit();
}

Expected<void> write_kitti_times(const std::filesystem::path& path, const Trajectory& trajectory) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  for (const StampedPose& pose : trajectory.poses) file.write(seconds_text(pose.time) + "\n");
  return file.commit();
}

}  // namespace hybridfusion
