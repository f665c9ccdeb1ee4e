#pragma once

#include <hybridfusion/core/random.hpp>

#include <string>

namespace hybridfusion::testing {

/// A damaged copy of `good`: cut, bits flipped, bytes overwritten with extremes, or a piece
/// repeated. The same for the same index.
[[nodiscard]] inline std::string mutated(const std::string& good, std::uint64_t index) {
  Random random(1, "mutations", index);
  std::string bytes = good;
  const auto position = [&] { return random.index(static_cast<std::uint32_t>(bytes.size())); };
  // Half of the damage goes to the start of the file, where formats keep their structure.
  const auto place = [&] {
    return random.uniform() < 0.5 ? position() : position() % 512 % bytes.size();
  };
  switch (random.index(4)) {
    case 0:
      bytes.resize(position());
      break;
    case 1:
      for (std::uint32_t i = random.index(16) + 1; i > 0; --i) {
        bytes[place()] ^= static_cast<char>(1U << random.index(8));
      }
      break;
    case 2: {
      const char value = random.uniform() < 0.5 ? '\xff' : '\0';
      const std::size_t first = place();
      for (std::size_t i = first; i < std::min(bytes.size(), first + 8); ++i) bytes[i] = value;
      break;
    }
    default:
      bytes.insert(place(), bytes.substr(position(), random.index(64) + 1));
      break;
  }
  return bytes;
}

}  // namespace hybridfusion::testing
