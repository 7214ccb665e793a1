// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "command_line/verb_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "command_line/help_pages.h"
#include "command_line/option_checks.h"
#include "common/options.h"

namespace findspace::app {
namespace {

constexpr const char *kPlaneGroup = "In the plane", *kSpaceGroup = "In space", *kBoard = "On a board",
                     *kDrawing = "Of drawings", *kLimits = "Limits";

CLI::Option* add_orientation(CLI::App& command, Options& o) {
  return command
      .add_option("--orientation", o.orientation,
                  "rotate the moving shape: a quaternion w,x,y,z, an axis and degrees such as z:90 or 1,1,0:45, or a "
                  "matrix of nine numbers (default: as drawn)")
      ->type_name("ROTATION")
      ->group(kSpaceGroup);
}

/// Of maps on lines in space.
void add_lines(CLI::App& command, std::string_view verb, Options& o) {
  const bool place = verb == "place";
  if (verb == "map") add_orientation(command, o);
  if (!place && verb != "map" && verb != "describe") return;
  auto* resolution = command.add_option("--resolution", o.resolution,
                                        place ? "seek positions on N x N lines, 1 to 16384 (default 128)"
                                              : "answer on N x N lines, 1 to 16384 (default: exactly where that is "
                                                "supported, else on 128 x 128 along each axis)");
  resolution->type_name("N")->check(CLI::Range(1, 16384).description(""))->group(kSpaceGroup);
  if (place) return;
  command.add_option("--step", o.spacing, "answer on lines S apart, in the scene's unit; instead of --resolution")
      ->type_name("S")
      ->excludes(resolution)
      ->group(kSpaceGroup);
  auto* axes =
      command.add_flag("--axes", o.axes, "lines along all three axes: certified components, volume of the surface");
  axes->group(kSpaceGroup);
  command.add_option("--axis", o.axis, "x, y or z: the axis that the lines run along (default z); not with --axes")
      ->type_name("AXIS")
      ->check(CLI::IsMember({"x", "y", "z"}).description(""))
      ->excludes(axes)
      ->group(kSpaceGroup);
  command
      .add_option("--side", o.side,
                  "inner or outer: cells about the lines that lie in the set, or that hold all of it; not with --axes "
                  "(default: "
                  "the lines alone)")
      ->type_name("SIDE")
      ->check(CLI::IsMember({"inner", "outer"}).description(""))
      ->excludes(axes)
      ->group(kSpaceGroup);
}

/// The strip of a packing, and the distances in it.
void add_strip(CLI::App& command, Options& o) {
  command.add_option("--height", o.height, "the height of the strip, instead of the file's")
      ->type_name("H")
      ->check(length_text)
      ->group(kPlaneGroup);
  command.add_option("--gap", o.gap, "the least distance of any two parts (default 0)")
      ->type_name("D")
      ->check(length_text)
      ->group(kPlaneGroup);
  command.add_option("--edge", o.edge, "the least distance of a part to the sides of the strip (default 0)")
      ->type_name("D")
      ->check(length_text)
      ->group(kPlaneGroup);
}

void add_start(CLI::App& command, Options& o) {
  command.add_option("--start", o.start, "a layout to begin with: JSON, or an SVG of sparrow (default: none)")
      ->type_name("FILE")
      ->group(kPlaneGroup);
}

/// How drawings are read, and curves beyond arcs.
// In the order of CurveRule and of PartRule.
const std::vector<std::string> kCurves{"near", "inside", "outside"}, kParts{"one", "elements", "outlines"};

/// Of one of the words.
std::size_t place_of(const std::string& word, const std::vector<std::string>& words) {
  return std::size_t(std::find(words.begin(), words.end(), word) - words.begin());
}

void add_drawings(CLI::App& command, Options& o) {
  command
      .add_option_function<std::string>(
          "--curves", [&o](const std::string& word) { o.drawings.curves = CurveRule(place_of(word, kCurves)); },
          "near, inside or outside: where the arcs lie that stand for curves (default near: on either side)")
      ->type_name("SIDE")
      ->check(CLI::IsMember(kCurves).description(""))
      ->group(kDrawing);
  command
      .add_option("--tolerance", o.drawings.tolerance,
                  "how far arcs may be from their curves, such as 0.01mm (default: 0.001mm, or 64 grid steps)")
      ->type_name("LENGTH")
      ->group(kDrawing);
  command.add_option("--join", o.drawings.join, "close gaps of outlines up to this width (default 0)")
      ->type_name("LENGTH")
      ->group(kDrawing);
  command
      .add_option(
          "--mend", o.drawings.mend,
          "mend outlines that cross by this width at most; 0: refuse them (default: what rounding does, --join)")
      ->type_name("LENGTH")
      ->group(kDrawing);
  command
      .add_flag_function(
          "--open-lines", [&o](std::int64_t) { o.drawings.open_lines = true; },
          "outlines that stay open are lines (default: an error)")
      ->group(kDrawing);
  command
      .add_option_function<std::string>(
          "--parts", [&o](const std::string& word) { o.drawings.parts = PartRule(place_of(word, kParts)); },
          "of a drawing: one (all outlines together), elements (each is its area) or outlines (each with its holes)")
      ->type_name("RULE")
      ->check(CLI::IsMember(kParts).description(""))
      ->group(kDrawing);
  command.add_option("--repair", o.drawings.repair, "join what is not joined in a mesh, up to this width (default 0)")
      ->type_name("LENGTH")
      ->group(kDrawing);
  command.add_option("--close-holes", o.drawings.close_holes, "close holes of a mesh up to this width (default 0)")
      ->type_name("LENGTH")
      ->group(kDrawing);
}

void add_dxf(CLI::App& command, Options& o) {
  command
      .add_option_function<std::string>(
          "--dxf", [&o](const std::string& word) { o.dxf = word == "2000" ? DxfVersion::k2000 : DxfVersion::kR12; },
          "r12 or 2000: the version of a DXF file that is written (default r12, which every program reads)")
      ->type_name("VERSION")
      ->check(CLI::IsMember({"r12", "2000"}).description(""))
      ->group(kDrawing);
}

/// What drawings do not say.
void add_drawn_parts(CLI::App& command, Options& o) {
  command.add_option("--sheet", o.sheet, "sheets of this size for drawings, instead of --height")
      ->type_name("W,H")
      ->check(sheet_text)
      ->group(kDrawing);
  command
      .add_option_function<std::string>(
          "--angles", [&o](const std::string& text) { o.angles = at_commas(text); },
          "the angles at which drawings may lie, in degrees (default 0)")
      ->type_name("DEG[,DEG]")
      ->check(angles_text)
      ->group(kDrawing);
  command.add_option("--tilt", o.tilt, "by how many degrees a copy may be off one of the angles (default 0)")
      ->type_name("DEG")
      ->check(tilt_text)
      ->group(kDrawing);
  command.add_flag("--mirrored", o.mirrored, "drawings may be turned over")->group(kDrawing);
  command.add_option("--unit", o.unit, "the unit of the result (default mm)")
      ->type_name("UNIT")
      ->check(unit_text)
      ->group(kDrawing);
  command.add_option("--layer", o.layer, "the layer of drawings that is read (default: all)")
      ->type_name("NAME")
      ->group(kDrawing);
  add_drawings(command, o);
}

/// Of packing problems and layouts.
void add_packing(CLI::App& command, std::string_view verb, Options& o) {
  const bool pack = verb == "pack";
  command
      .add_option(pack ? "PROBLEM" : "LAYOUT", o.scene,
                  pack ? "the problem, as nesting JSON, or one of solids; or drawings"
                       : "the layout: JSON, or an SVG of sparrow")
      ->required()
      ->type_name("");
  if (pack)
    command.add_option("xN", o.shapes, "how many of a drawing, and further drawings: bracket.dxf x12 lid.svg x3")
        ->expected(0, -1)
        ->type_name("");
  else
    command.add_option("PROBLEM", o.shapes, "the problem of a layout in JSON, or its drawings")
        ->expected(0, -1)
        ->type_name("");
  add_strip(command, o);
  add_drawn_parts(command, o);
  command.add_flag("--json", o.json, "print the result as JSON")->group(kCommon);
  if (!pack) return;
  command
      .add_option(
          "-o,--output", o.outputs,
          "write the layout to FILE: .json, .svg, .dxf; solids also .stl, .obj, .3mf, .glb, .ply, .off, .step; may be "
          "repeated")
      ->type_name("FILE")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false)
      ->group(kCommon);
  add_dxf(command, o);
  add_start(command, o);
  command.add_option("--seed", o.seed, "another search, a whole number from 0 on (default 1)")
      ->type_name("N")
      ->check(seed_text)
      ->group(kPlaneGroup);
  command
      .add_option(
          "--work", o.work,
          "end after N million evaluations a thread (of solids, an island): the same result every time (default: "
          "none)")
      ->type_name("N")
      ->check(length_text)
      ->group(kPlaneGroup);
}

/// Of many questions.
void add_batch(CLI::App& command, Options& o) {
  command.add_option("JOBS", o.scene, "the questions, a JSON object a line")->required()->type_name("");
  command
      .add_option("-o,--output", o.outputs,
                  "the results, a line for each question; what is done is kept beside it until the end")
      ->type_name("FILE")
      ->required()
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false)
      ->group(kCommon);
  command.add_option("--workers", o.workers, "questions answered at once, 0 to 1024 (default 0: one for each core)")
      ->type_name("N")
      ->check(CLI::Range(0, 1024).description(""))
      ->group(kCommon);
  command.add_flag("--as-they-come", o.as_they_come, "print each result when it is there")->group(kCommon);
  command.add_flag("--json", o.json, "print the summary as JSON")->group(kCommon);
}

bool is_packing(std::string_view verb) { return verb == "pack" || verb == "verify"; }

/// What is read, and where the result goes.
void add_files(CLI::App& command, std::string_view verb, Options& o) {
  if (verb == "batch") return add_batch(command, o);
  if (is_packing(verb)) return add_packing(command, verb, o);
  command.add_option("SCENE", o.scene, "the scene file, or a board of KiCad; - reads standard input")
      ->required()
      ->type_name("");
  if (verb == "describe" || verb == "convert")
    command.add_option("SHAPE", o.shapes, "the shape; may be left out where there is one only")
        ->expected(0, 1)
        ->type_name("");
  if (verb == "phi") command.add_option("SHAPE", o.shapes, "the two shapes")->required()->expected(2)->type_name("");
  command
      .add_option("-o,--output", o.outputs,
                  "write the result to FILE, in the format that its ending names; may be repeated")
      ->type_name("FILE")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false)
      ->group(kCommon);
  command.add_flag("--json", o.json, "print the result as JSON")->group(kCommon);
}

/// The position, the angle and the instant that are asked about.
void add_question(CLI::App& command, std::string_view verb, Options& o) {
  const bool phi = verb == "phi", values = verb == "check" || verb == "measure";
  if (phi || values || verb == "map" || verb == "explain") {
    const std::string_view of = verb == "map" ? "of maps over angles or time: " : "";
    const std::string_view otherwise = verb == "check"            ? "required"
                                       : phi || verb == "explain" ? "default: none"
                                                                  : "default: as drawn";
    command
        .add_option("--at", o.at, fmt::format("{}the position, in the scene's unit, taken exactly ({})", of, otherwise))
        ->type_name("X,Y[,Z]")
        ->group(kCommon);
  }
  if (phi) {
    command
        .add_option("--min-distance", o.min_distance, "the least allowed distance, in the scene's unit (default: none)")
        ->type_name("D")
        ->group(kCommon);
    command
        .add_option("--max-distance", o.max_distance,
                    "the greatest allowed distance, in the scene's unit (default: none)")
        ->type_name("D")
        ->group(kCommon);
  }
  if (values || verb == "explain") {
    auto* angle = command.add_option(
        "--angle", o.angle,
        "rotate the moving shape by DEG degrees, counter-clockwise, on a board as it is seen, in space about the "
        "z axis (default 0)");
    angle->type_name("DEG")->group(kCommon);
    add_orientation(command, o)->excludes(angle);
  }
  if (values) {
    command.add_option("--time", o.time, "an instant of the motion, in its own time (default: over all its time)")
        ->type_name("T")
        ->group(kPlaneGroup);
    if (verb == "check")
      command.add_flag("--explain", o.explain, "which way decided each condition, and how many milliseconds it took")
          ->group(kCommon);
    if (verb == "measure") {
      auto* all = command.add_flag("--all", o.all,
                                   "all distances, not only gap, margin, reach, protrusion (both ways) and hausdorff");
      all->group(kCommon);
      auto* only = command.add_option(
          "--only", o.only,
          "this distance alone, such as gap; no other is computed, but over time (default: those five)");
      only->type_name("NAME")->excludes(all)->group(kCommon);
    }
  }
}

/// Of drawings, and the form of the result.
void add_conversions(CLI::App& command, Options& o) {
  command.add_flag("--constructive", o.constructive, "JSON is a scene that makes the shape of simple ones")
      ->group(kPlaneGroup);
  command
      .add_option("--unit", o.unit, fmt::format("of a drawing's numbers: {} (default: what it states)", unit_list()))
      ->type_name("UNIT")
      ->group(kPlaneGroup);
  command.add_option("--id", o.id, "the element of a drawing, SVG or GeoJSON (default: all)")
      ->type_name("ID")
      ->group(kPlaneGroup);
  command.add_option("--layer", o.layer, "the layer of a drawing, DXF or SVG (default: all)")
      ->type_name("LAYER")
      ->group(kPlaneGroup);
  command.add_option("--index", o.index, "which of the drawing's shapes, from 0 (default: all)")
      ->type_name("N")
      ->group(kPlaneGroup);
  command.add_option("--floor", o.floor, "of a grid of heights: where the solid ends below")
      ->type_name("Z")
      ->group(kSpaceGroup);
}

bool asks_a_formula(std::string_view verb) {
  constexpr std::array<std::string_view, 6> kOthers{"describe", "convert", "phi", "batch", "pack", "verify"};
  return std::find(kOthers.begin(), kOthers.end(), verb) == kOthers.end();
}

void add_formulas(CLI::App& command, std::string_view verb, Options& o) {
  const auto text = [&](const char* name, std::string& value, const char* about, const char* type) {
    const auto given = [](const std::string& formula) { return formula.empty() ? "it is empty" : ""; };
    command.add_option(name, value, about)->type_name(type)->check(given)->group(kCommon);
  };
  text("--where", o.where, "the formula that must hold (default: the file's)", "FORMULA");
  if (verb == "map" || verb == "place")
    text("--minimize", o.minimize, "the objective to make least (default: the file's)", "OBJECTIVE");
  if (verb == "map")
    text("--maximize", o.maximize, "the objective to make greatest (default: the file's)", "OBJECTIVE");
}

/// What is asked of a board, which says no question itself.
void add_board(CLI::App& command, std::string_view verb, Options& o) {
  const auto text = [&](const char* name, auto& value, const char* about, const char* type) {
    return command.add_option(name, value, about)->type_name(type)->group(kBoard);
  };
  text("--move", o.move, "the parts that move together, by reference, or a group (default: the file's)", "PART[,PART]")
      ->delimiter(',');
  text("--fixed", o.fixed, "parts that must not move, beside those locked in the board (default: none)", "PART[,PART]")
      ->delimiter(',');
  text("--group", o.groups, "a group of parts, beside those of the board (default: none); once a group",
       "NAME=PART[,PART]");
  if (verb == "map" || verb == "place" || verb == "explain") {
    text("--free", o.free, "angles to add to the part's own, in degrees (default: none)", "DEG[,DEG]")->delimiter(',');
  }
}

/// What a region or a shape is made into.
void add_forms(CLI::App& command, std::string_view verb, Options& o) {
  if (verb == "map" || verb == "convert" || verb == "place") add_dxf(command, o);
  if (verb == "map")
    command
        .add_option("--apply", o.apply,
                    "interior, closure, boundary, regularize or complement of the region (default: the region)")
        ->type_name("OPERATION")
        ->check(CLI::IsMember({"interior", "closure", "boundary", "regularize", "complement"}).description(""))
        ->group(kPlaneGroup);
  if (verb == "map" || verb == "describe")
    command.add_flag("--exact", o.exact, "JSON has the exact cells too, which a scene reads back as the same set")
        ->group(kPlaneGroup);
  if (verb == "convert") add_conversions(command, o);
}

/// Of verbs that answer requests.
void add_service(CLI::App& command, std::string_view verb, Options& o) {
  if (verb == "view") {
    command
        .add_option("SCENE", o.scene,
                    "a scene, drawing, board or packing problem; its folder is the one that files are read from")
        ->required()
        ->type_name("");
    add_strip(command, o);
    add_start(command, o);
    command.add_option("--port", o.port, "the port on the loopback address (default: any that is free)")
        ->type_name("N")
        ->check(CLI::Range(1, 65535).description(""))
        ->group(kCommon);
    command.add_flag("--no-open", o.no_open, "print the link and open no browser")->group(kCommon);
    return;
  }
  command.add_option("SCENE", o.scene, "a scene to begin with; its folder is the one that files are read from")
      ->type_name("");
  command.add_flag("--stdio", o.stdio, "requests on standard input, a line each; answers on standard output")
      ->group(kCommon);
}

/// What one run may read and cost (docs/security.md).
void add_limits(CLI::App& command, Options& o) {
  const auto size = [&](const char* name, std::uint64_t& value, const char* about, const char* type) {
    command
        .add_option_function<std::string>(
            name, [&value](const std::string& t) { value = *size_of(t); }, about)
        ->type_name(type)
        ->check(size_text)
        ->group(kLimits);
  };
  command.add_option("--time-limit", o.time_limit, "give up after S seconds (default 0: never)")
      ->type_name("S")
      ->check(seconds)
      ->group(kLimits);
  size("--memory-limit", o.memory_limit, "give up beyond SIZE bytes of memory, such as 500M or 2G (default: none)",
       "SIZE");
  size("--input-limit", o.input_limit, "read SIZE bytes at most, unpacked (default 256M)", "SIZE");
  size("--work-limit", o.work_limit,
       "refuse what costs more than N units of work: input, constructions, searches in space (default 20000000)", "N");
  auto* none = command.add_flag("--no-files", o.no_files, "take no shapes from files that the scene names");
  none->group(kLimits);
  command
      .add_option("--root", o.root, "take shapes only from files in the folder DIR, wherever links lead (default: any)")
      ->type_name("DIR")
      ->excludes(none)
      ->group(kLimits);
  command
      .add_option("--store", o.store,
                  "keep sums of shapes and Phi-functions in the folder DIR, for further questions and processes")
      ->type_name("DIR")
      ->group(kCommon);
  size("--store-limit", o.store_limit, "keep SIZE bytes there at most; the oldest go first (default 1G)", "SIZE");
}

}  // namespace

void add_options(CLI::App& command, std::string_view verb, Options& o) {
  command.get_help_ptr()->group(kCommon);
  if (verb == "serve" || verb == "view")
    add_service(command, verb, o);
  else
    add_files(command, verb, o);
  if (verb != "pack" && verb != "verify") add_drawings(command, o);
  add_question(command, verb, o);
  add_forms(command, verb, o);
  if (asks_a_formula(verb)) {
    add_formulas(command, verb, o);
    add_board(command, verb, o);
  }
  add_lines(command, verb, o);
  command.add_option("--threads", o.threads, "threads to use, 0 to 4096 (default 0: one for each core)")
      ->type_name("N")
      ->check(thread_count)
      ->group(kCommon);
  add_limits(command, o);
  command.add_flag("-q,--quiet", o.quiet, "no notes, and no summary where files are written")->group(kCommon);
  command.footer(help_examples(verb));
}

}  // namespace findspace::app
