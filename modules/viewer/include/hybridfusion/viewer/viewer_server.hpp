#pragma once

#include <hybridfusion/core/error.hpp>

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hybridfusion {

/// Pages may run their own scripts; documents may only show themselves (inline style, data images).
enum class ContentPolicy : std::uint8_t { kPage, kDocument };

/// One thing the server hands out.
struct ServedFile {
  std::string url = {};           ///< "/cloud/vision/octree.bin"; compared byte by byte.
  std::string content_type = {};  ///< "text/html; charset=utf-8"
  /// A file, or bytes that outlive the server.
  std::variant<std::filesystem::path, std::string_view> content = {};
  ContentPolicy policy = ContentPolicy::kPage;
  std::filesystem::path root = {};  ///< Where a file must lie; empty: the root of the server.
};

/// Hands a fixed list of files to a browser on this machine. It listens on 127.0.0.1 only, answers
/// GET and HEAD for exactly the listed URLs, takes one byte range at most, and refuses requests
/// whose Host is not this server (DNS rebinding). Files are opened once, here; whatever happens to
/// their paths later, nothing else is read.
class ViewerServer {
 public:
  /// @param root  Every file without a root of its own must lie in this folder after symbolic
  ///              links are followed.
  /// @param port  0 takes a free one.
  /// @returns kNotFound for a file that is missing, not regular or outside of its root; kIo when
  /// the port is taken.
  [[nodiscard]] static Expected<ViewerServer> open(const std::filesystem::path& root,
                                                   const std::vector<ServedFile>& files,
                                                   int port);
  ViewerServer(ViewerServer&&) noexcept;
  ViewerServer& operator=(ViewerServer&&) noexcept;
  ~ViewerServer();

  [[nodiscard]] int port() const;
  /// "http://127.0.0.1:41234/"
  [[nodiscard]] std::string url() const;
  /// Answers until stop is requested.
  [[nodiscard]] Expected<void> serve(const std::stop_token& stop);

 private:
  struct Impl;
  explicit ViewerServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace hybridfusion
