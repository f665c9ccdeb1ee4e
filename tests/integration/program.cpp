#include "program.hpp"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hybridfusion::testing {
namespace {

void redirect(int descriptor, const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || ::dup2(file, descriptor) < 0) _exit(126);
  ::close(file);
}

void limit_file_size(std::uint64_t bytes) {
  const rlimit limit{.rlim_cur = bytes, .rlim_max = bytes};
  if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(126);
}

[[noreturn]] void become_program(const std::vector<std::string>& arguments,
                                 const Adversity& adversity,
                                 const std::filesystem::path& out,
                                 const std::filesystem::path& err) {
  redirect(STDOUT_FILENO, out);
  redirect(STDERR_FILENO, err);
  if (adversity.max_file_bytes > 0) limit_file_size(adversity.max_file_bytes);
  std::vector<std::string> owned = {HF_PROGRAM};
  owned.insert(owned.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& argument : owned) argv.push_back(argument.data());
  argv.push_back(nullptr);
  ::execv(HF_PROGRAM, argv.data());
  _exit(127);
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& arguments, const Adversity& adversity) {
  const std::string base =
      (std::filesystem::temp_directory_path() / ("hf_program_" + std::to_string(::getpid())))
          .string();
  const std::filesystem::path out = base + ".out";
  const std::filesystem::path err = base + ".err";
  const pid_t child = ::fork();
  if (child == 0) become_program(arguments, adversity, out, err);
  int status = 0;
  const auto start = std::chrono::steady_clock::now();
  bool stopped = false;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    if (adversity.signal_after_s > 0.0 && !stopped && passed.count() > adversity.signal_after_s) {
      ::kill(child, adversity.signal);
      stopped = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ProgramResult result{
      .exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
      .out = read_file(out),
      .err = read_file(err)};
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return result;
}

void ProgramTest::SetUp() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  folder_ = std::filesystem::temp_directory_path() / ("hf_" + std::to_string(::getpid()) + "_" +
                                                      info->test_suite_name() + "_" + info->name());
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
}

void ProgramTest::TearDown() {
  std::filesystem::remove_all(folder_);
}

std::string ProgramTest::write(const std::string& name, const std::string& content) const {
  std::filesystem::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name, std::ios::binary) << content;
  return path(name);
}

std::optional<std::filesystem::path> test_data() {
  const char* root = std::getenv("HYBRIDFUSION_TEST_DATA");
  if (root == nullptr) return std::nullopt;
  return root;
}

std::string read_file(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace hybridfusion::testing
