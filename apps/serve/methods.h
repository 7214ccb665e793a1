// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The one description of requests and answers: a row for each method, with its parameters. The pipe, the page, the
// tools of the Model Context Protocol and docs/protocol.json speak from it. Keywords: API, OpenRPC, tool.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "io/text/json_tree.h"
#include "io/text/read_limits.h"
#include "options.h"
#include "serve/loaded_scene.h"

namespace findspace::app {

/// A parameter or a method that is not as the table says: codes of JSON-RPC.
struct RequestError {
  enum Code { kParse = -32700, kRequest = -32600, kMethod = -32601, kParams = -32602, kInternal = -32603 };
  Code code;
  std::string message;
};

struct Parameter {
  std::string_view name;
  std::string_view schema;  // JSON Schema
  std::string_view about;
  bool required = false;
};

class SceneStore;

struct Method {
  std::string_view name, about;
  std::span<const Parameter> parameters;
  std::string (*run)(SceneStore&, const io::JsonValue& parameters);  // gives JSON
};

std::span<const Method> methods();
/// The method's parameters as a JSON Schema.
std::string parameters_schema(const Method& method);
/// All methods as one JSON document (docs/protocol.json).
std::string protocol_json();

/// The loaded scenes by name. Scenes, and the files that they name, are read below one folder only: --root, or else the
/// folder of the first scene, or else the current one.
class SceneStore {
 public:
  explicit SceneStore(const Options& options);

  /// The answer as JSON. Throws RequestError, and Error.
  std::string call(std::string_view method, const io::JsonValue& parameters);

  LoadedScene& scene(const std::string& name);
  void keep(const std::string& name, io::Scene scene);
  void forget(const std::string& name);
  /// Throws Error where the path leads out of the folder.
  std::filesystem::path within_root(const std::string& path) const;
  const std::filesystem::path& root() const { return reading_.root; }
  /// What a scene may open and cost.
  const io::ReadOptions& reading() const { return reading_; }

 private:
  io::ReadOptions reading_;
  std::map<std::string, std::unique_ptr<LoadedScene>> scenes_;
};

}  // namespace findspace::app
