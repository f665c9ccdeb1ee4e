#include "xyz.hpp"

#include "cloud_rows.hpp"

#include <iterator>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// With a decimal point: whole numbers before the colour would look like one of its channels.
[[nodiscard]] std::string pointed(float value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_not_of("0123456789-") == std::string::npos) text += ".0";
  return text;
}

}  // namespace

Expected<PointCloud> read_xyz(const std::filesystem::path& path) {
  return build_cloud(path, read_xyz_rows);
}

Expected<XyzPieceWriter> XyzPieceWriter::create(const std::filesystem::path& path,
                                                const Eigen::Vector3d& offset_m,
                                                const Eigen::Vector3d& units_m) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  return XyzPieceWriter(std::move(file), offset_m, units_m);
}

void XyzPieceWriter::add(const PointCloud& piece) {
  HF_CHECK(validate(piece).has_value());
  std::string row;
  const auto out = std::back_inserter(row);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Eigen::Vector3f& at = piece.points[i];
    row.clear();
    if (offset_m_.isZero()) {
      fmt::format_to(out, "{} {} {}", at.x(), at.y(), at.z());
    } else {
      const Eigen::Vector3d placed = (at.cast<double>() + offset_m_).cwiseQuotient(units_m_);
      fmt::format_to(out, "{:.4f} {:.4f} {:.4f}", placed.x(), placed.y(), placed.z());
    }
    if (!piece.intensities.empty()) {
      if (piece.colors.empty()) {
        fmt::format_to(out, " {}", piece.intensities[i]);
      } else {
        fmt::format_to(out, " {}", pointed(piece.intensities[i]));
      }
    }
    if (!piece.colors.empty()) {
      const Rgb8& color = piece.colors[i];
      fmt::format_to(out, " {} {} {}", color[0], color[1], color[2]);
    }
    row += '\n';
    file_.write(row);
  }
}

Expected<void> XyzPieceWriter::commit() {
  return file_.commit();
}

Expected<void> write_xyz(const std::filesystem::path& path,
                         const PointCloud& cloud,
                         const Eigen::Vector3d& offset_m) {
  HF_TRY(XyzPieceWriter file, XyzPieceWriter::create(path, offset_m));
  file.add(cloud);
  return file.commit();
}

}  // namespace hybridfusion
