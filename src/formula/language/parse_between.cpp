// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <algorithm>

#include "formula/language/parse_call.h"

namespace findspace::formula {
namespace {

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The two lists of a rule: their names, and what is in them.
struct RuleLists {
  std::string names[2];
  std::vector<std::string> moving[2], standing[2];  // members; those that stand only where each moves on its own
  bool stands[2] = {false, false};                  // whether others are in it
};

RuleLists lists_of(const Context& context, std::string first, std::string second) {
  RuleLists out;
  out.names[0] = std::move(first);
  out.names[1] = std::move(second);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string& name = out.names[k];
    const auto list = context.groups.find(name);
    const std::vector<std::string> members =
        list == context.groups.end() ? std::vector<std::string>{name} : list->second;
    for (const std::string& member : members)
      if (is_among(context.moving, member))
        out.moving[k].push_back(member);
      else if (context.independent && is_among(context.shapes, member))
        out.standing[k].push_back(member);
    out.stands[k] = is_among(context.shapes, name) && !is_among(context.moving, name);
  }
  return out;
}

/// Where all that moves has one position: the gap of what moves in each list to the other one, in the words of the
/// rule; of what moves in both the gap to both.
std::vector<Distance> of_all(const RuleLists& lists) {
  std::vector<Distance> out;
  for (std::size_t k = 0; k < 2; ++k) {
    if (lists.moving[k].empty() || !lists.stands[1 - k]) continue;
    if (!out.empty() && out[0].first == lists.moving[k]) {
      if (lists.names[0] != lists.names[1]) out[0].second.push_back(lists.names[0]);
      continue;
    }
    out.emplace_back();
    out.back().first = lists.moving[k];
    out.back().second = {lists.names[1 - k]};
    out.back().lists = {lists.names[0], lists.names[1]};
  }
  if (out.size() == 1) return out;
  std::vector<Distance> each;  // one a mover: the text of both lists would mean all of them again
  for (const Distance& d : out)
    for (const std::string& mover : d.first) {
      each.push_back(d);
      each.back().first = {mover};
      each.back().lists = {mover, d.second[0]};
    }
  return each;
}

/// Where each moves on its own: the gaps of all pairs, but those of one body. A list may hold shapes that are placed
/// where they are drawn, so its members are taken.
std::vector<Distance> of_pairs(const RuleLists& lists, const Context& context) {
  std::vector<Distance> out;
  const auto add = [&](const std::string& a, const std::string& b) {
    const auto is_known = [&](const Distance& d) {
      return (d.first[0] == a && d.second[0] == b) || (d.first[0] == b && d.second[0] == a);
    };
    if (std::any_of(out.begin(), out.end(), is_known)) return;
    out.emplace_back();
    out.back().first = {a};
    out.back().second = {b};
    out.back().lists = {a, b};
  };
  const auto body = [&](const std::string& name) {
    const auto found = context.body_of.find(name);
    return found == context.body_of.end() ? std::nullopt : std::optional(found->second);
  };
  for (std::size_t k = 0; k < 2; ++k)
    for (const std::string& mover : lists.moving[k]) {
      for (const std::string& other : lists.standing[1 - k]) add(mover, other);
      for (const std::string& other : lists.moving[1 - k])
        if (other != mover && (!body(mover) || body(mover) != body(other))) add(mover, other);
    }
  return out;
}

}  // namespace

bool CallReader::at_between() const { return cursor_.at_word("between") && cursor_.peek(1).kind == Token::Kind::kOpen; }

std::vector<Term> CallReader::between() {
  Span span;
  span.begin = cursor_.peek().span.begin;
  cursor_.take();
  const Span open = cursor_.take().span;
  std::string first = shape("between");
  if (!cursor_.accept(Token::Kind::kComma)) cursor_.fail_syntax("'between' takes two lists of shapes: between(G, H)");
  const RuleLists lists = lists_of(context_, std::move(first), shape("between"));
  if (!cursor_.accept(Token::Kind::kClose)) cursor_.fail_unclosed(open);
  span.end = cursor_.end();
  std::vector<Term> out;
  for (Distance& distance : context_.independent ? of_pairs(lists, context_) : of_all(lists)) {
    distance.kind = Kind::kGamma1;
    distance.spelled = &plain_name(Kind::kGamma1);
    out.push_back({std::move(distance), false, span});
  }
  return out;
}

}  // namespace findspace::formula
