#include "matching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <cblas.h>

// Absent when another BLAS than OpenBLAS is installed.
extern "C" [[gnu::weak]] void openblas_set_num_threads(int num_threads);

namespace hybridfusion {
namespace {

constexpr std::size_t kBlockRows = 128;
constexpr std::size_t kBlockCols = 1024;
constexpr std::size_t kLane = 16;
// Descriptors farther apart than this angle [rad] are no match however unique (as in COLMAP).
constexpr double kMaxAngle_rad = 0.7;

std::vector<float> unit_rows(const FeatureSet& features) {
  std::vector<float> rows(features.descriptors.begin(), features.descriptors.end());
  for (std::size_t i = 0; i < features.size(); ++i) {
    Eigen::Map<Eigen::Matrix<float, kDescriptorSize, 1>> row(rows.data() + i * kDescriptorSize);
    const float norm = row.norm();
    if (norm > 0.0F) row /= norm;
  }
  return rows;
}

struct Best {
  float similarity = -1.0F;
  float second = -1.0F;
  std::uint32_t index = 0;
};

[[gnu::target_clones("avx2", "default")]] float max_of(const float* values) {
  float best[4] = {values[0], values[1], values[2], values[3]};
  for (std::size_t k = 4; k < kLane; k += 4) {
    for (std::size_t c = 0; c < 4; ++c) best[c] = std::max(best[c], values[k + c]);
  }
  return std::max(std::max(best[0], best[1]), std::max(best[2], best[3]));
}

void update_row(Best& best, const float* similarities, std::size_t count, std::uint32_t offset) {
  const auto visit = [&](std::size_t j) {
    const float s = similarities[j];
    if (s > best.similarity) {
      best.second = best.similarity;
      best.similarity = s;
      best.index = offset + static_cast<std::uint32_t>(j);
    } else if (s > best.second) {
      best.second = s;
    }
  };
  std::size_t j = 0;
  // Few lanes hold anything above the second best seen so far.
  for (; j + kLane <= count; j += kLane) {
    if (max_of(similarities + j) <= best.second) continue;
    for (std::size_t k = j; k < j + kLane; ++k) visit(k);
  }
  for (; j < count; ++j) visit(j);
}

[[gnu::target_clones("avx2", "default")]] void update_columns(const float* similarities,
                                                              std::size_t count,
                                                              std::uint32_t row,
                                                              float* best,
                                                              std::uint32_t* index) {
  for (std::size_t j = 0; j < count; ++j) {
    const bool better = similarities[j] > best[j];
    best[j] = better ? similarities[j] : best[j];
    index[j] = better ? row : index[j];
  }
}

}  // namespace

void use_single_threaded_blas() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
}

std::vector<Match> match_features(const FeatureSet& first, const FeatureSet& second, double ratio) {
  const std::vector<float> a = unit_rows(first);
  const std::vector<float> b = unit_rows(second);
  std::vector<Best> rows(first.size());
  std::vector<float> column_best(second.size(), -1.0F);
  std::vector<std::uint32_t> column_index(second.size(), 0);
  std::vector<float> block(kBlockRows * kBlockCols);
  constexpr auto kSize = static_cast<int>(kDescriptorSize);
  for (std::size_t j0 = 0; j0 < second.size(); j0 += kBlockCols) {
    const std::size_t cols = std::min(kBlockCols, second.size() - j0);
    for (std::size_t i0 = 0; i0 < first.size(); i0 += kBlockRows) {
      const std::size_t height = std::min(kBlockRows, first.size() - i0);
      cblas_sgemm(CblasRowMajor,
                  CblasNoTrans,
                  CblasTrans,
                  static_cast<int>(height),
                  static_cast<int>(cols),
                  kSize,
                  1.0F,
                  a.data() + i0 * kDescriptorSize,
                  kSize,
                  b.data() + j0 * kDescriptorSize,
                  kSize,
                  0.0F,
                  block.data(),
                  static_cast<int>(cols));
      for (std::size_t i = 0; i < height; ++i) {
        const float* similarities = block.data() + i * cols;
        update_row(rows[i0 + i], similarities, cols, static_cast<std::uint32_t>(j0));
        update_columns(similarities,
                       cols,
                       static_cast<std::uint32_t>(i0 + i),
                       column_best.data() + j0,
                       column_index.data() + j0);
      }
    }
  }
  std::vector<Match> matches;
  const double ratio2 = ratio * ratio;
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    const Best& row = rows[i];
    if (row.similarity < std::cos(kMaxAngle_rad) || column_index[row.index] != i) continue;
    // Unit vectors: squared distance = 2 - 2 s.
    if (1.0 - row.similarity >= ratio2 * (1.0 - row.second)) continue;
    matches.push_back({.first = i, .second = row.index});
  }
  return matches;
}

}  // namespace hybridfusion
