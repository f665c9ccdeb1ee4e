#include "structure_level.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

constexpr double kDeg = 3.14159265358979323846 / 180.0;
// Wide enough for two rings of a scanner: one alone is a line, and the plane through it and the
// noise along its rays is the scanner's, not the world's.
constexpr double kFaceVoxel_m = 2.0;
constexpr float kMinAspect = 0.12F;
constexpr double kMaxWeight = 20.0;
// Faces of one wall or stretch of road share their lean: one piece a cell of this side counts.
constexpr double kPiece_m = 10.0;
// Walls lean by half a degree, streets slope by one to three (AASHTO: up to 5 % on local streets).
constexpr double kWallSigma_rad = 0.5 * kDeg;
constexpr double kGroundSigma_rad = 1.5 * kDeg;
// Slopes of one drive are alike: however long it is, the ground says no more than this.
constexpr double kGroundFloor_rad = 0.75 * kDeg;
constexpr double kLevelFloor_rad = 0.05 * kDeg;

struct Piece {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  // of its normals
  double weight = 0.0;
};
using Pieces = std::map<std::tuple<int, int, int>, Piece>;

void add_face(const MapFace& face, Pieces& pieces) {
  const Eigen::Vector3i cell = (face.center_m / kPiece_m).array().floor().cast<int>();
  Piece& piece = pieces[{cell.x(), cell.y(), cell.z()}];
  piece.spread += face.weight * face.normal * face.normal.transpose();
  piece.weight += face.weight;
}

bool is_line(const PlaneCluster& cluster) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(cluster.covariance, Eigen::EigenvaluesOnly);
  return !(solver.eigenvalues()[1] > kMinAspect * solver.eigenvalues()[2]);
}

double full_weight(const Piece& piece) {
  // A piece counts whole from this many points on.
  constexpr double kWhole = 200.0;
  return std::min(1.0, piece.weight / kWhole) / piece.weight;
}

/// One step: faces within `tolerance_rad` of upright or level pull the vertical towards them.
std::optional<StructureLevel> refined(std::span<const MapFace> faces,
                                      const Eigen::Vector3d& up,
                                      double tolerance_rad) {
  Pieces walls;
  Pieces grounds;
  for (const MapFace& face : faces) {
    const double cosine = std::abs(face.normal.dot(up));
    if (cosine < std::sin(tolerance_rad)) add_face(face, walls);
    if (cosine > std::cos(tolerance_rad)) add_face(face, grounds);
  }
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const auto& [cell, piece] : walls) {
    information += full_weight(piece) / (kWallSigma_rad * kWallSigma_rad) * piece.spread;
  }
  Eigen::Matrix3d by_ground = Eigen::Matrix3d::Zero();
  double num_grounds = 0.0;
  for (const auto& [cell, piece] : grounds) {
    const double share = full_weight(piece);
    by_ground += share * (piece.weight * Eigen::Matrix3d::Identity() - piece.spread);
    num_grounds += share * piece.weight;
  }
  if (num_grounds > 0.0) {
    const double variance = std::max(kGroundSigma_rad * kGroundSigma_rad / num_grounds,
                                     kGroundFloor_rad * kGroundFloor_rad);
    information += by_ground / num_grounds / variance;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(information);
  const Eigen::Vector3d& values = solver.eigenvalues();
  if (!(values[1] > 0.0)) return std::nullopt;
  StructureLevel level{.up_in_map = solver.eigenvectors().col(0)};
  if (level.up_in_map.dot(up) < 0.0) level.up_in_map = -level.up_in_map;
  level.sigma_rad = std::hypot(std::sqrt(1.0 / values[1] + 1.0 / values[2]), kLevelFloor_rad);
  return level;
}

/// The normal (or the guess) that most faces are upright or level to.
Eigen::Vector3d first_vertical(std::span<const MapFace> faces, const Eigen::Vector3d& about_up) {
  constexpr std::size_t kMaxCandidates = 60;
  constexpr double kFarthest = 0.7;  // cosine of 45 degrees
  constexpr double kTolerance_rad = 6.0 * kDeg;
  Eigen::Vector3d best = about_up;
  double best_score = -1.0;
  const std::size_t stride = faces.size() / kMaxCandidates + 1;
  const auto score_of = [&](const Eigen::Vector3d& up) {
    double score = 0.0;
    for (const MapFace& face : faces) {
      const double cosine = std::abs(face.normal.dot(up));
      if (cosine < std::sin(kTolerance_rad) || cosine > std::cos(kTolerance_rad)) {
        score += face.weight;
      }
    }
    return score;
  };
  best_score = score_of(best);
  for (std::size_t i = 0; i < faces.size(); i += stride) {
    Eigen::Vector3d up = faces[i].normal;
    if (up.dot(about_up) < 0.0) up = -up;
    if (up.dot(about_up) < kFarthest) continue;
    const double score = score_of(up);
    if (!(score > best_score)) continue;
    best_score = score;
    best = up;
  }
  return best;
}

}  // namespace

namespace {

/// Ground lies below every LiDAR; ceilings, where there are any, come with a floor.
bool ground_is_above(std::span<const MapFace> faces, const Eigen::Vector3d& up) {
  constexpr double kLevelCosine = 0.98;
  constexpr double kManyMore = 3.0;
  double above = 0.0;
  double below = 0.0;
  for (const MapFace& face : faces) {
    if (std::abs(face.normal.dot(up)) < kLevelCosine) continue;
    (face.from_lidar_m.dot(up) > 0.0 ? above : below) += face.weight;
  }
  return above > kManyMore * below;
}

}  // namespace

std::optional<StructureLevel> level_by_faces(std::span<const MapFace> faces,
                                             const Eigen::Vector3d& about_up) {
  if (faces.empty()) return std::nullopt;
  std::optional<StructureLevel> level{
      StructureLevel{.up_in_map = first_vertical(faces, about_up.normalized())}};
  for (const double tolerance_deg : {8.0, 5.0, 3.0, 3.0}) {
    level = refined(faces, level->up_in_map, tolerance_deg * kDeg);
    if (!level) return std::nullopt;
  }
  level->upside_down = ground_is_above(faces, level->up_in_map);
  return level;
}

Expected<std::optional<StructureLevel>> level_by_structure(const ScanStore& store,
                                                           const std::vector<Segment>& segments,
                                                           const Eigen::Vector3d& about_up_in_map,
                                                           const RunContext& ctx) {
  std::vector<MapFace> faces;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    const Rigid3& map_from_segment = store.scans()[segments[i].anchor].map_from_imu;
    const Eigen::Vector3d lidar_in_imu =
        store.scans()[segments[i].anchor].lidar_in_imu.cast<double>();
    HF_TRY(const std::vector<PlaneCluster> clusters,
           cluster_segment(store, segments[i], static_cast<std::uint32_t>(i), kFaceVoxel_m));
    for (const PlaneCluster& cluster : clusters) {
      const auto normal = normal_of(cluster);
      if (!normal || is_line(cluster)) continue;
      const Eigen::Vector3d mean = cluster.mean.cast<double>();
      faces.push_back({.normal = map_from_segment.rotation * *normal,
                       .center_m = map_from_segment * mean,
                       .weight = std::min<double>(cluster.count, kMaxWeight),
                       .from_lidar_m = map_from_segment.rotation * (mean - lidar_in_imu)});
    }
  }
  return level_by_faces(faces, about_up_in_map);
}

}  // namespace hybridfusion
