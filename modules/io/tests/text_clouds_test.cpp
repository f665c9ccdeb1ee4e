// Text clouds as other programs and people write them: read right, or refused.
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
using testing::TempFolder;

/// The second point of a file with everything that is known of it, or the refusal.
[[nodiscard]] std::string second_point(const std::filesystem::path& path) {
  const auto placed = read_placed_cloud(path);
  if (!placed) {
    return (placed.error().code == ErrorCode::kParse ? "refused: " : "?: ") +
           placed.error().message;
  }
  const PointCloud& cloud = placed->cloud;
  if (cloud.size() < 2) return fmt::format("{} points", cloud.size());
  const Eigen::Vector3d at = cloud.points[1].cast<double>() + placed->offset_m;
  std::string text = fmt::format("{}: {:.3f} {:.3f} {:.3f}", cloud.size(), at.x(), at.y(), at.z());
  if (!cloud.colors.empty()) {
    const Rgb8& c = cloud.colors[1];
    text += fmt::format(" rgb {} {} {}", c[0], c[1], c[2]);
  }
  if (!cloud.normals.empty()) {
    const Eigen::Vector3f& n = cloud.normals[1];
    text += fmt::format(" n {:g} {:g} {:g}", n.x(), n.y(), n.z());
  }
  if (!cloud.intensities.empty()) text += fmt::format(" i {:g}", cloud.intensities[1]);
  if (!cloud.times_s.empty()) text += fmt::format(" t {:.3f}", cloud.times_s[1]);
  for (const std::string& warning : placed->warnings) text += " | " + warning;
  return text;
}

struct Row {
  const char* kind;
  const char* member;
  const char* file;  ///< Name, whose extension counts.
  std::string content;
  const char* expected;  ///< Found in what second_point says.
};

const std::vector<Row> kRows = {
    {"heading",
     "CloudCompare, colours and normals",
     "a.txt",
     "//X Y Z R G B Nx Ny Nz\n3\n1.5 2.5 3.5 10 20 30 0 0 1\n1.25 2.5 3.5 13 103 203 0 1 0\n"
     "9 8 7 1 2 3 1 0 0\n",
     "3: 1.250 2.500 3.500 rgb 13 103 203 n 0 1 0"},
    {"heading",
     "CloudCompare, float colours, scalar before normals, semicolons",
     "a.asc",
     "//X;Y;Z;Rf;Gf;Bf;Intensity;Nx;Ny;Nz\n2\n1;2;3;0.1;0.2;0.3;0.5;0;0;1\n"
     "1.25;2.5;3.5;0.0509804;0.403922;0.796078;0.25;0;1;0\n",
     "2: 1.250 2.500 3.500 rgb 13 103 203 n 0 1 0 i 0.25"},
    {"heading",
     "table of a GIS",
     "a.csv",
     "id,X,Y,Z,classification\n0,1.5,2.5,3.5,2\n1,1.25,2.5,3.5,6\n",
     "2: 1.250 2.500 3.500"},
    {"heading",
     "names in quotes, text in a column",
     "a.csv",
     "\"name\",\"x\",\"y\",\"z\"\n\"P1\",1.5,2.5,3.5\n\"P2\",1.25,2.5,3.5\n",
     "2: 1.250 2.500 3.500 | column 'name' holds no numbers and is left out"},
    {"heading",
     "time first",
     "a.csv",
     "time,x,y,z\n100.5,1.5,2.5,3.5\n101.5,1.25,2.5,3.5\n",
     "2: 1.250 2.500 3.500 t 101.500"},
    {"heading",
     "Livox Viewer",
     "a.csv",
     "Version,Slot ID,LiDAR Index,Rsvd,Error Code,Timestamp Type,Data Type,Timestamp,X,Y,Z,"
     "Reflectivity,Tag,Ori_x,Ori_y,Ori_z,Ori_radius,Ori_theta,Ori_phi\n"
     "5,1,1,0,0x0,0,2,1577836800000000000,1.5,2.5,3.5,7,0,1500,2500,3500,4555,0,0\n"
     "5,1,1,0,0x0,0,2,1577836800000100000,1.25,2.5,3.5,9,0,1250,2500,3500,4477,0,0\n",
     "2: 1.250 2.500 3.500 i 9"},
    {"heading",
     "ParaView",
     "a.csv",
     "\"Points:0\",\"Points:1\",\"Points:2\",\"intensity\"\n1,2,3,4\n1.25,2.5,3.5,9\n",
     "2: 1.250 2.500 3.500 i 9"},
    {"heading",
     "easting and northing in another order",
     "a.txt",
     "Northing\tEasting\tElevation\n5400000.5\t500000.25\t300.5\n5400001.5\t500001.25\t301.5\n",
     "2: 500001.250 5400001.500 301.500"},
    {"heading",
     "ArcGIS with units",
     "a.csv",
     "POINT_X [m],POINT_Y [m],POINT_Z [m]\n1,2,3\n4,5,6\n",
     "2: 4.000 5.000 6.000"},
    {"heading",
     "commented",
     "a.xyz",
     "# x y z intensity\n1 2 3 4\n1 2 3 9\n",
     "2: 1.000 2.000 3.000 i 9"},
    {"heading", "z before x", "a.txt", "z x y\n3 1 2\n6 4 5\n", "2: 4.000 5.000 6.000"},
    {"heading",
     "with a mark of UTF-8",
     "a.csv",
     "\xef\xbb\xbfx,y,z\r\n1,2,3\r\n4,5,6\r\n",
     "2: 4.000 5.000 6.000"},
    {"heading",
     "repeated, as of joined files",
     "a.csv",
     "x,y,z\n1,2,3\nx,y,z\n4,5,6\n",
     "2: 4.000 5.000 6.000"},
    {"heading", "intensities", "a.csv", "x,y,z,Intensities\n1,2,3,4\n1,2,3,9\n", "i 9"},
    {"heading", "fewer names than columns", "a.csv", "x,y,z\n1,2,3,4\n4,5,6,7\n", "refused: "},
    {"heading", "no position", "a.csv", "a,b,c\n1,2,3\n4,5,6\n", "names no x, y and z"},
    {"heading", "one name twice", "a.csv", "x,y,z,x\n1,2,3,4\n4,5,6,7\n", "refused: "},
    {"heading", "feet", "a.csv", "x (ft),y (ft),z (ft)\n1,2,3\n4,5,6\n", "not in metres"},
    {"degrees",
     "latitude, longitude, elevation",
     "a.csv",
     "RelativeTime,Latitude,Longitude,Elevation\n0.0,69.333,-49.84,630\n0.1,69.334,-49.85,631\n",
     "in degrees"},
    {"degrees", "lat,lon,alt", "a.txt", "lat lon alt\n48.1 11.5 520\n48.2 11.6 521\n", "project"},
    {"no heading",
     "normals",
     "a.xyz",
     "1 2 3 0 0 1\n1.25 2.5 3.5 0 1 0\n",
     "2: 1.250 2.500 3.500 n 0 1 0"},
    {"no heading", "normals with a zero one", "a.xyz", "1 2 3 0.6 0 0.8\n4 5 6 0 0 0\n", "n 0 0 0"},
    {"no heading",
     "colours",
     "a.xyz",
     "1 2 3 0 0 1\n1.25 2.5 3.5 13 103 203\n",
     "rgb 13 103 203 | no heading: its columns are taken as x y z red green blue"},
    {"no heading",
     "colours behind normals",
     "a.txt",
     "1 2 3 0 0 1 9 9 9\n1 2 3 0.6 0 0.8 13 103 203\n",
     "rgb 13 103 203 n 0.6 0 0.8"},
    {"no heading",
     "intensity before colour",
     "a.txt",
     "1 2 3 0.5 1 2 3\n1 2 3 0.25 13 103 203\n",
     "rgb 13 103 203 i 0.25"},
    {"no heading",
     "intensity behind colour",
     "a.txt",
     "1 2 3 1 2 3 1000\n1 2 3 13 103 203 2000\n",
     "rgb 13 103 203 i 2000"},
    {"no heading",
     "intensity before or behind colour",
     "a.txt",
     "1 2 3 9 1 2 3\n1 2 3 9 4 5 6\n",
     "--columns"},
    {"no heading",
     "Leica .pts",
     "a.pts",
     "2\n1 2 3 -1000 1 2 3\n1 2 3 9 13 103 203\n",
     "rgb 13 103 203 i 9"},
    {"no heading", "five columns", "a.txt", "1 2 3 4 5\n6 7 8 9 10\n", "--columns"},
    {"no heading",
     "numbered rows",
     "a.csv",
     "1,10.5,20.5,30.5\n2,11.5,21.5,31.5\n3,1.5,2.5,3.5\n",
     "counts the rows"},
    {"no heading", "time first", "a.csv", "1577836800.1,1,2,3\n1577836800.2,4,5,6\n", "a time"},
    {"no heading",
     "neither colour nor normal",
     "a.txt",
     "1 2 3 4 5 600\n1 2 3 -4 5 6\n",
     "--columns"},
    {"decimal comma",
     "semicolons",
     "a.csv",
     "x;y;z\n1,5;2,5;3,5\n1,25;2,5;3,5\n",
     "2: 1.250 2.500 3.500"},
    {"decimal comma",
     "white space",
     "a.txt",
     "1,5 2,5 3,5\n1,25 2,5 3,5\n",
     "2: 1.250 2.500 3.500"},
    {"decimal comma",
     "tabs, whole numbers between",
     "a.txt",
     "1\t2\t3\n1,25\t-2,5\t3,5e2\n",
     "2: 1.250 -2.500 350.000"},
    {"decimal comma",
     "in quotes",
     "a.csv",
     "x,y,z\n\"1,5\",\"2,5\",\"3,5\"\n\"1,25\",\"2,5\",3\n",
     "2: 1.250 2.500 3.000"},
    {"decimal comma", "commas only", "a.csv", "1,5,2,5,3,5\n1,25,2,5,3,5\n", "decimals or"},
    {"decimal comma",
     "commas only, below a heading",
     "a.csv",
     "x,y,z\n1,5,2,5,3,5\n1,2,2,5,3,5\n",
     "refused: "},
    {"decimal comma", "points for thousands", "a.csv", "1.234,5;2;3\n1;2;3\n", "refused: "},
    {"decimal comma",
     "commas for thousands",
     "a.txt",
     "500,000.5 5,400,000.5 3\n1 2 3\n",
     "refused: "},
    {"separators",
     "comma and blank",
     "a.txt",
     "1.5, 2.5, 3.5\n1.25, 2.5, 3.5\n",
     "2: 1.250 2.500 3.500"},
    {"separators",
     "comma at the end",
     "a.csv",
     "1.5,2.5,3.5,\n1.25,2.5,3.5,\n",
     "2: 1.250 2.500 3.500"},
    {"separators",
     "several blanks and tabs",
     "a.xyz",
     "  1   2\t3\n 1.25 \t2.5  3.5  \n",
     "2: 1.250 2.500 3.500"},
    {"separators",
     "UTF-16",
     "a.txt",
     std::string("\xff\xfe"
                 "1\0 \0",
                 6) +
         "2 3",
     "UTF-16"},
    {"no return",
     "NaN points",
     "a.xyz",
     "1 2 3\nnan nan nan\n1.25 2.5 3.5\n-nan(ind) 1.#QNAN 3\n",
     "2: 1.250 2.500 3.500 | 2 points without a position"},
    {"no return",
     "empty cells",
     "a.csv",
     "x,y,z,i\n1,2,3,4\n,,,\n1.25,2.5,3.5,9\n,,,5\n",
     "2: 1.250 2.500 3.500 i 9 | 1 point"},
    {"no return", "nothing else", "a.xyz", "nan nan nan\nnan nan nan\n", "refused: "},
    {"no heading",
     "Open3D .pts",
     "a.pts",
     "2\n0.0 0.0 0.0 0.0000000000 10 20 30\n1.25 2.5 3.5 0.0000000000 13 103 203\n",
     "2: 1.250 2.500 3.500 rgb 13 103 203 i 0"},
    {"no heading",
     "CloudCompare with two scalars behind the colour",
     "a.asc",
     "0.0 0.0 0.0 10 20 30 5.0 2.0\n1.5 2.5 3.5 13 103 203 7.0 6.0\n",
     "--columns"},
    {"heading",
     "CloudCompare, count below it",
     "a.asc",
     "//X;Y;Z;R;G;B;Intensity;Classification\n2\n0.0;0.0;0.0;10;20;30;5.0;2.0\n"
     "1.25;2.5;3.5;13;103;203;7.0;6.0\n",
     "2: 1.250 2.500 3.500 rgb 13 103 203 i 7"},
    {"count",
     "two scans in one .pts",
     "a.pts",
     "1\n1 2 3 4\n2\n1.25 2.5 3.5 9\n4 5 6 7\n",
     "3: 1.250 2.500 3.500 i 9"},
    {"count",
     "said of two scans",
     "a.pts",
     "1\n1 2 3 4\n2\n1.25 2.5 3.5 9\n4 5 6 7\n",
     "its 2 scans became one cloud"},
    {"count",
     "cut file",
     "a.pts",
     "3\n1 2 3 4\n1.25 2.5 3.5 9\n",
     "3 points are announced, 2 follow"},
    {"other content",
     "ESRI grid",
     "a.asc",
     "ncols 3\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n1 2 3\n",
     "ESRI ASCII"},
    {"other content",
     "PTX",
     "a.pts",
     "2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n1 2 3 4\n",
     "refused: "},
};

TEST(TextClouds, AreReadRightOrRefused) {
  const TempFolder folder;
  for (const Row& row : kRows) {
    EXPECT_THAT(second_point(folder.file(row.file, row.content)), HasSubstr(row.expected))
        << row.kind << ", " << row.member;
  }
}

TEST(TextClouds, NamedColumnsDecide) {
  const TempFolder folder;
  const auto convert = [&](const char* content, std::vector<std::string> columns) {
    const auto done = convert_cloud({.in = folder.file("a.txt", content),
                                     .out = folder.path() / "a.ply",
                                     .columns = std::move(columns)});
    return done ? second_point(folder.path() / "a.ply") : done.error().message;
  };
  EXPECT_EQ(convert("0 1 2 3 9\n1 4 5 6 7\n", {"-", "x", "y", "z", "intensity"}),
            "2: 4.000 5.000 6.000 i 7");
  EXPECT_EQ(convert("a b c\n1 2 3\n4 5 6\n", {"z", "y", "x"}), "2: 6.000 5.000 4.000");
  EXPECT_EQ(convert("1,2,3,4,5,6\n1,2,3,7,8,9\n", {"x", "y", "z", "r", "g", "b"}),
            "2: 1.000 2.000 3.000 rgb 7 8 9");
  EXPECT_THAT(convert("1 2 3\n", {"x", "y"}), HasSubstr("names 2 columns, the rows have 3"));
  EXPECT_THAT(convert("1 2 3\n", {"lat", "lon", "z"}), HasSubstr("degrees"));
  const auto ply = convert_cloud(
      {.in = folder.path() / "a.ply", .out = folder.path() / "b.ply", .columns = {"x", "y", "z"}});
  ASSERT_FALSE(ply);
  EXPECT_EQ(ply.error().code, ErrorCode::kInvalidOptions);
}

}  // namespace
}  // namespace hybridfusion
