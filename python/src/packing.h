// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What packing in the plane and in space share in Python.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "findspace/packing.h"
#include "interruptible.h"
#include "numbers.h"
#include "options.h"
#include "pickles.h"

namespace findspace::python {

/// Members as Python shows them: exact numbers as text, rings as lists of pairs of text.
inline std::string shown(const Number& number) { return number.text(); }
inline std::pair<std::string, std::string> shown(const Point& p) { return {p.x.text(), p.y.text()}; }
template <class Value>
auto shown(const std::optional<Value>& value) {
  return value ? std::optional(shown(*value)) : std::nullopt;
}
template <class Value>
auto shown(const std::vector<Value>& values) {
  std::vector<decltype(shown(values[0]))> out;
  for (const Value& value : values) out.push_back(shown(value));
  return out;
}
/// For `.def_property_readonly("gap", showing(&PackProblem::gap), ...)`.
template <class Of, class Member>
auto showing(Member Of::*member) {
  return [member](const Of& of) { return shown(of.*member); };
}

/// The conditions of pairs, which problems of the plane and of space have alike.
template <class Problem>
void bind_conditions(py::class_<Problem>& problem) {
  problem.def_readonly("name", &Problem::name, "How files call it.")
      .def_property_readonly("gap", showing(&Problem::gap), "The least distance of two parts, exactly, as text.")
      .def_property_readonly("edge", showing(&Problem::edge),
                             "The least distance of a part to the sides of what holds it, exactly, as text.")
      .def_property_readonly(
          "gaps",
          [](const Problem& p) {
            std::vector<std::tuple<std::string, std::string, std::string>> out;
            for (const PackGap& g : p.gaps) out.emplace_back(g.first, g.second, g.gap.text());
            return out;
          },
          "Wider gaps of two kinds, (first, second, gap), exactly, as text.")
      .def_property_readonly(
          "conditions",
          [](const Problem& p) {
            std::vector<std::tuple<std::string, std::string, std::string>> out;
            for (const PackCondition& c : p.conditions) out.emplace_back(c.first, c.second, c.where);
            return out;
          },
          "Of two kinds, (first, second, formula of 'self' and 'other').")
      .def_readonly("where", &Problem::where, "What holds for any two copies, or ''.")
      .def_readonly("groups", &Problem::groups, "Kinds that stay together.");
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

/// A layout that was found, if any. In Python it remembers its problem, for pictures in notebooks.
template <class Layout>
struct Remembering {
  std::optional<Layout> layout;
  py::object problem;
};
/// The same of a layout that a search tells of.
template <class Layout>
struct Heard {
  const Layout& layout;
  const py::object& problem;
};

/// The search for the best layout of the problem, as a packing of Python asks it.
template <class Layout, class Problem>
Remembering<Layout> packed_in_python(const Problem& problem, const std::optional<Options>& options,
                                     const std::function<void(const Heard<Layout>&)>& better, const py::kwargs& words) {
  const Options asked = search_options(options, words);
  const Problem taken = problem;                // other threads of Python may change its parts meanwhile
  const py::object known = py::cast(&problem);  // the object that it is already
  std::function<void(const Layout&)> heard;
  if (better)
    heard = [&](const Layout& layout) {
      const py::gil_scoped_acquire held;
      better({layout, known});
    };
  return {interruptible([&] { return pack(taken, asked, heard); }), known};
}

/// As pickled(), with what it remembers.
template <class Value, class... Members>
auto pickled_with_problem(Members Value::*... members) {
  return py::pickle(
      [=](const py::object& self) {
        const auto& v = self.cast<const Value&>();
        return py::make_tuple(py::make_tuple(packed(v.*members)...), self.attr("__dict__"));
      },
      [=](const py::tuple& t) {
        const auto values = t[0].cast<py::tuple>();
        Value out{};
        std::size_t k = 0;
        (void(out.*members = unpacked<Members>(values[k++])), ...);
        return std::make_pair(out, t[1].cast<py::dict>());
      });
}

}  // namespace findspace::python

template <class Layout>
class pybind11::detail::type_caster<findspace::python::Remembering<Layout>> {
 public:
  static constexpr auto name = const_name("Optional[") + make_caster<Layout>::name + const_name("]");
  template <class T>
  using cast_op_type = findspace::python::Remembering<Layout>;

  static handle cast(const findspace::python::Remembering<Layout>& found, return_value_policy, handle) {
    if (!found.layout) return none().release();
    object out = pybind11::cast(*found.layout);
    out.attr("problem") = found.problem;
    return out.release();
  }
};

template <class Layout>
class pybind11::detail::type_caster<findspace::python::Heard<Layout>> {
 public:
  static constexpr auto name = make_caster<Layout>::name;
  template <class T>
  using cast_op_type = findspace::python::Heard<Layout>;

  static handle cast(const findspace::python::Heard<Layout>& heard, return_value_policy, handle) {
    object out = pybind11::cast(heard.layout, return_value_policy::copy);
    out.attr("problem") = heard.problem;
    return out.release();
  }
};
