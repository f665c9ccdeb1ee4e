#include "cached_features.hpp"

#include "rendered_flight.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/vision/reconstruct.hpp>

#include <atomic>
#include <map>
#include <mutex>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

FeatureSet some_features(std::size_t count) {
  FeatureSet features;
  Random random(3, "test/features");
  for (std::size_t i = 0; i < count; ++i) {
    features.pixels.emplace_back(static_cast<float>(random.uniform(0, 1600)), 0.1F);
    features.colors.push_back({static_cast<std::uint8_t>(i), 2, 3});
    for (std::size_t k = 0; k < kDescriptorSize; ++k) {
      features.descriptors.push_back(static_cast<std::uint8_t>(random.index(256)));
    }
  }
  return features;
}

TEST(CachedFeatures, BytesComeBackAsTheyWere) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{57}}) {
    const FeatureSet features = some_features(count);
    const auto again = features_from_bytes(to_bytes(features));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->pixels, features.pixels);
    EXPECT_EQ(again->colors, features.colors);
    EXPECT_EQ(again->descriptors, features.descriptors);
  }
  const auto matches = matches_from_bytes(to_bytes(std::vector<Match>{{4, 7}, {5, 1}}));
  ASSERT_TRUE(matches);
  ASSERT_EQ(matches->size(), 2U);
  EXPECT_EQ((*matches)[1].first, 5U);
  EXPECT_EQ((*matches)[1].second, 1U);
}

TEST(CachedFeatures, DamagedBytesAreNotTaken) {
  const std::string bytes = to_bytes(some_features(20));
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{10}, std::size_t{24}, bytes.size() - 1}) {
    EXPECT_FALSE(features_from_bytes(std::string_view(bytes).substr(0, length))) << length;
  }
  for (const std::size_t at :
       {std::size_t{1}, std::size_t{9}, std::size_t{17}, bytes.size() / 2, bytes.size() - 1}) {
    std::string rotten = bytes;
    rotten[at] = static_cast<char>(rotten[at] ^ 4);
    EXPECT_FALSE(features_from_bytes(rotten)) << at;
  }
  EXPECT_FALSE(matches_from_bytes(bytes));  // of another kind
}

/// A cache in memory that counts.
struct MemoryCache {
  std::map<std::string, std::string> files = {};
  std::mutex mutex = {};
  std::atomic<int> found = 0;

  PhotoCache cache(std::size_t photos) {
    PhotoCache result;
    for (std::size_t i = 0; i < photos; ++i)
      result.keys.push_back("photo" + std::string(1, static_cast<char>('a' + i)));
    result.load = [this](const std::string& name) -> std::optional<std::string> {
      const std::scoped_lock lock(mutex);
      const auto file = files.find(name);
      if (file == files.end()) return std::nullopt;
      ++found;
      return file->second;
    };
    result.save = [this](const std::string& name, std::string_view bytes) {
      const std::scoped_lock lock(mutex);
      files[name] = bytes;
    };
    return result;
  }
};

TEST(CachedFeatures, ReconstructionFromTheCacheIsTheSameEvenWhenItIsDamaged) {
  testing::RenderedFlight flight = testing::fly();
  MemoryCache memory;
  const PhotoCache cache = memory.cache(flight.photos.size());
  const auto plain = reconstruct(flight.photos, {});
  const auto first = reconstruct(flight.photos, {}, {}, {}, &cache);
  ASSERT_TRUE(plain && first);
  EXPECT_EQ(memory.found, 0);
  ASSERT_GE(memory.files.size(), 6U + 15U);  // six photos, all pairs
  memory.files.begin()->second.resize(30);
  // Nothing but the damaged photo is decoded again.
  std::atomic<int> decoded = 0;
  for (Photo& photo : flight.photos) {
    photo.load = [load = photo.load, &decoded] {
      ++decoded;
      return load();
    };
  }
  const auto again = reconstruct(flight.photos, {}, {}, {}, &cache);
  ASSERT_TRUE(again);
  EXPECT_LE(decoded, 1);
  for (const auto* other : {&*first, &*again}) {
    ASSERT_EQ(other->points.size(), plain->points.size());
    for (std::size_t i = 0; i < plain->points.size(); ++i) {
      EXPECT_EQ(other->points[i].point_in_enu, plain->points[i].point_in_enu);
    }
  }
}

}  // namespace
}  // namespace hybridfusion
