#include "positions_csv.hpp"
#include "report/html.hpp"
#include "workspace_data.hpp"

#include <filesystem>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(PositionsCsv, ReadsBackWhatItWrote) {
  const auto path = std::filesystem::temp_directory_path() / "hf_positions.csv";
  const std::vector<PositionRow> rows = {
      {.name = "a.jpg",
       .position = Eigen::Vector3d(1.5, -2.25, 60.0),
       .gnss = Eigen::Vector3d(1.0, -2.0, 61.0)},
      {.name = "odd, \"name\"\n.jpg", .reason = "too blurred, no matches"}};
  ASSERT_TRUE(write_positions_csv(path, rows));
  const auto read = read_positions_csv(path);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ(*(*read)[0].position, *rows[0].position);
  EXPECT_EQ(*(*read)[0].gnss, *rows[0].gnss);
  EXPECT_EQ((*read)[1].name, rows[1].name);
  EXPECT_EQ((*read)[1].reason, rows[1].reason);
  EXPECT_FALSE((*read)[1].position);
  std::filesystem::remove(path);
}

TEST(EnuFromEnu, IsTheIdentityForOneOriginAndMovesPointsWithTheEarth) {
  const GeodeticOrigin a{48.15, 11.57, 520.0};
  const GeodeticOrigin b{48.16, 11.58, 500.0};
  EXPECT_LT(enu_from_enu(a, a).translation.norm(), 1e-6);
  const Eigen::Vector3d point_in_b(30.0, -20.0, 5.0);
  const Eigen::Vector3d expected = enu_from_geodetic(a, geodetic_from_enu(b, point_in_b));
  EXPECT_LT((enu_from_enu(a, b) * point_in_b - expected).norm(), 1e-6);
}

TEST(Html, EscapesWhatComesFromFiles) {
  EXPECT_EQ(escaped("<b>\"x\" & 'y'</b>"), "&lt;b&gt;&quot;x&quot; &amp; &#39;y&#39;&lt;/b&gt;");
  const std::string table =
      html_table({{"mean_m", 0.25}, {"<script>", "<img>"}}, "run.json#/result");
  EXPECT_NE(
      table.find("<td class=v><data value='0.25' title='run.json#/result/mean_m'>0.25</data></td>"
                 "<td>m</td>"),
      std::string::npos);
  EXPECT_EQ(table.find("<script>"), std::string::npos);
  EXPECT_EQ(table.find("<img>"), std::string::npos);
}

}  // namespace
}  // namespace hybridfusion
