// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "command_line/support_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "command_line/help_pages.h"

namespace findspace::app {
namespace {

// A title after '#', then a question a line: its answer for each class of shapes, or one answer for all classes.
constexpr std::string_view kPlaneClasses = "polygons | arcs | chains and points | complements";
constexpr std::string_view kPlane = R"(# Values and truth at a position
`gap`, `distance`, apart | exact · quick
`gap`, `depth`, overlapping | exact · fast | exact · fast | exact · quick | exact · fast
`margin`, `cover` | exact · quick
`reach`, `eta2`, `delta2` | exact · quick
`protrusion`, `hausdorff`, `h` | enclosed 2^-34 · quick
truth of a formula | exact · fast | exact · fast | exact · quick | exact · fast
nearest feasible position | exact · fast
# Regions
whole region, every distance and level | exact · fast
positions on a line | exact · fast
along a direction, every level | exact · fast
# Sums of distances, and distances compared
truth at a position | exact · quick
region, where both sides are equal on lines and circles | exact · fast
region, other curves | inner, outer · slow
least value | enclosed · slow
# Least values (`-> min`, `minimize`, `maximize`)
`reach`, `eta2`, `delta2` | exact · fast
other distances | exact or enclosed 1e-13 · slow
along a direction | exact or 14 digits · slow
coordinates, `distance to` | exact · fast
# Rotation
angles at which a formula holds (`"free": "angle"`) | exact · slow
least values over angles | exact or 13 digits · slow | exact or 13 digits · long | exact or 13 digits · slow | exact or 13 digits · long
`rotating`: `check`, angles about the same point | exact or enclosed 1e-12 · quick
`rotating`: elsewhere, level 0 | exact · fast
`rotating`: elsewhere, other levels | inner, outer · fast
poses: each angle, rotated vertices on the grid | exact · fast
poses: between two angles | inner, outer · fast
# Motion
translation: region, truth, instants | exact · fast
translation: values over time, `-> min` | exact or enclosed 1e-13 · slow
rotation in time: region, instants | inner, outer · slow
rotation in time: values, truth | enclosed; truth may be refused · slow
door leaf: instants, truth | exact · slow
# Placement
one after another | exact · fast
all at once: two shapes, or pairs that form no ring | exact · fast
all at once: pairs that form a ring | exact · long | inner · long | exact · long | exact or inner · long)";

constexpr std::string_view kSpaceClasses = "boxes | convex | round convex | flat faces | round | cut | complements";
constexpr std::string_view kSpace = R"(# Values at a position
`gap`, `distance`, apart | exact · quick | exact · quick | exact · quick | exact · fast | exact · quick | enclosed · slow | exact · fast
`gap`, `depth`, overlapping | exact · quick | exact · quick | exact · quick | exact · slow | enclosed 2^-40 · slow | enclosed · slow | exact · fast
`margin`, `cover` from 0 up | exact · quick | exact · quick | exact · quick | exact · fast | enclosed 2^-40 · slow | enclosed · slow | exact · fast
`margin`, `cover` below 0 | exact · quick | exact · quick | enclosed 2^-40 · quick | exact · slow | enclosed 2^-36 · long | enclosed · slow | exact · fast
`reach` | exact · quick | exact · quick | exact · quick | exact · fast | exact · quick | exact · fast | exact · quick
`eta2`, `delta2` | exact · quick | exact · quick | exact or enclosed 2^-36 · quick | exact · slow | enclosed 2^-36 · slow | enclosed · slow | exact · quick
`protrusion`, `hausdorff`, `h` | enclosed 1e-12 · quick | exact · quick | exact · quick | enclosed 1e-12 · fast | enclosed 1e-12 · fast | enclosed · fast | enclosed 1e-12 · fast
`diameter` | exact · quick | exact · quick | exact · quick | exact · fast | exact · quick | exact or enclosed 2^-16 · fast | exact · quick
along a direction, every distance | exact · quick | exact · quick | exact · quick | exact · slow | exact or enclosed 2^-30 · fast | enclosed · slow | exact · slow
# Truth at a position
where the value is exact | exact
where it is enclosed | refused near the level
nearest feasible position | exact · quick | exact · quick | exact or none · quick | exact or none · quick | exact or none · quick | exact or none · quick | –
# Exact maps
formulas of [commands](commands.md#exact-maps) | exact · quick | exact, one distance · quick | exact, one distance · quick | on lines | on lines | on lines | boxes exact, else on lines · quick
# Maps on lines
`gap` at levels from 0 up | exact · quick | exact · quick | exact · quick | exact · quick | exact · quick | enclosed 2^-30 · slow | exact · quick
`gap` below 0 | exact · quick | exact · quick | exact · quick | exact · fast | enclosed 2^-30 · slow | enclosed 2^-30 · slow | exact · slow
`margin`, `cover` from 0 up | exact · quick | exact · quick | exact · quick | exact · quick | enclosed 2^-30 · slow | exact · quick | exact · quick
`margin`, `cover` below 0 | exact · quick | exact · quick | enclosed 2^-30 · fast | exact · fast | enclosed 2^-30 · slow | enclosed 2^-30 · quick | exact · slow
`eta2`, `delta2` | exact · quick | exact · quick | enclosed 2^-30 · quick | exact · fast | enclosed 2^-30 · slow | enclosed 2^-30 · quick | exact · quick
`reach` | exact · quick | exact · quick | exact · quick | exact · quick | exact · quick | enclosed 2^-30 · quick | exact · quick
`protrusion` up to 0 | exact · quick | exact · quick | exact · quick | exact · quick | enclosed 2^-30 · fast | exact · quick | exact · quick
`protrusion` above 0, `h` | enclosed 2^-30 · quick | exact · quick | exact · quick | enclosed 2^-30 · slow | enclosed 2^-30 · slow | enclosed 2^-30 · long | enclosed 2^-30 · slow
`hausdorff` | enclosed 2^-30 · quick | exact · quick | exact · quick | enclosed 2^-30 · slow | enclosed 2^-30 · slow | enclosed 2^-30 · slow | exact · quick
along a direction, lines that way | exact · quick | exact · quick | exact · quick | exact · quick | enclosed 2^-30 · quick | enclosed 2^-30 · slow | exact · fast
along a direction, other lines | exact · quick | exact · quick | exact or enclosed 2^-30 · quick | exact · slow | enclosed 2^-30 · quick | `gap` from 0 up and `reach` enclosed, others refused · slow | exact · slow
a line of any direction (`"free": {"line": ..}`) | exact · quick | exact · quick | exact · quick | exact · slow | exact · quick | enclosed 2^-30 · fast | exact · quick
# Least values (`-> min`)
`distance`, `depth`, `dstar` | exact · quick | exact · quick | exact · quick | exact · fast | exact · fast | exact or enclosed 2^-30 · fast | refused: no least value
`reach`, `eta2`, `delta2` | exact · quick | exact · quick | exact · quick | exact · slow | enclosed 2^-36 · slow | enclosed 2^-36 · fast | refused: no least value
`gap`, `eta1`, `delta1` | exact or enclosed 2^-40 · quick | exact or enclosed 2^-40 · quick | enclosed 2^-30 · slow | enclosed 2^-40 · long | enclosed 2^-30 · long | enclosed · long | refused: no least value
`protrusion`, where B fits | enclosed 2^-40 · slow | enclosed 2^-36 · quick | enclosed 2^-30 · slow | enclosed 2^-40 · long | enclosed 2^-30 · long | enclosed 2^-36 · slow | refused: no least value
`hausdorff` | enclosed 2^-30 · long | enclosed 2^-36 · quick | enclosed 2^-36 · fast | enclosed 2^-30 · long | enclosed 2^-30 · long | enclosed · long | refused: no least value
`gap`, `eta1`, `delta1` along a direction | exact · quick | exact · quick | exact or enclosed 2^-30 · fast | exact · long | enclosed 2^-14 · slow | enclosed · slow | refused: no least value
# Rotation, motion, placement
orientations: `check` at one | exact · quick | exact · quick | exact · quick | exact · fast | exact · quick | exact · fast | exact · quick
`rotating`, `free` over angles or time; `motion` | refused: not computed
placement one after another | exact · quick | exact · quick | inner, on lines · fast | exact or on lines · fast | inner, on lines · fast | inner, on lines · slow | exact or on lines · fast
placement all at once | exact · quick | refused: slanted faces | refused: slanted faces | refused: slanted faces | refused: slanted faces | refused: slanted faces | refused: slanted faces)";

constexpr std::string_view kIntroduction = R"(# The support table

Which question is answered exactly, for which kind of shape, and what does it cost?

| answer | means |
|---|---|
| exact | decided and computed without error; printed numbers are rounded once |
| enclosed 2^-40 | found by a numerical search; the true value is that near, as a share of the shapes' sizes. `lower`, `upper` and `proven` say how near |
| inner, outer | two certified sets: one of what certainly belongs, one of what possibly belongs |
| inner, on lines | positions that certainly belong; better ones may lie between the lines |
| refused: kind | not computed: an error with the reason, exit status 3; [the kinds](#kinds-of-refusal) |

| cost | one value, one line or one map takes |
|---|---|
| quick | up to 10 milliseconds |
| fast | up to a second |
| slow | up to 10 seconds |
| long | more, up to minutes |

Costs are orders of magnitude, tried on shapes of up to a hundred corners or faces and on meshes of some thousand triangles. [bench](../bench/README.md) has measurements.
A pair of shapes stands in the column of the more general one, which is the one farther to the right. A search that reaches its limit gives bounds, or is refused with a message; `--work-limit` raises it.
In space the searches for one least value, or for one line, look at 1,500,000 cells together: half a minute where six round shapes are cut out, more than a minute where twenty are. Then the least value is told between bounds, and the line is refused.

## In the plane

A map of two stars of 1000 corners takes [a second](../bench/results/cpp-2026-11-22.md). Few questions are refused in the plane; [a list](#refused-in-the-plane) follows.

| column | holds |
|---|---|
| polygons | polygons with holes, boxes |
| arcs | discs, paths with arcs, offsets |
| chains and points | shapes without interior, alone or with others |
| complements | complements of these; distances may be infinite |

)";

constexpr std::string_view kBetween = R"(
### Refused in the plane

| question | reason |
|---|---|
| shapes that rotate in time: truth within the bound of the level | not decided |
| shapes that rotate in time: distances along a direction | only distances in all directions are computed |
| shapes that rotate in time: best positions of `eta` and `delta` | the places where a shape fits come and go |
| shapes that move differently, taken as one (`B1+B2`) | the union changes its form in time |
| `check` of `-> min` with a motion | not computed |
| distances over time, over angles or at an angle | not computed |
| `-> min` over poses | not computed |
| placement all at once with more than 4096 alternatives | too many |
| a distance to an empty shape | there is none |

## In space

| column | holds |
|---|---|
| boxes | shapes whose faces are all parallel to the axes |
| convex | convex polytopes |
| round convex | balls and convex shapes grown by balls |
| flat faces | closed meshes, prisms, height fields, unions of polytopes |
| round | unions with round parts; a round shape beside one of the column before |
| cut | solids that round ones are cut out of (a bowl, a lens) |
| complements | complements of the first four columns |

Under "maps on lines" costs are for each line: a map of 64 × 64 lines has 4096. [meshes-2026-11-23](../bench/results/meshes-2026-11-23.md) measures whole maps.

)";

constexpr std::string_view kNotes = R"(
Some cells need more words:

| cells | remark |
|---|---|
| cut | of two such shapes, or one and a complement, values and lines are told between wide ends ([distances.md](distances.md#two-such-shapes)) |
| complements of round shapes | as "round"; complements of cut shapes are refused, and two complements |
| `margin` below 0, round convex | exact into a shape that is as round or rounder |
| `eta2` in a ball | of more than 40 corners or balls: enclosed 2^-36 |
| fits of zero clearance, round | where other than flat faces hold the shape, or no single part holds it, the value may have no upper end |
| containment in "round" along a direction, other lines | level 0 only |
| containment in "round", B about an inner edge at which walls of parts meet aslant | level 0 is not decided; along a direction mostly refused |
| least `protrusion`, round | in unions of round parts the search mostly ends at its limit |
| least values along a direction, round | where sets of positions touch without overlapping, `bound` is far from the value |
| least values along a direction, cut | of `gap` and of a cut shape in a round one `bound` may be far from the value |
| orientations | elsewhere as for the rotated shape; a box rotated by other than quarters is a convex polytope |
| "exact or none" | given where the region is one convex polytope, or one grown by a ball |

### Kinds of refusal

| kind | the message says |
|---|---|
| not computed | that this distance or question is not computed |
| no least value | that a distance to a complement has no least value |
| slanted faces | that all faces must be parallel to the axes |
)";

std::vector<std::string_view> split(std::string_view text, std::string_view by) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(by); end != text.npos; end = text.find(by)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + by.size());
  }
  parts.push_back(text);
  return parts;
}

/// A question and its answers, one for each class.
struct Row {
  std::string_view query;
  std::vector<std::string_view> answers;
};

struct Group {
  std::string_view title;
  std::vector<Row> rows;
};

std::vector<Group> groups_of(std::string_view table, std::size_t classes) {
  std::vector<Group> groups;
  for (const std::string_view line : split(table, "\n")) {
    if (line.starts_with("# ")) {
      groups.push_back({line.substr(2), {}});
      continue;
    }
    std::vector<std::string_view> cells = split(line, " | ");
    const std::string_view query = cells.front();
    cells.erase(cells.begin());
    if (cells.size() == 1) cells.resize(classes, cells.front());
    groups.back().rows.push_back({query, cells});
  }
  return groups;
}

std::string markdown(std::string_view table, std::string_view names) {
  const std::size_t classes = split(names, " | ").size();
  std::string out;
  for (const Group& group : groups_of(table, classes)) {
    out += fmt::format("{}### {}\n\n| query | {} |\n|", out.empty() ? "" : "\n", group.title, names);
    for (std::size_t i = 0; i <= classes; ++i) out += "---|";
    for (const Row& row : group.rows) out += fmt::format("\n| {} | {} |", row.query, fmt::join(row.answers, " | "));
    out += '\n';
  }
  return out;
}

/// Without the marks of markdown.
std::string plain(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with("]("))
      i = text.find(')', i);
    else if (text[i] != '`' && text[i] != '[')
      out += text[i];
  }
  return out;
}

/// A line for each answer, with the classes that have it.
std::string terminal_row(const Row& row, const std::vector<std::string_view>& classes) {
  std::vector<std::pair<std::string_view, std::vector<std::string_view>>> found;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const auto same =
        std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == row.answers[i]; });
    if (same == found.end()) {
      found.push_back({row.answers[i], {classes[i]}});
    } else {
      same->second.push_back(classes[i]);
    }
  }
  std::string out = fmt::format("  {}\n", plain(row.query));
  for (const auto& [answer, shapes] : found) {
    const bool all = shapes.size() == classes.size();
    out += help_entry(fmt::format("  {}", answer), all ? "all shapes" : fmt::format("{}", fmt::join(shapes, ", ")));
  }
  return out;
}

std::string terminal(std::string_view table, std::string_view names) {
  const std::vector<std::string_view> classes = split(names, " | ");
  std::string out;
  for (const Group& group : groups_of(table, classes.size())) {
    out += fmt::format("\n{}:\n", plain(group.title));
    for (const Row& row : group.rows) out += terminal_row(row, classes);
  }
  return out;
}

}  // namespace

std::string support_page() {
  return fmt::format(R"(Which question is answered exactly, for which shapes, and at what cost?

exact: computed without error. enclosed: as near to the true value as the number says.
inner, outer: two certified sets. refused: an error with the reason, exit status 3.
quick: up to 10 milliseconds. fast: up to a second. slow: up to 10 seconds. long: more.
A pair of shapes has the answer of the more general one, which stands later in this list:
  in the plane   {}
  in space       {}
docs/support.md has the same as tables, and says what each kind of shape holds.

IN THE PLANE
{}
IN SPACE
{})",
                     fmt::join(split(kPlaneClasses, " | "), ", "), fmt::join(split(kSpaceClasses, " | "), ", "),
                     terminal(kPlane, kPlaneClasses), terminal(kSpace, kSpaceClasses));
}

std::string support_markdown() {
  return fmt::format("{}{}{}{}{}", kIntroduction, markdown(kPlane, kPlaneClasses), kBetween,
                     markdown(kSpace, kSpaceClasses), kNotes);
}

}  // namespace findspace::app
