// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Reads the command line, and answers what asks for help.

#include "command_line/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "command_line/help_pages.h"
#include "command_line/option_checks.h"
#include "command_line/support_table.h"
#include "command_line/verb_options.h"
#include "command_line/verbs.h"

namespace findspace::app {
namespace {

constexpr const char* kAbout = "Where can this part go? The exact set of its positions, from a scene file.";

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

/// "mpa": an unknown verb is answered with the nearest one.
bool is_unknown_verb(int argc, char** argv, Reporter& reporter) {
  if (argc < 2 || argv[1][0] == '-') return false;
  const std::string word = argv[1];
  std::vector<std::string> names;
  for (const VerbEntry& verb : verbs()) names.push_back(verb.name);
  names.push_back("help");
  if (std::find(names.begin(), names.end(), word) != names.end()) return false;
  reporter.error(
      fmt::format("there is no verb '{}'{}; the verbs are {}", word, meant(word, names), fmt::join(names, " ")));
  return true;
}

/// The names of a verb's options, as they are typed.
std::vector<std::string> option_names(const VerbEntry& verb) {
  CLI::App app;
  Options options;
  add_options(app, verb.name, options);
  std::vector<std::string> out;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) out.push_back("--" + name);
    for (const std::string& name : option->get_snames()) out.push_back("-" + name);
  }
  return out;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What is wrong with arguments that are left: the first is an option of other verbs, or mistyped, or one too many.
std::string left_over(const std::vector<std::string>& rest, std::string_view of_verb) {
  const std::string name = rest.front().substr(0, rest.front().find('='));
  if (name.size() < 2 || name[0] != '-') return fmt::format("not expected: {}", fmt::join(rest, " "));
  std::vector<std::string> own, others;
  for (const VerbEntry& verb : verbs()) {
    const std::vector<std::string> names = option_names(verb);
    if (verb.is(of_verb)) own = names;
    if (contains(names, name)) others.push_back(verb.name);
  }
  if (contains(own, name)) return fmt::format("not expected: {}", fmt::join(rest, " "));
  if (!others.empty()) return fmt::format("{} is no option of {}, but of {}", name, of_verb, fmt::join(others, ", "));
  return fmt::format("{} has no option {}{}", of_verb, name, meant(name, own));
}

/// The library's words for a wrong number of arguments, plainly.
std::string plainly(const std::string& text) {
  constexpr std::string_view kMost = ": At Most 1 required but received ", kLeast = ": At least ",
                             kReceived = " required but received ";
  if (text == "A subcommand is required") return "a verb is required, such as map; 'findspace --help' lists them";
  if (const std::size_t at = text.find(kMost); at != std::string::npos)
    return fmt::format("{} is given {} times; once is meant", text.substr(0, at), text.substr(at + kMost.size()));
  const std::size_t at = text.find(kLeast), received = text.find(kReceived);
  if (at == std::string::npos || received == std::string::npos) return text;
  const std::size_t number = at + kLeast.size();
  return fmt::format("{}: {} are meant, given: {}", text.substr(0, at), text.substr(number, received - number),
                     text.substr(received + kReceived.size()));
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
  for (const VerbEntry& verb : verbs()) {
    if (verb.is(request.topic)) return print(app.get_subcommand(verb.name)->help("findspace"));
    names.emplace_back(verb.name);
  }
  reporter.error(fmt::format("there is no help on '{}'{}; the topics are {}, and the verbs", request.topic,
                             meant(request.topic, names), topics));
  return kUsage;
}

}  // namespace

CommandLine read_command_line(int argc, char** argv) {
  CLI::App app(kAbout, "findspace");
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h,--help", "print this help; after a verb its own")->group(kCommon);
  app.set_version_flag("--version", "findspace " FINDSPACE_VERSION, "print the version")->group(kCommon);
  app.require_subcommand(1);
  app.footer(help_examples(""));
  CommandLine out;
  HelpRequest request;
  // Where a verb comes first, its options alone are made.
  const auto is_first = [&](const VerbEntry& verb) { return argc > 1 && verb.name == std::string_view(argv[1]); };
  const bool one = std::any_of(verbs().begin(), verbs().end(), is_first);
  for (const VerbEntry& verb : verbs()) {
    CLI::App* command = app.add_subcommand(verb.name, verb.about);
    if (!one || is_first(verb)) add_options(*command, verb.name, out.options);
  }
  const CLI::App* help = add_help(app, request);
  Reporter errors;
  out.answered = kUsage;
  if (is_unknown_verb(argc, argv, errors)) return out;
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    app.exit(asked);
    out.answered = kDone;
    return out;
  } catch (const CLI::ExtrasError&) {
    const auto verb = app.get_subcommands();
    errors.error(fmt::format("{}\nTry 'findspace {}--help'.",
                             left_over(app.remaining(true), verb.empty() ? "findspace" : verb.front()->get_name()),
                             verb.empty() ? "" : verb.front()->get_name() + " "));
    return out;
  } catch (const CLI::ParseError& e) {
    errors.error(fmt::format("{}\nTry 'findspace --help'.", plainly(e.what())));
    return out;
  }
  if (help->parsed())
    out.answered = print_help(app, *help, request, errors);
  else
    out.verb = app.get_subcommands().front()->get_name();
  return out;
}

Options parse_question(std::string_view name, std::vector<std::string> arguments, Options usual) {
  CLI::App app("", "findspace");
  Options options = std::move(usual);
  add_options(app, name, options);
  std::reverse(arguments.begin(), arguments.end());
  try {
    app.parse(arguments);
  } catch (const CLI::ExtrasError&) {
    throw Error(ErrorCode::kUsage, left_over(app.remaining(true), name));
  } catch (const CLI::Error& e) {
    throw Error(ErrorCode::kUsage, plainly(e.what()));
  }
  return options;
}

}  // namespace findspace::app
