// Units and reference systems of LAS files: horizontal and vertical ones apart.
#include "las_builder.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/convert_cloud.hpp>
#include <hybridfusion/io/las.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

namespace hybridfusion {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using testing::LasBuilder;
using testing::TempFolder;

constexpr double kSurveyFoot_m = 1200.0 / 3937.0;
constexpr double kFoot_m = 0.3048;

/// WKT 1 or 2 of a code, made by PROJ.
[[nodiscard]] std::string wkt_of(const std::string& code, const char* version = "WKT1_GDAL") {
  OGRSpatialReference system;
  EXPECT_EQ(system.SetFromUserInput(code.c_str()), OGRERR_NONE);
  const std::string format = fmt::format("FORMAT={}", version);
  const char* const options[] = {format.c_str(), nullptr};
  char* text = nullptr;
  EXPECT_EQ(system.exportToWkt(&text, options), OGRERR_NONE);
  std::string wkt = text == nullptr ? "" : text;
  CPLFree(text);
  return wkt;
}

[[nodiscard]] LasBuilder modern(const std::string& wkt) {
  return LasBuilder{.minor = 4, .format = 6}.wkt(wkt);
}
[[nodiscard]] LasBuilder with_keys(const std::vector<std::pair<int, int>>& values) {
  return LasBuilder{}.keys(values);
}

/// "x y" steps in metres between the first two points, x by 1 and z by 10 units; or the refusal.
[[nodiscard]] std::string steps(const std::filesystem::path& path) {
  const auto las = read_las(path);
  if (!las) return "refused: " + las.error().message;
  const Eigen::Vector3f step = las->cloud.points[1] - las->cloud.points[0];
  std::string text = fmt::format("{:.4f} {:.3f}", step.x(), step.z());
  for (const std::string& warning : las->warnings) text += " | " + warning;
  return text;
}

struct Row {
  const char* member;
  LasBuilder file;
  std::string expected;
};

[[nodiscard]] std::string step(double x, double z) {
  return fmt::format("{:.4f} {:.3f}", x, 10.0 * z);
}

TEST(LasUnits, HorizontalAndVerticalOnesAreApart) {
  const std::string esri_vertical =
      ",VERTCS[\"NAVD_1988_Foot_US\",VDATUM[\"North_American_Vertical_Datum_1988\"],PARAMETER["
      "\"Vertical_Shift\",0.0],PARAMETER[\"Direction\",1.0],UNIT[\"Foot_US\",0.3048006096012192]]";
  const std::vector<Row> rows = {
      {"feet, heights in metres (WKT 1)", modern(wkt_of("EPSG:2263+5703")), step(kSurveyFoot_m, 1)},
      {"metres, heights in feet (WKT 1)",
       modern(wkt_of("EPSG:26918+6360")),
       step(1, kSurveyFoot_m)},
      {"metres, heights in feet (WKT 2)",
       modern(wkt_of("EPSG:26918+6360", "WKT2_2019")),
       step(1, kSurveyFoot_m)},
      {"feet, heights in metres (WKT 2)",
       modern(wkt_of("EPSG:2263+5703", "WKT2_2019")),
       step(kSurveyFoot_m, 1)},
      {"international feet, heights in them",
       modern(wkt_of("EPSG:2222+8228")),
       step(kFoot_m, kFoot_m)},
      {"feet without heights",
       modern(wkt_of("EPSG:2263")),
       step(kSurveyFoot_m, kSurveyFoot_m) + " | nothing says the unit of its heights"},
      {"ESRI, heights in feet",
       modern(wkt_of("EPSG:26918", "WKT1_ESRI") + esri_vertical),
       step(1, kSurveyFoot_m)},
      {"a plane of its own in feet",
       modern("LOCAL_CS[\"site\",UNIT[\"US survey foot\",0.304800609601219]]"),
       step(kSurveyFoot_m, kSurveyFoot_m)},
      {"depths", modern(wkt_of("EPSG:32632+5715")), "refused: "},
      {"degrees", modern(wkt_of("EPSG:4326")), "refused: "},
      {"broken, in feet", modern("PROJCS[\"x\",UNIT[\"Foot_US\",0.3048006"), "refused: "},
      {"broken", modern("PROJCS[\"x\""), step(1, 1) + " | its coordinate system cannot"},
      {"keys: code alone",
       with_keys({{1024, 1}, {3072, 2263}}),
       step(kSurveyFoot_m, kSurveyFoot_m)},
      {"keys: feet, vertical code in metres",
       with_keys({{1024, 1}, {3072, 2263}, {4096, 5703}}),
       step(kSurveyFoot_m, 1)},
      {"keys: metres, vertical code in feet",
       with_keys({{1024, 1}, {3072, 26918}, {4096, 6360}}),
       step(1, kSurveyFoot_m)},
      {"keys: vertical unit alone",
       with_keys({{1024, 1}, {3072, 26918}, {4099, 9002}}),
       step(1, kFoot_m)},
      {"keys: vertical unit against its code",
       with_keys({{1024, 1}, {3072, 26918}, {4096, 5703}, {4099, 9003}}),
       step(1, kSurveyFoot_m)},
      {"keys: metric code, units in feet",
       with_keys({{1024, 1}, {3072, 26918}, {3076, 9003}}),
       step(kSurveyFoot_m, kSurveyFoot_m)},
      {"keys: user-defined system in feet",
       with_keys({{1024, 1}, {3072, 32767}, {3076, 9002}}),
       step(kFoot_m, kFoot_m) + " | its coordinate system (without a name) is defined"},
      {"keys: feet by code, metres by key",
       with_keys({{1024, 1}, {3072, 2263}, {3076, 9001}}),
       "refused: "},
      {"keys: unknown unit", with_keys({{1024, 1}, {3072, 26918}, {3076, 9999}}), "refused: "},
      {"keys: geographic, user-defined", with_keys({{1024, 2}, {2048, 32767}}), "refused: "},
      {"keys: geographic by code", with_keys({{1024, 2}, {2048, 4326}}), "refused: "},
      {"keys: geocentric", with_keys({{1024, 3}, {2048, 4978}}), "geocentric"},
      {"keys: unknown code", with_keys({{1024, 1}, {3072, 9}}), "EPSG:9 is not known"},
  };
  const TempFolder folder;
  for (const Row& row : rows) {
    EXPECT_THAT(steps(folder.file("a.las", row.file.bytes())), HasSubstr(row.expected))
        << row.member;
  }
}

TEST(LasUnits, FilesInFeetStayInFeetAsLasAndBecomeMetresElsewhere) {
  const TempFolder folder;
  const auto in = folder.file("in.las", modern(wkt_of("EPSG:2263+5703")).bytes());
  ASSERT_TRUE(convert_cloud({.in = in, .out = folder.path() / "out.las"}));
  EXPECT_THAT(steps(folder.path() / "out.las"), HasSubstr(step(kSurveyFoot_m, 1)));
  const auto xyz = convert_cloud({.in = in, .out = folder.path() / "out.xyz"});
  ASSERT_TRUE(xyz);
  EXPECT_THAT(xyz->warnings, ::testing::Contains(HasSubstr("became metres")));
  const auto points = read_point_cloud(folder.path() / "out.xyz");
  ASSERT_TRUE(points);
  EXPECT_NEAR(points->points[1].x() - points->points[0].x(), kSurveyFoot_m, 1e-4);
  EXPECT_NEAR(points->points[1].z() - points->points[0].z(), 10.0, 1e-4);
}

constexpr GeodeticOrigin kNewYork = {.latitude_deg = 40.7, .longitude_deg = -73.9};
constexpr GeodeticOrigin kLondon = {.latitude_deg = 51.5, .longitude_deg = -0.1};
constexpr GeodeticOrigin kMunich = {.latitude_deg = 48.15, .longitude_deg = 11.57};

TEST(LasUnits, SystemsInFeetAreWritten) {
  const TempFolder folder;
  const auto in = folder.file("in.xyz", "0 0 0\n100 0 10\n");
  const auto done =
      convert_cloud({.in = in,
                     .out = folder.path() / "out.xyz",
                     .format = {.text_in_crs_units = true},
                     .georeference = Georeference{.origin = kNewYork, .crs = "epsg:2263"}});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_THAT(done->warnings, ::testing::Contains(HasSubstr("good to 4 m")));
  const std::string text = testing::content_of(folder.path() / "out.xyz");
  double x0 = 0.0;
  double x1 = 0.0;
  double unused = 0.0;
  ASSERT_EQ(std::sscanf(text.c_str(), "%lf %lf %lf\n%lf", &x0, &unused, &unused, &x1), 4);
  // Grid against ground: the scale of the zone is within 1e-4 here.
  EXPECT_NEAR(x1 - x0, 100.0 / kSurveyFoot_m, 0.1);
  EXPECT_GT(x0, 900'000.0);
}

TEST(LasUnits, AccuracyOfTheSystemIsToldOrRefused) {
  const TempFolder folder;
  const auto in = folder.file("in.xyz", "0 0 0\n1 0 0\n");
  const auto convert = [&](const GeodeticOrigin& origin, const char* crs, bool ballpark = false) {
    const auto done = convert_cloud(
        {.in = in,
         .out = folder.path() / "out.las",
         .georeference = Georeference{.origin = origin, .crs = crs, .allow_ballpark = ballpark}});
    if (!done) return "refused: " + done.error().message;
    return done->warnings.empty() ? std::string("good") : done->warnings.front();
  };
  EXPECT_EQ(convert(kMunich, "EPSG:25832"), "good");
  EXPECT_EQ(convert(kMunich, "epsg:32632"), "good");
  EXPECT_THAT(convert(kLondon, "EPSG:27700"), AnyOf("good", HasSubstr("OSTN15")));
  EXPECT_THAT(convert(kMunich, "EPSG:23032"), HasSubstr("--allow-ballpark"));
  EXPECT_THAT(convert(kMunich, "EPSG:23032", true), HasSubstr("positions are good to"));
  EXPECT_THAT(convert(kMunich, "EPSG:25832+7837"), AnyOf("good", HasSubstr("gcg2016")));
}

TEST(LasUnits, SurfaceHeightsKeepTheirUnitInCompoundSystems) {
  const TempFolder folder;
  const auto unit = [&](const std::string& code) {
    const auto in = folder.file("in.las", modern(wkt_of(code)).bytes());
    const auto done = convert_cloud(
        {.in = in, .dsm = folder.path() / "dsm.tif", .raster = {.cell_m = 1.0, .fill_cells = 0}});
    if (!done) return done.error().message;
    const std::string bytes = testing::content_of(folder.path() / "dsm.tif");
    const std::size_t at = bytes.find("role=\"unittype\">");
    return at == std::string::npos ? "none" : bytes.substr(at + 16, bytes.find('<', at) - at - 16);
  };
  EXPECT_EQ(unit("EPSG:25832"), "metre");
  EXPECT_EQ(unit("EPSG:25832+7837"), "m");
  EXPECT_EQ(unit("EPSG:26918+6360"), "ftUS");
}

}  // namespace
}  // namespace hybridfusion
