// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "answers.h"

#include <pybind11/stl.h>

#include <array>
#include <map>

#include "files.h"
#include "interruptible.h"
#include "numbers.h"
#include "pickles.h"

namespace findspace::python {
namespace {

std::optional<py::sequence> position_of(const py::handle& at) {
  return at.is_none() ? std::nullopt : std::optional(at.cast<py::sequence>());
}

/// [(name, at), (name, at, degrees), (name, at, degrees, copy)]
std::vector<PlaceQuestion::Near> near_of(const py::iterable& wanted) {
  std::vector<PlaceQuestion::Near> out;
  for (const py::handle each : wanted) {
    const char* const meant = "near: (name, at), (name, at, degrees) or (name, at, degrees, copy)";
    const auto given = each.cast<py::sequence>();
    refuse_text(given, meant);
    if (py::len(given) < 2 || py::len(given) > 4) throw py::value_error(meant);
    PlaceQuestion::Near& one = out.emplace_back(PlaceQuestion::Near{given[0].cast<std::string>()});
    one.at = pose_of(given[1].cast<py::sequence>(), py::none(), py::none()).at;
    if (py::len(given) > 2) one.degrees = amount(given[2]);
    if (py::len(given) > 3) one.copy = given[3].cast<int>();
  }
  return out;
}

/// (lines, apart, axis, side)
std::optional<MapLines> lines_of(const py::tuple& asked) {
  static const std::map<std::string, MapLines::Side> kSides{
      {"", MapLines::Side::kNone}, {"inner", MapLines::Side::kInner}, {"outer", MapLines::Side::kOuter}};
  const auto axis = asked[2].cast<std::string>();
  const auto side = kSides.find(asked[3].cast<std::string>());
  MapLines out;
  out.count = asked[0].cast<int>();
  out.apart = amount(asked[1]);
  out.axes = axis == "xyz";
  if (!out.axes && (axis.size() != 1 || axis[0] < 'x' || axis[0] > 'z'))
    throw py::value_error("axis: 'x', 'y', 'z', or 'xyz' for all three");
  if (side == kSides.end()) throw py::value_error("side: 'inner', 'outer', or ''");
  if (!out.axes) out.axis = Shape::Axis(axis[0] - 'x');
  out.side = side->second;
  if (out.count != 0 || out.apart) return out;
  if (axis != "z" || !side->first.empty()) throw py::value_error("axis and side need lines, or apart");
  return std::nullopt;
}

/// `asked`: of check, measure and explain the position, the angle and the instant, of measure the distances too; of map
/// its position, `apply`, `pictures`, `surface`, `before`, lines_of() and `resolution`; of describe the shape,
/// `surface`, `before` and lines_of(); of place `near` and `lines`; of nearest what a measurement has, of between two
/// places more, of check `nearest` and `snap`.
Answer answer_of(const Scene& scene, const std::string& verb, const py::tuple& asked) {
  if (verb == "map") {
    MapQuestion question{pose_of(position_of(asked[0]), py::none(), py::none()), asked[1].cast<std::string>(),
                         asked[2].cast<bool>(), asked[3].cast<bool>()};
    question.before = asked[4].cast<std::string>();
    question.lines = lines_of(asked[5].cast<py::tuple>());
    question.resolution = asked[6].cast<int>();
    return interruptible([&] { return scene.map(question); });
  }
  if (verb == "describe") {
    const auto shape = asked[0].cast<std::string>();
    const ShapeQuestion question{asked[1].cast<bool>(), lines_of(asked[3].cast<py::tuple>()), true,
                                 asked[2].cast<std::string>()};
    return interruptible([&] { return scene.describe(shape, question); });
  }
  if (verb == "place") {
    const PlaceQuestion question{near_of(asked[0].cast<py::iterable>()), asked[1].cast<int>()};
    return interruptible([&] { return scene.place(question); });
  }
  const Pose pose = pose_of(position_of(asked[0]), asked[1], asked[2]);
  if (verb == "check") {
    const CheckQuestion question{asked[3].cast<bool>(), amount(asked[4])};
    return interruptible([&] { return scene.check(pose, question); });
  }
  if (verb == "nearest") return interruptible([&] { return scene.nearest(pose); });
  if (verb == "between") {
    const Point first = point(asked[3].cast<py::sequence>()), second = point(asked[4].cast<py::sequence>());
    return interruptible([&] { return scene.between(first, second, pose); });
  }
  if (verb == "explain") return interruptible([&] { return scene.explain(pose); });
  const auto words = asked[3].cast<std::vector<std::string>>();
  return interruptible([&] { return scene.measure(pose, words); });
}

template <class Value>
auto read(Value (Answer::*of)() const) {
  return [of](const AnswerOf& a) { return (a.answer.*of)(); };
}

}  // namespace

Pose pose_of(const std::optional<py::sequence>& at, const py::object& degrees, const py::object& time) {
  Pose out{{}, amount(degrees), amount(time)};
  if (!at) return out;
  refuse_text(*at, "a position is (x, y) or (x, y, z)");
  for (const py::object& c : *at) out.at.push_back(number(c));
  return out;
}

AnswerOf answered(const Scene& scene, const std::string& verb, const py::tuple& asked) {
  return {scene, verb, asked, answer_of(scene, verb, asked)};
}

void bind_answer(py::module_& m) {
  py::class_<Measured>(m, "Measured", "One distance of a measurement.")
      .def(pickled<Measured>(&Measured::text, &Measured::value, &Measured::refused))
      .def_readonly("text", &Measured::text, "'gap(B, A)'.")
      .def_readonly("value", &Measured::value, "Its value with its bounds; None where it is not computed.")
      .def_readonly("refused", &Measured::refused, "Why it is not computed, or ''.")
      .def("__repr__", [](const Measured& d) { return "<Measured " + d.text + ">"; });
  py::class_<AnswerOf>(m, "Answer", "What a scene answers: the numbers, and the words, JSON and files of the program.")
      .def(py::pickle([](const AnswerOf& a) { return py::make_tuple(a.scene, a.verb, a.asked); },
                      [](const py::tuple& t) {
                        return answered(t[0].cast<Scene>(), t[1].cast<std::string>(), t[2].cast<py::tuple>());
                      }))
      .def_property_readonly(
          "found",
          [](const AnswerOf& a) {
            static constexpr std::array<const char*, 3> kWords{"yes", "no", "undecided"};
            return kWords[std::size_t(a.answer.found())];
          },
          "'yes'; 'no', which is proven; or 'undecided', as only bounds are known or a limit came first.")
      .def(
          "text",
          [](const AnswerOf& a, bool all, bool explain) { return a.answer.text({.all = all, .explain = explain}); },
          py::arg("all") = false, py::arg("explain") = false,
          "In words. `all`: every distance of a measurement, not only the usual ones; `explain`: which way decided "
          "each condition, and how long it took.")
      .def(
          "json",
          [](const AnswerOf& a, bool all, bool explain, bool exact) {
            return a.answer.json({.all = all, .explain = explain, .exact = exact});
          },
          py::arg("all") = false, py::arg("explain") = false, py::arg("exact") = false,
          "As the program prints it with --json; `exact`: of maps with the exact cells.")
      .def_property_readonly("endings", read(&Answer::endings), "The endings of the files that it can be.")
      .def(
          "file",
          [](const AnswerOf& a, const std::string& ending, const std::string& version) {
            const Region::Drawn drawn = a.answer.file(ending, {.dxf = dxf_version(version)});
            return std::make_pair(drawn.text, drawn.lost);
          },
          py::arg("ending"), py::arg("version") = "R12",
          "The text of a file with that ending, and what it does not say; `version`: of DXF, 'R12' or '2000'.")
      .def_property_readonly("notes", read(&Answer::notes), "What was rounded, and how far, or is not computed.")
      .def_property_readonly(
          "at", [](const AnswerOf& a) { return py::tuple(py::cast(a.answer.at())); },
          "Of a question about one position: which one, after snapping; () of other answers.")
      .def_property_readonly("check", read(&Answer::check), "Of a check: every condition.")
      .def_property_readonly(
          "nearest",
          [](const AnswerOf& a) -> py::object {
            const auto near = a.answer.nearest();
            return near ? py::object(py::make_tuple(py::tuple(py::cast(near->at)), near->distance, near->attained))
                        : py::none();
          },
          "The nearest feasible position, how far it is, and whether it is feasible itself: of a check that fails, and "
          "where that is the question.")
      .def_property_readonly("measured", read(&Answer::measured), "Of a measurement: its distances, pair by pair.")
      .def_property_readonly(
          "region",
          [](const AnswerOf& a) -> py::object {
            const auto r = a.answer.region();
            return r ? py::object(py::make_tuple(r->inner, r->outer)) : py::none();
          },
          "Of a map of positions in the plane: those that certainly belong, and those that possibly do; the same where "
          "it is exact.")
      .def_property_readonly("space_region", read(&Answer::space_region),
                             "Of a map of positions in space: the same, exactly; None of other answers.")
      .def_property_readonly("sampled", read(&Answer::sampled), "Whether it is a map of space on lines.")
      .def_property_readonly("on_lines", read(&Answer::on_lines),
                             "Of such a map: where the lines meet it, cast anew; None of other answers.")
      .def_property_readonly("surface", read(&Answer::surface),
                             "Of a map of positions in space: its surface; None of other answers.")
      .def_property_readonly("best", read(&Answer::best), "Of a map with an objective: the best value, or None.")
      .def_property_readonly("intervals", read(&Answer::intervals),
                             "Of a map of a line, of angles, in degrees, or of instants: what certainly belongs.")
      .def_property_readonly("possible", read(&Answer::possible), "The same of what possibly does.")
      .def_property_readonly("poses", read(&Answer::poses), "Of a map of poses of the plane, or None.")
      .def_property_readonly("explanation", read(&Answer::explanation), "Of an explanation, or None.")
      .def_property_readonly("placement", read(&Answer::placement), "Of a placement: what was put where, or None.")
      .def("__bool__", [](const AnswerOf& a) { return a.answer.found() == Answer::Found::kYes; })
      .def("__repr__", [](const AnswerOf& a) { return "<Answer " + a.answer.text() + ">"; })
      .def("_repr_svg_", [](const AnswerOf& a) { return a.answer.file(".svg").text; });
}

}  // namespace findspace::python
