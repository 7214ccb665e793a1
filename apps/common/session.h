// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the verbs share: the options, and the scene that they ask.
#pragma once

#include <findspace/scene.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "common/options.h"
#include "common/outputs.h"
#include "common/reporter.h"

namespace findspace::app {

class Session {
 public:
  /// Reads the scene; its notes are said. Throws Error.
  Session(const Options& options, Reporter& reporter);
  /// Of a scene that is already read.
  Session(const Options& options, Reporter& reporter, const Scene& scene);

  const Options& options() const { return options_; }
  Reporter& reporter() const { return reporter_; }
  /// The scene to be asked; what it says meanwhile is reported.
  const Scene& scene() const { return *scene_; }
  bool in_space() const { return scene().dimension() == 3; }
  /// Gives it away.
  Scene take() { return *std::exchange(scene_, std::nullopt); }

 private:
  const Options& options_;
  Reporter& reporter_;
  std::optional<Scene> scene_;
};

/// Whether the file is a circuit board of KiCad.
bool is_board(const std::filesystem::path& path);

}  // namespace findspace::app
