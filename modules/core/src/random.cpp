#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

/// SplitMix64 (Steele et al. 2014): spreads nearby seeds over the whole state space.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

}  // namespace

Random::Random(std::uint64_t seed, std::string_view stream, std::uint64_t index)
    : state_(mix(seed ^ mix(index))), increment_(mix(fnv1a(stream)) | 1U) {
  (void)next_u32();
}

std::uint32_t Random::next_u32() {
  const std::uint64_t old = state_;
  state_ = old * 6364136223846793005ULL + increment_;
  const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
  const auto rotation = static_cast<std::uint32_t>(old >> 59U);
  return (shifted >> rotation) | (shifted << ((32U - rotation) & 31U));
}

double Random::uniform() {
  const std::uint64_t high = next_u32();
  return static_cast<double>(((high << 32U) | next_u32()) >> 11U) * 0x1.0p-53;
}

std::uint32_t Random::index(std::uint32_t count) {
  HF_CHECK(count > 0);
  return static_cast<std::uint32_t>((std::uint64_t{next_u32()} * count) >> 32U);
}

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_normal_;
  }
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  const double angle = 2.0 * std::numbers::pi * uniform();
  spare_normal_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

}  // namespace hybridfusion
