// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A packing problem that is put on its grid once, for many questions: what Packing and SolidPacking share in Python.
#pragma once

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "findspace/pack_search.h"
#include "interruptible.h"
#include "numbers.h"
#include "packing.h"

namespace findspace::python {

/// Processes as an object of Python: number(), any(own), best_of(cost, own) with own in bytes.
class PeersOfPython final : public PackPeers {
 public:
  /// TypeError where it is none; nothing for None.
  static std::unique_ptr<PeersOfPython> of(const py::object& peers);

  std::size_t number() const override;
  bool any(bool own) override;
  std::string best_of(std::span<const double> cost, std::string own) override;

 private:
  explicit PeersOfPython(py::object peers) : peers_(std::move(peers)) {}

  py::object peers_;
};

/// The packing that a layout is asked with: the one given, or that of the problem which the layout remembers.
template <class Packing>
Packing packing_of(const py::object& layout, const std::optional<Packing>& given) {
  if (given) return *given;
  if (!py::hasattr(layout, "problem")) throw py::type_error("this layout does not know its problem: give it");
  return layout.attr("problem").cast<Packing>();
}

template <class Packing>
Packing packing_read(const std::string& text, const std::string& name, const std::optional<std::string>& folder,
                     const std::optional<ReadOptions>& reading, const py::object& gap, const py::object& edge,
                     const py::object& height) {
  const PackReading how{name, folder, reading.value_or(ReadOptions()), number(gap), number(edge), amount(height)};
  return interruptible([&] { return Packing::json(text, how); });
}

template <class Packing, class Layout>
Remembering<Layout> searched(const Packing& packing, const std::optional<Options>& options,
                             const std::optional<Layout>& start,
                             const std::function<void(const Heard<Layout>&, const PackProgress&)>& better,
                             const std::function<void(const PackProgress&)>& progress, const py::object& peers,
                             const py::kwargs& words) {
  const Options asked = search_options(options, words);
  const auto team = PeersOfPython::of(peers);
  const py::object known = py::cast(packing.problem());
  PackSearch<Layout> how{start, {}, {}, team.get()};
  if (better)
    how.better = [&](const Layout& layout, const PackProgress& state) {
      const py::gil_scoped_acquire held;
      better({layout, known}, state);
    };
  if (progress)
    how.progress = [&](const PackProgress& state) {
      const py::gil_scoped_acquire held;
      progress(state);
    };
  return {interruptible([&] { return packing.search(asked, how); }), known};
}

template <class Packing, class Problem, class Layout>
py::class_<Packing> bind_packing_of(py::module_& m, const char* name, const char* doc) {
  py::class_<Packing> packing(m, name, doc);
  packing.def(py::init<const Problem&>(), py::arg("problem"))
      .def(py::pickle([](const Packing& p) { return py::make_tuple(p.problem()); },
                      [](const py::tuple& t) { return Packing(t[0].cast<Problem>()); }))
      .def_static("json", &packing_read<Packing>, py::arg("text"), py::arg("name") = "problem",
                  py::arg("folder") = py::none(), py::arg("reading") = py::none(), py::arg("gap") = 0,
                  py::arg("edge") = 0, py::arg("height") = py::none(),
                  R"doc(A problem as nesting JSON (docs/nesting.md).

Parameters
----------
text : str
name : str
    What messages call it; files of shapes lie beside it.
folder : str, optional
    Or in this folder.
reading : ReadOptions, optional
    What may be opened, and at what cost.
gap, edge : number
    Least distances of parts, and of parts to the sides, where the text says none.
height : number, optional
    Of a strip, instead of what the problem says holds the parts.

Raises
------
Error
    Of code 'syntax' with line and column.
)doc")
      .def_property_readonly(
          "problem", [](const Packing& p) { return p.problem(); }, "As it was given, a copy.")
      .def_property_readonly("notes", &Packing::notes, "What was changed or left unread. A pickle leaves them out.")
      .def_property_readonly("copies", &Packing::copies, "How many copies of all parts are wanted.")
      .def_property_readonly(
          "lower_bound", [](const Packing& p) { return p.lower_bound().text(); },
          "No layout is shorter (of solids lower), exactly, as text; on sheets or in containers how few of them no "
          "layout\n"
          "of all parts goes below; of a box no area is smaller.")
      .def("search", &searched<Packing, Layout>, py::arg("options") = py::none(), py::kw_only(),
           py::arg("start") = py::none(), py::arg("better") = py::none(), py::arg("progress") = py::none(),
           py::arg("peers") = py::none(),
           R"doc(The best layout found, or None, as `pack`. Ctrl-C ends the search.

Parameters
----------
options : Options, optional
    Or its words.
start : layout, optional
    Of all copies, to begin with.
better : callable, optional
    Called with each better layout and a `PackProgress` at once. The layout is proved.
progress : callable, optional
    Called every while with a `PackProgress`.
peers : object, optional
    Other processes that search with this one, all alike: `number()` from 0, `any(own)` whether one says so, and
    `best_of(cost, own)` the bytes of the one with the least list of costs, of equal ones the first.

Raises
------
Error
    Where the layout to start with is none of this problem; and as the problem is refused.

Notes
-----
What the functions raise ends the search.
)doc")
      .def(
          "verdict", [](const Packing& p, Layout l) { return interruptible([&] { return p.verdict(l); }); },
          py::arg("layout"), "Whether a layout keeps all promises, by exact signs: a PackVerdict.")
      .def(
          "layout",
          [](const py::object& self, const std::string& text, const std::string& called) {
            const auto& p = self.cast<const Packing&>();
            return Remembering<Layout>{interruptible([&] { return std::optional(p.layout(text, called)); }),
                                       self.attr("problem")};
          },
          py::arg("json"), py::arg("name") = "layout",
          "A layout of this problem from JSON (docs/nesting.md). An error has line and column.");
  py::implicitly_convertible<Problem, Packing>();
  return packing;
}

}  // namespace findspace::python
