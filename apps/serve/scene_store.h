// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The loaded scenes and packings by name. Scenes, and the files that they name, are read below one folder only: --root,
// or else the folder of the first scene, or else the current one. Keywords: session, sandbox.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "common/options.h"
#include "serve/loaded.h"
#include "serve/packing_job.h"

namespace findspace::app {

class SceneStore {
 public:
  /// With the scene, drawing, board or packing problem of the command line, if there is one.
  explicit SceneStore(const Options& options);

  Loaded& scene(const std::string& name);
  void keep(const std::string& name, const Scene& scene);
  /// A copy under another name, with its own formula from now on.
  void copy(const std::string& name, const std::string& as);
  /// The scene's text with the formula and the moving shapes that it has now. Throws Error where it had none.
  std::string source(const std::string& name);
  PackingJob& packing(const std::string& name);
  bool has_packing() const { return !packings_.empty(); }
  /// A packing problem below the folder, and one from memory, which reads no files.
  void load_problem(const std::string& name, const std::string& path, PackReading asked);
  void load_problem_text(const std::string& name, const std::string& text, PackReading asked);
  void forget(const std::string& name);

  /// A scene, drawing or board below the folder. Throws Error where the path leads out of it.
  void load(const std::string& name, const std::string& path);
  /// A scene from memory, which reads no files.
  void load_text(const std::string& name, const std::string& text);

 private:
  void keep_problem(const std::string& name, const std::string& text, const PackReading& asked);
  std::filesystem::path within_root(const std::string& path) const;

  Options options_;  // the root is the one that is kept to
  std::map<std::string, std::unique_ptr<Loaded>> scenes_;
  std::map<std::string, std::unique_ptr<PackingJob>> packings_;
};

}  // namespace findspace::app
