// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a search for a layout tells and what is wrong with a layout, in Python.

#include "packings.h"

#include <array>

#include "pickles.h"

namespace findspace::python {
namespace {

const char* kind_of(const PackFault& fault) {
  static constexpr std::array<const char*, 10> kKinds{"overlap", "gap",   "condition", "outside",    "angle",
                                                      "zone",    "count", "sheets",    "containers", "fixed"};
  return kKinds[std::size_t(fault.kind)];
}

void bind_progress(py::module_& m) {
  py::class_<PackProgress>(m, "PackProgress", R"doc(Where a search for a layout stands.

Examples
--------
A bar of tqdm that runs for ten seconds: ``bar = tqdm(total=10)`` and ::

    packing.search(seconds=10, progress=lambda state: bar.update(state.seconds - bar.n))
)doc")
      .def(pickled<PackProgress>(&PackProgress::seconds, &PackProgress::processor, &PackProgress::length,
                                 &PackProgress::density, &PackProgress::overlap, &PackProgress::since_better))
      .def_readonly("seconds", &PackProgress::seconds, "Since the beginning, by the clock.")
      .def_readonly("processor", &PackProgress::processor, "The same of all threads.")
      .def_readonly("length", &PackProgress::length, "Of the best layout; of solids its height.")
      .def_readonly("density", &PackProgress::density, "Of the best layout.")
      .def_readonly("overlap", &PackProgress::overlap, "Left in the separation under way.")
      .def_readonly("since_better", &PackProgress::since_better, "Seconds since the best layout was found.")
      .def("__repr__", [](const PackProgress& p) {
        return py::str("<PackProgress seconds={:.1f} length={:g} density={:.3f}>")
            .format(p.seconds, p.length, p.density);
      });
}

}  // namespace

std::unique_ptr<PeersOfPython> PeersOfPython::of(const py::object& peers) {
  if (peers.is_none()) return nullptr;
  for (const char* name : {"number", "any", "best_of"})
    if (!py::hasattr(peers, name) || !PyCallable_Check(peers.attr(name).ptr()))
      throw py::type_error("peers have number(), any(own) and best_of(cost, own)");
  return std::unique_ptr<PeersOfPython>(new PeersOfPython(peers));
}

std::size_t PeersOfPython::number() const {
  const py::gil_scoped_acquire held;
  return peers_.attr("number")().cast<std::size_t>();
}

bool PeersOfPython::any(bool own) {
  const py::gil_scoped_acquire held;
  return peers_.attr("any")(own).cast<bool>();
}

std::string PeersOfPython::best_of(std::span<const double> cost, std::string own) {
  const py::gil_scoped_acquire held;
  const std::vector<double> numbers(cost.begin(), cost.end());
  return peers_.attr("best_of")(numbers, py::bytes(own)).cast<std::string>();
}

void bind_packings(py::module_& m) {
  bind_progress(m);
  py::class_<PackFault>(m, "PackFault", "Something that is wrong with a layout.")
      .def(pickled<PackFault>(&PackFault::kind, &PackFault::of, &PackFault::depth, &PackFault::near, &PackFault::text))
      .def_property_readonly("kind", &kind_of,
                             "'overlap', 'gap', 'condition', 'outside', 'angle', 'zone', 'count', 'sheets', "
                             "'containers' or 'fixed'.")
      .def_readonly("of", &PackFault::of, "Copies, 'bracket#3'; or the kind of part, sheet or container.")
      .def_readonly("depth", &PackFault::depth, "How deep an overlap is, how far outside, or how many too many.")
      .def_readonly("near", &PackFault::near, "Where, near there: two coordinates, three in space.")
      .def_readonly("text", &PackFault::text, "In words.")
      .def("__str__", [](const PackFault& f) { return f.text; })
      .def("__repr__", [](const PackFault& f) { return "<PackFault " + f.text + ">"; });
  py::class_<PackVerdict>(m, "PackVerdict", "Whether a layout keeps all promises, by exact signs; true where it does.")
      .def(pickled<PackVerdict>(&PackVerdict::faults, &PackVerdict::used, &PackVerdict::density))
      .def_readonly("faults", &PackVerdict::faults, "What is wrong, the deepest first.")
      .def_property_readonly(
          "used", [](const PackVerdict& v) { return v.used.text(); },
          "How far the parts go on the last sheet, of solids up in the last container: exactly, as text.")
      .def_readonly("density", &PackVerdict::density, "Of the parts in the layout's strip, sheets or containers.")
      .def_property_readonly("feasible", &PackVerdict::feasible, "No fault.")
      .def("__bool__", &PackVerdict::feasible)
      .def("__repr__", [](const PackVerdict& v) {
        return v.feasible() ? std::string("<PackVerdict feasible>")
                            : "<PackVerdict of " + std::to_string(v.faults.size()) + " faults>";
      });
}

}  // namespace findspace::python
