#include "raw_http.hpp"

#include <cstdlib>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

namespace hybridfusion::testing {

HttpAnswer ask(int port, const std::string& bytes, double patience_s) {
  const int connection = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  ::inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
  const auto seconds = static_cast<time_t>(patience_s);
  const timeval timeout{
      .tv_sec = seconds,
      .tv_usec = static_cast<suseconds_t>(1e6 * (patience_s - static_cast<double>(seconds)))};
  ::setsockopt(connection, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof(timeout));
  HttpAnswer answer;
  std::string received;
  if (::connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0) {
    ::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    char buffer[65536];
    for (ssize_t got = 0; (got = ::recv(connection, buffer, sizeof(buffer), 0)) > 0;) {
      received.append(buffer, static_cast<std::size_t>(got));
    }
  }
  ::close(connection);
  const std::size_t end = received.find("\r\n\r\n");
  if (received.rfind("HTTP/1.1 ", 0) != 0 || end == std::string::npos) return answer;
  answer.status = std::atoi(received.c_str() + 9);
  answer.headers = received.substr(0, end + 2);
  answer.body = received.substr(end + 4);
  return answer;
}

}  // namespace hybridfusion::testing
