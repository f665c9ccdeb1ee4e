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
#include <optional>
#include <system_error>
#include <utility>

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

/// A folder for one run, removed at its end.
class TemporaryFolder {
 public:
  static Expected<TemporaryFolder> create() {
    std::error_code code;
    const auto parent = std::filesystem::temp_directory_path(code);
    std::string name = (parent / "hybridfusion-view-XXXXXX").string();
    if (!code && ::mkdtemp(name.data()) != nullptr) return TemporaryFolder(name);
    return fail(
        ErrorCode::kIo,
        fmt::format("{}: no folder can be made there; set TMPDIR to one that can be written",
                    parent.string()));
  }
  TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  TemporaryFolder& operator=(TemporaryFolder&& other) noexcept {
    std::swap(path_, other.path_);
    return *this;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

/// Where the octrees lie, and whether they go when the viewer ends.
struct OctreeFolder {
  std::filesystem::path path = {};
  std::optional<TemporaryFolder> temporary = {};
};

Expected<void> make_octrees(const std::filesystem::path& folder,
                            const ViewScene& scene,
                            const RunContext& ctx) {
  for (const ViewLayer& layer : scene.layers) {
    std::error_code code;
    std::filesystem::create_directories(folder / layer.name, code);
    ctx.info(fmt::format("preparing {} for the viewer", layer.file.string()));
    if (auto written = write_octree(folder / layer.name, layer.batches, {}, ctx); !written) {
      return std::unexpected(written.error());
    }
  }
  return write_file_atomically(folder / kKeyFile, scene.key);
}

/// Octrees of all layers in the workspace, made anew unless they are of these very files; in a
/// folder for this run where the workspace cannot be written or another process works in it.
Expected<OctreeFolder> prepare_octrees(const std::filesystem::path& root,
                                       const ViewScene& scene,
                                       const RunContext& ctx) {
  constexpr std::uint64_t kMaxKeyBytes = 1U << 16U;
  const std::filesystem::path cache = root / kCacheFolder;
  const auto key = read_text_file(cache / kKeyFile, kMaxKeyBytes);
  if (key && *key == scene.key) return OctreeFolder{.path = cache};
  // Only who writes needs the workspace for itself; looking at it does not.
  const auto workspace = Workspace::open(root);
  Expected<void> writable;
  if (!workspace) writable = std::unexpected(workspace.error());
  if (writable) writable = workspace->make_folder(kCacheFolder);
  if (writable) {
    workspace->remove((std::filesystem::path(kCacheFolder) / kKeyFile).string());
    writable = write_file_atomically(cache / "writable", "");
    workspace->remove((std::filesystem::path(kCacheFolder) / "writable").string());
  }
  if (writable) {
    if (auto made = make_octrees(cache, scene, ctx); !made) return std::unexpected(made.error());
    return OctreeFolder{.path = cache};
  }
  HF_TRY(TemporaryFolder temporary, TemporaryFolder::create());
  ctx.warn(fmt::format("{}; what the viewer needs is prepared in {} for this time",
                       writable.error().message,
                       temporary.path().string()));
  if (auto made = make_octrees(temporary.path(), scene, ctx); !made) {
    return std::unexpected(made.error());
  }
  const std::filesystem::path path = temporary.path();
  return OctreeFolder{.path = path, .temporary = std::move(temporary)};
}

std::vector<ServedFile> served_files(const std::filesystem::path& root,
                                     const std::filesystem::path& octrees,
                                     const ViewScene& scene) {
  std::vector<ServedFile> files = viewer_page();
  files.push_back({"/scene.json", "application/json", std::string_view(scene.json)});
  for (const ViewLayer& layer : scene.layers) {
    const std::string url = fmt::format("/cloud/{}/", layer.name);
    const auto add = [&](std::string_view name, const char* type) {
      files.push_back({.url = url + std::string(name),
                       .content_type = type,
                       .content = octrees / layer.name / name,
                       .root = octrees});
    };
    add(octree_file::kMetadata, "application/json");
    add(octree_file::kHierarchy, "application/octet-stream");
    add(octree_file::kPoints, "application/octet-stream");
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
  const auto octrees = prepare_octrees(root, *scene, ctx);
  if (!octrees) return report_error(session, octrees.error());
  auto server = ViewerServer::open(root, served_files(root, octrees->path, *scene), arguments.port);
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
      "cache/view of the workspace the first time, or for this run only where it cannot be "
      "written.");
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
