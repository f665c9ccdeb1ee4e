#include "program.hpp"

#include <hybridfusion/io/jpeg.hpp>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

namespace hybridfusion::testing {
namespace {

using ::testing::HasSubstr;

class BadInput : public ProgramTest {
 protected:
  /// Exit code 3, a message that names `named`, nothing on stdout.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& named) const {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 3) << ::testing::PrintToString(arguments) << result.err;
    EXPECT_THAT(result.err, HasSubstr(named));
    EXPECT_TRUE(result.out.empty()) << result.out;
  }
  [[nodiscard]] std::vector<std::string> reconstruct(const std::string& images) const {
    return {"reconstruct", "--images", images, "--output", path("ws")};
  }
  [[nodiscard]] std::vector<std::string> map(const std::string& bag) const {
    return {"map", "--bag", bag, "--output", path("ws")};
  }
  [[nodiscard]] std::vector<std::string> register_clouds(const std::string& vision,
                                                         const std::string& lidar) const {
    return {"register", "--vision", vision, "--lidar", lidar, "--output", path("ws")};
  }
};

const std::string kPlyHeader =
    "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
    "property float z\nend_header\n";

std::string ply_of(int count) {
  std::string text = kPlyHeader;
  text.replace(text.find("{}"), 2, std::to_string(count));
  for (int i = 0; i < count; ++i) {
    text += std::to_string(i % 10) + " " + std::to_string(i / 10) + " 0\n";
  }
  return text;
}

TEST_F(BadInput, MissingFilesAndFoldersAreNamed) {
  expect_refused(reconstruct(path("no_folder")), "no_folder");
  expect_refused(map(path("no.bag")), "no.bag");
  expect_refused(register_clouds(path("no.ply"), path("no.ply")), "no.ply");
  expect_refused({"evaluate", "--workspace", path("no_ws")}, "no_ws");
  expect_refused({"evaluate", "--vision", path("no.ply"), "--lidar", path("no.ply")}, "no.ply");
  expect_refused({"convert", path("no.ply"), path("out.pcd")}, "no.ply");
  expect_refused({"config", "--config", path("no.yaml")}, "no.yaml");
}

TEST_F(BadInput, AFolderWithoutPhotosIsNamed) {
  std::filesystem::create_directories(path("empty"));
  expect_refused(reconstruct(path("empty")), "empty");
  write("texts/a.txt", "hello");
  write("texts/b.txt", "world");
  expect_refused(reconstruct(path("texts")), "texts");
}

TEST_F(BadInput, AFolderOfBrokenPhotosIsRefused) {
  write("images/a.jpg", "");
  write("images/b.jpg", "this is text, not a photo");
  expect_refused(reconstruct(path("images")), "images");
}

TEST_F(BadInput, PhotosThatShowNothingAreRefused) {
  Image8 image{.width = 64, .height = 48, .channels = 3};
  image.pixels.assign(64 * 48 * 3, 90);
  std::filesystem::create_directories(path("images"));
  for (const char* name : {"a.jpg", "b.jpg", "c.jpg", "d.jpg"}) {
    ASSERT_TRUE(write_jpeg(folder_ / "images" / name, image, 90));
  }
  expect_refused(reconstruct(path("images")), "three photos");
}

TEST_F(BadInput, CloudsInAnArbitraryFrameAreNotRegistered) {
  const std::string cloud = write("vision/dense.ply", ply_of(100));
  write("vision/frame.json", "{}");
  expect_refused(register_clouds(cloud, write("l.ply", ply_of(100))), "--gcp");
}

TEST_F(BadInput, EmptyAndForeignRecordingsAreRefused) {
  expect_refused(map(write("empty.bag", "")), "empty.bag");
  expect_refused(map(write("text.bag", "this is text, not a bag")), "text.bag");
}

TEST_F(BadInput, EmptyCloudsAreRefused) {
  const std::string good = write("good.ply", ply_of(100));
  expect_refused(register_clouds(write("empty.ply", ""), good), "empty.ply");
  expect_refused(register_clouds(good, write("none.ply", ply_of(0))), "none.ply");
  expect_refused(register_clouds(write("empty.pcd", ""), good), "empty.pcd");
  std::string cut = ply_of(100);
  cut.resize(cut.size() / 2);
  expect_refused(register_clouds(good, write("cut.ply", cut)), "cut.ply");
}

TEST_F(BadInput, AFlatFieldIsNoResultButNoError) {
  const std::string field = write("field.ply", ply_of(5000));
  const ProgramResult result = run_program(register_clouds(field, field));
  EXPECT_EQ(result.exit_code, 4) << result.err;
  const auto json = nlohmann::json::parse(read_file(path("ws/registration/registration.json")));
  EXPECT_EQ(json.at("status"), "refused");
  EXPECT_FALSE(json.at("reason").get<std::string>().empty());
  EXPECT_FALSE(std::filesystem::exists(path("ws/fused/fused.ply")));
}

TEST_F(BadInput, ErrorsAreJsonOnStdoutWhenAskedFor) {
  const ProgramResult result =
      run_program({"map", "--bag", path("no.bag"), "--output", path("ws"), "--json"});
  EXPECT_EQ(result.exit_code, 3);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("status"), "error");
  EXPECT_EQ(json.at("exit_code"), 3);
  EXPECT_THAT(json.at("message").get<std::string>(), HasSubstr("no.bag"));
}

TEST_F(BadInput, AWorkspaceInUseIsLeftAlone) {
  std::filesystem::create_directories(path("ws"));
  const int lock = ::open(path("ws/.lock").c_str(), O_CREAT | O_RDWR, 0600);
  ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
  const ProgramResult result = run_program(map(path("any.bag")));
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.err, HasSubstr("another hybridfusion process"));
  ::close(lock);
}

TEST_F(BadInput, AnOutputThatCannotBeCreatedIsNamed) {
  write("file", "in the way");
  const ProgramResult result =
      run_program({"map", "--bag", path("any.bag"), "--output", path("file/ws")});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.err, HasSubstr("file/ws"));
}

TEST_F(BadInput, ARecordingWithoutImuListsItsTopics) {
  HF_NEEDS_TEST_DATA();
  const std::string bag = (*test_data() / "block-12-avia/street.bag").string();
  auto arguments = map(bag);
  arguments.insert(arguments.end(), {"--set", "lidar.recording.imu_topic=/no/imu"});
  expect_refused(arguments, "/imu/data");
}

}  // namespace
}  // namespace hybridfusion::testing
