// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Plain values in a pickle: their members, one after another. Enumerations go as numbers, exact numbers as text.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <type_traits>
#include <vector>

#include "numbers.h"

namespace findspace::python {

namespace py = pybind11;

template <class Value>
inline constexpr bool is_vector = false;
template <class Item>
inline constexpr bool is_vector<std::vector<Item>> = true;
template <class Value>
inline constexpr bool is_optional = false;
template <class Item>
inline constexpr bool is_optional<std::optional<Item>> = true;

template <class Value>
py::object packed(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return py::int_(static_cast<int>(value));
  } else if constexpr (std::is_same_v<Value, Number>) {
    return py::str(value.text());
  } else if constexpr (std::is_same_v<Value, Point>) {
    return py::make_tuple(value.x.text(), value.y.text());
  } else if constexpr (is_optional<Value>) {
    return value ? packed(*value) : py::none();
  } else if constexpr (is_vector<Value>) {
    py::list out;
    for (const auto& item : value) out.append(packed(item));
    return out;
  } else {
    return py::cast(value);
  }
}

template <class Value>
Value unpacked(const py::handle& from) {
  if constexpr (std::is_enum_v<Value>) {
    return static_cast<Value>(from.cast<int>());
  } else if constexpr (std::is_same_v<Value, Number>) {
    return number(from);
  } else if constexpr (std::is_same_v<Value, Point>) {
    return point(from.cast<py::sequence>());
  } else if constexpr (is_optional<Value>) {
    return from.is_none() ? Value() : Value(unpacked<typename Value::value_type>(from));
  } else if constexpr (is_vector<Value>) {
    Value out;
    for (const py::handle& item : from) out.push_back(unpacked<typename Value::value_type>(item));
    return out;
  } else {
    return from.cast<Value>();
  }
}

/// For `.def(pickled<Value>(&Value::a, &Value::b))`.
template <class Value, class... Members>
auto pickled(Members Value::*... members) {
  return py::pickle([=](const Value& v) { return py::make_tuple(packed(v.*members)...); },
                    [=](const py::tuple& t) {
                      Value out{};
                      std::size_t k = 0;
                      (void(out.*members = unpacked<Members>(t[k++])), ...);
                      return out;
                    });
}

/// The same of a value that has no empty state: all its members, in their order.
template <class Value, class... Members>
auto pickled_whole(Members Value::*... members) {
  return py::pickle([=](const Value& v) { return py::make_tuple(v.*members...); },
                    [](const py::tuple& t) {
                      std::size_t k = 0;
                      return Value{t[k++].cast<Members>()...};
                    });
}

}  // namespace findspace::python
