// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/nesting_json.h"

#include <findspace/error.h>

namespace findspace::io {

using packing::Fraction;
using Kind = JsonValue::Kind;

NestingJson::NestingJson(const std::string& text, std::string name)
    : name_(std::move(name)), tree_(parse_json(text, name_, work_)) {}

std::string NestingJson::place(const JsonValue& at) const { return fmt::format("{}:{}:{}", name_, at.line, at.column); }

void NestingJson::fail(const JsonValue& at, const std::string& what) const {
  throw Error(ErrorCode::kSyntax, what, place(at));
}

const JsonValue& NestingJson::need(const JsonValue& object, const char* key) const {
  if (!object.is(Kind::kObject)) fail(object, fmt::format("an object with '{}' is meant", key));
  const JsonValue* value = object.find(key);
  if (value == nullptr) fail(object, fmt::format("'{}' is missing", key));
  return *value;
}

const JsonValue& NestingJson::list(const JsonValue& value) const {
  if (!value.is(Kind::kArray)) fail(value, fmt::format("a list is meant, not {}", value.kind_name()));
  return value;
}

Fraction NestingJson::number(const JsonValue& value) const {
  if (!value.is(Kind::kNumber) && !value.is(Kind::kString))
    fail(value, fmt::format("a number is meant, not {}", value.kind_name()));
  try {
    return Fraction::parse(value.text());
  } catch (const Error& e) {
    throw e.within(place(value));
  }
}

int NestingJson::whole(const JsonValue& value) const {
  const Fraction n = number(value);
  if (n.denominator() != 1 || n < 0 || n > 1000000) fail(value, "a whole number from 0 to 1000000 is meant");
  return int(n.numerator());
}

int NestingJson::digits_in(const JsonValue& value, int most) const {
  int digits = 0;
  if (value.is(Kind::kNumber)) {
    const Fraction n = number(value);
    while (digits < most && packing::power_of_ten(digits) % n.denominator() != 0) ++digits;
  }
  for (const JsonValue& item : value.items()) digits = std::max(digits, digits_in(item, most));
  return digits;
}

bool NestingJson::truth(const JsonValue& value) const {
  if (!value.is(Kind::kBoolean)) fail(value, fmt::format("true or false is meant, not {}", value.kind_name()));
  return value.boolean;
}

}  // namespace findspace::io
