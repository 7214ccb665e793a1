// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The program `findspace`: reads the command line, runs one verb, and rotates whatever happens into an exit status and
// a line that says what was wrong. docs/commands.md is its manual.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "commands.h"
#include "deadline.h"
#include "formula/language/names.h"
#include "plane/base/parallel.h"

namespace findspace::app {
namespace {

constexpr const char* kAbout = "Where can this part go? The exact set of its positions, from a scene file.";
constexpr std::string_view kExamples[] = {
    "findspace map scene.json                         the feasible region in words",
    "findspace map scene.json -o map.svg --json       a picture, and the region as JSON",
    "findspace map scene.json --apply boundary        its boundary",
    "cat scene.json | findspace map -                 the scene from standard input",
    "findspace check scene.json --at 12.5,7           is this position feasible, and why (not)",
    "findspace measure scene.json --at 12.5,7         all distances there",
    "findspace describe scene.json board              a shape as a point set",
    "findspace convert scene.json board -o board.wkt  a shape in another format",
    "findspace convert part.dxf -o part.svg           a drawing in another format",
    "findspace place scene.json -o placed.svg         positions for several shapes",
    "findspace phi scene.json A B --at 3,4            do A and B moved by (3, 4) overlap, touch, or lie apart",
};
constexpr const char* kStatus = R"(
Exit status: 0 done, and not empty or true; 1 proven empty or false; 2 wrong usage; 3 bad input;
4 a limit was reached; 70 internal error; 130 interrupted.)";

/// The end of a help text: examples of one verb, or of all ("").
std::string examples(std::string_view verb) {
  std::string out = "\nExamples:\n";
  for (const std::string_view line : kExamples) {
    if (line.find(fmt::format("findspace {}", verb)) != line.npos) out += fmt::format("  {}\n", line);
  }
  return out + kStatus;
}

using Verb = Outcome (*)(const Options&, Reporter&);

struct VerbEntry {
  const char* name;
  const char* about;
  Verb run;
};

constexpr VerbEntry kVerbs[] = {
    {"map", "the region of all feasible positions", run_map},
    {"check", "is a position feasible: every atom's value and truth", run_check},
    {"measure", "all distances of the moving shape to the others", run_measure},
    {"describe", "a shape of the scene as a point set", run_describe},
    {"convert", "a shape or a drawing in another format", run_convert},
    {"place", "positions for several shapes, one after another or all at once", run_place},
    {"phi", "the Phi-function of two bodies, in the plane or in space", run_phi_verb},
};

bool is(const VerbEntry& verb, std::string_view name) { return verb.name == name; }

/// Of maps on lines in space.
void add_lines(CLI::App& command, const VerbEntry& verb, Options& o) {
  const bool place = is(verb, "place");
  if (!place && !is(verb, "map") && !is(verb, "describe")) return;
  auto* resolution = command.add_option(
      "--resolution", o.resolution,
      place ? "3D: N x N lines where positions are taken on lines" : "3D: on N x N lines, for solids of any shape");
  resolution->type_name("N")->check(CLI::Range(1, 16384));
  if (place) return;
  command.add_option("--step", o.spacing, "3D: on lines so far apart, instead of --resolution")
      ->type_name("S")
      ->excludes(resolution);
  auto* axes =
      command.add_flag("--axes", o.axes, "3D: lines along all three axes: certified components, volume of the surface");
  command.add_option("--axis", o.axis, "3D: the axis that the lines run along; z if left out")
      ->check(CLI::IsMember({"x", "y", "z"}))
      ->excludes(axes);
  command.add_option("--side", o.side, "3D: cells about the lines that lie in the set, or hold all of it")
      ->check(CLI::IsMember({"inner", "outer"}))
      ->excludes(axes);
}

/// What is wrong with a time limit, or nothing. The system's clock takes no more than 1e9.
std::string seconds(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size() && value >= 0 && value <= 1e9) return "";
  return fmt::format("a number of seconds from 0 to 1e9 is meant, not '{}'", text);
}

/// What is wrong with a number of threads, or nothing.
std::string thread_count(const std::string& text) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size() && value >= 0 && value <= 4096) return "";
  return fmt::format("a whole number from 0 to 4096 is meant, not '{}'", text);
}

/// What is read, and where the result goes.
void add_files(CLI::App& command, const VerbEntry& verb, Options& o) {
  command.add_option("SCENE", o.scene, "the scene file; - reads standard input")->required();
  if (is(verb, "describe") || is(verb, "convert"))
    command.add_option("SHAPE", o.shapes, "the shape; may be left out where there is one only")->expected(0, 1);
  if (is(verb, "phi")) command.add_option("SHAPE", o.shapes, "the two shapes")->required()->expected(2);
  command.add_option("-o,--output", o.outputs, "a file for the result, its format by the ending; may be repeated")
      ->type_name("FILE")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  command.add_flag("--json", o.json, "the result as JSON on standard output");
}

/// The position, the angle and the instant that are asked about.
void add_question(CLI::App& command, const VerbEntry& verb, Options& o) {
  const bool phi = is(verb, "phi"), values = is(verb, "check") || is(verb, "measure");
  if (phi || values || is(verb, "map"))
    command.add_option("--at", o.at, "the position, decimals taken exactly")->type_name("X,Y[,Z]");
  if (phi) {
    command.add_option("--min-distance", o.min_distance, "a least allowed distance, adjusted for at --at")
        ->type_name("D");
    command.add_option("--max-distance", o.max_distance, "a greatest allowed distance, adjusted for at --at")
        ->type_name("D");
  }
  if (values) {
    command.add_option("--angle", o.angle, "degrees by which the moving shape is turned, taken exactly")
        ->type_name("DEG");
    if (is(verb, "measure"))
      command.add_flag("--all", o.all, "all distances; without it gap, margin, reach, protrusion, hausdorff");
    command.add_option("--time", o.time, "the instant of the motion, a decimal taken exactly")->type_name("T");
  }
}

/// What a region or a shape is made into.
void add_forms(CLI::App& command, const VerbEntry& verb, Options& o) {
  if (is(verb, "map"))
    command.add_option("--apply", o.apply, "an operation on the region")
        ->check(CLI::IsMember({"interior", "closure", "boundary", "regularize", "complement"}));
  if (is(verb, "map") || is(verb, "describe"))
    command.add_flag("--exact", o.exact, "2D: JSON has the exact cells too, which read back as the same set");
  if (!is(verb, "convert")) return;
  command.add_flag("--constructive", o.constructive, "2D: JSON is a scene that makes the shape of simple ones");
  command.add_option("--unit", o.unit, "of a drawing that states none")->type_name("um|mm|cm|m|in|mil");
  command.add_option("--id", o.id, "the element of a drawing (SVG, GeoJSON)");
  command.add_option("--layer", o.layer, "the layer of a drawing (DXF, SVG)");
  command.add_option("--index", o.index, "which of the drawing's shapes, from 0");
}

void add_options(CLI::App& command, const VerbEntry& verb, Options& o) {
  add_files(command, verb, o);
  add_question(command, verb, o);
  add_forms(command, verb, o);
  add_lines(command, verb, o);
  command.add_option("--threads", o.threads, "threads to use; 0: one for each core")
      ->type_name("N")
      ->check(thread_count);
  command.add_option("--time-limit", o.time_limit, "seconds after which to give up; 0: never")
      ->type_name("S")
      ->check(seconds);
  command.add_flag("-q,--quiet", o.quiet, "no notes, and no summary where files are written");
  command.footer(examples(verb.name));
}

Outcome run(const VerbEntry& verb, const Options& options, Reporter& reporter) {
  const plane::ThreadLimit threads(options.threads);
  // A placement minds its limit itself and gives the best result so far.
  const Deadline deadline(is(verb, "place") ? 0 : options.time_limit);
  return verb.run(options, reporter);
}

/// What went wrong, as an exit status; said on standard error.
int report(Reporter& reporter) {
  try {
    throw;
  } catch (const Error& e) {
    reporter.error(e);
    return e.code() == ErrorCode::kUsage ? kUsage : kBadInput;
  } catch (const std::bad_alloc&) {
    reporter.error("out of memory");
    return kLimit;
  } catch (const std::exception& e) {
    reporter.error(
        fmt::format("internal error: {}\nThis is a bug of findspace. Please report it with the scene.", e.what()));
  } catch (...) {
    reporter.error("internal error\nThis is a bug of findspace. Please report it with the scene.");
  }
  return kInternal;
}

int finish(const Outcome& outcome, const Options& options, Reporter& reporter) {
  reporter.stage("");
  const bool wanted = options.json || !options.quiet || options.outputs.empty();
  const auto put = [](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); };
  if (wanted && outcome.stream) outcome.stream(put);
  if (wanted) put(outcome.text);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    reporter.error("standard output cannot be written");
    return kBadInput;
  }
  return outcome.status;
}

/// "mpa": an unknown verb is answered with the nearest one.
bool is_unknown_verb(int argc, char** argv, Reporter& reporter) {
  if (argc < 2 || argv[1][0] == '-') return false;
  const std::string word = argv[1];
  std::vector<std::string> names;
  for (const VerbEntry& verb : kVerbs) names.push_back(verb.name);
  if (std::find(names.begin(), names.end(), word) != names.end()) return false;
  const std::string near = formula::nearest(word, names);
  reporter.error(fmt::format("there is no verb '{}'{}; the verbs are {}", word,
                             near.empty() ? "" : fmt::format("; did you mean '{}'?", near), fmt::join(names, " ")));
  return true;
}

int program(int argc, char** argv) {
  CLI::App app(kAbout, "findspace");
  app.set_version_flag("--version", "findspace " FINDSPACE_VERSION);
  app.require_subcommand(1);
  app.footer(examples(""));
  Options options;
  for (const VerbEntry& verb : kVerbs) add_options(*app.add_subcommand(verb.name, verb.about), verb, options);
  Reporter errors;
  if (is_unknown_verb(argc, argv, errors)) return kUsage;
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    app.exit(asked);
    return kDone;
  } catch (const CLI::ExtrasError&) {
    errors.error(fmt::format("not expected: {}\nTry 'findspace --help'.", fmt::join(app.remaining(true), " ")));
    return kUsage;
  } catch (const CLI::ParseError& e) {
    errors.error(fmt::format("{}\nTry 'findspace --help'.", e.what()));
    return kUsage;
  }
  Reporter reporter(options.quiet);
  try {
    const std::string name = app.get_subcommands().front()->get_name();
    const VerbEntry& verb =
        *std::find_if(std::begin(kVerbs), std::end(kVerbs), [&](const VerbEntry& v) { return is(v, name); });
    return finish(run(verb, options, reporter), options, reporter);
  } catch (...) {
    return report(reporter);
  }
}

}  // namespace
}  // namespace findspace::app

int main(int argc, char** argv) {
  findspace::app::end_on_interrupt();
  try {
    return findspace::app::program(argc, argv);
  } catch (...) {
    findspace::app::Reporter reporter;
    return findspace::app::report(reporter);
  }
}
