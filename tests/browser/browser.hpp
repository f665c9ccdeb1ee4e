#pragma once

#include "child_process.hpp"

#include <hybridfusion/core/photo.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace hybridfusion::testing {

/// Headless Chromium with one page, driven by the Chrome DevTools Protocol over a pipe. WebGL is
/// drawn by SwiftShader, so that no graphics card is needed.
class Browser {
 public:
  /// The program, or nothing where Chromium is not installed.
  [[nodiscard]] static std::optional<std::string> program();

  /// @param profile  Folder for the browser's own files.
  /// @param webgl  False: a browser without WebGL.
  Browser(const std::filesystem::path& profile, bool webgl);

  void open(const std::string& url);
  /// Value of a JavaScript expression; null when it throws.
  [[nodiscard]] nlohmann::json evaluate(const std::string& expression);
  /// Evaluates until the expression is true. @returns false after `patience_s`.
  [[nodiscard]] bool wait_for(const std::string& expression, double patience_s);
  [[nodiscard]] Image8 screenshot();
  /// Errors of the console, exceptions and failed requests so far.
  [[nodiscard]] const std::vector<std::string>& errors() const { return errors_; }

 private:
  nlohmann::json call(const std::string& method, const nlohmann::json& parameters);
  void note(const nlohmann::json& event);

  Pipe to_browser_;
  Pipe from_browser_;
  std::filesystem::path profile_;
  std::unique_ptr<ChildProcess> process_ = {};
  std::string rest_ = {};
  std::string session_ = {};
  int last_id_ = 0;
  std::vector<std::string> errors_ = {};
};

}  // namespace hybridfusion::testing
