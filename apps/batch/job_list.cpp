// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "batch/job_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "command_line/command_line.h"
#include "command_line/option_checks.h"
#include "findspace/error.h"
#include "findspace/json.h"
#include "findspace/text.h"

namespace findspace::app {
namespace {

using JsonKind = JsonValue::Kind;

const std::vector<std::string> kKeys{"id", "verb", "scene", "path", "shapes", "options"};

[[noreturn]] void refuse(std::string message) { throw Error(ErrorCode::kBadValue, std::move(message)); }

/// The object that begins there, as it is written.
std::string_view object_text(std::string_view line, std::size_t start) {
  int depth = 0;
  for (std::size_t k = start; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '"') {
      for (++k; line[k] != '"'; ++k) k += line[k] == '\\';
    } else if (c == '/') {
      k = line.find("*/", k + 2) + 1;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return line.substr(start, k + 1 - start);
    }
  }
  return line.substr(start);
}

std::string id_of(const JsonValue& line) {
  const JsonValue* id = line.find("id");
  if (id == nullptr) return "";
  if (id->is(JsonKind::kNumber)) return id->text;
  if (!id->is(JsonKind::kString)) refuse(fmt::format("\"id\" is a number or a text, not {}", id->kind_name()));
  return json_string(id->text);
}

std::string scalar(const std::string& key, const JsonValue& value) {
  if (!value.is(JsonKind::kNumber) && !value.is(JsonKind::kString))
    refuse(fmt::format("option \"{}\" is a number, a text, true or a list of these, not {}", key, value.kind_name()));
  return value.text;
}

/// {"at": [1, 2], "json": true} as --at=1,2 --json.
void add_options_of(const JsonValue& options, std::vector<std::string>& out) {
  if (!options.is(JsonKind::kObject)) refuse(fmt::format("\"options\" is an object, not {}", options.kind_name()));
  for (std::size_t k = 0; k < options.size(); ++k) {
    const std::string& key = options.keys[k];
    const JsonValue& value = options.items[k];
    if (value.is(JsonKind::kBoolean)) {
      if (value.boolean) out.push_back("--" + key);
      continue;
    }
    std::string text;
    if (value.is(JsonKind::kArray))
      for (const JsonValue& item : value.items) text += (text.empty() ? "" : ",") + scalar(key, item);
    else
      text = scalar(key, value);
    out.push_back(fmt::format("--{}={}", key, text));
  }
}

const std::string& text_of(const JsonValue& value, std::string_view key) {
  if (!value.is(JsonKind::kString)) refuse(fmt::format("\"{}\" is a text, not {}", key, value.kind_name()));
  return value.text;
}

void read_verb(const JsonValue& line, Job& job) {
  const JsonValue* verb = line.find("verb");
  if (verb == nullptr) refuse("\"verb\" is missing");
  job.verb = text_of(*verb, "verb");
  if (is_question(job.verb)) return;
  const auto names = question_names();
  refuse(fmt::format("there is no verb '{}' here{}; the verbs are {}", job.verb, meant(job.verb, names),
                     fmt::join(names, " ")));
}

void read_scene(const JsonValue& line, std::string_view text, const std::filesystem::path& folder, Job& job) {
  const JsonValue *scene = line.find("scene"), *path = line.find("path");
  if ((scene == nullptr) == (path == nullptr)) refuse("a question has either \"scene\" or \"path\"");
  if (path != nullptr) {
    job.arguments.push_back((folder / text_of(*path, "path")).string());
    return;
  }
  if (!scene->is(JsonKind::kObject)) refuse(fmt::format("\"scene\" is an object, not {}", scene->kind_name()));
  job.scene = object_text(text, static_cast<std::size_t>(scene->column - 1));
  job.arguments.emplace_back("scene");
}

void read_line(std::string_view text, const std::filesystem::path& folder, Job& job) {
  const JsonValue line = read_json(text, "question");
  if (!line.is(JsonKind::kObject)) refuse(fmt::format("a question is an object, not {}", line.kind_name()));
  if (std::string id = id_of(line); !id.empty()) job.id = std::move(id);
  for (const std::string& key : line.keys)
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
      refuse(fmt::format("a question has no \"{}\"{}; it has {}", key, meant(key, kKeys), fmt::join(kKeys, " ")));
  read_verb(line, job);
  read_scene(line, text, folder, job);
  if (const JsonValue* shapes = line.find("shapes"))
    for (const JsonValue& name : shapes->items) job.arguments.push_back(text_of(name, "shapes"));
  if (const JsonValue* options = line.find("options")) add_options_of(*options, job.arguments);
}

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

}  // namespace

JobList::JobList(const std::filesystem::path& path, std::uint64_t input_limit)
    : text_(read_text(path, input_limit)), folder_(path.parent_path()), digest_(fnv1a(text_)) {
  std::size_t number = 0;
  for (std::size_t start = 0; start < text_.size();) {
    const std::size_t end = std::min(text_.find('\n', start), text_.size());
    ++number;
    const std::string_view line = std::string_view(text_).substr(start, end - start);
    if (line.find_first_not_of(" \t\r") != line.npos) lines_.push_back({number, start, end - start});
    start = end + 1;
  }
  if (lines_.empty()) throw Error(ErrorCode::kBadValue, "there is no question in it", path.string());
  std::unordered_map<std::string, std::size_t> first;
  for (std::size_t k = 0; k < size(); ++k) {
    const Job one = job(k);
    if (one.id.empty()) continue;
    const auto [found, fresh] = first.emplace(one.id, lines_[k].number);
    if (!fresh)
      throw Error(ErrorCode::kBadValue,
                  fmt::format("lines {} and {} have the same id {}", found->second, lines_[k].number, one.id),
                  path.string());
  }
}

Job JobList::job(std::size_t k) const {
  Job out;
  out.line = lines_[k].number;
  try {
    read_line(std::string_view(text_).substr(lines_[k].start, lines_[k].size), folder_, out);
  } catch (const Error& e) {
    out.fault = e.what();
  }
  return out;
}

}  // namespace findspace::app
