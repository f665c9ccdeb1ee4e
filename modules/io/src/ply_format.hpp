#pragma once

#include "input_file.hpp"
#include "scalar_type.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

struct PlyProperty {
  std::string name = {};
  ScalarType type = ScalarType::kFloat32;
  std::optional<ScalarType> count_type = {};  ///< Present: a list with counts of this type.
};

struct PlyElement {
  std::string name = {};
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties = {};
};

enum class PlyEncoding : std::uint8_t { kAscii, kLittleEndian, kBigEndian };

/// Reads the elements of a PLY file one after the other, row by row.
class PlyReader {
 public:
  /// Reads the header and checks the declared counts against the size of the file.
  [[nodiscard]] static Expected<PlyReader> open(const std::filesystem::path& path);

  [[nodiscard]] const std::vector<PlyElement>& elements() const { return elements_; }
  [[nodiscard]] const InputFile& file() const { return file_; }

  /// Reads the next row of `element` (elements must be read in order, completely).
  /// @param scalars  One value per property; for a list its length.
  /// @param lists    One per property, empty for scalars.
  [[nodiscard]] Expected<void> read_row(const PlyElement& element,
                                        std::vector<double>& scalars,
                                        std::vector<std::vector<double>>& lists);
  /// Reads past a whole element.
  [[nodiscard]] Expected<void> skip(const PlyElement& element);

 private:
  explicit PlyReader(InputFile file) : file_(std::move(file)) {}
  [[nodiscard]] Expected<void> read_header();
  [[nodiscard]] Expected<void> parse_header_line(std::string_view line);
  [[nodiscard]] Expected<void> check_counts() const;
  [[nodiscard]] Expected<double> read_value(ScalarType type);
  [[nodiscard]] Expected<void> read_list(const PlyProperty& property, std::vector<double>& values);

  InputFile file_;
  std::vector<PlyElement> elements_ = {};
  std::optional<PlyEncoding> encoding_ = {};
};

}  // namespace hybridfusion
