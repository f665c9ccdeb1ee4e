// What a stated confidence is worth: how many of the poses that carry it are right.
#include "pair_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace hybridfusion::benchmark {
namespace {

constexpr std::array<double, 5> kEdges{0.0, 0.1, 0.5, 0.9, 1.0};
constexpr std::size_t kNumBins = kEdges.size() - 1;

struct Bin {
  std::size_t poses = 0;
  std::size_t right = 0;
  double confidence_sum = 0.0;
};

std::size_t bin_of(double confidence) {
  const auto* const above = std::ranges::upper_bound(kEdges, confidence);
  return std::min(static_cast<std::size_t>(above - kEdges.begin()) - 1, kNumBins - 1);
}

}  // namespace

void print_calibration(const std::vector<Outcome>& outcomes,
                       const std::vector<std::string>& methods) {
  fmt::print(
      "\nPoses by their confidence, refused ones too: how many, mean confidence, share that is "
      "right. Brier score: mean square of confidence less outcome (1 right, 0 not)\n\n| method |");
  for (std::size_t i = 0; i < kNumBins; ++i) {
    fmt::print(" {:.1f} to {:.1f} |", kEdges[i], kEdges[i + 1]);
  }
  fmt::print(" Brier score |\n|---|---|---|---|---|---|\n");
  for (const std::string& method : methods) {
    std::array<Bin, kNumBins> bins{};
    double squares = 0.0;
    std::size_t poses = 0;
    for (const Outcome& o : outcomes) {
      if (o.method != method) continue;
      Bin& bin = bins[bin_of(o.confidence)];
      ++bin.poses;
      bin.right += o.right ? 1 : 0;
      bin.confidence_sum += o.confidence;
      const double error = o.confidence - (o.right ? 1.0 : 0.0);
      squares += error * error;
      ++poses;
    }
    if (poses == 0) continue;
    fmt::print("| {} |", method);
    for (const Bin& bin : bins) {
      if (bin.poses == 0) {
        fmt::print(" - |");
        continue;
      }
      const auto count = static_cast<double>(bin.poses);
      fmt::print(" {}: {:.2f}, {:.2f} |",
                 bin.poses,
                 bin.confidence_sum / count,
                 static_cast<double>(bin.right) / count);
    }
    fmt::print(" {:.4f} |\n", squares / static_cast<double>(poses));
  }
}

}  // namespace hybridfusion::benchmark
