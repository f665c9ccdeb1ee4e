#include "sgm_steps.hpp"

#include <cuda_runtime.h>

#include <vector>

namespace hybridfusion::device {
namespace {

constexpr unsigned kThreads = 256;
constexpr unsigned kWarp = 32;
constexpr unsigned kLinesPerBlock = 4;  // 4 * 2 * 1024 path costs: 16 KiB of shared memory

/// The 32 lanes of a warp.
struct WarpLanes {
  unsigned lane;

  template <class Body>
  __device__ void each(int count, const Body& body) const {
    for (int k = static_cast<int>(lane); k < count; k += kWarp) body(k);
    __syncwarp();
  }
  __device__ int smallest(int count, const std::int16_t* values) const {
    int least = kNever;
    for (int k = static_cast<int>(lane); k < count; k += kWarp) {
      least = values[k] < least ? values[k] : least;
    }
    for (unsigned step = kWarp / 2; step > 0; step /= 2) {
      const int other = __shfl_xor_sync(0xffffffffU, least, static_cast<int>(step));
      least = other < least ? other : least;
    }
    return least;
  }
};

template <class Body>
__global__ void run_items(Body body, std::size_t count) {
  const std::size_t item = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x;
  if (item < count) body(item);
}

__global__ void run_lines(PathBody body, std::size_t count) {
  __shared__ std::int16_t costs[kLinesPerBlock][2][kMaxCandidates];
  const unsigned group = threadIdx.x / kWarp;
  const std::size_t line = static_cast<std::size_t>(blockIdx.x) * kLinesPerBlock + group;
  if (line >= count) return;
  body(WarpLanes{threadIdx.x % kWarp}, line, costs[group][0], costs[group][1]);
}

/// Launches in order on the default stream; keeps the first error.
struct DeviceRunner {
  cudaError_t& error;

  template <class Body>
  void items(std::size_t count, const Body& body) {
    if (error != cudaSuccess || count == 0) return;
    run_items<<<static_cast<unsigned>((count + kThreads - 1) / kThreads), kThreads>>>(body, count);
    error = cudaGetLastError();
  }
  void lines(const PathBody& body) {
    const std::size_t count = body.num_lines();
    if (error != cudaSuccess || count == 0) return;
    const auto blocks = static_cast<unsigned>((count + kLinesPerBlock - 1) / kLinesPerBlock);
    run_lines<<<blocks, kLinesPerBlock * kWarp>>>(body, count);
    error = cudaGetLastError();
  }
};

/// Device memory that is freed at the end; the first error stays.
class Arena {
 public:
  explicit Arena(cudaError_t& error) : error_(error) {}
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena() {
    for (void* block : blocks_) cudaFree(block);
  }

  template <class T>
  T* room(std::size_t count) {
    void* block = nullptr;
    if (error_ == cudaSuccess) error_ = cudaMalloc(&block, (count > 0 ? count : 1) * sizeof(T));
    if (error_ != cudaSuccess) return nullptr;
    blocks_.push_back(block);
    return static_cast<T*>(block);
  }
  template <class T>
  const T* copy(const T* values, std::size_t count) {
    T* block = room<T>(count);
    if (block != nullptr) {
      error_ = cudaMemcpy(block, values, count * sizeof(T), cudaMemcpyHostToDevice);
    }
    return block;
  }

 private:
  cudaError_t& error_;
  std::vector<void*> blocks_;
};

}  // namespace

const char* device_problem() {
  int count = 0;
  const cudaError_t error = cudaGetDeviceCount(&count);
  if (error != cudaSuccess) return cudaGetErrorString(error);
  return count > 0 ? nullptr : "no CUDA device";
}

const char* match_on_device(const SgmProblem& problem, float* disparity) {
  const std::size_t left = static_cast<std::size_t>(problem.width) * problem.height;
  const std::size_t right = left + static_cast<std::size_t>(problem.num_disparities - 1) * problem.height;
  std::vector<std::uint64_t> begin(left);
  std::uint64_t entries = 0;
  for (std::size_t i = 0; i < left; ++i) {
    if (problem.count[i] > kMaxCandidates) return "more candidates of a pixel than the kernels hold";
    begin[i] = entries;
    entries += static_cast<std::uint64_t>(problem.count[i]);
  }
  cudaError_t error = cudaSuccess;
  Arena arena(error);
  SgmVolume volume;
  volume.in = problem;
  volume.in.left = arena.copy(problem.left, left);
  volume.in.right = arena.copy(problem.right, right);
  volume.in.right_mask = arena.copy(problem.right_mask, right);
  volume.in.low = arena.copy(problem.low, left);
  volume.in.count = arena.copy(problem.count, left);
  volume.in.large_penalty = arena.copy(problem.large_penalty, 256);
  volume.begin = arena.copy(begin.data(), left);
  volume.left_codes = arena.room<std::uint64_t>(left);
  volume.right_codes = arena.room<std::uint64_t>(right);
  volume.costs = arena.room<std::uint8_t>(entries);
  volume.sums = arena.room<std::int16_t>(entries);
  volume.right_disparity = arena.room<std::int16_t>(right);
  volume.disparity = arena.room<float>(left);
  run_steps(DeviceRunner{error}, volume);
  if (error == cudaSuccess) {
    error = cudaMemcpy(disparity, volume.disparity, left * sizeof(float), cudaMemcpyDeviceToHost);
  }
  return error == cudaSuccess ? nullptr : cudaGetErrorString(error);
}

}  // namespace hybridfusion::device
