#pragma once

#include "pair_scene.hpp"

#include <hybridfusion/core/random.hpp>

namespace hybridfusion::benchmark {

/// LiDAR within `radius_m` of one place of the drive.
void crop(SceneClouds& clouds, double radius_m, Random& random);
/// Cuts the vision cloud back to what the LiDAR cannot have seen.
void separate(PointCloud& vision, const PointCloud& lidar);
/// Adds the cloud turned by 180 degrees about the vertical through the origin: two headings fit
/// equally well.
void make_symmetric(PointCloud& cloud);
void thin(PointCloud& cloud, int keep_every);
/// Moves every LiDAR point by what an odometry with this drift would have gathered by then: a
/// slow turn of heading and a shift along one direction.
void add_drift(SceneClouds& clouds, double drift, Random& random);
/// A bend that an odometry leaves: smooth over some 200 m of way.
void add_wander(SceneClouds& clouds, double size_m, Random& random);
/// Doming and block deformation: a few centimetres over a hundred metres.
void bend(PointCloud& cloud, Random& random);
/// Dark asphalt and deep shadow: discs in which stereo finds no ground.
void drop_dark_ground(PointCloud& cloud, Random& random);
/// What cars that drove along leave in a LiDAR map: smeared boxes beside the way.
void add_moving_cars(SceneClouds& clouds, Random& random);

}  // namespace hybridfusion::benchmark
