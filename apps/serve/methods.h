// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The one description of requests and answers: a row for each method, with its parameters. The pipe, the page, the
// tools of the Model Context Protocol and docs/protocol.json speak from it. Keywords: API, OpenRPC, tool.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "findspace/json.h"
#include "serve/scene_store.h"

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

struct Method {
  std::string_view name, about;
  std::span<const Parameter> parameters;
  std::string (*run)(SceneStore&, const JsonValue& parameters);  // gives JSON
};

std::span<const Method> methods();
/// The method's parameters as a JSON Schema.
std::string parameters_schema(const Method& method);
/// All methods as one JSON document (docs/protocol.json).
std::string protocol_json();

/// The answer to a request as JSON. Throws RequestError, and Error.
std::string run_method(SceneStore& store, std::string_view name, const JsonValue& parameters);

}  // namespace findspace::app
