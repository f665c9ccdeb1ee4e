#include "test_files.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using testing::content_of;
using ::testing::HasSubstr;
using testing::TempFolder;

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const TempFolder folder;
  const auto path = folder.file("a.txt", "old");
  {
    auto file = AtomicFile::create(path);
    ASSERT_TRUE(file);
    file->write(std::string(1'000'000, 'x'));
    EXPECT_EQ(content_of(path), "old");
  }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.txt.part"));
  ASSERT_TRUE(write_file_atomically(path, "new"));
  EXPECT_EQ(content_of(path), "new");
}

TEST(AtomicFile, LargeContentIsWrittenCompletely) {
  const TempFolder folder;
  std::string content;
  for (int i = 0; i < 300'000; ++i) content += static_cast<char>(i * 7 + i / 251);
  auto file = AtomicFile::create(folder.path() / "a");
  ASSERT_TRUE(file);
  for (std::size_t i = 0; i < content.size(); i += 777)
    file->write(std::string_view(content).substr(i, 777));
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(content_of(folder.path() / "a"), content);
}

TEST(AtomicFile, MissingFolderIsNamed) {
  const TempFolder folder;
  const auto file = AtomicFile::create(folder.path() / "none" / "a.txt");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kIo);
  EXPECT_THAT(file.error().message, AllOf(HasSubstr("none/a.txt"), HasSubstr("No such file")));
}

TEST(AtomicFile, ALinkPlantedUnderTheTemporaryNameIsNotFollowed) {
  const TempFolder folder;
  const auto target = folder.file("target", "precious");
  std::filesystem::create_symlink(target, folder.path() / "a.txt.part");
  const auto file = AtomicFile::create(folder.path() / "a.txt");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kIo);
  EXPECT_EQ(content_of(target), "precious");
}

TEST(AtomicFile, NoRoomIsReportedWithPathAndBytesAndLeavesNothing) {
  // A limit on the size of files stands in for a full disk.
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  const rlimit limit = {.rlim_cur = 300'000, .rlim_max = old_limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  const TempFolder folder;
  const auto written = write_file_atomically(folder.path() / "a.txt", std::string(1'000'000, 'x'));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_handler);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kIo);
  EXPECT_THAT(written.error().message, AllOf(HasSubstr("a.txt"), HasSubstr("300000 bytes")));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(AtomicFile, StartIsReplacedWithoutTouchingTheRest) {
  const TempFolder folder;
  const auto path = folder.path() / "a";
  const std::string rest(700'000, 'r');  // more than is buffered
  for (const std::size_t written_first : {std::size_t{0}, rest.size()}) {
    auto file = AtomicFile::create(path);
    ASSERT_TRUE(file);
    file->write("00000");
    file->write(rest.substr(0, written_first));
    file->overwrite_start("12345");
    file->write(rest.substr(written_first));  // goes on at the end
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(content_of(path), "12345" + rest);
  }
}

TEST(AtomicFile, StartLongerThanTheFileIsTheCallersMistake) {
  const TempFolder folder;
  auto file = AtomicFile::create(folder.path() / "a");
  ASSERT_TRUE(file);
  file->write("123");
  EXPECT_THROW(file->overwrite_start("1234"), std::logic_error);
}

TEST(AtomicFile, AFolderInTheWayIsAnError) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.path() / "a" / "b");
  const auto written = write_file_atomically(folder.path() / "a", "x");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, AllOf(HasSubstr("1 bytes"), HasSubstr("/a")));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.part"));
}

TEST(ReadTextFile, IsBounded) {
  const TempFolder folder;
  const auto path = folder.file("a.txt", "hello");
  EXPECT_EQ(read_text_file(path, 5).value(), "hello");
  EXPECT_EQ(read_text_file(path, 4).error().code, ErrorCode::kParse);
  EXPECT_EQ(read_text_file(folder.path() / "b.txt", 4).error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace hybridfusion
