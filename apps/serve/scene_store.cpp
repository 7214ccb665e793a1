// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "serve/scene_store.h"

#include <fmt/format.h>

#include "common/inside_folder.h"
#include "common/session.h"
#include "findspace/error.h"
#include "findspace/json.h"
#include "findspace/text.h"
#include "placing/packing_report.h"
#include "serve/methods.h"

namespace findspace::app {
namespace {

/// Whether a file is a packing problem: it lists items, or kinds of items in space. Throws Error for a layout alone.
bool is_problem(const std::filesystem::path& path, std::uint64_t most) {
  if (path.extension() != ".json") return false;
  const JsonValue file = read_json(read_text(path, most), path.string());
  const auto has = [&](const char* key) { return file.find(key) != nullptr; };
  if (has("layout") && !has("shapes"))
    throw Error(ErrorCode::kUsage, "a layout is shown with its problem: findspace view PROBLEM --start LAYOUT",
                path.string());
  return (has("items") && !has("shapes")) || has("item-types");
}

/// Which names are loaded, or by which method one is.
template <class Loads>
std::string loaded_names(const Loads& loads, std::string_view method) {
  if (loads.empty()) return fmt::format("'{}' comes first", method);
  std::vector<std::string> names;
  for (const auto& [name, load] : loads) names.push_back(fmt::format("'{}'", name));
  return fmt::format("loaded: {}", fmt::join(names, ", "));
}

Scene read_scene(const Options& options) {
  Reporter reporter(true);
  return Session(options, reporter).scene().with(Scene::Listener());
}

}  // namespace

SceneStore::SceneStore(const Options& options) : options_(options) {
  const std::filesystem::path scene(options.scene);
  if (options_.root.empty())
    options_.root = scene.parent_path().empty() ? std::filesystem::current_path() : scene.parent_path();
  options_.root = std::filesystem::weakly_canonical(options_.root);
  if (scene.empty()) return;
  if (is_problem(scene, options.input_limit)) {
    PackReading asked = pack_reading(options_, scene.string());
    asked.folder = scene.parent_path().string();
    keep_problem("scene", read_text(scene, options.input_limit), asked);
    if (options.start) packing("scene").begin_with_file(*options.start, options.input_limit);
    return;
  }
  Options first = options_;
  if (options.no_files) first.root.clear();
  keep("scene", read_scene(first));
}

Loaded& SceneStore::scene(const std::string& name) {
  const auto found = scenes_.find(name);
  if (found == scenes_.end())
    throw RequestError{RequestError::kParams,
                       fmt::format("no scene '{}' is loaded; {}", name, loaded_names(scenes_, "load"))};
  return *found->second;
}

PackingJob& SceneStore::packing(const std::string& name) {
  const auto found = packings_.find(name);
  if (found == packings_.end())
    throw RequestError{RequestError::kParams,
                       fmt::format("no packing '{}' is loaded; {}", name, loaded_names(packings_, "pack"))};
  return *found->second;
}

void SceneStore::keep(const std::string& name, const Scene& scene) {
  auto loaded = Loaded::make(scene);
  packings_.erase(name);
  scenes_[name] = std::move(loaded);
}

void SceneStore::copy(const std::string& name, const std::string& as) { keep(as, scene(name).scene()); }

std::string SceneStore::source(const std::string& name) { return scene(name).scene().edited_text(); }

void SceneStore::keep_problem(const std::string& name, const std::string& text, const PackReading& asked) {
  auto job = PackingJob::make(text, asked);
  scenes_.erase(name);
  packings_[name] = std::move(job);
}

void SceneStore::load_problem(const std::string& name, const std::string& path, PackReading asked) {
  const std::filesystem::path whole = within_root(path);
  asked.name = path;
  asked.read = reading(options_);
  asked.folder = whole.parent_path().string();
  keep_problem(name, read_text(whole, options_.input_limit), asked);
}

void SceneStore::load_problem_text(const std::string& name, const std::string& text, PackReading asked) {
  asked.name = name;
  asked.read = reading(options_);
  asked.read.files = false;
  keep_problem(name, text, asked);
}

void SceneStore::forget(const std::string& name) {
  if (packings_.erase(name) > 0) return;
  scene(name);
  scenes_.erase(name);
}

void SceneStore::load(const std::string& name, const std::string& path) {
  Options options = options_;
  const std::filesystem::path whole = within_root(path);
  options.scene = whole.string();
  options.move.clear();
  options.where.clear();
  options.minimize.clear();
  options.maximize.clear();
  options.free.clear();
  keep(name, read_scene(options));
}

void SceneStore::load_text(const std::string& name, const std::string& text) {
  ReadOptions without_files = reading(options_);
  without_files.files = false;
  keep(name, Scene::json(text, options_.root, without_files, name));
}

std::filesystem::path SceneStore::within_root(const std::string& path) const {
  const std::filesystem::path whole = std::filesystem::weakly_canonical(std::filesystem::path(options_.root) / path);
  if (!is_inside_folder(whole, options_.root))
    throw Error(ErrorCode::kFile, "lies outside the folder that is served", path);
  return whole;
}

}  // namespace findspace::app
