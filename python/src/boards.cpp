// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Circuit boards of KiCad in Python. What a check said is told again from its board and its rules.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <map>

#include "findspace/board.h"
#include "interruptible.h"
#include "numbers.h"
#include "pickles.h"

namespace findspace::python {
namespace {

/// A verdict, with what it was asked of.
struct VerdictOf {
  Board board;
  std::optional<Formula> rules;
  std::string place;
  BoardVerdict verdict;
};

VerdictOf checked(const Board& board, const std::optional<Formula>& rules, const std::string& place) {
  return {board, rules, place, interruptible([&] { return board.check(rules, place); })};
}

using Groups = std::map<std::string, std::vector<std::string>>;

BoardOptions board_options(const std::string& name, const Groups& groups, const std::vector<std::string>& fixed,
                           std::uint64_t input_limit) {
  BoardOptions options{name, {}, fixed, input_limit};
  for (const auto& [group, parts] : groups) options.groups.push_back({group, parts});
  return options;
}

std::vector<std::string> names_of(const py::object& moving) {
  if (py::isinstance<py::str>(moving)) return {moving.cast<std::string>()};
  return moving.cast<std::vector<std::string>>();
}

BoardQuestion question_of(const py::object& move, const std::string& where, const std::string& minimize,
                          const std::string& maximize, bool place, const std::vector<py::object>& angles,
                          const std::string& before) {
  BoardQuestion out{names_of(move), where, minimize, maximize, before, place, {}};
  for (const py::object& angle : angles) out.angles.push_back(number(angle));
  return out;
}

py::tuple packed_board(const Board& board) {
  const BoardOptions& o = board.options();
  Groups groups;
  for (const BoardGroup& group : o.groups) groups[group.name] = group.parts;
  return py::make_tuple(py::bytes(board.source()), o.name, groups, o.fixed, o.input_limit);
}

Board unpacked_board(const py::tuple& t) {
  return Board::text(t[0].cast<std::string>(),
                     board_options(t[1].cast<std::string>(), t[2].cast<Groups>(), t[3].cast<std::vector<std::string>>(),
                                   t[4].cast<std::uint64_t>()));
}

void bind_verdict(py::module_& m) {
  using Broken = BoardVerdict::Broken;
  py::class_<VerdictOf> verdict(m, "BoardVerdict",
                                "What a check of a board says; true where every part keeps the rules.");
  py::class_<Broken>(verdict, "Broken", "A part that breaks the rules.")
      .def_readonly("part", &Broken::part, "Its reference.")
      .def_readonly("at", &Broken::at, "Where its anchor is, in mm.")
      .def_readonly("check", &Broken::check, "What it breaks: of rules about pairs those that do not hold.")
      .def(pickled<Broken>(&Broken::part, &Broken::at, &Broken::check))
      .def("__repr__", [](const Broken& b) { return "<Broken " + b.part + ">"; });
  verdict
      .def(py::pickle([](const VerdictOf& v) { return py::make_tuple(v.board, v.rules, v.place); },
                      [](const py::tuple& t) {
                        return checked(t[0].cast<Board>(), t[1].cast<std::optional<Formula>>(),
                                       t[2].cast<std::string>());
                      }))
      .def_property_readonly(
          "holds", [](const VerdictOf& v) { return v.verdict.holds(); }, "Whether every part keeps the rules.")
      .def("__bool__", [](const VerdictOf& v) { return v.verdict.holds(); })
      .def_property_readonly(
          "parts", [](const VerdictOf& v) { return v.verdict.parts(); }, "How many were asked: those with a body.")
      .def_property_readonly(
          "rules", [](const VerdictOf& v) { return v.verdict.rules(); }, "The rules, also where none were given.")
      .def_property_readonly(
          "notes", [](const VerdictOf& v) { return v.verdict.notes(); }, "What had to be rounded.")
      .def_property_readonly(
          "broken", [](const VerdictOf& v) { return v.verdict.broken(); }, "Those that break them, as in the file.")
      .def(
          "text", [](const VerdictOf& v, bool explain) { return v.verdict.text(explain); }, py::arg("explain") = false,
          "In words; `explain`: which way decided each condition, and how long it took.")
      .def(
          "json", [](const VerdictOf& v, bool explain) { return v.verdict.json(explain); }, py::arg("explain") = false,
          "As `findspace check --json` writes it.")
      .def_property_readonly(
          "svg", [](const VerdictOf& v) { return v.verdict.svg(); }, "The board, with what is wrong on it.")
      .def(
          "_repr_svg_", [](const VerdictOf& v) { return v.verdict.svg(); }, "For notebooks.")
      .def("__str__", [](const VerdictOf& v) { return v.verdict.text(); })
      .def("__repr__", [](const VerdictOf& v) {
        return "<BoardVerdict " + std::to_string(v.verdict.broken().size()) + " of " +
               std::to_string(v.verdict.parts()) + " parts break the rules>";
      });
}

}  // namespace

void bind_boards(py::module_& m) {
  py::class_<Board> board(m, "Board", R"doc(A circuit board of KiCad: rule checks, and worlds in which parts move.

Names are those of docs/boards.md: every part, pad "U3.14", "board", "holes", "keepouts", copper by layer and net, and
lists of parts. Lengths are in millimetres, y runs downwards. It is immutable.

Examples
--------
>>> import findspace as fs
>>> part = '(footprint "a:b" (layer "F.Cu") (at {} 5) (property "Reference" "{}") ' \
...     '(fp_rect (start -1 -1) (end 1 1) (layer "F.CrtYd")))'
>>> board = fs.Board.text('(kicad_pcb (version 20221018) (layers (0 "F.Cu" signal) (44 "Edge.Cuts" user)) ' +
...     '(gr_rect (start 0 0) (end 20 10) (layer "Edge.Cuts"))' + part.format(4, "U1") + part.format("5.5", "U2") + ')')
>>> board.parts
['U1', 'U2']
>>> verdict = board.check("clear(self, others, 0.25mm)")
>>> bool(verdict), [(b.part, b.at) for b in verdict.broken]
(False, [('U1', [4.0, 5.0]), ('U2', [5.5, 5.0])])
>>> board.world("U2").solve("inside(U2, board) and clear(U2, others, 0.25mm)").bounds
(1.0, 1.0, 19.0, 9.0)
)doc");
  bind_verdict(m);
  const auto kLimit = kUsualInput;
  board
      .def_static(
          "file",
          [](const std::string& path, const std::string& name, const Groups& groups,
             const std::vector<std::string>& fixed, std::uint64_t input_limit) {
            const BoardOptions options = board_options(name, groups, fixed, input_limit);
            return interruptible([&] { return Board::file(path, options); });
          },
          py::arg("path"), py::kw_only(), py::arg("name") = "board", py::arg("groups") = Groups(),
          py::arg("fixed") = std::vector<std::string>(), py::arg("input_limit") = kLimit,
          R"doc(A file ".kicad_pcb".

Parameters
----------
path : str
name : str
    How messages call it.
groups : dict of str to list of str
    Lists of parts by names of their own, beside those of the board.
fixed : list of str
    Parts and groups that must not move, beside those that are locked.
input_limit : int
    Bytes.

Raises
------
Error
    Of code 'file'; 'syntax' with the line; 'unknown name' for a part of a group that is none; 'limit'.
)doc")
      .def_static(
          "text",
          [](const std::string& text, const std::string& name, const Groups& groups,
             const std::vector<std::string>& fixed) {
            const BoardOptions options = board_options(name, groups, fixed, kUsualInput);
            return interruptible([&] { return Board::text(text, options); });
          },
          py::arg("kicad_pcb"), py::kw_only(), py::arg("name") = "board", py::arg("groups") = Groups(),
          py::arg("fixed") = std::vector<std::string>(), "The text of such a file.")
      .def(py::pickle(&packed_board, &unpacked_board))
      .def_property_readonly("parts", &Board::parts, "References of the parts that have a body, as in the file.")
      .def_property_readonly("notes", &Board::notes, "What was found odd on the way.")
      .def_property_readonly("source", &Board::source, "The text that it was read from.")
      .def("check", &checked, py::arg("rules") = py::none(), py::arg("place") = "rules",
           R"doc(Whether the rules hold for each part where it stands.

Parameters
----------
rules : Formula or str, optional
    Of `self`; `others` are the parts on the same side of the board. Without rules every body is on the board and
    overlaps no other.
place : str
    What errors in the rules call them.

Returns
-------
BoardVerdict
)doc")
      .def(
          "world",
          [](const Board& b, const py::object& moving) {
            const std::vector<std::string> names = names_of(moving);
            return interruptible([&] { return b.world(names); });
          },
          py::arg("moving"),
          "The world in which a part, a group or a list of these moves; a position is that of the first one's anchor. "
          "Its "
          "degrees go from the x axis to the y axis, clockwise as the board is seen; those of a scene go the other "
          "way.")
      .def(
          "scene",
          [](const Board& b, const py::object& move, const std::string& where, const std::string& minimize,
             const std::string& maximize, bool place, const std::vector<py::object>& angles,
             const std::string& before) {
            const BoardQuestion question = question_of(move, where, minimize, maximize, place, angles, before);
            return interruptible([&] { return b.scene(question); });
          },
          py::arg("move") = std::vector<std::string>(), py::arg("where") = "", py::kw_only(), py::arg("minimize") = "",
          py::arg("maximize") = "", py::arg("place") = false, py::arg("angles") = std::vector<py::object>(),
          py::arg("before") = "",
          R"doc(A scene whose lengths and positions are the board's own.

Parameters
----------
move : str or list of str
    Parts and groups that move, together; in a placement each on its own.
where, minimize, maximize : str
    Formulas, as a scene has them.
place : bool
    It is a placement of these parts.
angles : list of numbers
    The angles that they may have, in degrees as KiCad counts them, from the part's own on.
before : str
    What messages put before the words of the formulas.

Examples
--------
>>> import findspace as fs
>>> part = '(footprint "a:b" (layer "F.Cu") (at 4 5) (property "Reference" "U1") ' \
...     '(fp_rect (start -1 -1) (end 1 1) (layer "F.CrtYd")))'
>>> board = fs.Board.text('(kicad_pcb (version 20221018) (layers (0 "F.Cu" signal) (44 "Edge.Cuts" user)) ' +
...     '(gr_rect (start 0 0) (end 20 10) (layer "Edge.Cuts"))' + part + ')')
>>> board.scene("U1", "inside(U1, board)").map().region[0].bounds
(1.0, 1.0, 19.0, 9.0)
)doc")
      .def("__repr__", [](const Board& b) { return "<Board of " + std::to_string(b.parts().size()) + " parts>"; });
}

}  // namespace findspace::python
