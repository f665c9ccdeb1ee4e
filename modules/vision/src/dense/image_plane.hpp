#pragma once

#include <cstddef>
#include <vector>

namespace hybridfusion {

/// One value a pixel, rows from the top.
template <class T>
struct ImagePlane {
  int width = 0;
  int height = 0;
  std::vector<T> values = {};

  ImagePlane() = default;
  ImagePlane(int w, int h, T value = {})
      : width(w),
        height(h),
        values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}

  [[nodiscard]] std::size_t offset(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] T& at(int x, int y) { return values[offset(x, y)]; }
  [[nodiscard]] const T& at(int x, int y) const { return values[offset(x, y)]; }
  [[nodiscard]] T* row(int y) { return values.data() + offset(0, y); }
  [[nodiscard]] const T* row(int y) const { return values.data() + offset(0, y); }
  [[nodiscard]] bool contains(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height;
  }
};

}  // namespace hybridfusion
