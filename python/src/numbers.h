// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Python's numbers and points as exact ones: int, decimal.Decimal and text as written, a float as the decimal that it
// prints as.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "findspace/formula.h"
#include "findspace/number.h"

namespace findspace::python {

namespace py = pybind11;

inline Number number(const py::handle& value) {
  if (PyFloat_Check(value.ptr())) return Number(value.cast<double>());
  if (PyUnicode_Check(value.ptr())) return Number(value.cast<std::string>());
  return Number(py::str(value).cast<std::string>());
}

/// Nothing for None.
inline std::optional<Number> amount(const py::object& value) {
  return value.is_none() ? std::nullopt : std::optional(number(value));
}

inline Level level(const py::handle& value) { return number(value); }

/// Python's texts are sequences too, of letters; here one is a slip.
inline void refuse_text(const py::sequence& values, const char* meant) {
  if (PyUnicode_Check(values.ptr()) || PyBytes_Check(values.ptr())) throw py::type_error(meant);
}

/// (x, y)
inline Point point(const py::sequence& p) {
  refuse_text(p, "a point is (x, y)");
  if (py::len(p) != 2) throw py::value_error("a point is (x, y)");
  return {number(p[0]), number(p[1])};
}

/// (x, y, z)
inline Point3 point3(const py::sequence& p) {
  refuse_text(p, "a point of space is (x, y, z)");
  if (py::len(p) != 3) throw py::value_error("a point of space is (x, y, z)");
  return {number(p[0]), number(p[1]), number(p[2])};
}

inline Grid grid(const py::handle& step) { return {number(step)}; }

}  // namespace findspace::python
