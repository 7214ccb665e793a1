// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Arrays of numpy as spans of positions, without a copy where they are contiguous doubles.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "findspace/error.h"
#include "findspace/number.h"

namespace findspace::python {

namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

/// An array as an argument. Unlike an Array, one that is not filled yet costs no array of numpy.
class Doubles : public Array {
 public:
  Doubles() : Array(py::reinterpret_steal<Array>(py::handle())) {}
  explicit Doubles(Array array) : Array(std::move(array)) {}
};

/// Indices as an argument: nothing is cut off or wrapped to make some of other numbers.
class WholeNumbers : public Indices {
 public:
  WholeNumbers() : Indices(py::reinterpret_steal<Indices>(py::handle())) {}
  explicit WholeNumbers(const py::array& from) : Indices(py::reinterpret_steal<Indices>(py::handle())) {
    const char kind = from.dtype().kind();
    if (from.size() > 0 && kind != 'i' && kind != 'u') throw py::type_error("indices are whole numbers");
    const auto wide = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(from);
    if (!wide) throw py::error_already_set();
    for (py::ssize_t k = 0; k < wide.size(); ++k)
      if (wide.data()[k] != std::int32_t(wide.data()[k]))
        throw py::value_error("the index " + std::to_string(wide.data()[k]) + " is too large");
    static_cast<Indices&>(*this) = Indices::ensure(wide);
  }
};

/// Rows of `Row` of an array of shape (n, columns).
template <class Row, class Values>
std::span<const Row> rows(const Values& values, const char* what) {
  const py::ssize_t columns = py::ssize_t(std::tuple_size_v<Row>);
  if (values.ndim() != 2 || values.shape(1) != columns)
    throw py::value_error(std::string(what) + " have the shape (n, " + std::to_string(columns) + ")");
  return {reinterpret_cast<const Row*>(values.data()), std::size_t(values.shape(0))};
}

inline std::span<const Position> positions(const Array& values, const char* what = "positions") {
  return rows<Position>(values, what);
}

template <class Points>
Array array_of(const Points& points) {
  Array out({py::ssize_t(std::size(points)), py::ssize_t(2)});
  double* to = out.mutable_data();
  for (const Position& p : points) {
    *to++ = p[0];
    *to++ = p[1];
  }
  return out;
}

}  // namespace findspace::python

template <>
class pybind11::detail::type_caster<findspace::python::Doubles> {
 public:
  PYBIND11_TYPE_CASTER(findspace::python::Doubles, handle_type_name<findspace::python::Array>::name);

  bool load(handle from, bool convert) {
    if (!convert && !findspace::python::Array::check_(from)) return false;
    value = findspace::python::Doubles(findspace::python::Array::ensure(from));
    return bool(value);
  }
};

template <>
class pybind11::detail::type_caster<findspace::python::WholeNumbers> {
 public:
  PYBIND11_TYPE_CASTER(findspace::python::WholeNumbers, handle_type_name<findspace::python::Indices>::name);

  bool load(handle from, bool) {
    const auto all = pybind11::array::ensure(from);
    if (all) value = findspace::python::WholeNumbers(all);
    return bool(value);
  }
};
