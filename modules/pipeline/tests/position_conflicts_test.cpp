#include "position_conflicts.hpp"

#include "position_sources.hpp"
#include "test_files.hpp"

#include <hybridfusion/core/geodetic.hpp>

#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;
using testing::TempFolder;

constexpr GeodeticOrigin kSite = {.latitude_deg = 48.15, .longitude_deg = 11.57, .altitude_m = 520};
constexpr GeodeticOrigin kBoston = {
    .latitude_deg = 42.36, .longitude_deg = -71.06, .altitude_m = 30};

/// Eight photos, 20 m apart in two strips, 65 m above the ground.
PhotoFolder flight_at(const GeodeticOrigin& site) {
  PhotoFolder folder{.folder = "flight"};
  for (int i = 0; i < 8; ++i) {
    const GeodeticPosition at =
        geodetic_from_enu(site, {20.0 * (i % 4), 20.0 * (i / 4), 65.0 + 0.1 * i});
    Photo photo;
    photo.metadata.name = fmt::format("IMG_{}.JPG", i);
    photo.metadata.width = 1600;
    photo.metadata.height = 1200;
    photo.metadata.latitude_deg = at.latitude_deg;
    photo.metadata.longitude_deg = at.longitude_deg;
    photo.metadata.altitude_m = at.altitude_m;
    photo.metadata.gps_horizontal_error_m = 1.5;
    folder.photos.push_back(photo);
  }
  return folder;
}

struct Row {
  std::string name;
  GeodeticPosition at;
};

std::vector<Row> rows_of(const PhotoFolder& folder) {
  std::vector<Row> rows;
  for (const Photo& photo : folder.photos) {
    rows.push_back({photo.metadata.name,
                    {*photo.metadata.latitude_deg,
                     *photo.metadata.longitude_deg,
                     *photo.metadata.altitude_m}});
  }
  return rows;
}

class Conflicts : public ::testing::Test {
 protected:
  /// What is said of that geo.txt: the refusal, or the warnings after "warned: ".
  std::string of_tags(PhotoFolder folder,
                      const std::string& system,
                      const std::function<std::string(const GeodeticPosition&)>& columns) {
    std::string text = system + "\n";
    for (const Row& row : rows_of(folder)) text += row.name + " " + columns(row.at) + "\n";
    return said({.images = "flight", .geo_tags = files_.file("geo.txt", text)}, std::move(folder));
  }

  std::string of_control(PhotoFolder folder, const std::string& text) {
    return said({.images = "flight", .control = files_.file("gcp_list.txt", text)},
                std::move(folder));
  }

  static std::string said(const PhotoInputs& inputs, PhotoFolder folder) {
    const auto sources = take_positions(inputs, folder);
    if (!sources) return "refused: " + sources.error().message;
    const auto lines = judged_positions(*sources, {});
    if (!lines) return "refused: " + lines.error().message;
    std::string text = "taken";
    for (const std::string& line : *lines) text += "; " + line;
    return text;
  }

  TempFolder files_ = {};
};

std::string lon_lat(const GeodeticPosition& p) {
  return fmt::format("{:.9f} {:.9f} {:.3f}", p.longitude_deg, p.latitude_deg, p.altitude_m);
}

TEST_F(Conflicts, ARightFileIsTakenWithoutAWord) {
  EXPECT_EQ(of_tags(flight_at(kSite), "EPSG:4326", lon_lat), "taken");
}

TEST_F(Conflicts, EachWrongFileIsRefusedWithItsCause) {
  struct Case {
    const char* what;
    const char* system;
    std::function<std::string(const GeodeticPosition&)> columns;
    const char* cause;
  };
  const std::vector<Case> cases = {
      {"axes swapped",
       "EPSG:4326",
       [](const auto& p) {
         return fmt::format("{:.9f} {:.9f} {:.3f}", p.latitude_deg, p.longitude_deg, p.altitude_m);
       },
       "latitude and longitude swapped"},
      {"west for east",
       "EPSG:4326",
       [](const auto& p) {
         return fmt::format("{:.9f} {:.9f} {:.3f}", -p.longitude_deg, p.latitude_deg, p.altitude_m);
       },
       "sign of the longitude"},
      {"south for north",
       "EPSG:4326",
       [](const auto& p) {
         return fmt::format("{:.9f} {:.9f} {:.3f}", p.longitude_deg, -p.latitude_deg, p.altitude_m);
       },
       "sign of the latitude"},
      {"degrees under a code", "EPSG:32632", lon_lat, "look like degrees"},
      {"degrees under a zone", "WGS84 UTM 32N", lon_lat, "look like degrees"},
      {"degrees under a projection",
       "+proj=utm +zone=32 +datum=WGS84 +units=m",
       lon_lat,
       "degrees"},
      {"metres under degrees",
       "EPSG:4326",
       [](const auto& p) { return fmt::format("691234.5 5336789.1 {:.3f}", p.altitude_m); },
       "look like metres"},
      {"a place 60 m off",
       "EPSG:4326",
       [](const auto& p) {
         return lon_lat({p.latitude_deg + 60.0 / 111200.0, p.longitude_deg, p.altitude_m});
       },
       "60.0 m apart"},
      {"heights in feet",
       "EPSG:4326",
       [](const auto& p) {
         return lon_lat({p.latitude_deg, p.longitude_deg, p.altitude_m / 0.3048});
       },
       "heights look like feet"}};
  for (const Case& each : cases) {
    const std::string said = of_tags(flight_at(kSite), each.system, each.columns);
    EXPECT_THAT(said, ::testing::StartsWith("refused: ")) << each.what;
    EXPECT_THAT(said, HasSubstr(each.cause)) << each.what;
  }
}

TEST_F(Conflicts, TheZoneThatFitsIsNamed) {
  // The zone's own easting and northing of a place on its central meridian, under another zone.
  const GeodeticOrigin on_meridian = {
      .latitude_deg = 45.1534, .longitude_deg = 9.0, .altitude_m = 200};
  const PhotoFolder folder = flight_at(on_meridian);
  const auto columns = [&](const GeodeticPosition& p) {
    const Eigen::Vector3d enu = enu_from_geodetic(on_meridian, p);
    return fmt::format(
        "{:.3f} {:.3f} {:.3f}", 500000.0 + enu.x(), 4999990.0 + enu.y(), p.altitude_m);
  };
  EXPECT_THAT(of_tags(folder, "EPSG:32632", columns), HasSubstr("taken"));
  for (const char* system : {"EPSG:32633", "WGS84 UTM 31N", "EPSG:25833"}) {
    const std::string said = of_tags(folder, system, columns);
    EXPECT_THAT(said, ::testing::StartsWith("refused: ")) << system;
    EXPECT_THAT(said, HasSubstr("fit UTM zone 32N")) << said;
  }
  const auto northing_first = [&](const GeodeticPosition& p) {
    const Eigen::Vector3d enu = enu_from_geodetic(on_meridian, p);
    return fmt::format(
        "{:.3f} {:.3f} {:.3f}", 4999990.0 + enu.y(), 500000.0 + enu.x(), p.altitude_m);
  };
  EXPECT_THAT(of_tags(folder, "EPSG:32632", northing_first),
              HasSubstr("easting and northing swapped"));
}

TEST_F(Conflicts, HeightsAboveSeaLevelAreToldAndTaken) {
  const std::string said = of_tags(flight_at(kSite), "EPSG:4326", [](const auto& p) {
    return lon_lat({p.latitude_deg, p.longitude_deg, p.altitude_m - 46.0});
  });
  EXPECT_THAT(said, ::testing::StartsWith("taken; "));
  EXPECT_THAT(said, HasSubstr("539.4 m"));
  EXPECT_THAT(said, HasSubstr("585"));
}

TEST_F(Conflicts, OneRowThatIsOffIsAWarning) {
  int row = 0;
  const std::string said = of_tags(flight_at(kSite), "EPSG:4326", [&](const auto& p) {
    return lon_lat(
        {p.latitude_deg + (row++ == 2 ? 40.0 / 111200.0 : 0.0), p.longitude_deg, p.altitude_m});
  });
  EXPECT_THAT(said, ::testing::StartsWith("taken; "));
  EXPECT_THAT(said, HasSubstr("IMG_2.JPG"));
}

TEST_F(Conflicts, WhereThePhotosKnowNothingTheExtentStillShowsDegreesInMetres) {
  PhotoFolder folder = flight_at(kSite);
  const auto rows = rows_of(folder);
  for (Photo& photo : folder.photos) {
    photo.metadata.latitude_deg.reset();
    photo.metadata.longitude_deg.reset();
  }
  std::string degrees = "+proj=utm +zone=32 +datum=WGS84\n";
  std::string wide = "EPSG:4326\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    degrees += rows[i].name + " " + lon_lat(rows[i].at) + "\n";
    wide += fmt::format("{} {} {} 100\n", rows[i].name, 10.0 + 9.0 * static_cast<double>(i), 48.0);
  }
  EXPECT_THAT(said({.images = "flight", .geo_tags = files_.file("a.txt", degrees)}, folder),
              HasSubstr("look like degrees"));
  std::string one = "EPSG:4326\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    one +=
        fmt::format("{} {:.11f} 48.0 100\n", rows[i].name, 11.0 + 1e-10 * static_cast<double>(i));
  }
  EXPECT_THAT(said({.images = "flight", .geo_tags = files_.file("c.txt", one)}, folder),
              HasSubstr("photos lie within"));
  EXPECT_THAT(said({.images = "flight", .geo_tags = files_.file("b.txt", wide)}, folder),
              HasSubstr("not those of one block"));
}

TEST_F(Conflicts, ControlFarFromTheFlightIsRefused) {
  struct Case {
    const char* text;
    const char* cause;
  };
  const GeodeticOrigin on_meridian = {
      .latitude_deg = 45.1534, .longitude_deg = 9.0, .altitude_m = 200};
  for (const Case& each :
       {Case{"EPSG:32632\n500010 5000000 200 10 10 IMG_0.JPG p\n", "taken"},
        Case{"EPSG:32633\n500010 5000000 200 10 10 IMG_0.JPG p\n", "fit UTM zone 32N"},
        Case{"EPSG:4326\n45.1534 9.0 200 10 10 IMG_0.JPG p\n", "latitude and longitude swapped"},
        Case{"EPSG:4326\n9.0 45.2534 200 10 10 IMG_0.JPG p\n", "11 km apart"},
        Case{"EPSG:32632\n9.0 45.1534 200 10 10 IMG_0.JPG p\n", "look like degrees"},
        Case{"EPSG:4326\n9.0 45.1534 400 10 10 IMG_0.JPG p\n", "above the photos"},
        Case{"EPSG:4326\n9.0 45.1534 200 10 10 OTHER.JPG p\n", "photos that are not there"}}) {
    EXPECT_THAT(of_control(flight_at(on_meridian), each.text), HasSubstr(each.cause)) << each.text;
  }
}

TEST_F(Conflicts, HeightsCountInTheUnitOfAPlaneInFeetAndThatIsSaid) {
  // Massachusetts state plane, US survey feet, as a surveyor there delivers it.
  const auto survey = read_surveyed_points(
      files_.file("gcp.txt", "epsg:2249\n775000 2955000 100 10 10 IMG_0.JPG p\n"));
  ASSERT_TRUE(survey) << survey.error().message;
  EXPECT_NEAR(survey->points[0].position.altitude_m, 100.0 * 1200.0 / 3937.0, 1e-9);
  EXPECT_NEAR(survey->points[0].position.latitude_deg, 42.36, 0.05);
  ASSERT_EQ(survey->notes.size(), 1U);
  EXPECT_THAT(survey->notes[0], HasSubstr("foot"));
}

/// Photos that something else than GNSS put `up_m` above where GNSS has them.
Reconstruction placed(const GeodeticOrigin& site, double east_m, double up_m) {
  Reconstruction result{.origin = site};
  for (int i = 0; i < 8; ++i) {
    View view{.name = fmt::format("IMG_{}.JPG", i)};
    view.gnss_in_enu = Eigen::Vector3d(20.0 * i, 0.0, 65.0);
    view.gnss_sigma_m = Eigen::Vector3d(1.5, 1.5, 5.0);
    view.enu_from_camera =
        Rigid3{.translation = *view.gnss_in_enu + Eigen::Vector3d(east_m, 0.0, up_m)};
    result.views.push_back(view);
  }
  return result;
}

TEST(Placement, ControlThatPutsThePhotosElsewhereIsAnError) {
  EXPECT_TRUE(compare_placement(placed(kBoston, 3.0, 8.0), {.what = "ground control"}, {}).empty());
  const auto apart = compare_placement(placed(kBoston, 40.0, 0.0), {.what = "ground control"}, {});
  ASSERT_EQ(apart.size(), 1U);
  EXPECT_TRUE(is_error(apart[0]));
  EXPECT_THAT(apart[0].text, HasSubstr("40.0 m apart"));
}

TEST(Placement, HeightsInAnotherUnitAreAnErrorOtherDifferencesAWarning) {
  // Ground at 30 m: 98 feet taken for metres lift everything by 68 m.
  const auto feet = compare_placement(
      placed(kBoston, 0.0, 68.4), {.what = "ground control", .height_m = 98.4}, {});
  ASSERT_EQ(feet.size(), 1U);
  EXPECT_TRUE(is_error(feet[0]));
  EXPECT_THAT(feet[0].text, HasSubstr("feet taken for metres"));
  // 30 m under a system of feet: 21 m too low, which a guessed unit does not survive.
  const auto metres =
      compare_placement(placed(kBoston, 0.0, -20.9),
                        {.what = "ground control", .height_m = 9.1, .unit_assumed = true},
                        {});
  ASSERT_EQ(metres.size(), 1U);
  EXPECT_TRUE(is_error(metres[0]));
  EXPECT_THAT(metres[0].text, HasSubstr("metres taken for feet"));
  const auto other = compare_placement(
      placed(kBoston, 0.0, 41.0), {.what = "ground control", .height_m = 500.0}, {});
  ASSERT_EQ(other.size(), 1U);
  EXPECT_FALSE(is_error(other[0]));
}

}  // namespace
}  // namespace hybridfusion
