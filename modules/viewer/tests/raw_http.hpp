#pragma once

#include <string>

namespace hybridfusion::testing {

struct HttpAnswer {
  int status = 0;  ///< 0: closed without an answer.
  std::string headers = {};
  std::string body = {};
};

/// Sends these very bytes to the port and reads until the server closes or says nothing for so
/// long: no client library that would tidy up the path first.
[[nodiscard]] HttpAnswer ask(int port, const std::string& bytes, double patience_s = 10.0);

}  // namespace hybridfusion::testing
