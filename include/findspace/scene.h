// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A scene file (docs/scene.md) as values: its shapes, its world, and what it asks. Formulas may name its groups and
// lists. Guarantee: the same questions have the same answers as in the program. Cost: of reading, then that of a World.
// Error: kFile, kSyntax and others with the place in the file. Keywords: input, project file.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/files.h"
#include "findspace/formula.h"
#include "findspace/shape.h"
#include "findspace/world.h"

namespace findspace {

/// Immutable and cheap to copy.
class Scene {
 public:
  /// Files of shapes are looked for beside it. What is not trusted may be read without files, from one folder alone, or
  /// at less cost: Error(kUnsupported), Error(kFile), Error(kLimit).
  static Scene file(const std::string& path, const ReadOptions& reading = {});
  /// The text of a scene; files of shapes are looked for in the folder.
  static Scene json(std::string_view text, const std::string& folder = ".", const ReadOptions& reading = {});

  /// By name; a group is one as well.
  const std::map<std::string, Shape>& shapes() const;
  /// With what moves, in time too. Error(kBadValue) where the scene does not say what does.
  const World& world() const;
  /// "where", "true" without it.
  const Formula& where() const;
  /// "minimize" and "maximize", or empty.
  const std::string& minimize() const;
  const std::string& maximize() const;
  /// What it was read from, and the folder of its files.
  const std::string& text() const;
  const std::string& folder() const;
  /// What might be opened, and at what cost.
  const ReadOptions& reading() const;
  /// What was changed on the way: points that were rounded, rings that were reversed.
  const std::vector<std::string>& notes() const;

  struct Data;
  explicit Scene(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
