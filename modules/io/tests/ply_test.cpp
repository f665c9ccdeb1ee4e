#include "mutations.hpp"
#include "sample_cloud.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/ply.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using testing::bytes_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TempFolder;

TEST(Ply, CloudReadsBackBitForBitInBothFormats) {
  const TempFolder folder;
  const PointCloud cloud = testing::sample_cloud(100);
  for (const PlyFormat format : {PlyFormat::kAscii, PlyFormat::kBinaryLittleEndian}) {
    const auto path = folder.path() / "cloud.ply";
    ASSERT_TRUE(write_ply(path, cloud, {.format = format, .comments = {"two\nlines"}}));
    const auto back = read_ply(path);
    ASSERT_TRUE(back) << back.error().message;
    testing::expect_equal(*back, cloud);
    EXPECT_THAT(testing::content_of(path), HasSubstr("comment two lines\n"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "cloud.ply.part"));
  }
}

TEST(Ply, BatchesTogetherAreTheCloud) {
  const TempFolder folder;
  const PointCloud cloud = testing::sample_cloud(100);
  const auto path = folder.path() / "cloud.ply";
  ASSERT_TRUE(write_ply(path, cloud));
  PointCloud together;
  std::vector<std::size_t> sizes;
  const auto read = read_ply_batches(path, 33, [&](PointCloud&& batch) -> Expected<void> {
    sizes.push_back(batch.size());
    together = concatenate(std::move(together), batch);
    return {};
  });
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_THAT(sizes, ElementsAre(33U, 33U, 33U, 1U));
  testing::expect_equal(together, cloud);
}

TEST(Ply, BatchesEndWithTheVisitorsErrorOrThatOfTheFile) {
  const TempFolder folder;
  const auto path = folder.path() / "cloud.ply";
  ASSERT_TRUE(write_ply(path, testing::sample_cloud(100)));
  int calls = 0;
  const auto stopped = read_ply_batches(path, 10, [&](PointCloud&&) -> Expected<void> {
    return ++calls == 2 ? Expected<void>(fail(ErrorCode::kCancelled, "enough")) : Expected<void>();
  });
  EXPECT_EQ(stopped.error().code, ErrorCode::kCancelled);
  EXPECT_EQ(calls, 2);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  const auto cut = read_ply_batches(path, 10, [](PointCloud&&) -> Expected<void> { return {}; });
  EXPECT_EQ(cut.error().code, ErrorCode::kParse);
}

TEST(Ply, CloudWithoutChannelsStaysWithout) {
  const TempFolder folder;
  const PointCloud cloud = {.points = {{1, 2, 3}}};
  ASSERT_TRUE(write_ply(folder.path() / "a.ply", cloud));
  const auto back = read_ply(folder.path() / "a.ply");
  ASSERT_TRUE(back);
  testing::expect_equal(*back, cloud);
}

TEST(Ply, AnEmptyCloudIsACloud) {
  const TempFolder folder;
  ASSERT_TRUE(write_ply(folder.path() / "a.ply", PointCloud{}));
  const auto back = read_ply(folder.path() / "a.ply");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_TRUE(back->empty());
}

TEST(Ply, BigEndianAnyOrderAnyTypeListsAndOtherElements) {
  std::string file =
      "ply\r\nformat binary_big_endian 1.0\ncomment x\nobj_info y\n"
      "element camera 1\nproperty list ushort short values\n"
      "element vertex 2\nproperty uchar diffuse_blue\nproperty double z\nproperty int y\n"
      "property list uchar float unused\nproperty short x\nproperty uchar diffuse_red\n"
      "property uchar diffuse_green\nproperty float scalar_Intensity\nend_header\n";
  file += bytes_of<std::uint16_t>(2, std::endian::big);
  file += bytes_of<std::int16_t>(7, std::endian::big) + bytes_of<std::int16_t>(8, std::endian::big);
  for (int i = 0; i < 2; ++i) {
    file += bytes_of<std::uint8_t>(3, std::endian::big);
    file +=
        bytes_of(-1.5 - i, std::endian::big) + bytes_of<std::int32_t>(-70000 + i, std::endian::big);
    file += bytes_of<std::uint8_t>(1, std::endian::big) + bytes_of(1e30F, std::endian::big);
    file += bytes_of<std::int16_t>(-300, std::endian::big);
    file +=
        bytes_of<std::uint8_t>(1, std::endian::big) + bytes_of<std::uint8_t>(2, std::endian::big);
    file += bytes_of(0.25F, std::endian::big);
  }
  const TempFolder folder;
  const auto cloud = read_ply(folder.file("a.ply", file));
  ASSERT_TRUE(cloud) << cloud.error().message;
  EXPECT_THAT(
      cloud->points,
      ElementsAre(Eigen::Vector3f(-300, -70000, -1.5), Eigen::Vector3f(-300, -69999, -2.5)));
  EXPECT_EQ(cloud->colors[0], (Rgb8{1, 2, 3}));
  EXPECT_EQ(cloud->intensities[1], 0.25F);
}

TEST(Ply, FloatColorsCountFromZeroToOne) {
  const TempFolder folder;
  const auto cloud =
      read_ply(folder.file("a.ply",
                           "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                           "property float y\nproperty float z\nproperty float red\n"
                           "property float green\nproperty float blue\nend_header\n"
                           "1 2 3 0 0.5 1"));
  ASSERT_TRUE(cloud) << cloud.error().message;
  EXPECT_EQ(cloud->colors.at(0), (Rgb8{0, 128, 255}));
}

struct BadPly {
  const char* content;
  const char* says;
};
class MalformedPly : public ::testing::TestWithParam<BadPly> {};
#define VERTEX "property float x\nproperty float y\nproperty float z\nend_header\n"
INSTANTIATE_TEST_SUITE_P(
    Ply,
    MalformedPly,
    ::testing::Values(
        BadPly{"", "empty"},
        BadPly{"hello\n", "not a PLY"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 2\n", "end_header"},
        BadPly{"ply\nelement vertex 0\n" VERTEX, "no format"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex -1\n" VERTEX, "element vertex -1"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n" VERTEX, "quad"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 1000000000000\n" VERTEX "1 2 3\n",
               "truncated"},
        BadPly{"ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\n" VERTEX,
               "truncated"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 2\n" VERTEX "1.0 2.0 3.0\n", "truncated"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 1\n" VERTEX "1 two 3\n", "'two'"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 2\n" VERTEX "nan 2 3\n1 nan 3\n",
               "none of its 2"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 1\n" VERTEX "1 inf 3\n", "has a position"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 1\n" VERTEX "1 1e300 3\n", "has a position"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
               "no x, y and z"},
        BadPly{"ply\nformat ascii 1.0\nelement face 1\nproperty int a\nend_header\n1\n",
               "'vertex'"},
        BadPly{"ply\nformat ascii 1.0\nelement vertex 1\n" VERTEX "678016.1234 5403456.123 412.9\n",
               "subtract a common offset"}));
#undef VERTEX

TEST_P(MalformedPly, IsAParseErrorNamingFileCauseAndNextStep) {
  const TempFolder folder;
  const auto cloud = read_ply(folder.file("bad.ply", GetParam().content));
  ASSERT_FALSE(cloud);
  EXPECT_EQ(cloud.error().code, ErrorCode::kParse);
  EXPECT_THAT(cloud.error().message,
              AllOf(HasSubstr("bad.ply"), HasSubstr(GetParam().says), HasSubstr(";")));
}

TEST(Ply, MissingFileAndFolderAreNotFoundAndNotAFile) {
  const TempFolder folder;
  EXPECT_EQ(read_ply(folder.path() / "none.ply").error().code, ErrorCode::kNotFound);
  EXPECT_EQ(read_ply(folder.path()).error().code, ErrorCode::kParse);
}

TEST(Ply, EveryTruncationIsAnError) {
  const TempFolder folder;
  ASSERT_TRUE(write_ply(folder.path() / "a.ply", testing::sample_cloud(5)));
  const std::string good = testing::content_of(folder.path() / "a.ply");
  for (std::size_t size = 0; size < good.size(); ++size) {
    const auto cloud = read_ply(folder.file("cut.ply", good.substr(0, size)));
    ASSERT_FALSE(cloud) << size;
    ASSERT_EQ(cloud.error().code, ErrorCode::kParse);
  }
}

TEST(Ply, RandomDamageNeverCrashes) {
  const TempFolder folder;
  for (const PlyFormat format : {PlyFormat::kAscii, PlyFormat::kBinaryLittleEndian}) {
    ASSERT_TRUE(write_ply(folder.path() / "a.ply", testing::sample_cloud(20), {.format = format}));
    const std::string good = testing::content_of(folder.path() / "a.ply");
    for (std::uint64_t i = 0; i < 400; ++i) {
      const auto path = folder.file("bad.ply", testing::mutated(good, i));
      if (const auto cloud = read_ply(path)) {
        EXPECT_TRUE(validate(*cloud));
      }
      static_cast<void>(read_ply_columns(path));
      static_cast<void>(read_ply_mesh(path));
    }
  }
}

TEST(PlyMesh, PolygonsBecomeFansWithTheirLabel) {
  const TempFolder folder;
  const auto mesh = read_ply_mesh(folder.file(
      "m.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 3\nproperty list uchar int vertex_index\nproperty uchar label\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 7\n3 3 2 1 2\n2 0 1 9\n"));
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->vertices.size(), 4U);
  using Triangle = std::array<std::uint32_t, 3>;
  EXPECT_THAT(mesh->triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{3, 2, 1}));
  EXPECT_THAT(mesh->labels, ElementsAre(7, 7, 2));
}

TEST(PlyMesh, FacesOfMissingVerticesAreRefused) {
  const TempFolder folder;
  const auto mesh = read_ply_mesh(folder.file(
      "m.ply",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0 1\n"));
  ASSERT_FALSE(mesh);
  EXPECT_THAT(mesh.error().message, HasSubstr("face 0"));
}

TEST(PlyColumns, AreFoundByName) {
  const TempFolder folder;
  const auto table =
      read_ply_columns(folder.file("t.ply",
                                   "ply\nformat ascii 1.0\nelement vertex 2\nproperty uchar "
                                   "label\nproperty list uchar int skip\n"
                                   "property double drone\nend_header\n1 2 8 9 0.5\n3 0 1e10\n"));
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_EQ(table->size(), 2U);
  ASSERT_NE(table->find("drone"), nullptr);
  EXPECT_THAT(*table->find("drone"), ElementsAre(0.5, 1e10));
  EXPECT_THAT(*table->find("label"), ElementsAre(1.0, 3.0));
  EXPECT_EQ(table->find("skip"), nullptr);
}

TEST(PlyColumns, TruthSamplesAndMeshOfADataSetAreRead) {
  const auto truth = testing::test_data("block-11/truth");
  if (!truth) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  const auto table = read_ply_columns(*truth / "samples.ply");
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_EQ(table->size(), 112'651U);
  for (const char* const name : {"label", "drone", "vehicle"})
    ASSERT_NE(table->find(name), nullptr);
  const auto mesh = read_ply_mesh(*truth / "mesh.ply");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->vertices.size(), 345'475U);
  EXPECT_EQ(mesh->labels.size(), mesh->triangles.size());
}

TEST(Ply, RealFilesOfOtherProgramsGivePointsOrAClearError) {
  const auto data = testing::test_data("");
  if (!data) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  const auto scan = read_ply(*data / "pairs/street-scans/source.ply");
  ASSERT_TRUE(scan) << scan.error().message;
  EXPECT_EQ(scan->size(), 69'792U);
  EXPECT_EQ(scan->intensities.size(), 69'792U);
  std::size_t good = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(*data / "formats/pdal/test/data/ply")) {
    const auto cloud = read_ply(entry.path());
    good += cloud ? 1 : 0;
    if (!cloud) {
      EXPECT_THAT(cloud.error().message, HasSubstr(entry.path().filename().string()));
    }
  }
  EXPECT_GE(good, 5U);
}

}  // namespace
}  // namespace hybridfusion
