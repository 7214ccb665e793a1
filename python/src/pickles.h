// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Plain values in a pickle: their members, one after another. Enumerations go as numbers.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <type_traits>

namespace findspace::python {

namespace py = pybind11;

template <class Member>
py::object packed(const Member& member) {
  if constexpr (std::is_enum_v<Member>)
    return py::int_(static_cast<int>(member));
  else
    return py::cast(member);
}

template <class Member>
void unpack(const py::handle& from, Member& member) {
  if constexpr (std::is_enum_v<Member>)
    member = static_cast<Member>(from.cast<int>());
  else
    member = from.cast<Member>();
}

/// For `.def(pickled<Value>(&Value::a, &Value::b))`.
template <class Value, class... Members>
auto pickled(Members Value::*... members) {
  return py::pickle([=](const Value& v) { return py::make_tuple(packed(v.*members)...); },
                    [=](const py::tuple& t) {
                      Value out{};
                      std::size_t k = 0;
                      (unpack(t[k++], out.*members), ...);
                      return out;
                    });
}

}  // namespace findspace::python
