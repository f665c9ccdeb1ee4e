#include "cached_features.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <type_traits>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kFeatureMark = 0x3154414546464848ULL;
constexpr std::uint64_t kMatchMark = 0x315443544d464848ULL;

/// FNV-1a over words: tells a torn or rotten file, not an attack.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  std::size_t i = 0;
  for (; i + sizeof(std::uint64_t) <= bytes.size(); i += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, sizeof word);
    hash = (hash ^ word) * 0x100000001b3ULL;
    hash ^= hash >> 29U;
  }
  for (; i < bytes.size(); ++i) {
    hash = (hash ^ static_cast<unsigned char>(bytes[i])) * 0x100000001b3ULL;
  }
  return hash;
}

/// Mark, checksum of what follows, number of elements.
struct Header {
  std::uint64_t mark = 0;
  std::uint64_t sum = 0;
  std::uint64_t count = 0;
};

template <class T>
void append(std::string& bytes, std::span<const T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

std::string with_header(std::uint64_t mark, std::size_t count, std::string_view payload) {
  const Header header{.mark = mark, .sum = checksum(payload), .count = count};
  std::string bytes(sizeof header, '\0');
  std::memcpy(bytes.data(), &header, sizeof header);
  bytes.append(payload);
  return bytes;
}

/// The payload when it is whole and has `element_size` bytes an element.
std::optional<std::string_view> payload_of(std::string_view bytes,
                                           std::uint64_t mark,
                                           std::size_t element_size) {
  Header header;
  if (bytes.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  const std::string_view payload = bytes.substr(sizeof header);
  if (header.mark != mark || payload.size() % element_size != 0 ||
      payload.size() / element_size != header.count || checksum(payload) != header.sum) {
    return std::nullopt;
  }
  return payload;
}

template <class T>
void take(std::string_view& payload, std::size_t count, std::vector<T>& values) {
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, payload.data() + i * sizeof(T), sizeof(T));
    values.push_back(value);
  }
  payload.remove_prefix(count * sizeof(T));
}

constexpr std::size_t kFeatureBytes = 2 * sizeof(float) + sizeof(Rgb8) + kDescriptorSize;

const std::string* key_of(const PhotoCache* cache, std::size_t index) {
  if (cache == nullptr || index >= cache->keys.size() || cache->keys[index].empty()) return nullptr;
  return &cache->keys[index];
}

Expected<FeatureSet> computed_features(const Photo& photo, const FeatureOptions& options) {
  HF_TRY(const Image8 image, photo.load());
  if (image.width != photo.metadata.width || image.height != photo.metadata.height) {
    return fail(ErrorCode::kParse,
                fmt::format("decoded to {} x {} px, but its header says {} x {}",
                            image.width,
                            image.height,
                            photo.metadata.width,
                            photo.metadata.height));
  }
  return extract_features(image, options);
}

}  // namespace

std::string to_bytes(const FeatureSet& features) {
  std::string payload;
  payload.reserve(features.size() * kFeatureBytes);
  for (const Eigen::Vector2f& pixel : features.pixels) {
    append<float>(payload, {pixel.data(), 2});
  }
  append<Rgb8>(payload, features.colors);
  append<std::uint8_t>(payload, features.descriptors);
  return with_header(kFeatureMark, features.size(), payload);
}

std::optional<FeatureSet> features_from_bytes(std::string_view bytes) {
  auto payload = payload_of(bytes, kFeatureMark, kFeatureBytes);
  if (!payload) return std::nullopt;
  const std::size_t count = payload->size() / kFeatureBytes;
  FeatureSet features;
  std::vector<float> coordinates;
  take(*payload, 2 * count, coordinates);
  for (std::size_t i = 0; i < count; ++i) {
    features.pixels.emplace_back(coordinates[2 * i], coordinates[2 * i + 1]);
  }
  take(*payload, count, features.colors);
  take(*payload, count * kDescriptorSize, features.descriptors);
  return features;
}

std::string to_bytes(const std::vector<Match>& matches) {
  std::string payload;
  append<Match>(payload, matches);
  return with_header(kMatchMark, matches.size(), payload);
}

std::optional<std::vector<Match>> matches_from_bytes(std::string_view bytes) {
  auto payload = payload_of(bytes, kMatchMark, sizeof(Match));
  if (!payload) return std::nullopt;
  std::vector<Match> matches;
  take(*payload, payload->size() / sizeof(Match), matches);
  return matches;
}

Expected<FeatureSet> photo_features(const Photo& photo,
                                    std::size_t index,
                                    const FeatureOptions& options,
                                    const PhotoCache* cache) {
  const std::string* key = key_of(cache, index);
  if (key == nullptr) return computed_features(photo, options);
  std::string name = *key;
  name += ".features";
  if (const auto bytes = cache->load(name)) {
    if (auto features = features_from_bytes(*bytes)) return *std::move(features);
  }
  HF_TRY(FeatureSet features, computed_features(photo, options));
  cache->save(name, to_bytes(features));
  return features;
}

std::vector<Match> photo_matches(const FeatureSet& first,
                                 const FeatureSet& second,
                                 std::size_t first_index,
                                 std::size_t second_index,
                                 double ratio,
                                 const PhotoCache* cache) {
  const std::string* a = key_of(cache, first_index);
  const std::string* b = key_of(cache, second_index);
  if (a == nullptr || b == nullptr) return match_features(first, second, ratio);
  std::string name = *a;
  name.append("-").append(*b).append(".matches");
  if (const auto bytes = cache->load(name)) {
    auto matches = matches_from_bytes(*bytes);
    const bool fits = matches && std::ranges::all_of(*matches, [&](const Match& match) {
                        return match.first < first.size() && match.second < second.size();
                      });
    if (fits) return *std::move(matches);
  }
  std::vector<Match> matches = match_features(first, second, ratio);
  cache->save(name, to_bytes(matches));
  return matches;
}

}  // namespace hybridfusion
