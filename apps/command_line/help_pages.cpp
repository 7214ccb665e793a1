// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "command_line/help_pages.h"

#include <findspace/vocabulary.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "command_line/support_table.h"

namespace findspace::app {
namespace {

constexpr std::size_t kTextColumn = 30, kColumns = 100;

constexpr std::string_view kExamples[] = {
    "findspace map scene.json                         the feasible region in words",
    "findspace map scene.json -o map.svg --json       a picture, and the region as JSON",
    "findspace map scene.json --apply boundary        its boundary",
    "cat scene.json | findspace map -                 the scene from standard input",
    "findspace check scene.json --at 12.5,7           is this position feasible, and why (not)",
    "findspace explain scene.json                     why nothing is feasible, or the slack of each level",
    "findspace measure scene.json --at 12.5,7         all distances there",
    "findspace describe scene.json board              a shape as a point set",
    "findspace convert scene.json board -o board.wkt  a shape in another format",
    "findspace convert part.dxf -o part.svg           a drawing in another format",
    "findspace place scene.json -o placed.svg         positions for several shapes",
    "findspace pack parts.json -o layout.svg          parts on a strip, as short as possible",
    "findspace pack lid.dxf x12 --height 400          the same of drawings, each with its count",
    "findspace verify layout.json parts.json          is this layout feasible, exactly",
    "findspace batch questions.jsonl -o results.jsonl  many questions, over all cores and restarts",
    "findspace phi scene.json A B --at 3,4            do A and B moved by (3, 4) overlap or touch",
    "findspace serve --stdio scene.json               answers requests, a line each",
    "findspace view scene.json                        the scene in the browser, with a part to drag",
};

constexpr std::string_view kStatus = R"(
Exit status: 0 done, and not empty or true; 1 proven empty or false; 2 wrong usage; 3 bad input;
4 a limit was reached; 70 internal error; 130 interrupted.)";

/// Letters, not bytes.
std::size_t width(std::string_view text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

/// What a distance is, in the order of their words.
constexpr std::array<std::string_view, 14> kMeanings{
    "the gap between B and A; 0 where they touch; below 0 minus the depth of the overlap",
    "the largest distance between a point of B and a point of A",
    "how far B is from lying in A; below 0 minus the margin",
    "the largest translation to a position where B touches A from inside",
    "how far B is from covering A; below 0 minus the margin",
    "the largest translation to a position where B touches A while covering it",
    "how far B extends beyond A; below 0 inside",
    "the Hausdorff distance of B and A",
    "the plain distance; 0 where the shapes meet",
    "the largest distance between a point of B and a point of A",
    "how far B extends beyond A; 0 inside",
    "how deep A lies in B; 0 where it does not",
    "the diameter of both together",
    "the depth of the overlap; 0 where there is none"};

/// A word that a newcomer reads, not a letter of the literature.
bool is_plain(std::string_view name) {
  return name.size() > 2 && std::all_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

/// All words with this value, plain ones first: of these the later rows, which are the plain English ones.
std::vector<std::string> words_of(const std::string& distance, bool exchanged, bool negated) {
  std::vector<std::string> plain, others;
  std::string symbol;
  for (const DistanceWord& row : distance_words()) {
    if (row.distance != distance) continue;
    symbol = row.symbol;
    if (row.exchanged != exchanged || row.negated != negated) continue;
    if (is_plain(row.word)) {
      plain.insert(plain.begin(), row.word);
    } else {
      others.push_back(row.word);
    }
  }
  plain.insert(plain.end(), others.begin(), others.end());
  if (!exchanged && !negated && std::find(plain.begin(), plain.end(), symbol) == plain.end()) plain.push_back(symbol);
  return plain;
}

/// One word a distance.
std::vector<DistanceWord> distances() {
  std::vector<DistanceWord> words = distance_words();
  words.resize(kMeanings.size());
  return words;
}

std::string distance_list() {
  std::string out;
  const std::vector<DistanceWord> all = distances();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& distance = all[i].distance;
    const std::vector<std::string> straight = words_of(distance, false, false);
    out += help_entry(fmt::format("{}", fmt::join(straight, " ")), kMeanings[i]);
    const std::vector<std::string> negated = words_of(distance, false, true);
    if (!negated.empty())
      out += help_entry(fmt::format("{}", fmt::join(negated, " ")), fmt::format("minus {}", distance));
    const std::vector<std::string> exchanged = words_of(distance, true, false);
    if (!exchanged.empty())
      out += help_entry(fmt::format("{}", fmt::join(exchanged, " ")),
                        fmt::format("{} with the shapes exchanged", straight.front()));
  }
  return out;
}

/// "<=" of ">=".
std::string mirrored_sign(std::string sign) {
  if (sign[0] == '<' || sign[0] == '>') sign[0] = sign[0] == '<' ? '>' : '<';
  return sign;
}

/// "clear(B, A, c)" and "gap(B, A) >= c".
std::string predicate_entry(const PredicateWord& row) {
  const std::vector<std::string> negated = words_of(row.distance, false, true);
  const bool mirrored = row.negated && !negated.empty();
  const std::string distance = mirrored ? negated.front() : words_of(row.distance, false, false).front();
  const std::string sign = mirrored ? mirrored_sign(row.relation) : row.relation;
  const bool level = row.level != PredicateWord::Level::kNone;
  const std::string call = fmt::format("{}(B, A{})", row.word, level ? ", c" : "");
  const std::string number = !level ? "0" : row.negated && !mirrored ? "-c" : "c";
  const std::string_view without = row.level == PredicateWord::Level::kOptional ? "; c is 0 where left out" : "";
  return help_entry(call, fmt::format("{}(B, A) {} {}{}", distance, sign, number, without));
}

/// The words of distances that take along=, toward= and rotating=.
std::string directional_names() {
  std::vector<std::string> all;
  for (const DistanceWord& row : distances()) {
    if (!row.directional) continue;
    const std::vector<std::string> negated = words_of(row.distance, false, true);
    all.push_back(negated.empty() ? words_of(row.distance, false, false).front() : negated.front());
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

std::string formula_page() {
  std::string predicates;
  for (const PredicateWord& row : predicate_words()) predicates += predicate_entry(row);
  return fmt::format(R"(The formula says where the moving shape may be. It stands in the scene under "where".

  inside(chip, board, 1mm) and gap(chip, screws) >= 0.5 and gap(chip, key) <= 12.5

A distance of two shapes is compared with a number, or with another: gap(B, A) <= gap(B, C).
Sums have factors: gap(B, A) + 2 * gap(B, C) <= 5. One of the two shapes is the moving one.
B stands for the moving shape and A for a fixed one.

Comparisons:
{}{}{}
Joining, the tightest first:  not  and  or  ( )
Numbers are exact decimals, in the scene's unit. They may carry a unit: {}.
Angles are in degrees.

Distances (names in a row mean the same):
{}
Predicates:
{}
One more argument counts some motions only: gap(B, A, along=(1, 0)).
{}{}{}It is taken by {}.

In a scene with a motion, inf gap(B, A) is the least value over time, sup gap(B, A) the largest.

A name of a shape that is not a plain word stands in quotes: gap(B, "my part").
A1+A2 is the union of two shapes: gap(B, A1+A2).

docs/formula.md is the manual; docs/distances.md has the definitions.
)",
                     help_entry("<  <=  =  !=  >=  >", "gap(B, A) >= 0.5, or 0.5 <= gap(B, A) <= 2"),
                     help_entry("-> min", "reach(B, A) -> min: as small as it is at any position"),
                     help_entry("true, false", "everywhere, nowhere"), unit_list(), distance_list(), predicates,
                     help_entry("along=(X, Y[, Z])", "translations both ways along this direction"),
                     help_entry("toward=(X, Y[, Z])", "translations of B this way"),
                     help_entry("rotating=(X, Y)", "rotations of B about this point, in degrees; in the plane"),
                     directional_names());
}

struct Line {
  std::string_view name, text;
};

constexpr Line kSceneKeys[] = {
    {"findspace", "1, the version of this format; required"},
    {"shapes", "an object, name to shape; required"},
    {"unit", ""},
    {"grid", "the step of the grid in that unit; default 1e-6"},
    {"moving", "the shape that moves, or a list of shapes that move together"},
    {"groups", "an object, name to list of shapes; empty lists are the empty set"},
    {"y", "up or down: how the y axis runs in pictures"},
    {"where", "the conditions: findspace help formula"},
    {"minimize, maximize", "a distance, a sum of distances, x, y, z, or \"distance to [X, Y]\""},
    {"free", "what the map is over: position (default), angle, pose, time, or {\"line\": {..}}"},
    {"about, angles",
     "of angle and pose: the centre of the rotation, and the angles in degrees, in space also orientations"},
    {"curves, tolerance", "arcs for other curves: inside, outside or near (default), and how far off at most"},
    {"join, open_lines", "of drawings: gaps up to this length are closed; true: open lines are polylines"},
    {"parts", "of drawings: one (all outlines together), elements (each is its area), outlines (each with its holes)"},
    {"mend", "of drawings: outlines that cross by no more than this are mended; 0 refuses them"},
    {"repair, close_holes", "of meshes: what is no farther apart is joined; holes up to this width are closed"},
    {"motion", "shapes that move in time: way points, times, angles"},
    {"place", "several shapes to place: shapes, each, pairs, constraints, minimize, method, angles, count"},
    {"$schema", "the address of docs/scene.schema.json, for editors; not read"}};

constexpr Line kPlaneShapes[] = {
    {"polygon, holes", "a ring [[X, Y], ..] and rings in it"},
    {"disc", "{\"center\": [X, Y], \"radius\": R}"},
    {"box", "{\"min\": [X, Y], \"max\": [X, Y]}"},
    {"path", "SVG path data, all commands; y points upwards"},
    {"outline", "[[X, Y], step, ..]; steps: points, or to with through, center, bulge; bezier"},
    {"ellipse", "{center, radii, rotate}"},
    {"bezier", "[[X, Y], ..], the control points; with weights"},
    {"spline", "{degree, points, knots, weights, closed}"},
    {"points", "isolated points [[X, Y], ..]"},
    {"polyline", "an open chain [[X, Y], ..]"},
    {"cells", "an exact boundary, as convert writes it"},
    {"file", "a .svg .dxf .wkt .geojson .json; with id, layer, index, unit, join, mend"}};

constexpr Line kSpaceShapes[] = {
    {"polytope", "the convex hull of points [[X, Y, Z], ..]"},
    {"box", "{\"min\": [X, Y, Z], \"max\": [X, Y, Z]}"},
    {"ball", "{\"center\": [X, Y, Z], \"radius\": R}"},
    {"prism", "{\"polygon\": [..], \"holes\": [..], \"z\": [LOW, HIGH]}"},
    {"height_field", "{\"heights\": [[Z, ..], ..], \"step\": [DX, DY], \"floor\": Z}, ground; also at"},
    {"mesh", "{\"vertices\": [..], \"faces\": [..]}, closed"},
    {"file", "a .stl .obj .off .ply .3mf .glb .asc .step .iges; with unit, floor, repair, close_holes"}};

constexpr Line kMadeShapes[] = {
    {"union, intersection", "of a list of shapes"},
    {"difference", "the first of a list without the others"},
    {"complement", "everything outside a shape"},
    {"interior, closure, boundary", "of a shape"},
    {"regularize", "the closure of the interior"},
    {"translate, of", "a shape moved by [X, Y]"},
    {"rotate, of", "a shape rotated by degrees; with about, and in space axis, or by a quaternion or matrix"},
    {"simplify", "LENGTH, of: arcs for runs of short segments; with curves"},
    {"mirror", "DEGREES, about, of: mirrored in a line"},
    {"point_reflection", "reflected through the origin"},
    {"minkowski_sum", "of two shapes, as minkowski_difference"},
    {"offset, of", "a shape grown by a ball of this radius; below 0 it shrinks"},
    {"hull", "the convex hull"}};

template <std::size_t n>
std::string lines(const Line (&all)[n]) {
  std::string out;
  for (const Line& line : all) {
    const bool unit = line.name == "unit";
    out += help_entry(line.name, unit ? unit_list() + ": the unit of all lengths" : std::string(line.text));
  }
  return out;
}

std::string scene_page() {
  return fmt::format(
      R"page(A scene is a JSON file: shapes, which of them moves, and the conditions. Comments are allowed.

  {{
    "findspace": 1, "unit": "mm",
    "shapes": {{
      "board": {{"polygon": [[0,0], [100,0], [100,60], [0,60]]}},
      "chip": {{"disc": {{"center": [0,0], "radius": 4}}}}
    }},
    "moving": "chip", "where": "inside(chip, board, 1mm)"
  }}

Keys:
{}
Numbers are exact decimals. Every point is rounded once to the grid, and the program says so.
A scene is either in the plane or in space.
A shape is an object with one of these keys, the name of another shape, or a list of shapes.

In the plane:
{}
In space:
{}
Made from others:
{}
docs/scene.md is the manual. With "$schema" editors complete the keys.
)page",
      lines(kSceneKeys), lines(kPlaneShapes), lines(kSpaceShapes), lines(kMadeShapes));
}

std::string debugging_page() {
  return R"page(Where an answer is not what you expected:

  findspace check scene.json --at X,Y --explain

says beside each condition which way decided it, and how many milliseconds it took.

  FINDSPACE_DUMP=DIR findspace map scene.json

writes the geometry of each stage into the folder DIR, numbered in the order of the computation:
SVG in the plane, OBJ in space, in grid steps or in steps that divide them. Stages are parts,
convolution, sum, signs, overlay, region, cells, search. The answer stays the same; it takes one
thread. docs/architecture.md says what each file shows.
)page";
}

constexpr HelpTopic kTopics[] = {
    {"formula", "how conditions are written: distances, predicates, units", formula_page},
    {"scene", "the keys of a scene, and all kinds of shapes", scene_page},
    {"support", "which question is answered exactly for which shapes, and at what cost", support_page},
    {"debugging", "which way answered, and pictures of the stages of an answer", debugging_page},
};

}  // namespace

std::string help_entry(std::string_view name, std::string_view text) {
  std::string out = fmt::format("  {}", name);
  std::size_t column = width(out);
  if (column + 2 > kTextColumn) {
    out += '\n';
    column = 0;
  }
  out.append(kTextColumn - column, ' ');
  column = kTextColumn;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    const std::size_t blank = column > kTextColumn ? 1 : 0;
    if (blank && column + blank + width(word) > kColumns) {
      out += '\n' + std::string(kTextColumn, ' ');
      column = kTextColumn;
    } else if (blank) {
      out += ' ';
      ++column;
    }
    out += word;
    column += width(word);
  }
  return out + '\n';
}

std::string help_examples(std::string_view verb) {
  std::string out = "Examples:\n";
  for (const std::string_view line : kExamples) {
    if (line.find(fmt::format("findspace {}", verb)) != line.npos) out += fmt::format("  {}\n", line);
  }
  return out.append(kStatus);
}

std::string unit_list() {
  const std::vector<std::string> names = unit_words();
  return fmt::format("{} or {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

std::span<const HelpTopic> help_topics() { return kTopics; }

}  // namespace findspace::app
