// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// JSON-RPC 2.0 over texts: one request or a batch in, its answer on one line out. The methods are those of methods.h;
// `rpc.discover` gives their description. Beside them it speaks the Model Context Protocol: `initialize`, `ping`,
// `tools/list` and `tools/call`, each method being a tool. Errors of the scene have code -32000 and say in "data" which
// kind they are and where. Source: https://www.jsonrpc.org/specification; https://modelcontextprotocol.io, 2025-06-18.
// Keywords: remote procedure call, MCP, tool.
#pragma once

#include <string>
#include <string_view>

#include "serve/methods.h"

namespace findspace::app {

/// The answer to a request that is beyond a limit.
std::string limit_error(std::string_view id, std::string_view message);

class JsonRpc {
 public:
  enum class Late { kSaid, kSilent };
  /// A request that takes longer than `seconds` ends the process (0: none does); an error is written to standard output
  /// before, unless `late` says not.
  JsonRpc(SceneStore& store, double seconds, Late late) : store_(store), seconds_(seconds), late_(late) {}

  /// The answer on one line; "" where none is due.
  std::string answer(std::string_view request);

 private:
  std::string answer(const JsonValue& request);
  std::string result(const std::string& method, const JsonValue& parameters);
  std::string call_tool(const JsonValue& parameters);

  SceneStore& store_;
  double seconds_;
  Late late_;
};

}  // namespace findspace::app
