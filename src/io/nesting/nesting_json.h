// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Access to the JSON of packing problems and layouts, with errors that say where: "parts.json:12:5".
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/text/json_tree.h"
#include "packing/problem/fraction.h"
#include "packing/problem/left_out.h"

namespace findspace::io {

class NestingJson {
 public:
  NestingJson(const std::string& text, std::string name);

  const JsonValue& tree() const { return tree_.root(); }
  const std::string& name() const { return name_; }
  plane::WorkBudget& work() { return work_; }

  std::string place(const JsonValue& at) const;
  [[noreturn]] void fail(const JsonValue& at, const std::string& what) const;
  const JsonValue& need(const JsonValue& object, const char* key) const;
  const JsonValue& list(const JsonValue& value) const;
  packing::Fraction number(const JsonValue& value) const;
  /// From 0 to 1000000.
  int whole(const JsonValue& value) const;
  bool truth(const JsonValue& value) const;
  /// The most digits after the point of a number in it, at most `most`.
  int digits_in(const JsonValue& value, int most) const;
  /// Of what has that name.
  template <class Named>
  std::size_t index_of(const JsonValue& name, const std::vector<Named>& all, const char* what) const {
    const auto same = [&](const Named& one) { return one.name == name.text(); };
    const auto found = std::find_if(all.begin(), all.end(), same);
    if (found == all.end()) fail(name, fmt::format("there is no {} '{}'", what, name.text()));
    return std::size_t(found - all.begin());
  }
  /// Refuses a second of that name; `one` is the last of them.
  template <class Named>
  void check_name(const JsonValue& one, const std::vector<Named>& all, const char* what) const {
    const auto same = [&](const Named& other) { return other.name == all.back().name; };
    if (std::count_if(all.begin(), all.end(), same) > 1)
      fail(one, fmt::format("there are two {} '{}': give them an 'id' each", what, all.back().name));
  }
  /// Of a layout.
  template <class Named>
  std::vector<packing::LeftOut> left_out(const JsonValue& value, const std::vector<Named>& parts) const {
    std::vector<packing::LeftOut> result;
    for (const JsonValue& out : list(value).items())
      result.push_back({index_of(need(out, "part"), parts, "part"), whole(need(out, "copies")),
                        std::string(need(out, "why").text())});
    return result;
  }

 private:
  std::string name_;
  plane::WorkBudget work_;
  JsonTree tree_;
};

}  // namespace findspace::io
