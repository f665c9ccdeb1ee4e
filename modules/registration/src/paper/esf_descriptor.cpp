#include <hybridfusion/core/random.hpp>
#include <hybridfusion/registration/esf_descriptor.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinPoints = 100;
constexpr int kBins = 64;
constexpr int kSide = 64;  // lattice of the line tracing, Wohlkinger and Vincze III
enum Space { kIn = 0, kOut = 1, kMixed = 2 };
constexpr int kD2 = 0;
constexpr int kRatio = 3;
constexpr int kD3 = 4;
constexpr int kA3 = 7;

/// Points in lattice units, the farthest from the mean on the sphere that fits the lattice.
std::vector<Eigen::Vector3d> fit_to_lattice(std::span<const Eigen::Vector3f> points) {
  std::vector<Eigen::Vector3d> fitted;
  fitted.reserve(points.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points) {
    if (!p.allFinite()) continue;
    fitted.emplace_back(p.cast<double>());
    mean += fitted.back();
  }
  mean /= static_cast<double>(std::max<std::size_t>(fitted.size(), 1));
  double radius = 0.0;
  for (Eigen::Vector3d& p : fitted) {
    p -= mean;
    radius = std::max(radius, p.norm());
  }
  // One lattice cell of margin on each side keeps every cell that is marked inside.
  const double scale = radius > 0.0 ? (0.5 * kSide - 1.5) / radius : 0.0;
  for (Eigen::Vector3d& p : fitted) p = scale * p + Eigen::Vector3d::Constant(0.5 * kSide);
  return fitted;
}

/// True when the points do not all lie on one line (or in one point).
bool spans_a_plane(std::span<const Eigen::Vector3d> points) {
  const Eigen::Vector3d centre = Eigen::Vector3d::Constant(0.5 * kSide);
  const auto distance = [&](const Eigen::Vector3d& p) { return (p - centre).squaredNorm(); };
  const Eigen::Vector3d axis = *std::ranges::max_element(points, {}, distance) - centre;
  const double length = axis.norm();
  if (!(length > 0.0)) return false;
  return std::ranges::any_of(points, [&](const Eigen::Vector3d& p) {
    return axis.cross(p - centre).norm() / length > 1e-3;  // lattice units, above float rounding
  });
}

class Lattice {
 public:
  explicit Lattice(std::span<const Eigen::Vector3d> points)
      : occupied_(static_cast<std::size_t>(kSide) * kSide * kSide, 0) {
    // A cell and its 26 neighbours, so that a sparsely sampled surface has no holes for the lines.
    for (const Eigen::Vector3d& p : points) {
      const Eigen::Vector3i c = p.cast<int>();
      for (int z = c.z() - 1; z <= c.z() + 1; ++z) {
        for (int y = c.y() - 1; y <= c.y() + 1; ++y) {
          for (int x = c.x() - 1; x <= c.x() + 1; ++x) occupied_[index(x, y, z)] = 1;
        }
      }
    }
  }

  /// Share of occupied cells on the way from `a` to `b`, in steps of one cell along the longest
  /// axis; the two end points themselves are occupied by definition and do not count.
  [[nodiscard]] double occupied_share(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    const Eigen::Vector3d way = b - a;
    const int steps = static_cast<int>(way.cwiseAbs().maxCoeff());
    if (steps < 2) return 1.0;
    const Eigen::Vector3d stride = way / steps;
    Eigen::Vector3d p = a;
    int hits = 0;
    for (int k = 1; k < steps; ++k) {
      p += stride;
      hits += occupied_[index(
          static_cast<int>(p.x()), static_cast<int>(p.y()), static_cast<int>(p.z()))];
    }
    return static_cast<double>(hits) / (steps - 1);
  }

 private:
  [[nodiscard]] static std::size_t index(int x, int y, int z) {
    return (static_cast<std::size_t>(z) * kSide + static_cast<std::size_t>(y)) * kSide +
           static_cast<std::size_t>(x);
  }
  std::vector<std::uint8_t> occupied_;
};

Space space_of(double occupied_share) {
  if (occupied_share >= 1.0) return kIn;
  return occupied_share <= 0.0 ? kOut : kMixed;
}

struct Value {
  double value;
  int histogram;  ///< Of its family and space.
};

/// The shape values of all triples, by family.
struct Samples {
  std::vector<Value> d2, ratio, d3, a3;
};

/// Angle at `b` between the rays to `a` and `c` [rad].
double angle_at(const Eigen::Vector3d& b, const Eigen::Vector3d& a, const Eigen::Vector3d& c) {
  return std::atan2((a - b).cross(c - b).norm(), (a - b).dot(c - b));
}

void add_triple(const std::array<Eigen::Vector3d, 3>& p, const Lattice& lattice, Samples& out) {
  std::array<Space, 3> spaces{};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d& a = p[static_cast<std::size_t>(k)];
    const Eigen::Vector3d& b = p[static_cast<std::size_t>((k + 1) % 3)];
    const double share = lattice.occupied_share(a, b);
    const Space space = space_of(share);
    spaces[static_cast<std::size_t>(k)] = space;
    out.d2.push_back({(b - a).norm(), kD2 + space});
    if (space == kMixed) out.ratio.push_back({share, kRatio});
  }
  const bool same = spaces[0] == spaces[1] && spaces[1] == spaces[2];
  const Space space = same ? spaces[0] : kMixed;
  out.d3.push_back({std::sqrt(0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm()), kD3 + space});
  out.a3.push_back({angle_at(p[1], p[0], p[2]), kA3 + space});
}

void add_family(const std::vector<Value>& values, double largest, EsfSignature& signature) {
  if (values.empty() || !(largest > 0.0)) return;
  const float weight = 0.25F / static_cast<float>(values.size());
  for (const Value& v : values) {
    const int bin = std::min(kBins - 1, static_cast<int>(v.value / largest * kBins));
    signature[static_cast<std::size_t>(v.histogram * kBins + bin)] += weight;
  }
}

double largest_of(const std::vector<Value>& values) {
  double largest = 0.0;
  for (const Value& v : values) largest = std::max(largest, v.value);
  return largest;
}

}  // namespace

Expected<EsfSignature> compute_esf(std::span<const Eigen::Vector3f> points,
                                   const EsfSampling& sampling) {
  HF_CHECK(sampling.samples > 0);
  const std::vector<Eigen::Vector3d> fitted = fit_to_lattice(points);
  if (fitted.size() < kMinPoints) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("a shape descriptor needs at least {} finite points, got {}",
                            kMinPoints,
                            fitted.size()));
  }
  if (!spans_a_plane(fitted)) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("the {} points of a patch lie on one line", fitted.size()));
  }
  const Lattice lattice(fitted);
  Random random(sampling.seed, "registration/esf");
  const auto count = static_cast<std::uint32_t>(fitted.size());
  Samples values;
  for (int s = 0; s < sampling.samples; ++s) {
    const std::array<std::uint32_t, 3> i{
        random.index(count), random.index(count), random.index(count)};
    if (i[0] == i[1] || i[1] == i[2] || i[0] == i[2]) continue;
    add_triple({fitted[i[0]], fitted[i[1]], fitted[i[2]]}, lattice, values);
  }
  EsfSignature signature{};
  add_family(values.d2, largest_of(values.d2), signature);
  add_family(values.ratio, 1.0, signature);
  add_family(values.d3, largest_of(values.d3), signature);
  add_family(values.a3, std::numbers::pi, signature);
  return signature;
}

CentredSignature centre_signature(const EsfSignature& signature) {
  double mean = 0.0;
  for (const float v : signature) mean += static_cast<double>(v);
  mean /= static_cast<double>(signature.size());
  CentredSignature centred;
  double squares = 0.0;
  for (std::size_t i = 0; i < signature.size(); ++i) {
    centred.values[i] = static_cast<float>(static_cast<double>(signature[i]) - mean);
    squares += static_cast<double>(centred.values[i]) * static_cast<double>(centred.values[i]);
  }
  // What rounding leaves of a constant is no shape.
  const double rounding = 1e-6 * std::abs(mean) * std::sqrt(static_cast<double>(signature.size()));
  centred.norm = std::sqrt(squares) > rounding ? std::sqrt(squares) : 0.0;
  return centred;
}

double pearson_correlation(const CentredSignature& x, const CentredSignature& y) {
  const double norm = x.norm * y.norm;
  if (!(norm > 0.0)) return 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    sum += static_cast<double>(x.values[i]) * static_cast<double>(y.values[i]);
  }
  return std::clamp(sum / norm, -1.0, 1.0);
}

}  // namespace hybridfusion
