#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/point_cloud.hpp>

#include <span>
#include <string>

#include <Eigen/Geometry>

namespace hybridfusion {

/// A parallel view: picture x to the right and y down in pixels, depth away from the viewer [m].
struct ParallelView {
  Eigen::Affine3d picture_from_world = Eigen::Affine3d::Identity();
  int width_px = 0;
  int height_px = 0;
};

/// From above, north up, so that `box` (x-y) fills the picture. @param width_px  of the picture
[[nodiscard]] ParallelView view_from_above(const Eigen::AlignedBox2d& box, int width_px);

/// From the side the camera comes from: `azimuth_rad` from north clockwise, `elevation_rad` above
/// the horizon; `box` fills the picture.
[[nodiscard]] ParallelView oblique_view(const Eigen::AlignedBox3d& box,
                                        double azimuth_rad,
                                        double elevation_rad,
                                        int width_px);

/// Draws points as small discs with a depth buffer; edges in depth are darkened (eye-dome lighting,
/// Boucheny 2009), so that shapes read without normals. No display or graphics card is needed.
class Splatter {
 public:
  explicit Splatter(const ParallelView& view);
  void add(const Eigen::Vector3f& point_in_world, const Rgb8& color, int radius_px);
  [[nodiscard]] Image8 image(Rgb8 background) const;

 private:
  ParallelView view_;
  std::vector<float> depth_m_;
  std::vector<Rgb8> color_;
};

/// The picture without the rows above and below what is drawn, a narrow margin left; an oblique
/// view of a flat scene is mostly air. Rows with a few stray points count as blank.
[[nodiscard]] Image8 without_blank_rows(Image8 image, Rgb8 background);

/// "data:image/jpeg;base64,...". @returns kIo when the picture cannot be encoded.
[[nodiscard]] Expected<std::string> data_uri(const Image8& image);
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace hybridfusion
