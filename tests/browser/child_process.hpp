#pragma once

#include <map>
#include <string>
#include <vector>

#include <sys/types.h>

namespace hybridfusion::testing {

/// A program in the background, ended with the object.
class ChildProcess {
 public:
  /// @param descriptors  The child's descriptor -> ours, handed over beside stdin, stdout, stderr.
  ChildProcess(const std::vector<std::string>& arguments, const std::map<int, int>& descriptors);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Sends the signal and waits. @returns exit code, or 128 + signal, or -1 when it had to be
  /// killed after `patience_s`.
  int end(int signal, double patience_s);

 private:
  pid_t pid_ = -1;
};

/// Both ends of a pipe, closed with the object unless taken away.
struct Pipe {
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_read();
  void close_write();

  int read_end = -1;
  int write_end = -1;
};

/// Reads up to and without `delimiter`; keeps what follows in `rest`. Empty after `patience_s`.
[[nodiscard]] std::string read_until(int descriptor,
                                     char delimiter,
                                     std::string& rest,
                                     double patience_s);

}  // namespace hybridfusion::testing
