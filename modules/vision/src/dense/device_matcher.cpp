#include "device_matcher.hpp"

#include <string>

namespace hybridfusion {
namespace {

#ifdef HF_WITH_CUDA
constexpr const char* kBuiltWithout = nullptr;
#else
constexpr const char* kBuiltWithout = "the program was built without HF_CUDA";
#endif

const char* problem_of_device() {
#ifdef HF_WITH_CUDA
  return device::device_problem();
#else
  return kBuiltWithout;
#endif
}

const char* run_on_device([[maybe_unused]] const device::SgmProblem& problem,
                          [[maybe_unused]] float* disparity) {
#ifdef HF_WITH_CUDA
  return device::match_on_device(problem, disparity);
#else
  return kBuiltWithout;
#endif
}

}  // namespace

device::SgmProblem sgm_problem(const RectifiedImages& images,
                               const DisparityRanges& ranges,
                               const StepPenalties& penalties,
                               const StereoOptions& options) {
  return {.width = images.left.width,
          .height = images.left.height,
          .num_disparities = images.num_disparities,
          .left = images.left.values.data(),
          .right = images.right.values.data(),
          .right_mask = images.right_mask.values.data(),
          .low = ranges.low.values.data(),
          .count = ranges.count.values.data(),
          .large_penalty = penalties.large.data(),
          .small_penalty = penalties.small,
          .diagonal_paths = options.diagonal_paths,
          .uniqueness = options.uniqueness,
          .max_left_right_px = options.max_left_right_px};
}

std::unique_ptr<DeviceMatcher> DeviceMatcher::open(const StereoOptions& options,
                                                   const RunContext& ctx) {
  if (options.backend == "cpu") return nullptr;
  const char* problem = problem_of_device();
  if (problem == nullptr) {
    ctx.info("stereo matching on the CUDA device");
    return std::unique_ptr<DeviceMatcher>(new DeviceMatcher(ctx));
  }
  if (options.backend == "cuda") {
    ctx.warn(std::string("stereo.backend = cuda, but ") + problem + ": matching on the CPU");
  }
  return nullptr;
}

std::optional<ImagePlane<float>> DeviceMatcher::match(const RectifiedImages& images,
                                                      const DisparityRanges& ranges,
                                                      const StereoOptions& options) {
  if (failed_) return std::nullopt;
  const StepPenalties penalties =
      step_penalties(options.smoothness_small, options.smoothness_large);
  ImagePlane<float> disparity(images.left.width, images.left.height);
  const char* problem =
      run_on_device(sgm_problem(images, ranges, penalties, options), disparity.values.data());
  if (problem == nullptr) return disparity;
  if (!failed_.exchange(true)) {
    ctx_.warn(std::string("the CUDA device failed (") + problem +
              "): matching on the CPU from here on");
  }
  return std::nullopt;
}

}  // namespace hybridfusion
