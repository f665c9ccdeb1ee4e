#include "browser.hpp"

#include <hybridfusion/io/jpeg.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <unistd.h>

namespace hybridfusion::testing {
namespace {

using Json = nlohmann::json;

constexpr double kPatience_s = 60.0;

std::string from_base64(const std::string& text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) continue;
    group = (group << 6U) | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>((group >> static_cast<unsigned>(bits)) & 255U);
  }
  return bytes;
}

}  // namespace

std::optional<std::string> Browser::program() {
  for (const char* path :
       {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"}) {
    if (::access(path, X_OK) == 0) return path;
  }
  return std::nullopt;
}

Browser::Browser(const std::filesystem::path& profile, bool webgl) : profile_(profile) {
  std::vector<std::string> arguments = {"/usr/bin/env",  // its sockets go with the profile
                                        "TMPDIR=" + profile.string(),
                                        *program(),
                                        "--headless=new",
                                        "--no-sandbox",  // tests run as root in containers
                                        "--disable-dev-shm-usage",
                                        "--no-first-run",
                                        "--disable-background-networking",
                                        "--disable-component-update",
                                        "--hide-scrollbars",
                                        "--window-size=1000,640",
                                        "--remote-debugging-pipe",
                                        "--user-data-dir=" + profile.string()};
  if (webgl) {
    arguments.insert(arguments.end(),
                     {"--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"});
  } else {
    arguments.insert(arguments.end(), {"--disable-gpu", "--disable-3d-apis"});
  }
  arguments.emplace_back("about:blank");
  process_ = std::make_unique<ChildProcess>(
      arguments, std::map<int, int>{{3, to_browser_.read_end}, {4, from_browser_.write_end}});
  to_browser_.close_read();
  from_browser_.close_write();
  const Json targets = call("Target.getTargets", Json::object());
  for (const Json& target : targets.value("targetInfos", Json::array())) {
    if (target.value("type", "") != "page") continue;
    session_ = call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}})
                   .value("sessionId", "");
    break;
  }
  for (const char* domain : {"Page.enable", "Runtime.enable", "Log.enable"}) {
    call(domain, Json::object());
  }
}

void Browser::note(const Json& event) {
  const std::string method = event.value("method", "");
  const Json parameters = event.value("params", Json::object());
  if (method == "Runtime.exceptionThrown") errors_.push_back(parameters.dump());
  if (method == "Log.entryAdded" && parameters["entry"].value("level", "") == "error") {
    errors_.push_back(parameters["entry"].dump());
  }
  if (method == "Runtime.consoleAPICalled" && parameters.value("type", "") == "error") {
    errors_.push_back(parameters["args"].dump());
  }
}

Json Browser::call(const std::string& method, const Json& parameters) {
  Json message = {{"id", ++last_id_}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) message["sessionId"] = session_;
  std::string bytes = message.dump();
  bytes += '\0';
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t wrote = ::write(to_browser_.write_end, bytes.data() + done, bytes.size() - done);
    if (wrote <= 0) return Json::object();
    done += static_cast<std::size_t>(wrote);
  }
  while (true) {
    const std::string text = read_until(from_browser_.read_end, '\0', rest_, kPatience_s);
    if (text.empty()) {
      errors_.push_back("the browser did not answer " + method);
      return Json::object();
    }
    const Json answer = Json::parse(text, nullptr, false);
    if (answer.value("id", 0) == last_id_) return answer.value("result", Json::object());
    note(answer);
  }
}

void Browser::open(const std::string& url) {
  call("Page.navigate", {{"url", url}});
}

Json Browser::evaluate(const std::string& expression) {
  const Json result =
      call("Runtime.evaluate",
           {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
  return result.value("result", Json::object()).value("value", Json());
}

bool Browser::wait_for(const std::string& expression, double patience_s) {
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() <
         patience_s) {
    if (evaluate(expression) == Json(true)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

Image8 Browser::screenshot() {
  const Json shot = call("Page.captureScreenshot", {{"format", "jpeg"}, {"quality", 95}});
  const std::filesystem::path path = profile_ / "screenshot.jpg";
  std::ofstream(path, std::ios::binary) << from_base64(shot.value("data", ""));
  return decode_jpeg(path).value_or(Image8{});
}

}  // namespace hybridfusion::testing
