// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The programs `findspace` and `findspace-mpi`: reads the command line, runs one verb, and turns whatever happens
// into an exit status and a line that says what was wrong. docs/commands.md is its manual.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "command_line.h"
#include "commands.h"
#include "help_pages.h"
#include "option_checks.h"
#include "plane/base/parallel.h"
#include "row_team.h"
#include "run_limits.h"
#include "session.h"
#include "stage_dump.h"
#include "support_table.h"

namespace findspace::app {
namespace {

constexpr const char* kAbout = "Where can this part go? The exact set of its positions, from a scene file.";
constexpr const char *kCommon = "Common", *kPlane = "In the plane", *kSpace = "In space", *kBoard = "On a board",
                     *kDrawing = "Of drawings";
constexpr const char* kLimits = "Limits";

/// Help for people: an entry a line, wrapped at 100 columns, without the types of arguments.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string type = option->get_type_name();
    return help_entry(make_option_name(option, is_positional) + (type.empty() ? "" : " " + type),
                      option->get_description());
  }
  std::string make_subcommand(const CLI::App* verb) const override {
    return help_entry(verb->get_name(), verb->get_description());
  }
  std::string make_description(const CLI::App* app) const override { return app->get_description() + "\n"; }
  /// One blank line between groups.
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    const std::string text = CLI::Formatter::make_group(group, is_positional, options);
    return is_positional || group == kCommon ? text : text.substr(1);
  }
  std::string make_footer(const CLI::App* app) const override { return app->get_footer() + "\n"; }
};

using Verb = Outcome (*)(const Options&, Reporter&);

struct VerbEntry {
  const char* name;
  const char* about;
  Verb run;
};

constexpr VerbEntry kVerbs[] = {
    {"map", "Answers where the moving shape can go: all its feasible positions.", run_map},
    {"check", "Answers whether a position is feasible: the value and truth of every condition.", run_check},
    {"explain", "Answers why no position is feasible and what would change that, or how much slack each level has.",
     run_explain},
    {"measure", "Answers how far the moving shape is from each other shape.", run_measure},
    {"describe", "Answers what a shape is as a point set: its size, parts, holes and boundary.", run_describe},
    {"convert", "Answers what a shape or a drawing is in another format.", run_convert},
    {"place", "Answers where several shapes can go together, one after another or all at once.", run_place},
    {"phi", "Answers whether two shapes overlap, touch or lie apart, by their Phi-function.", run_phi_verb},
    {"pack", "Answers how parts can be packed into a short strip, or onto few sheets.", run_pack},
    {"verify", "Answers whether a layout is feasible, exactly: overlaps, the strip, angles and counts.", run_verify},
    {"batch", "Answers many questions, a line each, over all cores, machines and restarts.", run_batch},
    {"serve", "Keeps scenes loaded and answers requests of other programs, in JSON-RPC 2.0.", run_serve},
    {"view", "Opens the scene in the browser: drag the part, see the region, and why not.", run_view},
};

bool is(const VerbEntry& verb, std::string_view name) { return verb.name == name; }

/// It answers requests until its client leaves.
bool is_service(const VerbEntry& verb) { return is(verb, "serve") || is(verb, "view"); }

/// Of maps on lines in space.
void add_lines(CLI::App& command, const VerbEntry& verb, Options& o) {
  const bool place = is(verb, "place");
  if (!place && !is(verb, "map") && !is(verb, "describe")) return;
  auto* resolution = command.add_option("--resolution", o.resolution,
                                        place ? "seek positions on N x N lines, 1 to 16384 (default 128)"
                                              : "answer on N x N lines, 1 to 16384 (default: exactly where that is "
                                                "supported, else on 128 x 128 along each axis)");
  resolution->type_name("N")->check(CLI::Range(1, 16384).description(""))->group(kSpace);
  if (place) return;
  command.add_option("--step", o.spacing, "answer on lines S apart, in the scene's unit; instead of --resolution")
      ->type_name("S")
      ->excludes(resolution)
      ->group(kSpace);
  auto* axes =
      command.add_flag("--axes", o.axes, "lines along all three axes: certified components, volume of the surface");
  axes->group(kSpace);
  command.add_option("--axis", o.axis, "x, y or z: the axis that the lines run along (default z); not with --axes")
      ->type_name("AXIS")
      ->check(CLI::IsMember({"x", "y", "z"}).description(""))
      ->excludes(axes)
      ->group(kSpace);
  command
      .add_option("--side", o.side,
                  "inner or outer: cells about the lines that lie in the set, or that hold all of it; not with --axes")
      ->type_name("SIDE")
      ->check(CLI::IsMember({"inner", "outer"}).description(""))
      ->excludes(axes)
      ->group(kSpace);
}

/// The strip of a packing, and the distances in it.
void add_strip(CLI::App& command, Options& o) {
  command.add_option("--height", o.height, "the height of the strip, instead of the file's")
      ->type_name("H")
      ->group(kPlane);
  command.add_option("--gap", o.gap, "the least distance of any two parts (default 0)")->type_name("D")->group(kPlane);
  command.add_option("--edge", o.edge, "the least distance of a part to the sides of the strip (default 0)")
      ->type_name("D")
      ->group(kPlane);
}

void add_start(CLI::App& command, Options& o) {
  command.add_option("--start", o.start, "a layout to begin with: JSON, or an SVG of sparrow")
      ->type_name("FILE")
      ->group(kPlane);
}

/// Of packing problems and layouts.
void add_packing(CLI::App& command, const VerbEntry& verb, Options& o) {
  const bool pack = is(verb, "pack");
  command
      .add_option(pack ? "PROBLEM" : "LAYOUT", o.scene,
                  pack ? "the problem, as nesting JSON" : "the layout: JSON, or an SVG of sparrow")
      ->required()
      ->type_name("");
  if (!pack) command.add_option("PROBLEM", o.shapes, "the problem of a layout in JSON")->expected(0, 1)->type_name("");
  add_strip(command, o);
  command.add_flag("--json", o.json, "print the result as JSON")->group(kCommon);
  if (!pack) return;
  command.add_option("-o,--output", o.outputs, "write the layout to FILE, .json, .svg or .dxf; may be repeated")
      ->type_name("FILE")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false)
      ->group(kCommon);
  add_start(command, o);
  command.add_option("--seed", o.seed, "another search (default 1)")->type_name("N")->group(kPlane);
  command.add_option("--work", o.work, "end after N million evaluations a thread: the same result every time")
      ->type_name("N")
      ->group(kPlane);
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

bool is_packing(const VerbEntry& verb) { return is(verb, "pack") || is(verb, "verify"); }

/// What is read, and where the result goes.
void add_files(CLI::App& command, const VerbEntry& verb, Options& o) {
  if (is(verb, "batch")) return add_batch(command, o);
  if (is_packing(verb)) return add_packing(command, verb, o);
  command.add_option("SCENE", o.scene, "the scene file, or a board of KiCad; - reads standard input")
      ->required()
      ->type_name("");
  if (is(verb, "describe") || is(verb, "convert"))
    command.add_option("SHAPE", o.shapes, "the shape; may be left out where there is one only")
        ->expected(0, 1)
        ->type_name("");
  if (is(verb, "phi")) command.add_option("SHAPE", o.shapes, "the two shapes")->required()->expected(2)->type_name("");
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
void add_question(CLI::App& command, const VerbEntry& verb, Options& o) {
  const bool phi = is(verb, "phi"), values = is(verb, "check") || is(verb, "measure");
  if (phi || values || is(verb, "map") || is(verb, "explain")) {
    const std::string_view of = is(verb, "map") ? "of maps over angles or time: " : "";
    const std::string_view otherwise = is(verb, "check")            ? "required"
                                       : phi || is(verb, "explain") ? "default: none"
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
  if (values) {
    command
        .add_option("--angle", o.angle,
                    "rotate the moving shape by DEG degrees, counter-clockwise, in space about the z axis (default 0)")
        ->type_name("DEG")
        ->group(kCommon);
    command
        .add_option("--orientation", o.orientation,
                    "rotate the moving shape: a quaternion w,x,y,z, an axis and degrees such as z:90 or 1,1,0:45, or a "
                    "matrix of nine numbers (default: as drawn)")
        ->type_name("ROTATION")
        ->group(kSpace);
    command.add_option("--time", o.time, "an instant of the motion, in its own time (default: over all its time)")
        ->type_name("T")
        ->group(kPlane);
    if (is(verb, "check"))
      command.add_flag("--explain", o.explain, "which way decided each condition, and how many milliseconds it took")
          ->group(kCommon);
    if (is(verb, "measure")) {
      auto* all =
          command.add_flag("--all", o.all, "all distances, not only gap, margin, reach, protrusion and hausdorff");
      all->group(kCommon);
      auto* only =
          command.add_option("--only", o.only, "this distance alone, such as gap; no other is computed in space");
      only->type_name("NAME")->excludes(all)->group(kCommon);
    }
  }
}

/// How drawings are read, and curves beyond arcs.
void add_drawings(CLI::App& command, Options& o) {
  command
      .add_option_function<std::string>(
          "--curves", [&o](const std::string& word) { o.drawings.curves = io::parse_curve_rule(word); },
          "near, inside or outside: where the arcs lie that stand for curves (default near: on either side)")
      ->type_name("SIDE")
      ->check(CLI::IsMember({"near", "inside", "outside"}).description(""))
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
      .add_flag_function(
          "--open-lines", [&o](std::int64_t) { o.drawings.open_lines = true; },
          "outlines that stay open are lines (default: an error)")
      ->group(kDrawing);
}

/// Of drawings, and the form of the result.
void add_conversions(CLI::App& command, Options& o) {
  command.add_flag("--constructive", o.constructive, "JSON is a scene that makes the shape of simple ones")
      ->group(kPlane);
  command
      .add_option("--unit", o.unit, fmt::format("of a drawing's numbers: {} (default: what it states)", unit_list()))
      ->type_name("UNIT")
      ->group(kPlane);
  command.add_option("--id", o.id, "the element of a drawing, SVG or GeoJSON (default: all)")
      ->type_name("ID")
      ->group(kPlane);
  command.add_option("--layer", o.layer, "the layer of a drawing, DXF or SVG (default: all)")
      ->type_name("LAYER")
      ->group(kPlane);
  command.add_option("--index", o.index, "which of the drawing's shapes, from 0 (default: all)")
      ->type_name("N")
      ->group(kPlane);
}

/// What is asked of a board, which says no question itself.
void add_board(CLI::App& command, const VerbEntry& verb, Options& o) {
  if (is(verb, "describe") || is(verb, "convert") || is(verb, "phi") || is(verb, "batch")) return;
  const auto text = [&](const char* name, auto& value, const char* about, const char* type) {
    return command.add_option(name, value, about)->type_name(type)->group(kBoard);
  };
  text("--move", o.move, "the parts that move together, by reference", "PART[,PART]")->delimiter(',');
  text("--where", o.where, "the formula that must hold", "FORMULA");
  if (is(verb, "map") || is(verb, "place")) text("--minimize", o.minimize, "the objective to make least", "OBJECTIVE");
  if (is(verb, "map")) {
    text("--maximize", o.maximize, "the objective to make greatest", "OBJECTIVE");
  }
  if (is(verb, "map") || is(verb, "place")) {
    text("--free", o.free, "angles to add to the part's own, in degrees (default: none)", "DEG[,DEG]")->delimiter(',');
  }
}

/// What a region or a shape is made into.
void add_forms(CLI::App& command, const VerbEntry& verb, Options& o) {
  if (is(verb, "map"))
    command
        .add_option("--apply", o.apply,
                    "interior, closure, boundary, regularize or complement of the region (default: the region)")
        ->type_name("OPERATION")
        ->check(CLI::IsMember({"interior", "closure", "boundary", "regularize", "complement"}).description(""))
        ->group(kPlane);
  if (is(verb, "map") || is(verb, "describe"))
    command.add_flag("--exact", o.exact, "JSON has the exact cells too, which a scene reads back as the same set")
        ->group(kPlane);
  if (is(verb, "convert")) add_conversions(command, o);
}

/// Of verbs that answer requests.
void add_service(CLI::App& command, const VerbEntry& verb, Options& o) {
  if (is(verb, "view")) {
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
  size("--work-limit", o.work_limit, "refuse input that costs more than N units of work (default 20M)", "N");
  auto* none = command.add_flag("--no-files", o.no_files, "take no shapes from files that the scene names");
  none->group(kLimits);
  command.add_option("--root", o.root, "take shapes only from files in the folder DIR, wherever links lead")
      ->type_name("DIR")
      ->excludes(none)
      ->group(kLimits);
}

void add_options(CLI::App& command, const VerbEntry& verb, Options& o) {
  command.get_help_ptr()->group(kCommon);
  if (is_service(verb))
    add_service(command, verb, o);
  else
    add_files(command, verb, o);
  if (!is(verb, "pack") && !is(verb, "verify")) add_drawings(command, o);
  add_question(command, verb, o);
  add_forms(command, verb, o);
  add_board(command, verb, o);
  add_lines(command, verb, o);
  command.add_option("--threads", o.threads, "threads to use, 0 to 4096 (default 0: one for each core)")
      ->type_name("N")
      ->check(thread_count)
      ->group(kCommon);
  add_limits(command, o);
  command.add_flag("-q,--quiet", o.quiet, "no notes, and no summary where files are written")->group(kCommon);
  command.footer(help_examples(verb.name));
}

Outcome run(const VerbEntry& verb, const Options& options, Reporter& reporter) {
  check_outputs(options, endings_of(verb.name));  // before anything is read
  const plane::ThreadLimit threads(options.threads);
  const auto dump = StageDump::from_environment();
  const plane::ObserveStages observe(dump.get());
  Outcome outcome = verb.run(options, reporter);
  if (dump) dump->finish(reporter);
  return outcome;
}

/// What went wrong, as an exit status; said on standard error.
int report(Reporter& reporter) {
  try {
    throw;
  } catch (const Error& e) {
    reporter.error(e);
    return status_of(e);
  } catch (const std::bad_alloc&) {
    end_out_of_memory();
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
  begin_printing();
  if (wanted && outcome.stream) outcome.stream(put);
  if (wanted) put(outcome.text);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    reporter.error("standard output cannot be written");
    return kBadInput;
  }
  end_limits();
  return outcome.status;
}

/// "mpa": an unknown verb is answered with the nearest one.
bool is_unknown_verb(int argc, char** argv, Reporter& reporter) {
  if (argc < 2 || argv[1][0] == '-') return false;
  const std::string word = argv[1];
  std::vector<std::string> names;
  for (const VerbEntry& verb : kVerbs) names.push_back(verb.name);
  names.push_back("help");
  if (std::find(names.begin(), names.end(), word) != names.end()) return false;
  reporter.error(
      fmt::format("there is no verb '{}'{}; the verbs are {}", word, meant(word, names), fmt::join(names, " ")));
  return true;
}

struct HelpRequest {
  std::string topic;
  bool markdown = false;
};

CLI::App* add_help(CLI::App& app, HelpRequest& request) {
  std::string topics = "Topics:\n";
  for (const HelpTopic& topic : help_topics()) topics += help_entry(topic.name, topic.about);
  CLI::App* command = app.add_subcommand("help", "Answers how formulas and scenes are written, and what is supported.");
  command->get_help_ptr()->group(kCommon);
  command->add_option("TOPIC", request.topic, "one of the topics below, or a verb (default: the list of topics)")
      ->type_name("");
  command->add_flag("--markdown", request.markdown, "of support: print docs/support.md")->group(kCommon);
  command->footer(topics);
  return command;
}

/// A page for the topic; of a verb the same as its --help.
ExitStatus print_help(const CLI::App& app, const CLI::App& help, const HelpRequest& request, Reporter& reporter) {
  const auto print = [](const std::string& text) {
    fmt::print("{}", text);
    return kDone;
  };
  if (request.markdown && request.topic != "support") {
    reporter.error("--markdown belongs to 'findspace help support'");
    return kUsage;
  }
  if (request.topic.empty()) return print(help.help("findspace"));
  if (request.markdown) return print(support_markdown());
  std::vector<std::string> names;
  for (const HelpTopic& topic : help_topics()) {
    if (topic.name == request.topic) return print(topic.page());
    names.emplace_back(topic.name);
  }
  const std::string topics = fmt::format("{}", fmt::join(names, ", "));
  for (const VerbEntry& verb : kVerbs) {
    if (is(verb, request.topic)) return print(app.get_subcommand(verb.name)->help("findspace"));
    names.emplace_back(verb.name);
  }
  reporter.error(fmt::format("there is no help on '{}'{}; the topics are {}, and the verbs", request.topic,
                             meant(request.topic, names), topics));
  return kUsage;
}

int program(int argc, char** argv, RowTeam* team) {
  CLI::App app(kAbout, "findspace");
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h,--help", "print this help; after a verb its own")->group(kCommon);
  app.set_version_flag("--version", "findspace " FINDSPACE_VERSION, "print the version")->group(kCommon);
  app.require_subcommand(1);
  app.footer(help_examples(""));
  Options options;
  HelpRequest request;
  for (const VerbEntry& verb : kVerbs) add_options(*app.add_subcommand(verb.name, verb.about), verb, options);
  const CLI::App* help = add_help(app, request);
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
  options.team = team;
  if (help->parsed()) return print_help(app, *help, request, errors);
  Reporter reporter(options.quiet);
  try {
    const std::string name = app.get_subcommands().front()->get_name();
    const VerbEntry& verb =
        *std::find_if(std::begin(kVerbs), std::end(kVerbs), [&](const VerbEntry& v) { return is(v, name); });
    // A server and a batch have a limit for each request.
    Options limited = options;
    if (is_service(verb) || is(verb, "batch")) limited.time_limit = 0;
    if (is(verb, "batch")) limited.memory_limit = 0;  // of each question
    set_limits(limited, ends_in_time(name));
    const bool writes = team == nullptr || team->leads() || is(verb, "batch");
    if (!writes) limited.outputs.clear();
    return finish(run(verb, writes ? options : limited, reporter), options, reporter);
  } catch (...) {
    return report(reporter);
  }
}

const VerbEntry* find_question(std::string_view name) {
  for (const VerbEntry& verb : kVerbs)
    if (is(verb, name) && !is_service(verb) && !is(verb, "batch")) return &verb;
  return nullptr;
}

}  // namespace

bool is_question(std::string_view verb) { return find_question(verb) != nullptr; }

std::vector<std::string> question_names() {
  std::vector<std::string> out;
  for (const VerbEntry& verb : kVerbs)
    if (is_question(verb.name)) out.emplace_back(verb.name);
  return out;
}

Options parse_question(std::string_view name, std::vector<std::string> arguments) {
  const VerbEntry& verb = *find_question(name);
  CLI::App app("", "findspace");
  Options options;
  add_options(app, verb, options);
  std::reverse(arguments.begin(), arguments.end());
  try {
    app.parse(arguments);
  } catch (const CLI::ExtrasError&) {
    throw Error(ErrorCode::kUsage, fmt::format("not expected: {}", fmt::join(app.remaining(true), " ")));
  } catch (const CLI::Error& e) {
    throw Error(ErrorCode::kUsage, e.what());
  }
  return options;
}

Outcome run_question(std::string_view verb, const Options& options, Reporter& reporter) {
  return run(*find_question(verb), options, reporter);
}

bool ends_in_time(std::string_view verb) { return verb == "place" || verb == "pack"; }

int run_program(int argc, char** argv, RowTeam* team) {
  end_on_signals();
  try {
    return program(argc, argv, team);
  } catch (...) {
    Reporter reporter;
    return report(reporter);
  }
}

}  // namespace findspace::app
