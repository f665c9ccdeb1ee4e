#pragma once

#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/geometry/normals.hpp>
#include <hybridfusion/registration/registration_options.hpp>

#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A LiDAR point with its plane.
struct FineSample {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  bool is_vertical = false;
  bool is_held_out = false;  ///< Judges the result, takes no part in it.
};

/// Planar LiDAR points that `start` brings into the box of `vision`: up to half of
/// `options.samples` vertical ones, the rest horizontal; every fifth is held out.
[[nodiscard]] std::vector<FineSample> draw_samples(std::span<const Eigen::Vector3f> vision,
                                                   std::span<const Eigen::Vector3f> lidar,
                                                   const Rigid3& start,
                                                   const FineOptions& options,
                                                   const RunContext& ctx);

/// Local planes of the vision cloud, computed where they are asked for.
class LazyPlanes {
 public:
  /// The neighbourhood doubles (at most twice) until half of a probe of the cloud is planar: thick
  /// clouds need wider planes.
  LazyPlanes(std::span<const Eigen::Vector3f> points,
             const FineOptions& options,
             const RunContext& ctx);

  /// Makes sure that at(i) is valid for every i in `wanted`.
  void prepare(std::vector<std::size_t> wanted, const RunContext& ctx);
  struct Plane {
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    float curvature = -1.0F;  ///< Negative: not computed yet.
  };
  [[nodiscard]] const Plane& at(std::size_t index) const { return planes_[index]; }
  [[nodiscard]] const KdTree& tree() const { return tree_; }

 private:
  void compute(std::span<const std::size_t> wanted, int neighbors, const RunContext& ctx);

  std::span<const Eigen::Vector3f> points_;
  KdTree tree_;
  std::vector<Plane> planes_;
  int neighbors_;
};

/// What all alignments of one pair near one pose share.
struct FineInputs {
  LazyPlanes planes;
  std::vector<FineSample> samples;
};
[[nodiscard]] FineInputs make_fine_inputs(std::span<const Eigen::Vector3f> vision,
                                          std::span<const Eigen::Vector3f> lidar,
                                          const Rigid3& start,
                                          const FineOptions& options,
                                          const RunContext& ctx);

}  // namespace hybridfusion
