#include "appearance.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <Eigen/Core>

namespace hybridfusion {
namespace {

constexpr Eigen::Index kWords = 64;
constexpr Eigen::Index kSize = static_cast<Eigen::Index>(kDescriptorSize);
constexpr std::size_t kSamplesPerPhoto = 300;
constexpr std::size_t kMaxSamples = 50000;
constexpr int kIterations = 12;

using Words = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Descriptor = Eigen::RowVectorXf;

Descriptor descriptor_of(const FeatureSet& features, std::size_t k) {
  using Bytes = Eigen::Matrix<std::uint8_t, 1, Eigen::Dynamic>;
  return Eigen::Map<const Bytes>(features.descriptors.data() + k * kDescriptorSize, kSize)
             .cast<float>() /
         512.0F;
}

/// Every k-th descriptor, so that each photo has its say.
std::vector<Descriptor> sample(std::span<const FeatureSet> features) {
  const std::size_t share = std::max<std::size_t>(
      8, std::min(kSamplesPerPhoto, kMaxSamples / std::max<std::size_t>(1, features.size())));
  std::vector<Descriptor> samples;
  for (const FeatureSet& set : features) {
    const std::size_t step = std::max<std::size_t>(1, set.size() / share);
    for (std::size_t k = 0; k < set.size(); k += step) samples.push_back(descriptor_of(set, k));
  }
  return samples;
}

Eigen::Index nearest_word(const Words& words,
                          const Eigen::VectorXf& half_norms,
                          const Descriptor& descriptor) {
  Eigen::Index word = 0;
  const Eigen::VectorXf score = words * descriptor.transpose() - half_norms;
  score.maxCoeff(&word);
  return word;
}

/// k-means from random samples; a word that nothing belongs to stays where it is.
Words cluster(const std::vector<Descriptor>& samples, const RunContext& ctx) {
  Random random(ctx.seed, "vision/appearance");
  Words words(kWords, kSize);
  for (Eigen::Index w = 0; w < kWords; ++w) {
    words.row(w) = samples[random.index(static_cast<std::uint32_t>(samples.size()))];
  }
  std::vector<Eigen::Index> assigned(samples.size());
  for (int iteration = 0; iteration < kIterations && !ctx.stopped(); ++iteration) {
    const Eigen::VectorXf half_norms = 0.5F * words.rowwise().squaredNorm();
    parallel_for(ctx, samples.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        assigned[i] = nearest_word(words, half_norms, samples[i]);
      }
    });
    Words sum = Words::Zero(kWords, kSize);
    Eigen::VectorXf count = Eigen::VectorXf::Zero(kWords);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      sum.row(assigned[i]) += samples[i];
      count[assigned[i]] += 1.0F;
    }
    for (Eigen::Index w = 0; w < kWords; ++w) {
      if (count[w] > 0.0F) words.row(w) = sum.row(w) / count[w];
    }
  }
  return words;
}

/// Sums of the differences to the words, signed square roots, unit length per word and in all.
Eigen::VectorXf vlad(const FeatureSet& features, const Words& words) {
  const Eigen::VectorXf half_norms = 0.5F * words.rowwise().squaredNorm();
  Words sum = Words::Zero(kWords, kSize);
  for (std::size_t k = 0; k < features.size(); ++k) {
    const Descriptor descriptor = descriptor_of(features, k);
    const Eigen::Index word = nearest_word(words, half_norms, descriptor);
    sum.row(word) += descriptor - words.row(word);
  }
  sum = sum.array().sign() * sum.array().abs().sqrt();
  for (Eigen::Index w = 0; w < kWords; ++w) {
    const float norm = sum.row(w).norm();
    if (norm > 0.0F) sum.row(w) /= norm;
  }
  Eigen::VectorXf result = Eigen::Map<const Eigen::VectorXf>(sum.data(), sum.size());
  const float norm = result.norm();
  return norm > 0.0F ? Eigen::VectorXf(result / norm) : result;
}

}  // namespace

std::vector<PhotoPair> similar_photos(std::span<const FeatureSet> features,
                                      int count,
                                      const RunContext& ctx) {
  const std::vector<Descriptor> samples = sample(features);
  if (samples.size() < static_cast<std::size_t>(kWords)) return {};
  const Words words = cluster(samples, ctx);
  std::vector<Eigen::VectorXf> looks(features.size());
  parallel_for(ctx, features.size(), 1, [&](std::size_t i, std::size_t) {
    if (!ctx.stopped()) looks[i] = vlad(features[i], words);
  });
  std::set<PhotoPair> pairs;
  for (std::size_t i = 0; i < looks.size() && !ctx.stopped(); ++i) {
    if (features[i].size() == 0) continue;
    std::vector<std::pair<float, std::size_t>> others;
    for (std::size_t j = 0; j < looks.size(); ++j) {
      if (j != i && features[j].size() > 0) others.emplace_back(-looks[i].dot(looks[j]), j);
    }
    const auto kept = std::min(others.size(), static_cast<std::size_t>(count));
    std::ranges::partial_sort(others, others.begin() + static_cast<std::ptrdiff_t>(kept));
    for (std::size_t k = 0; k < kept; ++k) {
      const std::size_t j = others[k].second;
      pairs.insert({.first = static_cast<std::uint32_t>(std::min(i, j)),
                    .second = static_cast<std::uint32_t>(std::max(i, j))});
    }
  }
  return {pairs.begin(), pairs.end()};
}

}  // namespace hybridfusion
