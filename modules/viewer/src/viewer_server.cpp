#include "served_file.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <httplib.h>

namespace hybridfusion {
namespace {

constexpr const char* kAddress = "127.0.0.1";
constexpr std::size_t kThreads = 16;  // a browser keeps six connections open
constexpr std::size_t kChunkBytes = 64U << 10U;
constexpr int kTimeout_s = 10;

constexpr const char* kPagePolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; "
    "img-src 'self' data: blob:; connect-src 'self'; worker-src 'self' blob:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
constexpr const char* kDocumentPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; img-src data:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

struct Entry {
  OpenContent content;
  std::string content_type = {};
  const char* policy = kPagePolicy;
};

void refuse(httplib::Response& response, int status, std::string text) {
  response.status = status;
  response.set_content(std::move(text) + "\n", "text/plain; charset=utf-8");
}

}  // namespace

struct ViewerServer::Impl {
  httplib::Server server;
  std::map<std::string, Entry, std::less<>> entries;
  int port = 0;

  [[nodiscard]] bool is_own_host(const httplib::Request& request) const {
    if (request.get_header_value_count("Host") != 1) return false;
    const std::string host = request.get_header_value("Host");
    return host == fmt::format("{}:{}", kAddress, port) ||
           host == fmt::format("localhost:{}", port);
  }

  void answer(httplib::Request& request, httplib::Response& response) const {
    request.ranges.clear();  // the library would cut answers, refusals too, by them once more
    if (!is_own_host(request)) return refuse(response, 403, "wrong Host");
    if (request.method != "GET" && request.method != "HEAD") {
      response.set_header("Allow", "GET, HEAD");
      return refuse(response, 405, "only GET and HEAD");
    }
    const auto found = entries.find(request.path);
    if (found == entries.end()) return refuse(response, 404, "no such file");
    send(request, found->second, response);
  }

  static void send(const httplib::Request& request,
                   const Entry& entry,
                   httplib::Response& response) {
    const std::uint64_t size = entry.content.size();
    response.set_header("Content-Security-Policy", entry.policy);
    response.set_header("Accept-Ranges", "bytes");
    ByteRange range{.first = 0, .last = size == 0 ? 0 : size - 1};
    response.status = 200;
    if (request.has_header("Range")) {
      const auto asked = request.get_header_value_count("Range") == 1
                             ? parse_range(request.get_header_value("Range"), size)
                             : std::nullopt;
      if (!asked) {
        response.set_header("Content-Range", fmt::format("bytes */{}", size));
        return refuse(response, 416, "one range within the file, please");
      }
      range = *asked;
      response.status = 206;
      response.set_header("Content-Range",
                          fmt::format("bytes {}-{}/{}", range.first, range.last, size));
    }
    if (size == 0) return response.set_content("", entry.content_type);
    response.set_content_provider(
        range.last - range.first + 1,
        entry.content_type,
        [&entry, range](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
          std::array<char, kChunkBytes> buffer;
          const std::size_t got = entry.content.read(
              range.first + offset, std::span(buffer).first(std::min(length, buffer.size())));
          return got > 0 && sink.write(buffer.data(), got);
        });
  }
};

ViewerServer::ViewerServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ViewerServer::ViewerServer(ViewerServer&&) noexcept = default;
ViewerServer& ViewerServer::operator=(ViewerServer&&) noexcept = default;
ViewerServer::~ViewerServer() = default;

Expected<ViewerServer> ViewerServer::open(const std::filesystem::path& root,
                                          const std::vector<ServedFile>& files,
                                          int port) {
  auto impl = std::make_unique<Impl>();
  for (const ServedFile& file : files) {
    HF_TRY(OpenContent content, OpenContent::open(file.root.empty() ? root : file.root, file));
    Entry entry{.content = std::move(content), .content_type = file.content_type};
    if (file.policy == ContentPolicy::kDocument) entry.policy = kDocumentPolicy;
    impl->entries.insert_or_assign(file.url, std::move(entry));
  }
  httplib::Server& server = impl->server;
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };  // it deletes it
  server.set_read_timeout(kTimeout_s);
  server.set_write_timeout(kTimeout_s);
  server.set_keep_alive_max_count(1000);
  server.set_payload_max_length(0);
  server.set_tcp_nodelay(true);
  server.set_socket_options([](socket_t socket) {
    // The library's default lets another program listen on the same port and take half the
    // requests.
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
  server.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cross-Origin-Resource-Policy", "same-origin"},
                              {"Cross-Origin-Opener-Policy", "same-origin"},
                              {"Cache-Control", "no-cache"}});
  server.set_pre_routing_handler([own = impl.get()](const auto& request, auto& response) {
    // The request is the library's own local variable, handed out as const.
    own->answer(const_cast<httplib::Request&>(request), response);
    return httplib::Server::HandlerResponse::Handled;
  });
  impl->port = port == 0                             ? server.bind_to_any_port(kAddress)
               : server.bind_to_port(kAddress, port) ? port
                                                     : -1;
  if (impl->port <= 0) {
    return fail(
        ErrorCode::kIo,
        fmt::format("port {} of {} cannot be opened; choose another --port, or 0 for a free "
                    "one",
                    port,
                    kAddress));
  }
  return ViewerServer(std::move(impl));
}

int ViewerServer::port() const {
  return impl_->port;
}

std::string ViewerServer::url() const {
  return fmt::format("http://{}:{}/", kAddress, impl_->port);
}

Expected<void> ViewerServer::serve(const std::stop_token& stop) {
  std::atomic<bool> ended = false;
  // The server can only be stopped once it runs.
  std::jthread stopper([&](const std::stop_token& end) {
    while (!ended && !end.stop_requested()) {
      if (stop.stop_requested() && impl_->server.is_running()) impl_->server.stop();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  const bool orderly = impl_->server.listen_after_bind();
  ended = true;
  if (!orderly && !stop.stop_requested()) {
    return fail(ErrorCode::kIo, fmt::format("the server at {} broke down; start it again", url()));
  }
  return {};
}

}  // namespace hybridfusion
