#pragma once

#include "octree_points.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// Writes the three files of a Potree 2.0 octree.
class OctreeOutput {
 public:
  [[nodiscard]] static Expected<OctreeOutput> create(const std::filesystem::path& folder,
                                                     const OctreeCube& root,
                                                     const OctreeAttributes& attributes,
                                                     const OctreeOptions& options);

  /// Appends a node's points; nodes may come in any order. @returns its index for set_child().
  [[nodiscard]] std::size_t add_node(std::span<const OctreePoint> points, int depth);
  void set_child(std::size_t parent, int octant, std::size_t child);

  /// @param root  Index of the root node. Writes hierarchy and metadata and makes all visible.
  [[nodiscard]] Expected<OctreeSummary> finish(std::size_t root);

 private:
  struct Node {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    std::uint32_t count = 0;
    std::array<std::optional<std::size_t>, 8> children = {};
  };
  OctreeOutput(AtomicFile file, std::filesystem::path folder)
      : file_(std::move(file)), folder_(std::move(folder)) {}
  void append(const OctreePoint& point, std::string& bytes);
  [[nodiscard]] std::string hierarchy(std::size_t root) const;
  [[nodiscard]] std::string metadata() const;

  AtomicFile file_;
  std::filesystem::path folder_;
  OctreeCube cube_ = {};
  OctreeAttributes attributes_ = {};
  OctreeOptions options_ = {};
  OctreeSummary summary_ = {};
  std::uint64_t written_ = 0;
  std::vector<Node> nodes_ = {};
};

}  // namespace hybridfusion
