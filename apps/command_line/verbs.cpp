// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "command_line/verbs.h"

#include <algorithm>
#include <iterator>

#include "command_line/command_line.h"
#include "common/commands.h"

namespace findspace::app {
namespace {

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

const VerbEntry* find_question(std::string_view name) {
  const VerbEntry* verb = find_verb(name);
  return verb == nullptr || verb->is_service() || verb->is("batch") ? nullptr : verb;
}

}  // namespace

std::span<const VerbEntry> verbs() { return kVerbs; }

const VerbEntry* find_verb(std::string_view name) {
  const auto* const found =
      std::find_if(std::begin(kVerbs), std::end(kVerbs), [&](const VerbEntry& v) { return v.is(name); });
  return found == std::end(kVerbs) ? nullptr : found;
}

bool is_question(std::string_view verb) { return find_question(verb) != nullptr; }

std::vector<std::string> question_names() {
  std::vector<std::string> out;
  for (const VerbEntry& verb : kVerbs)
    if (is_question(verb.name)) out.emplace_back(verb.name);
  return out;
}

bool ends_in_time(std::string_view verb) { return verb == "place" || verb == "pack"; }

}  // namespace findspace::app
