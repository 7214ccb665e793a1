// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What packing in the plane and in space share in Python.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "findspace/packing.h"
#include "numbers.h"
#include "options.h"
#include "pickles.h"

namespace findspace::python {

inline std::optional<Number> amount(const py::object& value) {
  return value.is_none() ? std::nullopt : std::optional(number(value));
}

using NamedGap = std::tuple<std::string, std::string, py::object>;
using NamedCondition = std::tuple<std::string, std::string, Formula>;

template <class Problem>
void set_conditions(Problem& problem, const std::vector<NamedGap>& gaps, const std::vector<NamedCondition>& conditions,
                    const std::optional<Formula>& where, std::vector<PackGroup> groups) {
  for (const auto& [first, second, distance] : gaps) problem.gaps.push_back({first, second, number(distance)});
  for (const auto& [first, second, formula] : conditions) problem.conditions.push_back({first, second, formula.text()});
  if (where) problem.where = where->text();
  problem.groups = std::move(groups);
}

inline py::list named(const std::vector<PackGap>& gaps) {
  py::list out;
  for (const PackGap& g : gaps) out.append(py::make_tuple(g.first, g.second, packed(g.gap)));
  return out;
}

inline py::list named(const std::vector<PackCondition>& conditions) {
  py::list out;
  for (const PackCondition& c : conditions) out.append(py::make_tuple(c.first, c.second, c.where));
  return out;
}

template <class Problem>
py::object where_of(const Problem& problem) {
  return problem.where.empty() ? py::none() : py::object(py::str(problem.where));
}

/// 10 seconds where neither a time nor a work is said.
inline Options search_options(const std::optional<Options>& options, const py::kwargs& words) {
  Options asked = options_of(options, words);
  if (!options && !words.contains("seconds") && !words.contains("work")) asked.seconds = 10;
  return asked;
}

}  // namespace findspace::python
