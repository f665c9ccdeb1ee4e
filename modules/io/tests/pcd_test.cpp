#include "mutations.hpp"
#include "sample_cloud.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/pcd.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::TempFolder;

class EveryPcdFormat : public ::testing::TestWithParam<PcdFormat> {};
INSTANTIATE_TEST_SUITE_P(Pcd,
                         EveryPcdFormat,
                         ::testing::Values(PcdFormat::kAscii,
                                           PcdFormat::kBinary,
                                           PcdFormat::kBinaryCompressed));

TEST_P(EveryPcdFormat, CloudReadsBackBitForBit) {
  const TempFolder folder;
  for (const std::size_t count : {0U, 1U, 7U, 5000U}) {
    const PointCloud cloud = testing::sample_cloud(count);
    ASSERT_TRUE(write_pcd(folder.path() / "a.pcd", cloud, {.format = GetParam()}));
    const auto back = read_pcd(folder.path() / "a.pcd");
    ASSERT_TRUE(back) << back.error().message;
    testing::expect_equal(*back, cloud);
  }
}

TEST_P(EveryPcdFormat, EveryTruncationIsAnError) {
  const TempFolder folder;
  ASSERT_TRUE(write_pcd(folder.path() / "a.pcd", testing::sample_cloud(5), {.format = GetParam()}));
  const std::string good = testing::content_of(folder.path() / "a.pcd");
  // The last two bytes of the ascii form are a digit and the line end: a cut digit is a number
  // still.
  for (std::size_t size = 0; size + 2 < good.size(); ++size) {
    const auto cloud = read_pcd(folder.file("cut.pcd", good.substr(0, size)));
    ASSERT_FALSE(cloud) << size;
    ASSERT_EQ(cloud.error().code, ErrorCode::kParse);
  }
}

TEST_P(EveryPcdFormat, RandomDamageNeverCrashes) {
  const TempFolder folder;
  ASSERT_TRUE(
      write_pcd(folder.path() / "a.pcd", testing::sample_cloud(40), {.format = GetParam()}));
  const std::string good = testing::content_of(folder.path() / "a.pcd");
  for (std::uint64_t i = 0; i < 400; ++i) {
    const auto cloud = read_pcd(folder.file("bad.pcd", testing::mutated(good, i)));
    if (cloud) {
      EXPECT_TRUE(validate(*cloud));
    }
  }
}

TEST(Pcd, CompressedFormIsSmallerForRepetitiveData) {
  const TempFolder folder;
  PointCloud cloud;
  for (int i = 0; i < 10'000; ++i)
    cloud.points.emplace_back(static_cast<float>(i % 16), 2.0F, 3.0F);
  ASSERT_TRUE(write_pcd(folder.path() / "a.pcd", cloud));
  EXPECT_LT(std::filesystem::file_size(folder.path() / "a.pcd"), 10'000U);
  testing::expect_equal(read_pcd(folder.path() / "a.pcd").value(), cloud);
}

TEST(Pcd, NoReturnsOfOrganisedCloudsAreDropped) {
  const TempFolder folder;
  const auto cloud =
      read_pcd(folder.file("a.pcd",
                           "# .PCD\nVERSION .7\nFIELDS x y z rgb desc\nSIZE 4 4 4 4 4\n"
                           "TYPE F F F F F\nCOUNT 1 1 1 1 2\nWIDTH 2\nHEIGHT 2\n"
                           "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n"
                           "1 2 3 4.2108e+06 9 9\nnan nan nan 0 9 9\n"
                           "4 5 6 4278190335 9 9\nnan nan nan 0 9 9\n"));
  ASSERT_TRUE(cloud) << cloud.error().message;
  ASSERT_EQ(cloud->size(), 2U);
  EXPECT_EQ(cloud->points[1], Eigen::Vector3f(4, 5, 6));
  EXPECT_EQ(cloud->colors[1], (Rgb8{0, 0, 255}));  // 0xff0000ff
}

struct BadPcd {
  const char* content;
  const char* says;
};
class MalformedPcd : public ::testing::TestWithParam<BadPcd> {};
#define FIELDS "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
INSTANTIATE_TEST_SUITE_P(
    Pcd,
    MalformedPcd,
    ::testing::Values(
        BadPcd{"", "empty"},
        BadPcd{"hello\n", "not a PCD"},
        BadPcd{FIELDS "DATA ascii\n1 2 3\n", "number of points"},
        BadPcd{FIELDS "WIDTH 4294967295\nHEIGHT 4294967295\nPOINTS 1\nDATA binary\n", "fit"},
        BadPcd{FIELDS "WIDTH 2000000000\nHEIGHT 1\nPOINTS 2000000000\nDATA binary\nabc",
               "truncated"},
        BadPcd{FIELDS "POINTS 18446744073709551615\nDATA binary\nabc", "truncated"},
        BadPcd{FIELDS "POINTS 1000000\nDATA binary_compressed\n\x01\x00\x01\x01\xff\xff\xff\x7f",
               "truncated"},
        BadPcd{FIELDS "POINTS 2\nDATA ascii\n1 2 3\n", "truncated"},
        BadPcd{FIELDS "POINTS 1\nDATA ascii\n1 b 3\n", "'b'"},
        BadPcd{FIELDS "POINTS 1\nDATA zip\n1 2 3\n", "'zip'"},
        BadPcd{"FIELDS x y z\nSIZE 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n", "do not match"},
        BadPcd{"FIELDS x y q\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n",
               "no x, y and z"},
        BadPcd{"FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n",
               "unknown type"}));
#undef FIELDS

TEST_P(MalformedPcd, IsAParseErrorNamingFileCauseAndNextStep) {
  const TempFolder folder;
  const auto cloud = read_pcd(folder.file("bad.pcd", GetParam().content));
  ASSERT_FALSE(cloud);
  EXPECT_EQ(cloud.error().code, ErrorCode::kParse);
  EXPECT_THAT(cloud.error().message,
              AllOf(HasSubstr("bad.pcd"), HasSubstr(GetParam().says), HasSubstr(";")));
}

TEST(Pcd, RealFilesOfOtherProgramsGivePointsOrAClearError) {
  const auto folder = testing::test_data("formats/pdal/test/data/pcd");
  if (!folder) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    const auto cloud = read_pcd(entry.path());
    if (!cloud) {
      EXPECT_THAT(cloud.error().message, HasSubstr(entry.path().filename().string()));
    }
  }
}

}  // namespace
}  // namespace hybridfusion
