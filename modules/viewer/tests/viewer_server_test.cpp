#include "raw_http.hpp"
#include "served_file.hpp"
#include "temp_folder.hpp"

#include <hybridfusion/viewer/viewer_server.hpp>
#include <hybridfusion/viewer/web_page.hpp>

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::HttpAnswer;
using ::testing::Not;
using testing::TempFolder;

/// A server over a small workspace, with a secret beside it that no request may reach.
class ViewerServerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("secret.txt", "SECRET");
    folder_.write("ws/unlisted.txt", "SECRET");
    for (int i = 0; i < 1000; ++i) content_ += "line " + std::to_string(i) + "\n";
    files_ = {{"/", "text/html; charset=utf-8", std::string_view("<p>page</p>")},
              {"/data.bin", "application/octet-stream", folder_.write("ws/data.bin", content_)},
              {"/report",
               "text/html; charset=utf-8",
               folder_.write("ws/report.html", "<p>report</p>"),
               ContentPolicy::kDocument},
              {"/empty", "text/plain", folder_.write("ws/empty", "")}};
    auto server = ViewerServer::open(folder_.path() / "ws", files_, 0);
    ASSERT_TRUE(server) << server.error().message;
    server_.emplace(*std::move(server));
    thread_ = std::jthread([this](const std::stop_token& stop) { served_ = server_->serve(stop); });
  }
  void TearDown() override {
    thread_.request_stop();
    thread_.join();
    EXPECT_TRUE(served_) << served_.error().message;
  }

  [[nodiscard]] HttpAnswer ask(const std::string& request_line,
                               const std::string& headers = "") const {
    return testing::ask(server_->port(),
                        request_line +
                            " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server_->port()) +
                            "\r\nConnection: close\r\n" + headers + "\r\n");
  }

  TempFolder folder_;
  std::string content_ = {};
  std::vector<ServedFile> files_ = {};
  std::optional<ViewerServer> server_ = {};
  Expected<void> served_ = {};
  std::jthread thread_ = {};
};

TEST_F(ViewerServerTest, GivesWhatIsListed) {
  const HttpAnswer page = ask("GET /");
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.body, "<p>page</p>");
  const HttpAnswer data = ask("GET /data.bin");
  EXPECT_EQ(data.status, 200);
  EXPECT_EQ(data.body, content_);
  EXPECT_EQ(ask("GET /empty").status, 200);
  EXPECT_EQ(ask("GET /data.bin?x=1").body, content_) << "a query is no part of the name";
}

TEST_F(ViewerServerTest, HeadHasTheSameHeadersAndNoBody) {
  const HttpAnswer answer = ask("HEAD /data.bin");
  EXPECT_EQ(answer.status, 200);
  EXPECT_THAT(answer.headers, HasSubstr("Content-Length: " + std::to_string(content_.size())));
  EXPECT_EQ(answer.body, "");
}

TEST_F(ViewerServerTest, AllAnswersForbidForeignScriptsAndSniffing) {
  EXPECT_THAT(ask("GET /").headers,
              AllOf(HasSubstr("default-src 'none'"),
                    HasSubstr("script-src 'self'"),
                    HasSubstr("worker-src 'self' blob:"),
                    HasSubstr("nosniff"),
                    HasSubstr("frame-ancestors 'none'"),
                    Not(HasSubstr("unsafe-eval"))));
  EXPECT_THAT(ask("GET /report").headers,
              AllOf(HasSubstr("default-src 'none'"), Not(HasSubstr("script-src"))));
  EXPECT_THAT(ask("GET /nothing").headers, HasSubstr("nosniff"));
}

TEST_F(ViewerServerTest, NothingBesideTheListIsReached) {
  for (const char* path : {"/../secret.txt",
                           "/unlisted.txt",
                           "/..%2fsecret.txt",
                           "/%2e%2e/secret.txt",
                           "//data.bin",
                           "/./data.bin",
                           "/data.bin/",
                           "/data.bin%00",
                           "/ws/data.bin",
                           "/etc/passwd",
                           "/DATA.BIN",
                           "/report/../../secret.txt",
                           "/\\..\\secret.txt",
                           "/data.bin/../../secret.txt"}) {
    const HttpAnswer answer = ask(std::string("GET ") + path);
    EXPECT_TRUE(answer.status == 404 || answer.status == 400) << path << " " << answer.status;
    EXPECT_THAT(answer.body, Not(HasSubstr("SECRET"))) << path;
  }
}

TEST_F(ViewerServerTest, OneRangeIsServed) {
  const HttpAnswer middle = ask("GET /data.bin", "Range: bytes=10-19\r\n");
  EXPECT_EQ(middle.status, 206);
  EXPECT_EQ(middle.body, content_.substr(10, 10));
  EXPECT_THAT(middle.headers,
              HasSubstr("Content-Range: bytes 10-19/" + std::to_string(content_.size())));
  EXPECT_EQ(ask("GET /data.bin", "Range: bytes=-5\r\n").body, content_.substr(content_.size() - 5));
  EXPECT_EQ(ask("GET /data.bin", "Range: bytes=100-\r\n").body, content_.substr(100));
  EXPECT_EQ(ask("GET /data.bin", "Range: bytes=0-999999\r\n").body, content_);
}

TEST_F(ViewerServerTest, SeveralRangesAndRangesOutsideAreRefused) {
  std::string many = "Range: bytes=0-9";
  for (int i = 0; i < 200; ++i) many += ",0-9";
  for (const std::string& range : {std::string("Range: bytes=0-1,4-5"),
                                   many,
                                   std::string("Range: bytes=9-1"),
                                   std::string("Range: bytes=99999999-"),
                                   std::string("Range: lines=1-2"),
                                   std::string("Range: bytes=-0"),
                                   std::string("Range: bytes=18446744073709551616-"),
                                   std::string("Range: bytes=0-1\r\nRange: bytes=2-3")}) {
    const HttpAnswer answer = ask("GET /data.bin", range + "\r\n");
    EXPECT_EQ(answer.status, 416) << range;
    EXPECT_LT(answer.body.size(), 200U) << range;
  }
}

TEST_F(ViewerServerTest, OnlyItsOwnNameAsHost) {
  const std::string port = std::to_string(server_->port());
  const auto with_host = [&](const std::string& headers) {
    return testing::ask(server_->port(),
                        "GET /data.bin HTTP/1.1\r\nConnection: close\r\n" + headers + "\r\n");
  };
  EXPECT_EQ(with_host("Host: localhost:" + port + "\r\n").status, 200);
  for (const std::string& headers : {std::string("Host: evil.example:") + port + "\r\n",
                                     std::string("Host: 127.0.0.1\r\n"),
                                     std::string("Host: 127.0.0.1:1\r\n"),
                                     std::string(""),
                                     std::string("Host:\r\n"),
                                     "Host: 127.0.0.1:" + port + "\r\nHost: evil.example\r\n",
                                     "Host: 127.0.0.1:" + port + ".evil.example\r\n"}) {
    const HttpAnswer answer = with_host(headers);
    EXPECT_EQ(answer.status, 403) << headers;
    EXPECT_THAT(answer.body, Not(HasSubstr("line"))) << headers;
  }
}

TEST_F(ViewerServerTest, OnlyGetAndHead) {
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH"}) {
    const HttpAnswer answer = ask(std::string(method) + " /data.bin", "Content-Length: 0\r\n");
    EXPECT_EQ(answer.status, 405) << method;
    EXPECT_THAT(answer.body, Not(HasSubstr("line"))) << method;
  }
}

TEST_F(ViewerServerTest, GarbageIsAnsweredOrClosedAndTheServerGoesOn) {
  for (const std::string& bytes : {std::string("\r\n\r\n"),
                                   std::string("GET\r\n\r\n"),
                                   std::string(20000, 'A') + "\r\n\r\n",
                                   "GET / HTTP/1.1\r\n" + std::string(20000, 'B') + ": x\r\n\r\n",
                                   std::string("\x16\x03\x01\x02\x00\x01\x00", 7) + "\r\n\r\n"}) {
    EXPECT_THAT(testing::ask(server_->port(), bytes, 0.5).body, Not(HasSubstr("line")));
  }
  EXPECT_EQ(ask("GET /").status, 200);
}

TEST_F(ViewerServerTest, WhatReplacesAFileLaterIsNotServed) {
  std::filesystem::remove(folder_.path() / "ws/data.bin");
  std::filesystem::create_symlink(folder_.path() / "secret.txt", folder_.path() / "ws/data.bin");
  EXPECT_EQ(ask("GET /data.bin").body, content_);
}

TEST(ViewerServer, LinksOutOfTheWorkspaceAreRefused) {
  const TempFolder folder;
  folder.write("secret.txt", "SECRET");
  folder.write("ws/real.txt", "real");
  const auto root = folder.path() / "ws";
  std::filesystem::create_symlink("../secret.txt", root / "out");
  std::filesystem::create_symlink("real.txt", root / "in");
  std::filesystem::create_symlink("loop", root / "loop");
  std::filesystem::create_directory_symlink("..", root / "up");
  const auto opened = [&](const std::filesystem::path& path) {
    return ViewerServer::open(root, {{"/x", "text/plain", path}}, 0);
  };
  EXPECT_TRUE(opened(root / "in"));
  for (const char* name : {"out", "loop", "up/secret.txt", "missing", "../secret.txt", "."}) {
    const auto server = opened(root / name);
    ASSERT_FALSE(server) << name;
    EXPECT_EQ(server.error().code, ErrorCode::kNotFound) << name;
  }
}

TEST(ViewerServer, APortThatIsTakenIsAnError) {
  const auto first = ViewerServer::open("/", {}, 0);
  ASSERT_TRUE(first);
  const auto second = ViewerServer::open("/", {}, first->port());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kIo);
  EXPECT_THAT(second.error().message, HasSubstr(std::to_string(first->port())));
}

TEST(ViewerPage, NeedsNothingFromTheNetwork) {
  for (const ServedFile& file : viewer_page()) {
    const auto bytes = std::get<std::string_view>(file.content);
    EXPECT_GT(bytes.size(), 1000U) << file.url;
    if (file.url == "/") {
      EXPECT_THAT(std::string(bytes),
                  AllOf(Not(HasSubstr("https://")), Not(HasSubstr("<script>"))));
    }
  }
}

TEST(ParseRange, TakesOneRangeWithinTheFile) {
  EXPECT_EQ(parse_range("bytes=2-4", 10)->last, 4U);
  EXPECT_EQ(parse_range("bytes=-4", 10)->first, 6U);
  EXPECT_EQ(parse_range("bytes=-40", 10)->first, 0U);
  EXPECT_EQ(parse_range("bytes=3-", 10)->last, 9U);
  for (const char* text : {"bytes=",
                           "bytes=-",
                           "bytes=a-b",
                           "bytes=10-",
                           "bytes=1",
                           "bytes= 1-2",
                           "bytes=1-2,",
                           "bytes=+1-2",
                           "bytes=1--2",
                           ""}) {
    EXPECT_FALSE(parse_range(text, 10)) << text;
  }
  EXPECT_FALSE(parse_range("bytes=0-", 0));
}

}  // namespace
}  // namespace hybridfusion
