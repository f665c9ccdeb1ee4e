#include "doctor_checks.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMaxDecodedPixels = 3e8;
// Measured on four flights: the least sharp good photo has 0.82 of the median, a focus blur of 1.5
// px leaves 0.1 to 0.45 of it, a motion blur of 9 px 0.24 to 0.73.
constexpr double kBlurredShare = 0.6;
constexpr double kBlackMean = 12.0;
constexpr double kWhiteMean = 245.0;

struct PixelState {
  bool decoded = false;
  bool damaged = false;
  double sharpness = 0.0;
  double mean = 0.0;
};

/// One channel; green of a colour image.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values = {};

  [[nodiscard]] float at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

Plane plane_of(const Image8& image) {
  Plane plane{.width = image.width, .height = image.height};
  const auto step = static_cast<std::size_t>(image.channels);
  plane.values.reserve(image.pixels.size() / step);
  for (std::size_t i = step / 2; i < image.pixels.size(); i += step) {
    plane.values.push_back(image.pixels[i]);
  }
  return plane;
}

Plane halved(const Plane& plane) {
  Plane half{.width = plane.width / 2, .height = plane.height / 2};
  half.values.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      half.values.push_back(0.25F * (plane.at(2 * x, 2 * y) + plane.at(2 * x + 1, 2 * y) +
                                     plane.at(2 * x, 2 * y + 1) + plane.at(2 * x + 1, 2 * y + 1)));
    }
  }
  return half;
}

/// Mean square of the Laplacian.
double detail_of(const Plane& plane) {
  double sum = 0.0;
  for (int y = 1; y + 1 < plane.height; ++y) {
    for (int x = 1; x + 1 < plane.width; ++x) {
      const double laplacian = 4.0 * plane.at(x, y) - plane.at(x - 1, y) - plane.at(x + 1, y) -
                               plane.at(x, y - 1) - plane.at(x, y + 1);
      sum += laplacian * laplacian;
    }
  }
  return sum / std::max(1.0, static_cast<double>(plane.width - 2) * (plane.height - 2));
}

PixelState state_of(const Photo& photo) {
  const auto image = photo.load();
  if (!image) return {.decoded = true, .damaged = true};
  double sum = 0.0;
  for (const std::uint8_t value : image->pixels) sum += value;
  return {.decoded = true,
          .sharpness = sharpness_of(*image),
          .mean = sum / std::max<double>(1.0, static_cast<double>(image->pixels.size()))};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void report(std::span<const Photo> photos,
            const std::vector<PixelState>& states,
            std::vector<std::string> unreadable,
            Diagnosis& diagnosis) {
  std::vector<double> sharpness;
  for (const PixelState& state : states) {
    if (state.decoded && !state.damaged) sharpness.push_back(state.sharpness);
  }
  const double typical = sharpness.empty() ? 0.0 : median(sharpness);
  std::vector<std::string> blurred;
  std::vector<std::string> exposure;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::string& name = photos[i].metadata.name;
    const PixelState& state = states[i];
    if (!state.decoded) continue;
    if (state.damaged) {
      unreadable.push_back(name);
    } else if (state.mean < kBlackMean || state.mean > kWhiteMean) {
      exposure.push_back(name);
    } else if (state.sharpness < kBlurredShare * typical) {
      blurred.push_back(name);
    }
  }
  const auto add = [&](std::string_view id, std::vector<std::string> names, std::string_view what) {
    if (names.empty()) return;
    auto cause = fmt::format("{} photos {}: {}", names.size(), what, listed(names));
    diagnosis.findings.add(id, std::move(cause), names);
  };
  add("photos.unreadable", std::move(unreadable), "cannot be read");
  add("photos.exposure", std::move(exposure), "are almost black or white");
  add("photos.blurred", std::move(blurred), "are blurred against the rest");
}

}  // namespace

double sharpness_of(const Image8& image) {
  const Plane half = halved(plane_of(image));
  const Plane eighth = halved(halved(half));
  return detail_of(half) / std::max(1e-9, detail_of(eighth));
}

Expected<void> check_pixels(const PhotoFolder& folder,
                            Diagnosis& diagnosis,
                            const RunContext& ctx) {
  const std::vector<Photo>& photos = folder.photos;
  double total_px = 0.0;
  for (const Photo& photo : photos) {
    total_px += static_cast<double>(photo.metadata.width) * photo.metadata.height;
  }
  const auto stride =
      static_cast<std::size_t>(std::max(1.0, std::ceil(total_px / kMaxDecodedPixels)));
  const std::size_t sampled = (photos.size() + stride - 1) / stride;
  std::vector<PixelState> states(photos.size());
  std::atomic<std::int64_t> done = 0;
  parallel_for(ctx, sampled, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !ctx.stopped(); ++i) {
      states[i * stride] = state_of(photos[i * stride]);
      ctx.report(
          {.stage = "doctor/photos", .done = ++done, .total = static_cast<std::int64_t>(sampled)});
    }
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while looking at the photos");
  diagnosis.facts.push_back(
      fmt::format("pixels of {} of {} photos looked at", sampled, photos.size()));
  std::vector<std::string> unreadable;
  for (const QuarantinedPhoto& photo : folder.quarantined) unreadable.push_back(photo.name);
  report(photos, states, std::move(unreadable), diagnosis);
  return {};
}

}  // namespace hybridfusion
