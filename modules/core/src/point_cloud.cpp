#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Calls `visitor(a.channel, b.channel)` for each optional channel: the one place that lists them.
template <class A, class B, class Visitor>
void visit_channels(A& a, B& b, Visitor&& visitor) {
  visitor(a.normals, b.normals);
  visitor(a.colors, b.colors);
  visitor(a.intensities, b.intensities);
  visitor(a.times_s, b.times_s);
  visitor(a.sigmas_m, b.sigmas_m);
  visitor(a.confidences, b.confidences);
  visitor(a.sources, b.sources);
}

}  // namespace

Expected<void> validate(const PointCloud& cloud) {
  Expected<void> result;
  visit_channels(cloud, cloud, [&](const auto& channel, const auto&) {
    if (!channel.empty() && channel.size() != cloud.size()) {
      result = fail(
          ErrorCode::kInsufficient,
          fmt::format(
              "a channel of the cloud has {} values for {} points", channel.size(), cloud.size()));
    }
  });
  return result;
}

PointCloud select(const PointCloud& cloud, const std::vector<std::size_t>& indices) {
  const auto gather = [&indices](auto& out, const auto& in) {
    if (in.empty()) return;
    out.reserve(indices.size());
    for (const std::size_t i : indices) out.push_back(in[i]);
  };
  PointCloud result;
  gather(result.points, cloud.points);
  visit_channels(result, cloud, gather);
  return result;
}

void keep_flagged(PointCloud& cloud, const std::vector<char>& is_kept) {
  HF_CHECK(is_kept.size() == cloud.size());
  const auto compact = [&is_kept](auto& channel, const auto&) {
    if (channel.empty()) return;
    std::size_t count = 0;
    for (std::size_t i = 0; i < is_kept.size(); ++i) {
      if (is_kept[i] != 0) channel[count++] = channel[i];
    }
    channel.resize(count);
  };
  visit_channels(cloud, cloud, compact);
  compact(cloud.points, cloud.points);
}

PointCloud concatenate(PointCloud a, const PointCloud& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  visit_channels(a, b, [](auto& channel, const auto& tail) {
    if (channel.empty() || tail.empty()) {
      channel.clear();
    } else {
      channel.insert(channel.end(), tail.begin(), tail.end());
    }
  });
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  return a;
}

PointCloud transformed(const Sim3& target_from_source, PointCloud cloud) {
  for (Eigen::Vector3f& p : cloud.points) {
    p = (target_from_source * Eigen::Vector3d(p.cast<double>())).cast<float>();
  }
  const Eigen::Quaternionf rotation = target_from_source.rotation.cast<float>();
  for (Eigen::Vector3f& n : cloud.normals) n = rotation * n;
  for (float& sigma : cloud.sigmas_m) sigma *= static_cast<float>(target_from_source.scale);
  return cloud;
}

PointCloud transformed(const Rigid3& target_from_source, PointCloud cloud) {
  return transformed(
      Sim3{.rotation = target_from_source.rotation, .translation = target_from_source.translation},
      std::move(cloud));
}

std::size_t remove_non_finite(PointCloud& cloud) {
  std::vector<char> is_finite(cloud.size());
  std::ranges::transform(cloud.points, is_finite.begin(), [](const Eigen::Vector3f& p) {
    return static_cast<char>(p.allFinite());
  });
  const auto dropped = static_cast<std::size_t>(std::ranges::count(is_finite, 0));
  if (dropped > 0) keep_flagged(cloud, is_finite);
  return dropped;
}

}  // namespace hybridfusion
