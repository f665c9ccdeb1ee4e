#include "appearance.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// Photos of `places` places in turn: descriptors of one place come from its own words.
std::vector<FeatureSet> photos_of_places(std::size_t count, std::size_t places) {
  Random random(3, "test/places");
  constexpr std::size_t kWordsPerPlace = 20;
  std::vector<std::uint8_t> words(places * kWordsPerPlace * kDescriptorSize);
  for (auto& value : words) value = static_cast<std::uint8_t>(random.index(120));
  std::vector<FeatureSet> photos(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (int k = 0; k < 200; ++k) {
      const std::size_t word = (i % places) * kWordsPerPlace + random.index(kWordsPerPlace);
      photos[i].pixels.emplace_back(0.0F, 0.0F);
      for (std::size_t d = 0; d < kDescriptorSize; ++d) {
        photos[i].descriptors.push_back(
            static_cast<std::uint8_t>(words[word * kDescriptorSize + d] + random.index(8)));
      }
    }
  }
  return photos;
}

TEST(SimilarPhotos, AreThoseOfOnePlaceAtAnyNumberOfThreads) {
  const auto photos = photos_of_places(20, 5);
  RunContext one;
  one.num_threads = 1;
  const auto pairs = similar_photos(photos, 3, one);
  // Four photos a place: the three nearest of each are the others there, nearly always.
  const auto of_one_place = std::ranges::count_if(
      pairs, [](const PhotoPair& pair) { return pair.first % 5 == pair.second % 5; });
  EXPECT_GE(of_one_place, 28);
  EXPECT_LE(pairs.size(), 34U);
  RunContext three;
  three.num_threads = 3;
  EXPECT_EQ(similar_photos(photos, 3, three), pairs);
}

TEST(SimilarPhotos, PhotosWithoutKeypointsHaveNone) {
  auto photos = photos_of_places(8, 2);
  photos[2] = {};
  for (const PhotoPair& pair : similar_photos(photos, 2, {})) {
    EXPECT_NE(pair.first, 2U);
    EXPECT_NE(pair.second, 2U);
  }
  EXPECT_TRUE(similar_photos(std::vector<FeatureSet>(4), 2, {}).empty());
}

}  // namespace
}  // namespace hybridfusion
