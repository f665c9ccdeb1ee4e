#include "json_file.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace hybridfusion {

Expected<nlohmann::json> read_json_object(const std::filesystem::path& path) {
  constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;
  HF_TRY(const std::string content, read_text_file(path, kMaxBytes));
  // Deep nesting would exhaust the stack when the tree is destroyed.
  constexpr int kMaxDepth = 100;
  bool too_deep = false;
  const auto limit_depth = [&too_deep](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    too_deep = too_deep || depth > kMaxDepth;
    return !too_deep;
  };
  nlohmann::json root = nlohmann::json::parse(content, limit_depth, /*allow_exceptions=*/false);
  if (too_deep || !root.is_object()) {
    return fail(
        ErrorCode::kParse,
        fmt::format("{}: not a JSON object; check that the file is complete", path.string()));
  }
  return root;
}

std::optional<double> json_number(const nlohmann::json& object, std::string_view key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  const auto value = found->get<double>();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Expected<Rigid3> json_rigid(const std::filesystem::path& path,
                            const nlohmann::json& object,
                            std::string_view key) {
  const auto bad = [&](std::string_view cause) {
    return fail(
        ErrorCode::kParse,
        fmt::format(
            "{}: '{}' {}; give the 16 numbers of a rigid motion, row-major, last row 0 0 0 1",
            path.string(),
            key,
            cause));
  };
  const auto found = object.find(key);
  if (found == object.end()) {
    return fail(ErrorCode::kNotFound,
                fmt::format("{}: there is no '{}'; add {{\"{}\": [16 numbers, row-major]}}",
                            path.string(),
                            key,
                            key));
  }
  if (!found->is_array() || found->size() != 16) return bad("is not a list of 16 numbers");
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i) {
    const nlohmann::json& entry = (*found)[static_cast<std::size_t>(i)];
    if (!entry.is_number()) return bad("is not a list of 16 numbers");
    matrix(i / 4, i % 4) = entry.get<double>();
  }
  constexpr double kTolerance = 1e-3;
  if (!matrix.allFinite()) return bad("is not finite");
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  if (rotation.determinant() <= 0.0 || !(rotation * rotation.transpose()).isIdentity(kTolerance) ||
      !matrix.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), kTolerance)) {
    return bad("is not a rotation and a translation");
  }
  return Rigid3::from_matrix(matrix);
}

}  // namespace hybridfusion
