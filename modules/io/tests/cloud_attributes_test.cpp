// What files say of their points beside position, colour and intensity: kept, or said to be lost.
#include "las_builder.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/convert_cloud.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;
using testing::LasBuilder;
using testing::TempFolder;

/// Everything that is said of the last point, by name.
[[nodiscard]] std::string last_point(const std::filesystem::path& path) {
  const auto survey = survey_cloud(path);
  if (!survey) return "refused: " + survey.error().message;
  std::string text;
  auto read = read_cloud_batches(path, *survey, 1000, [&](CloudBatch&& cloud) -> Expected<void> {
    text = fmt::format("{}:", cloud.size());
    const std::size_t last = cloud.size() - 1;
    if (!cloud.intensities.empty()) text += fmt::format(" intensity={}", cloud.intensities[last]);
    if (!cloud.times_s.empty()) text += fmt::format(" time={}", cloud.times_s[last]);
    if (!cloud.colors.empty()) text += fmt::format(" red={}", cloud.colors[last][0]);
    for (const PointScalar& s : cloud.scalars)
      text += fmt::format(" {}={:g}", s.name, s.values[last]);
    return {};
  });
  if (!read) return "refused: " + read.error().message;
  for (const std::string& warning : survey->warnings) text += " | " + warning;
  return text;
}

/// A LAS 1.4 file whose points say all that the format can.
[[nodiscard]] std::string full_las() {
  LasBuilder file{.minor = 4, .format = 7, .encoding = 1, .extra_bytes = 3};
  std::string amplitude(192, '\0');
  amplitude[2] = 3;  // unsigned short
  amplitude.replace(4, 9, "Amplitude");
  amplitude[3] = 0x08;  // scaled
  LasBuilder::put(amplitude, 112, 0.5);
  std::string pulse(192, '\0');
  pulse[2] = 1;
  pulse.replace(4, 11, "Pulse width");
  file.vlr("LASF_Spec", 4, amplitude + pulse);
  return file.bytes([](std::string& record, std::uint32_t i) {
    record[14] = static_cast<char>(2 | 3 << 4);
    record[15] = static_cast<char>(0x02 | 0x08 | 2 << 4 | 0x40 | 0x80);
    record[16] = static_cast<char>(i == 0 ? 2 : 71);
    record[17] = 9;
    LasBuilder::put(record, 18, std::int16_t{-2500});
    LasBuilder::put(record, 20, std::uint16_t{4711});
    LasBuilder::put(record, 22, 4e8 + i);
    LasBuilder::put(record, 36, static_cast<std::uint16_t>(20 * i));
    record[38] = static_cast<char>(5 + i);
  });
}

TEST(CloudAttributes, OfLasSurviveEveryFormatThatHoldsThem) {
  const TempFolder folder;
  const auto in = folder.file("in.las", full_las());
  const std::string expected =
      " return_number=2 number_of_returns=3 scan_direction=1 edge_of_flight_line=1 "
      "classification=71 key_point=1 overlap=1 scanner_channel=2 scan_angle=-15 user_data=9 "
      "point_source_id=4711 Amplitude=30";
  ASSERT_THAT(last_point(in), HasSubstr(expected));
  for (const char* const name : {"out.las", "out.ply", "out.pcd"}) {
    const auto done = convert_cloud({.in = in, .out = folder.path() / name});
    ASSERT_TRUE(done) << name << done.error().message;
    EXPECT_THAT(done->warnings, ::testing::IsEmpty()) << name;
    EXPECT_THAT(last_point(folder.path() / name), HasSubstr(expected)) << name;
    EXPECT_THAT(last_point(folder.path() / name), HasSubstr("width=8")) << name;
  }
  const auto text = convert_cloud({.in = in, .out = folder.path() / "out.xyz"});
  ASSERT_TRUE(text);
  ASSERT_EQ(text->warnings.size(), 1U);
  for (const char* const name : {"time", "classification", "return_number", "Amplitude"}) {
    EXPECT_THAT(text->warnings[0], HasSubstr(name));
  }
  const auto old = convert_cloud(
      {.in = in, .out = folder.path() / "old.las", .format = {.las_version = LasVersion::k12}});
  ASSERT_TRUE(old);
  EXPECT_THAT(old->warnings, ::testing::Contains(HasSubstr("classes above 31")));
  EXPECT_THAT(last_point(folder.path() / "old.las"), HasSubstr("return_number=2"));
}

TEST(CloudAttributes, WeekTimesStayWeekTimes) {
  const TempFolder folder;
  const auto in =
      folder.file("in.las", LasBuilder{}.bytes([](std::string& record, std::uint32_t i) {
        LasBuilder::put(record, 20, 302400.5 + i);
      }));
  EXPECT_THAT(last_point(in), HasSubstr("gps_time=302404"));
  ASSERT_TRUE(convert_cloud({.in = in, .out = folder.path() / "a.ply"}));
  ASSERT_TRUE(convert_cloud({.in = folder.path() / "a.ply", .out = folder.path() / "b.las"}));
  EXPECT_THAT(last_point(folder.path() / "b.las"), HasSubstr("gps_time=302404"));
}

struct Row {
  const char* kind;
  const char* member;
  const char* file;
  std::string content;
  const char* expected;
};

[[nodiscard]] std::string ply(const char* properties, const char* rows) {
  return fmt::format(
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty "
      "float z\n{}end_header\n{}",
      properties,
      rows);
}

[[nodiscard]] std::string pcd(const char* head, const char* rest, const char* rows) {
  return fmt::format("VERSION 0.7\n{}\n{}DATA ascii\n{}", head, rest, rows);
}

TEST(CloudAttributes, OfOtherFilesAreKeptOrToldOf) {
  const char* const kXyz = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1";
  const std::vector<Row> rows = {
      {"intensity",
       "intensities",
       "a.ply",
       ply("property float intensities\n", "1 2 3 4\n1 2 3 9\n"),
       "intensity=9"},
      {"intensity",
       "scalar_Intensity",
       "a.ply",
       ply("property float scalar_Intensity\n", "1 2 3 4\n1 2 3 9\n"),
       "intensity=9"},
      {"intensity",
       "reflectance",
       "a.ply",
       ply("property float reflectance\n", "1 2 3 4\n1 2 3 9\n"),
       "intensity=9"},
      {"scalars",
       "of CloudCompare",
       "a.ply",
       ply("property float scalar_Classification\n", "1 2 3 4\n1 2 3 9\n"),
       "scalar_Classification=9"},
      {"scalars",
       "named alike",
       "a.ply",
       ply("property float a\nproperty float a\n", "1 2 3 4 5\n1 2 3 8 9\n"),
       "a=8 a_2=9"},
      {"scalars",
       "alpha of MeshLab",
       "a.ply",
       ply("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n",
           "1 2 3 7 8 9 255\n1 2 3 7 8 9 255\n"),
       "2: red=7"},
      {"scalars",
       "alpha that says something",
       "a.ply",
       ply("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n",
           "1 2 3 7 8 9 255\n1 2 3 7 8 9 100\n"),
       "alpha=100"},
      {"times",
       "nanoseconds are no seconds",
       "a.ply",
       ply("property double timestamp\n", "1 2 3 1.7e18\n1 2 3 1.7e18\n"),
       "timestamp=1.7e+18"},
      {"no return", "NaN", "a.ply", ply("", "nan nan nan\n1 2 3\n"), "1: | 1 point without"},
      {"no return",
       "NaN",
       "a.pcd",
       pcd(kXyz, "WIDTH 2\nHEIGHT 1\nPOINTS 2\n", "nan nan nan\n1 2 3\n"),
       "1: | 1 point without"},
      {"mesh",
       "faces",
       "a.ply",
       "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty "
       "float "
       "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n4 5 6\n3 0 1 "
       "0\n",
       "1 rows of 'face' are left out"},
      {"grid",
       "0 by 0 beside the points",
       "a.pcd",
       pcd(kXyz, "WIDTH 0\nHEIGHT 0\nPOINTS 2\n", "1 2 3\n4 5 6\n"),
       "2:"},
      {"grid",
       "that contradicts the points",
       "a.pcd",
       pcd(kXyz, "WIDTH 3\nHEIGHT 1\nPOINTS 2\n", "1 2 3\n4 5 6\n"),
       "refused: "},
      {"fields",
       "padding",
       "a.pcd",
       pcd("FIELDS x y z _ i _\nSIZE 4 4 4 1 4 1\nTYPE F F F U F U\nCOUNT 1 1 1 2 1 1",
           "WIDTH 2\nHEIGHT 1\nPOINTS 2\n",
           "1 2 3 0 0 5 0\n1 2 3 0 0 6 0\n"),
       "2: i=6"},
      {"colours",
       "of PCL in ascii: whole numbers",
       "a.pcd",
       pcd("FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1",
           "WIDTH 2\nHEIGHT 1\nPOINTS 2\n",
           "1 2 3 660510\n1 2 3 878539\n"),
       "2: red=13"},
      {"colours",
       "of Open3D in ascii: tiny floats",
       "a.pcd",
       pcd("FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1",
           "WIDTH 2\nHEIGHT 1\nPOINTS 2\n",
           "1 2 3 9.255716487e-40\n1 2 3 1.23109537e-39\n"),
       "2: red=13"},
      {"fields",
       "of several values",
       "a.pcd",
       pcd("FIELDS x y z fpfh\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 2",
           "WIDTH 2\nHEIGHT 1\nPOINTS 2\n",
           "1 2 3 0 0\n1 2 3 0 0\n"),
       "field 'fpfh' of 2 values"},
  };
  const TempFolder folder;
  for (const Row& row : rows) {
    EXPECT_THAT(last_point(folder.file(row.file, row.content)), HasSubstr(row.expected))
        << row.kind << ", " << row.member;
  }
}

TEST(CloudAttributes, ScalarsOfOtherSpellingsFillTheFieldsOfLas) {
  const TempFolder folder;
  const auto in = folder.file(
      "in.ply",
      ply("property float scalar_Classification\nproperty float scalar_Scan_Angle_Rank\nproperty "
          "float PointSourceId\nproperty double scalar_GpsTime\n",
          "1 2 3 2 5 7 302400.5\n1 2 3 6 -9 8 302401.5\n"));
  ASSERT_TRUE(convert_cloud({.in = in, .out = folder.path() / "out.las"}));
  EXPECT_THAT(last_point(folder.path() / "out.las"),
              HasSubstr("2: gps_time=302402 classification=6 scan_angle=-9 point_source_id=8"));
  ASSERT_TRUE(convert_cloud(
      {.in = in, .out = folder.path() / "b.ply", .format = {.ply_scalar_prefix = true}}));
  EXPECT_THAT(testing::content_of(folder.path() / "b.ply"),
              HasSubstr("float scalar_Classification\n"));
}

TEST(CloudAttributes, DeviationAndConfidenceAreExtraBytesOfLas) {
  const TempFolder folder;
  const auto in = folder.file(
      "in.ply",
      ply("property float sigma\nproperty float confidence\n", "1 2 3 0.125 4\n4 5 6 0.25 5\n"));
  ASSERT_TRUE(convert_cloud({.in = in, .out = folder.path() / "out.las"}));
  const auto las = read_placed_cloud(folder.path() / "out.las");
  ASSERT_TRUE(las) << las.error().message;
  EXPECT_EQ(las->cloud.sigmas_m, (std::vector<float>{0.125F, 0.25F}));
  EXPECT_EQ(las->cloud.confidences, (std::vector<float>{4.0F, 5.0F}));
  EXPECT_THAT(testing::content_of(folder.path() / "out.las"), HasSubstr("standard deviation [m]"));
}

TEST(CloudAttributes, ViewpointsFollowThePoints) {
  const TempFolder folder;
  const auto in = folder.file(
      "in.pcd",
      "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n"
      "VIEWPOINT 500001 2 3 0.5 0.5 0.5 0.5\nPOINTS 1\nDATA ascii\n500000.5 5400000.5 1\n");
  const auto done = convert_cloud({.in = in, .out = folder.path() / "out.pcd"});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_THAT(testing::content_of(folder.path() / "out.pcd"),
              HasSubstr("VIEWPOINT 1 -5399998 3 0.5 0.5 0.5 0.5\n"));
  const auto las = convert_cloud({.in = in, .out = folder.path() / "out.las"});
  ASSERT_TRUE(las);
  EXPECT_THAT(las->warnings, ::testing::Contains(HasSubstr("VIEWPOINT")));
}

TEST(CloudAttributes, OthersReadTheNamesThatAreWritten) {
  const TempFolder folder;
  const auto in = folder.file("in.ply",
                              ply("property uchar red\nproperty uchar green\nproperty uchar blue\n"
                                  "property float intensity\nproperty uchar classification\n",
                                  "1 2 3 13 103 203 0.5 2\n4 5 6 1 2 3 0.25 6\n"));
  ASSERT_TRUE(convert_cloud(
      {.in = in, .out = folder.path() / "a.pcd", .format = {.encoding = CloudEncoding::kAscii}}));
  EXPECT_THAT(
      testing::content_of(folder.path() / "a.pcd"),
      HasSubstr("FIELDS x y z rgb intensity classification\nSIZE 4 4 4 4 4 1\nTYPE F F F F F "
                "U\n"));
  EXPECT_THAT(last_point(folder.path() / "a.pcd"), HasSubstr("red=1"));
  ASSERT_TRUE(convert_cloud(
      {.in = in, .out = folder.path() / "a.ply", .format = {.ply_scalar_prefix = true}}));
  EXPECT_THAT(testing::content_of(folder.path() / "a.ply"),
              HasSubstr("property float scalar_intensity\nproperty uchar scalar_classification\n"));
}

}  // namespace
}  // namespace hybridfusion
