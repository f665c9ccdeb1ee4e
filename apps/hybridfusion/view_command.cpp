#include "cli.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/pipeline/view_scene.hpp>
#include <hybridfusion/pipeline/workspace.hpp>
#include <hybridfusion/viewer/octree.hpp>
#include <hybridfusion/viewer/viewer_server.hpp>
#include <hybridfusion/viewer/web_page.hpp>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <unistd.h>

namespace hybridfusion::cli {
namespace {

constexpr std::string_view kCacheFolder = "cache/view";
constexpr std::string_view kKeyFile = "key.txt";

struct ViewArguments {
  std::string workspace = {};
  int port = 0;
  bool no_browser = false;
};

/// Octrees of all layers below `cache`, made anew unless they are of these very files.
Expected<void> prepare_octrees(const std::filesystem::path& root,
                               const ViewScene& scene,
                               const RunContext& ctx) {
  constexpr std::uint64_t kMaxKeyBytes = 1U << 16U;
  const std::filesystem::path cache = root / kCacheFolder;
  const auto key = read_text_file(cache / kKeyFile, kMaxKeyBytes);
  if (key && *key == scene.key) return {};
  // Only who writes needs the workspace for itself; looking at it does not.
  HF_TRY(const Workspace workspace, Workspace::open(root));
  workspace.remove((std::filesystem::path(kCacheFolder) / kKeyFile).string());
  for (const ViewLayer& layer : scene.layers) {
    const std::string folder = (std::filesystem::path(kCacheFolder) / layer.name).string();
    if (auto made = workspace.make_folder(folder); !made) return made;
    ctx.info(fmt::format("preparing {} for the viewer", layer.file.string()));
    if (auto written = write_octree(root / folder, layer.batches, {}, ctx); !written) {
      return std::unexpected(written.error());
    }
  }
  return write_file_atomically(cache / kKeyFile, scene.key);
}

std::vector<ServedFile> served_files(const std::filesystem::path& root, const ViewScene& scene) {
  std::vector<ServedFile> files = viewer_page();
  files.push_back({"/scene.json", "application/json", std::string_view(scene.json)});
  for (const ViewLayer& layer : scene.layers) {
    const std::filesystem::path folder = root / kCacheFolder / layer.name;
    const std::string url = fmt::format("/cloud/{}/", layer.name);
    files.push_back({url + std::string(octree_file::kMetadata),
                     "application/json",
                     folder / octree_file::kMetadata});
    for (const std::string_view name : {octree_file::kHierarchy, octree_file::kPoints}) {
      files.push_back({url + std::string(name), "application/octet-stream", folder / name});
    }
  }
  std::error_code code;
  if (std::filesystem::is_regular_file(root / workspace_file::kReport, code)) {
    files.push_back({"/report",
                     "text/html; charset=utf-8",
                     root / workspace_file::kReport,
                     ContentPolicy::kDocument});
  }
  return files;
}

/// Opens the user's browser where there is a desktop; the URL is printed in any case.
void open_browser(const std::string& url) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string program = "xdg-open";
  std::string argument = url;
  char* const argv[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  ::posix_spawnp(&child, program.c_str(), nullptr, nullptr, argv, ::environ);
}

void print_url(const Session& session, const ViewerServer& server) {
  if (session.globals.json) {
    const nlohmann::ordered_json json = {
        {"status", "ok"}, {"url", server.url()}, {"port", server.port()}};
    fmt::print("{}\n", json.dump());
  } else {
    fmt::print("{}\nCtrl-C ends the viewer.\n", server.url());
  }
  std::fflush(stdout);
}

int view(const ViewArguments& arguments, Session& session) {
  const std::filesystem::path root = arguments.workspace;
  const RunContext& ctx = session.context;
  const auto scene = view_scene(root, ctx);
  if (!scene) return report_error(session, scene.error());
  if (auto ready = prepare_octrees(root, *scene, ctx); !ready) {
    return report_error(session, ready.error());
  }
  auto server = ViewerServer::open(root, served_files(root, *scene), arguments.port);
  if (!server) return report_error(session, server.error());
  print_url(session, *server);
  if (!arguments.no_browser) open_browser(server->url());
  if (auto served = server->serve(ctx.stop); !served) return report_error(session, served.error());
  return kDone;
}

}  // namespace

void add_view_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "view",
      "Shows the clouds, cameras and trajectory of a workspace in the browser, whichever stages "
      "ran. The page is served to this machine only, until Ctrl-C. Octrees are prepared in "
      "cache/view of the workspace the first time.");
  auto arguments = std::make_shared<ViewArguments>();
  command->add_option("workspace", arguments->workspace, "Workspace folder")->required();
  command->add_option("--port", arguments->port, "Port on 127.0.0.1; 0 takes a free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command->add_flag("--no-browser", arguments->no_browser, "Only print the address");
  command->footer(
      help_footer("hybridfusion view result/",
                  "WORKSPACE: what run, reconstruct, map or register made",
                  "WORKSPACE/cache/: octrees of the clouds, made once; nothing else is touched"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) { return view(*arguments, session); };
  });
}

}  // namespace hybridfusion::cli
