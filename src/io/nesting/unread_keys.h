// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Keys of a nesting problem that are not read. Files of other programs have keys of their own, so they are noted, not
// refused; but one that is nearly a known key is a slip. Errors: that of NestingJson::fail with the known key.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/nesting/nesting_json.h"

namespace findspace::io {

class UnreadKeys {
 public:
  explicit UnreadKeys(const NestingJson& json) : json_(json) {}

  /// Of an object; `of` says of which in a note: " of items".
  void look(const JsonValue& object, std::span<const std::string_view> known, std::string_view of);
  /// Of all objects of a list of the object, if it has one.
  void look_through(const JsonValue& object, std::string_view list, std::span<const std::string_view> known);
  /// Of the polygon under "shape" and of its data, if it is stated as one.
  void look_at_polygon(const JsonValue& object);
  /// A line for all of them; none where everything is read.
  std::vector<std::string> notes() const;

 private:
  const NestingJson& json_;
  std::vector<std::string> unread_;
};

/// Of a problem in the plane.
std::vector<std::string> unread_keys(const NestingJson& json);

}  // namespace findspace::io
