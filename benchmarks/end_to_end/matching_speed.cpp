#include "matching_speed.hpp"

#include "dense/image_warp.hpp"
#include "dense/stereo_matcher.hpp"

#include <algorithm>
#include <ctime>

namespace hybridfusion::benchmark {

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

nlohmann::ordered_json matching_speed(const Photo& photo, const DensifyOptions& options) {
  constexpr int kDisparities = 161;
  const auto image = photo.load();
  if (!image) return nullptr;
  const WorkImage work = reduce(*image,
                                {.width_px = image->width, .height_px = image->height},
                                std::min(options.max_size_px, 1200));
  const int width = work.grey.cols / 4 * 4 - kDisparities + 1;
  const int height = work.grey.rows / 4 * 4;
  if (width < kDisparities) return nullptr;
  RectifiedImages pair{.left = {width / 4 * 4, height},
                       .right = {width / 4 * 4 + kDisparities - 1, height},
                       .left_mask = {width / 4 * 4, height, 255},
                       .right_mask = {width / 4 * 4 + kDisparities - 1, height, 255},
                       .num_disparities = kDisparities};
  for (int y = 0; y < height; ++y) {
    std::copy_n(work.grey.ptr<std::uint8_t>(y), pair.right.width, pair.right.row(y));
    std::copy_n(work.grey.ptr<std::uint8_t>(y) + 80, pair.left.width, pair.left.row(y));
  }
  const double mpx = 1e-6 * static_cast<double>(pair.left.values.size());
  nlohmann::ordered_json json;
  const auto timed = [&](const char* name, auto&& work_on) {
    const double start = cpu_s();
    work_on();
    json[name] = (cpu_s() - start) / mpx;
  };
  StereoOptions stereo = options.stereo;
  stereo.diagonal_paths = false;
  timed("full_range_4_paths", [&] { (void)match_semi_globally(pair, full_ranges(pair), stereo); });
  timed("coarse_to_fine_4_paths", [&] { (void)match_pair(pair, stereo); });
  stereo.diagonal_paths = true;
  timed("full_range_8_paths", [&] { (void)match_semi_globally(pair, full_ranges(pair), stereo); });
  stereo.matcher = "sgbm";
  timed("opencv_sgbm_3way", [&] { (void)match_pair(pair, stereo); });
  return json;
}

}  // namespace hybridfusion::benchmark
