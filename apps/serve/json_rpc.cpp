// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/json_rpc.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>

#include "common/run_limits.h"
#include "findspace/text.h"

namespace findspace::app {
namespace {

using JsonKind = JsonValue::Kind;

constexpr int kSceneFault = -32000, kLimitReached = -32001;
constexpr std::string_view kProtocolVersion = "2025-06-18";
constexpr std::size_t kCodeCount = static_cast<std::size_t>(ErrorCode::kLimit) + 1;
constexpr std::array<std::string_view, kCodeCount> kCodes{
    "usage", "syntax", "unknown name", "bad value", "geometry", "out of range", "file", "unsupported", "limit"};

/// JSON without line breaks: those of results stand between tokens only.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string error_text(std::string_view id, int code, std::string_view message, const std::string& data = "") {
  return fmt::format(R"({{"jsonrpc": "2.0", "id": {}, "error": {{"code": {}, "message": {}{}}}}})", id, code,
                     json_string(message), data.empty() ? "" : ", \"data\": " + data);
}

/// Line and column of a place that ends with them: "formula 1:12", "scene.json:4:7".
std::string line_and_column(std::string_view place) {
  const std::size_t last = place.rfind(':');
  if (last == place.npos || last == 0) return "";
  const std::size_t before = place.find_last_not_of("0123456789", last - 1);
  const std::size_t start = before == place.npos ? 0 : before + 1;
  int line = 0, column = 0;
  const auto whole = [](std::string_view digits, int& out) {
    return std::from_chars(digits.data(), digits.data() + digits.size(), out).ptr == digits.data() + digits.size() &&
           !digits.empty();
  };
  if (!whole(place.substr(start, last - start), line) || !whole(place.substr(last + 1), column)) return "";
  return fmt::format(R"(, "line": {}, "column": {})", line, column);
}

std::string error_data(const Error& e) {
  const std::string points = json_list(e.geometry(), [](const std::array<double, 2>& p) {
    return fmt::format("[{}, {}]", json_number(p[0]), json_number(p[1]));
  });
  return fmt::format(R"({{"kind": {}, "place": {}{}, "points": {}}})",
                     json_string(kCodes[static_cast<std::size_t>(e.code())]), json_string(e.place()),
                     line_and_column(e.place()), points);
}

/// An id as it was written; null where it is neither a number nor a string.
std::string id_text(const JsonValue* id) {
  if (id == nullptr) return "null";
  return id->is(JsonKind::kNumber) ? id->text : id->is(JsonKind::kString) ? json_string(id->text) : "null";
}

std::string tools() {
  return fmt::format(R"({{"tools": {}}})", json_list(methods(), [](const Method& m) {
                       return fmt::format(R"({{"name": "{}", "description": {}, "inputSchema": {}}})", m.name,
                                          json_string(m.about), parameters_schema(m));
                     }));
}

std::string greeting() {
  return fmt::format(
      R"({{"protocolVersion": "{}", "capabilities": {{"tools": {{}}}}, "serverInfo": {{"name": "findspace", "version": "{}"}}}})",
      kProtocolVersion, FINDSPACE_VERSION);
}

}  // namespace

std::string limit_error(std::string_view id, std::string_view message) {
  return error_text(id, kLimitReached, message);
}

std::string JsonRpc::call_tool(const JsonValue& parameters) {
  const JsonValue *name = parameters.find("name"), *arguments = parameters.find("arguments");
  if (name == nullptr || !name->is(JsonKind::kString))
    throw RequestError{RequestError::kParams, "tools/call takes \"name\" and \"arguments\""};
  const auto content = [](const std::string& text) {
    return fmt::format(R"("content": [{{"type": "text", "text": {}}}])", json_string(text));
  };
  // What is wrong with the scene is for the assistant to read; what is wrong with the call is for the client.
  try {
    const std::string result =
        one_line(run_method(store_, name->text, arguments == nullptr ? JsonValue() : *arguments));
    return fmt::format(R"({{{}, "structuredContent": {}, "isError": false}})", content(result), result);
  } catch (const Error& e) {
    return fmt::format(R"({{{}, "isError": true}})", content(e.what()));
  }
}

std::string JsonRpc::result(const std::string& method, const JsonValue& parameters) {
  if (method == "rpc.discover") return protocol_json();
  if (method == "initialize") return greeting();
  if (method == "ping") return "{}";
  if (method == "tools/list") return tools();
  if (method == "tools/call") return call_tool(parameters);
  return run_method(store_, method, parameters);
}

std::string JsonRpc::answer(const JsonValue& request) {
  const JsonValue *id = request.find("id"), *method = request.find("method"), *parameters = request.find("params");
  const std::string named = id_text(id);
  if (!request.is(JsonKind::kObject) || method == nullptr || !method->is(JsonKind::kString))
    return error_text(named, RequestError::kRequest, "a request is an object with \"jsonrpc\", \"id\" and \"method\"");
  const auto last_words = [&](std::string_view why) {
    return late_ == Late::kSilent ? "" : error_text(named, kLimitReached, why) + "\n";
  };
  const RequestLimits limits(seconds_, last_words("the time limit is reached"), last_words("out of memory"));
  std::string out;
  try {
    out = fmt::format(R"({{"jsonrpc": "2.0", "id": {}, "result": {}}})", named,
                      method->text.starts_with("notifications/")
                          ? "null"
                          : one_line(result(method->text, parameters == nullptr ? JsonValue() : *parameters)));
  } catch (const RequestError& e) {
    out = error_text(named, e.code, e.message);
  } catch (const Error& e) {
    const int code = e.code() == ErrorCode::kLimit ? kLimitReached : kSceneFault;
    out = error_text(named, code, e.message(), error_data(e));
  } catch (const std::bad_alloc&) {
    out = error_text(named, kLimitReached, "out of memory");
  } catch (const std::exception& e) {
    out = error_text(named, RequestError::kInternal, fmt::format("internal error: {}", e.what()));
  }
  return id == nullptr ? "" : out;
}

std::string JsonRpc::answer(std::string_view text) {
  JsonValue request;
  try {
    request = read_json(text, "request");
  } catch (const Error& e) {
    return error_text("null", RequestError::kParse, e.what());
  }
  if (!request.is(JsonKind::kArray)) return answer(request);
  if (request.items.empty()) return error_text("null", RequestError::kRequest, "an empty batch");
  std::string all;
  for (const JsonValue& one : request.items) {
    const std::string text_of_one = answer(one);
    if (!text_of_one.empty()) all += (all.empty() ? "" : ", ") + text_of_one;
  }
  return all.empty() ? "" : "[" + all + "]";
}

}  // namespace findspace::app
