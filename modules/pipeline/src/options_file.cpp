#include "json_text.hpp"
#include "options_text.hpp"
#include "options_yaml.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/pipeline/options_file.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kMaxConfigBytes = 1U << 20U;

YAML::Node node_of(const PipelineOptions& options) {
  return YAML::Load(to_yaml(options));
}

/// Plain scalars that are JSON as they stand are numbers or truth values.
Json json_of(const YAML::Node& node) {
  if (node.IsMap()) {
    Json object = Json::object();
    for (const auto& entry : node) object[entry.first.as<std::string>()] = json_of(entry.second);
    return object;
  }
  if (node.IsSequence()) {
    Json array = Json::array();
    for (const YAML::Node& entry : node) array.push_back(json_of(entry));
    return array;
  }
  if (!node.IsScalar()) return nullptr;
  return Json::accept(node.Scalar()) ? Json::parse(node.Scalar()) : Json(node.Scalar());
}

}  // namespace

Expected<void> load_options(const std::filesystem::path& path, PipelineOptions& options) {
  HF_TRY(const std::string text, read_text_file(path, kMaxConfigBytes));
  try {
    const YAML::Node node = YAML::Load(text);
    if (node.IsNull()) return {};  // an empty file sets nothing
    if (auto read = read_yaml(node, options); !read) {
      return std::unexpected(std::move(read).error().with_context(path.string()));
    }
  } catch (const YAML::Exception& error) {
    return fail(ErrorCode::kParse, fmt::format("{}: {}", path.string(), error.what()));
  }
  if (auto valid = validate(options); !valid) {
    return std::unexpected(std::move(valid).error().with_context(path.string()));
  }
  return {};
}

Expected<void> apply_setting(std::string_view setting, PipelineOptions& options) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string_view::npos) {
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("--set {}: expected group.option=value", setting));
  }
  auto set = set_option(options, setting.substr(0, equals), setting.substr(equals + 1));
  if (set) set = validate(options);
  if (!set) return std::unexpected(std::move(set).error().with_context("--set"));
  return {};
}

std::string to_yaml(const PipelineOptions& options) {
  YAML::Emitter out;
  write_yaml(out, options);
  return std::string(out.c_str()) + "\n";
}

std::string to_json(const PipelineOptions& options) {
  return json_of(node_of(options)).dump(1);
}

std::string options_reference() {
  std::string markdown =
      "| option | default | unit | range | meaning | source |\n|---|---|---|---|---|---|\n";
  append_reference(markdown, PipelineOptions{});
  return markdown;
}

std::string options_text(const PipelineOptions& options, std::string_view group) {
  YAML::Emitter out;
  out << node_of(options)[std::string(group)];
  return fmt::format("{}:\n{}\n", group, out.c_str());
}

Expected<void> save_effective_options(const Project& project,
                                      const std::vector<std::string_view>& groups) {
  const std::filesystem::path path = project.workspace.path(workspace_file::kConfig);
  const YAML::Node now = node_of(project.options);
  YAML::Node former;
  if (const auto text = read_text_file(path, kMaxConfigBytes)) {
    try {
      former = YAML::Load(*text);
    } catch (const YAML::Exception&) {
      former = {};  // somebody edited it; it is rewritten from what is known
    }
  }
  YAML::Emitter out;
  out << YAML::BeginMap;
  for (const auto& entry : now) {
    const auto group = entry.first.as<std::string>();
    const bool ran = std::ranges::find(groups, group) != groups.end();
    const bool kept = !ran && former.IsMap() && former[group];
    if (!ran && !kept) continue;
    out << YAML::Key << group << YAML::Value << (ran ? entry.second : former[group]);
  }
  out << YAML::EndMap;
  return write_file_atomically(path, std::string(out.c_str()) + "\n");
}

}  // namespace hybridfusion
