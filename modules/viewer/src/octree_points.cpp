#include "octree_points.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kSpillBuffer = 16384;

std::unexpected<Error> spill_failed() {
  return fail(ErrorCode::kIo,
              fmt::format("the octree of the viewer needs room on the disk ({}); free some",
                          std::strerror(errno)));
}

}  // namespace

int OctreeCube::octant_of(const Eigen::Vector3f& point) const {
  const Eigen::Vector3d middle = min_m.array() + 0.5 * side_m;
  // Potree's numbering: x is the highest bit.
  return (point.x() >= middle.x() ? 4 : 0) + (point.y() >= middle.y() ? 2 : 0) +
         (point.z() >= middle.z() ? 1 : 0);
}

OctreeCube OctreeCube::child(int octant) const {
  const double half_m = 0.5 * side_m;
  const Eigen::Vector3d shift((octant & 4) != 0 ? half_m : 0.0,
                              (octant & 2) != 0 ? half_m : 0.0,
                              (octant & 1) != 0 ? half_m : 0.0);
  return {.min_m = min_m + shift, .side_m = half_m};
}

CellGrid::CellGrid(const OctreeCube& cube, int cells_per_side)
    : cube_(cube),
      cells_(cells_per_side),
      taken_(static_cast<std::size_t>(cells_per_side) * cells_per_side * cells_per_side) {}

bool CellGrid::take(const Eigen::Vector3f& point) {
  const Eigen::Array3d relative =
      (point.cast<double>() - cube_.min_m).array() * (cells_ / cube_.side_m);
  const Eigen::Array3i cell = relative.floor().cast<int>().max(0).min(cells_ - 1);
  const auto index = (static_cast<std::size_t>(cell.z()) * cells_ + cell.y()) * cells_ + cell.x();
  if (taken_[index]) return false;
  taken_[index] = true;
  return true;
}

Expected<PointSpill> PointSpill::create(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor >= 0) return PointSpill({::fdopen(descriptor, "w+b"), Close{}});
  // Some file systems have no nameless files: take the name away at once.
  std::string name = (folder / "spill-XXXXXX").string();
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named < 0) return spill_failed();
  ::unlink(name.c_str());
  return PointSpill({::fdopen(named, "w+b"), Close{}});
}

Expected<void> PointSpill::add(const OctreePoint& point) {
  buffer_.push_back(point);
  ++size_;
  return buffer_.size() < kSpillBuffer ? Expected<void>() : flush();
}

Expected<void> PointSpill::flush() {
  const std::size_t count = buffer_.size();
  if (std::fwrite(buffer_.data(), sizeof(OctreePoint), count, file_.get()) != count) {
    return spill_failed();
  }
  buffer_.clear();
  return {};
}

Expected<void> PointSpill::for_each(
    const std::function<Expected<void>(const OctreePoint&)>& visit) {
  if (auto flushed = flush(); !flushed) return flushed;
  std::rewind(file_.get());
  std::vector<OctreePoint> batch(kSpillBuffer);
  for (std::size_t done = 0; done < size_;) {
    const std::size_t wanted = std::min(kSpillBuffer, size_ - done);
    if (std::fread(batch.data(), sizeof(OctreePoint), wanted, file_.get()) != wanted) {
      return spill_failed();
    }
    for (std::size_t i = 0; i < wanted; ++i) {
      if (auto visited = visit(batch[i]); !visited) return visited;
    }
    done += wanted;
  }
  return {};
}

}  // namespace hybridfusion
