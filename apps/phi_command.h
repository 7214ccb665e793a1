// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb `phi`: the Phi-function of two polytopes (or unions of polytopes) of a scene, and its value at a position.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/scene.h"

namespace findspace::app {

struct PhiRequest {
  std::string first, second;                   // names of shapes of the scene
  std::optional<std::string> at;               // "x,y,z" in the scene's unit, decimals taken exactly
  bool json = false;                           // standard output: JSON, else the table
  std::vector<std::filesystem::path> outputs;  // .json .txt .obj .off .stl .svg
};

struct CommandResult {
  std::string text;  // for standard output; empty where outputs were named and json was not asked for
  int exit_status = 0;
  std::vector<std::string> notes;  // for standard error: what was repaired or rounded
};

/// Throws Error; the caller turns it into exit status 2 (kUsage) or 3.
CommandResult run_phi(const io::Scene& scene, const PhiRequest& request);

}  // namespace findspace::app
