// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the verbs share: the options, and the scene that they are about. As a scene of the public headers (asked()), or
// for verbs that still answer by the layers of src as what these ask.
#pragma once

#include <findspace/scene.h>

#include <optional>
#include <string>

#include "common/options.h"
#include "common/outputs.h"
#include "common/reporter.h"
#include "io/question/asked_scene.h"

namespace findspace::app {

class Session : public io::AskedScene {
 public:
  /// Reads the scene; its notes are said. Throws Error.
  Session(const Options& options, Reporter& reporter);
  /// Of a scene that is already read.
  Session(const Options& options, Reporter& reporter, findspace::Scene scene);
  Session(const Options& options, Reporter& reporter, io::Scene scene);

  const Options& options() const { return options_; }
  Reporter& reporter() const { return reporter_; }
  /// The scene to be asked; what it says meanwhile is reported. Not after forget_shapes().
  const findspace::Scene& asked() const { return *asked_; }

  /// A shape. Error(kUnknownName); what had to be rounded is said where its region is made.
  Shape shape(const std::string& name) const;
  /// The exact set of one of the plane; what had to be rounded is said once.
  Region shape_region(const std::string& name) const;
  /// Lets go of how the shapes are made, where a world has their sets: only their names stay.
  void forget_shapes();

 private:
  const Options& options_;
  Reporter& reporter_;
  std::optional<findspace::Scene> asked_;
};

/// Whether the file is a circuit board of KiCad.
bool is_board(const std::filesystem::path& path);

}  // namespace findspace::app
