#include "plan_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace hybridfusion {
namespace {

constexpr int kDepth = 4;  // the coarsest cells hold 2^4 x 2^4 shifts
constexpr std::size_t kMaxPoints = 500;
constexpr double kYawStep_rad = std::numbers::pi / 180.0;
constexpr std::size_t kMaxVisits = 60'000;
constexpr std::uint8_t kOnWall = 4;
constexpr std::uint8_t kBesideWall = 2;

/// Agreement of a wall at each plan cell, and for each level its maximum over the 2^level x 2^level
/// cells that begin there: an upper bound for all their shifts.
class ScoreGrids {
 public:
  explicit ScoreGrids(const std::vector<Eigen::Vector2f>& walls) {
    Eigen::Vector2i low = Eigen::Vector2i::Constant(1 << 20);
    Eigen::Vector2i high = -low;
    for (const Eigen::Vector2f& wall : walls) {
      low = low.cwiseMin(cell_of(wall));
      high = high.cwiseMax(cell_of(wall));
    }
    constexpr int kMargin = (1 << kDepth) + 1;
    origin_ = low - Eigen::Vector2i::Constant(kMargin);
    size_ = high - low + Eigen::Vector2i::Constant(kMargin + 3);
    std::vector<std::uint8_t> grid(static_cast<std::size_t>(size_.x()) * size_.y(), 0);
    for (const Eigen::Vector2f& wall : walls) {
      const Eigen::Vector2i at = cell_of(wall) - origin_;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          std::uint8_t& value = grid[index(at + Eigen::Vector2i(dx, dy))];
          value = std::max(value, dx == 0 && dy == 0 ? kOnWall : kBesideWall);
        }
      }
    }
    levels_.push_back(std::move(grid));
    for (int level = 1; level <= kDepth; ++level) levels_.push_back(pooled(level));
  }

  static Eigen::Vector2i cell_of(const Eigen::Vector2f& p) {
    return (p / kPlanCell_m).array().floor().cast<int>();
  }

  [[nodiscard]] int value(int level, const Eigen::Vector2i& cell) const {
    const Eigen::Vector2i at = cell - origin_;
    if (at.x() < 0 || at.y() < 0 || at.x() >= size_.x() || at.y() >= size_.y()) return 0;
    return levels_[static_cast<std::size_t>(level)][index(at)];
  }

 private:
  [[nodiscard]] std::size_t index(const Eigen::Vector2i& at) const {
    return static_cast<std::size_t>(at.y()) * size_.x() + at.x();
  }

  [[nodiscard]] std::vector<std::uint8_t> pooled(int level) const {
    const std::vector<std::uint8_t>& finer = levels_.back();
    std::vector<std::uint8_t> out(finer.size());
    const int step = 1 << (level - 1);
    for (int y = 0; y < size_.y(); ++y) {
      for (int x = 0; x < size_.x(); ++x) {
        std::uint8_t best = 0;
        for (const int dy : {0, step}) {
          for (const int dx : {0, step}) {
            if (x + dx >= size_.x() || y + dy >= size_.y()) continue;
            best = std::max(best, finer[index({x + dx, y + dy})]);
          }
        }
        out[index({x, y})] = best;
      }
    }
    return out;
  }

  Eigen::Vector2i origin_ = Eigen::Vector2i::Zero();
  Eigen::Vector2i size_ = Eigen::Vector2i::Zero();
  std::vector<std::vector<std::uint8_t>> levels_ = {};
};

struct Node {
  int score = 0;
  int level = 0;
  int turn = 0;
  Eigen::Vector2i shift = Eigen::Vector2i::Zero();  // in plan cells
  std::size_t order = 0;                            // ties are broken by age

  bool operator<(const Node& other) const {
    return score != other.score ? score < other.score : order > other.order;
  }
};

/// The source's walls, turned, as plan cells.
std::vector<std::vector<Eigen::Vector2i>> turned_cells(const std::vector<Eigen::Vector2f>& walls,
                                                       const PlanWindow& window,
                                                       int num_turns) {
  const std::size_t stride = walls.size() / kMaxPoints + 1;
  std::vector<std::vector<Eigen::Vector2i>> turns;
  for (int turn = -num_turns; turn <= num_turns; ++turn) {
    const Eigen::Matrix2f rotation = Eigen::Rotation2Dd(window.centre.yaw_rad + turn * kYawStep_rad)
                                         .toRotationMatrix()
                                         .cast<float>();
    const Eigen::Vector2f shift = window.centre.shift_m.cast<float>();
    std::vector<Eigen::Vector2i>& cells = turns.emplace_back();
    for (std::size_t i = 0; i < walls.size(); i += stride) {
      cells.push_back(ScoreGrids::cell_of(rotation * walls[i] + shift));
    }
  }
  return turns;
}

}  // namespace

std::vector<PlanMatch> search_plan(const Submap& target,
                                   const Submap& source,
                                   const PlanWindow& window,
                                   double min_score,
                                   std::size_t max_matches) {
  std::vector<PlanMatch> matches;
  if (target.walls.empty() || source.walls.empty()) return matches;
  const ScoreGrids grids(target.walls);
  const int num_turns = static_cast<int>(std::ceil(window.yaw_rad / kYawStep_rad));
  const auto turns = turned_cells(source.walls, window, num_turns);
  const int reach = static_cast<int>(std::ceil(window.radius_m / kPlanCell_m));
  const double full = static_cast<double>(turns.front().size()) * kOnWall;
  std::priority_queue<Node> open;
  std::size_t order = 0;
  const auto push = [&](int level, int turn, const Eigen::Vector2i& shift) {
    int score = 0;
    for (const Eigen::Vector2i& cell : turns[static_cast<std::size_t>(turn + num_turns)]) {
      score += grids.value(level, cell + shift);
    }
    if (score < min_score * full) return;
    open.push({.score = score, .level = level, .turn = turn, .shift = shift, .order = order++});
  };
  for (int turn = -num_turns; turn <= num_turns; ++turn) {
    for (int y = -reach; y <= reach; y += 1 << kDepth) {
      for (int x = -reach; x <= reach; x += 1 << kDepth) push(kDepth, turn, {x, y});
    }
  }
  for (std::size_t visits = 0; !open.empty() && visits < kMaxVisits; ++visits) {
    const Node node = open.top();
    open.pop();
    if (node.level > 0) {
      const int half = 1 << (node.level - 1);
      for (const int dy : {0, half}) {
        for (const int dx : {0, half}) {
          const Eigen::Vector2i shift = node.shift + Eigen::Vector2i(dx, dy);
          if (shift.maxCoeff() <= reach) push(node.level - 1, node.turn, shift);
        }
      }
      continue;
    }
    const PlanMatch match{
        .pose = {.yaw_rad = window.centre.yaw_rad + node.turn * kYawStep_rad,
                 .shift_m = window.centre.shift_m + kPlanCell_m * node.shift.cast<double>()},
        .score = node.score / full};
    const bool fresh = std::ranges::none_of(matches, [&](const PlanMatch& other) {
      return (other.pose.shift_m - match.pose.shift_m).norm() < kPlanSeparation_m;
    });
    if (fresh) matches.push_back(match);
    if (matches.size() == max_matches) break;
  }
  return matches;
}

}  // namespace hybridfusion
