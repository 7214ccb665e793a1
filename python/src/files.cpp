// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What reading may open and cost in Python, and how drawings and meshes are read.

#include "findspace/files.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>

#include "files.h"
#include "pickles.h"

namespace findspace::python {
namespace {

constexpr std::array<const char*, 3> kCurveRules{"near", "inside", "outside"};

constexpr std::array<const char*, 3> kPartRules{"one", "elements", "outlines"};

template <class Rule>
std::optional<Rule> word_of(const std::optional<std::string>& word, const std::array<const char*, 3>& known,
                            const char* what) {
  if (!word) return std::nullopt;
  for (std::size_t k = 0; k < known.size(); ++k)
    if (*word == known[k]) return Rule(k);
  throw py::value_error(std::string(what) + " are '" + known[0] + "', '" + known[1] + "' or '" + known[2] + "'");
}

/// Lengths are text with a unit, or numbers.
std::optional<std::string> length(const py::object& value) {
  return value.is_none() ? std::nullopt : std::optional(number(value).text());
}

void bind_rules(py::module_& m) {
  py::class_<DrawingRules>(m, "DrawingRules", R"doc(Rules of drawings and meshes; None leaves a rule to the file.

Parameters
----------
curves : 'near', 'inside' or 'outside', optional
    On which side of a curve the arcs lie that stand for it.
tolerance : number or str, optional
    How far these may be from it: a length, "0.001mm", or a number in the unit of the scene.
join : number or str, optional
    The widest gap between outlines that is closed.
mend : number or str, optional
    The widest crossing of outlines that is mended; 0: none.
open_lines : bool, optional
    Open outlines are lines, not errors.
parts : 'one', 'elements' or 'outlines', optional
    What the parts of a drawing are: all outlines together, each element as the area that it encloses, or each outline
    that lies in no other, with its holes.
repair : number or str, optional
    Of meshes: the width within which open edges are joined.
close_holes : number or str, optional
    Of meshes: how wide holes may be that are closed.

Examples
--------
>>> import findspace as fs
>>> rules = fs.DrawingRules(curves="inside", tolerance="0.01mm")
>>> rules.over(fs.DrawingRules(curves="near", join=2)).join
'2'
)doc")
      .def(py::init([](const std::optional<std::string>& curves, const py::object& tolerance, const py::object& join,
                       const py::object& mend, std::optional<bool> open_lines, const std::optional<std::string>& parts,
                       const py::object& repair, const py::object& close_holes) {
             return DrawingRules{word_of<CurveRule>(curves, kCurveRules, "curves"),
                                 length(tolerance),
                                 length(join),
                                 length(mend),
                                 open_lines,
                                 word_of<PartRule>(parts, kPartRules, "parts"),
                                 length(repair),
                                 length(close_holes)};
           }),
           py::kw_only(), py::arg("curves") = py::none(), py::arg("tolerance") = py::none(),
           py::arg("join") = py::none(), py::arg("mend") = py::none(), py::arg("open_lines") = py::none(),
           py::arg("parts") = py::none(), py::arg("repair") = py::none(), py::arg("close_holes") = py::none())
      .def(pickled<DrawingRules>(&DrawingRules::curves, &DrawingRules::tolerance, &DrawingRules::join,
                                 &DrawingRules::mend, &DrawingRules::open_lines, &DrawingRules::parts,
                                 &DrawingRules::repair, &DrawingRules::close_holes))
      .def_property_readonly(
          "curves",
          [](const DrawingRules& r) {
            return r.curves ? std::optional<std::string>(kCurveRules[std::size_t(*r.curves)]) : std::nullopt;
          },
          "On which side of a curve the arcs lie that stand for it, or None.")
      .def_readonly("tolerance", &DrawingRules::tolerance, "How far these may be from it, as text, or None.")
      .def_readonly("join", &DrawingRules::join, "The widest gap that is closed, as text, or None.")
      .def_readonly("mend", &DrawingRules::mend, "The widest crossing that is mended, as text, or None.")
      .def_readonly("open_lines", &DrawingRules::open_lines, "Whether open outlines are lines, or None.")
      .def_property_readonly(
          "parts",
          [](const DrawingRules& r) {
            return r.parts ? std::optional<std::string>(kPartRules[std::size_t(*r.parts)]) : std::nullopt;
          },
          "What the parts of a drawing are, or None.")
      .def_readonly("repair", &DrawingRules::repair, "The width within which edges of meshes are joined, or None.")
      .def_readonly("close_holes", &DrawingRules::close_holes, "How wide holes of meshes are closed, or None.")
      .def("over", &DrawingRules::over, py::arg("those"), "These where they say something, else those.");
}

}  // namespace

DxfVersion dxf_version(const std::string& word) {
  if (word == "R12") return DxfVersion::kR12;
  if (word == "2000") return DxfVersion::k2000;
  throw py::value_error("a version of DXF is 'R12' or '2000'");
}

void bind_files(py::module_& m) {
  m.def("drawing_endings", &drawing_endings, py::arg("dimension"),
        R"doc(The endings of drawings (2) or of meshes and models (3) that shapes are read from.

Examples
--------
>>> import findspace as fs
>>> fs.drawing_endings(2)
['.svg', '.dxf', '.wkt', '.geojson']
)doc");
  bind_rules(m);
  py::class_<ReadOptions>(m, "ReadOptions", R"doc(What reading may open and cost; the same limits as the program's.

What goes beyond is refused with an `Error` of code 'limit', 'unsupported' or 'file', and nothing else is opened.

Parameters
----------
files : bool
    Whether shapes may come from other files.
root : str
    These lie in this folder, links followed; '': anywhere.
input_limit : int
    Bytes of all files together, packed ones as they are unpacked.
work_limit : int
    Units of work, of reading, of each shape and of each formula: the same on every machine.
drawings : DrawingRules, optional
    Before those that a scene states.

Examples
--------
>>> import findspace as fs
>>> text = '{"findspace": 1, "shapes": {"A": {"file": "plate.dxf"}}}'
>>> try:
...     fs.Scene.json(text, reading=fs.ReadOptions(files=False))
... except fs.Error as error:
...     print(error.code)
unsupported
)doc")
      .def(py::init([](bool files, std::string root, std::uint64_t input_limit, std::uint64_t work_limit,
                       const std::optional<DrawingRules>& drawings) {
             return ReadOptions{files, std::move(root), input_limit, work_limit, drawings.value_or(DrawingRules())};
           }),
           py::kw_only(), py::arg("files") = true, py::arg("root") = "", py::arg("input_limit") = kUsualInput,
           py::arg("work_limit") = kUsualWork, py::arg("drawings") = py::none())
      .def(pickled<ReadOptions>(&ReadOptions::files, &ReadOptions::root, &ReadOptions::input_limit,
                                &ReadOptions::work_limit, &ReadOptions::drawings))
      .def_readonly("files", &ReadOptions::files, "Whether shapes may come from other files.")
      .def_readonly("root", &ReadOptions::root, "The folder that these lie in, or ''.")
      .def_readonly("input_limit", &ReadOptions::input_limit, "Bytes of all files together.")
      .def_readonly("work_limit", &ReadOptions::work_limit, "Units of work.")
      .def_readonly("drawings", &ReadOptions::drawings, "Rules before those that a scene states.");
}

}  // namespace findspace::python
