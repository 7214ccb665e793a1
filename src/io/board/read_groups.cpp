// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/board/read_groups.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>

#include "io/board/read_part.h"
#include "plane/base/work_budget.h"

namespace findspace::io {
namespace {

constexpr std::uint64_t kMember = 10;  // units of work for a member of a group, again for each group around it

/// What members are called by: (uuid ..) since KiCad 8, before it (tstamp ..), of groups (id ..).
std::string id_of(const Sexpr& item) {
  for (const char* key : {"uuid", "tstamp", "id"})
    if (const auto id = item.find(key)) return id->item(0).text();
  return "";
}

class GroupReader {
 public:
  GroupReader(const Sexpr& root, const std::vector<Sexpr>& footprints, Board& board) : board_(board) {
    for (std::size_t k = 0; k < footprints.size(); ++k) parts_.emplace(id_of(footprints[k]), k);
    root.each([&](const Sexpr& item) {
      if (!item.is("group")) return;
      by_id_.emplace(id_of(item), groups_.size());
      groups_.push_back(item);
    });
    parts_.erase("");
    by_id_.erase("");
  }

  void run() {
    for (const Sexpr& group : groups_) add(group, members(group));
  }

 private:
  /// Numbers of parts, also of the groups within it.
  std::set<std::size_t> members(const Sexpr& group) {
    std::set<std::size_t> out, seen;
    std::vector<Sexpr> open{group};
    const auto take = [&](const Sexpr& member) {
      work_.charge(kMember, "groups with so many members");
      const std::string id = member.text();
      if (const auto part = parts_.find(id); part != parts_.end()) out.insert(part->second);
      const auto inner = by_id_.find(id);
      if (inner != by_id_.end() && seen.insert(inner->second).second) open.push_back(groups_[inner->second]);
    };
    while (!open.empty()) {
      const Sexpr next = open.back();
      open.pop_back();
      if (const auto list = next.find("members")) list->each(take);
    }
    return out;
  }

  void add(const Sexpr& group, const std::set<std::size_t>& members) {
    const std::vector<Sexpr> items = group.items();
    std::string given = items.empty() || items[0].is_list() ? "" : items[0].text();
    if (given.empty()) given = "group";
    const bool locked = has_flag(group, "locked");
    PartGroup out{given, {}};
    for (const std::size_t k : members) {
      Part& part = board_.parts[k];
      if (!part.body) continue;
      part.locked = part.locked || locked;
      out.parts.push_back(part.name);
    }
    if (out.parts.empty()) return;
    for (int k = 2; !taken_.insert(out.name).second; ++k) out.name = fmt::format("{} {}", given, k);
    board_.groups.push_back(std::move(out));
  }

  Board& board_;
  std::map<std::string, std::size_t> parts_, by_id_;
  std::vector<Sexpr> groups_;
  std::set<std::string> taken_;
  plane::WorkBudget work_{plane::kUsualWorkBudget};
};

}  // namespace

void read_groups(const Sexpr& root, const std::vector<Sexpr>& footprints, Board& board) {
  GroupReader(root, footprints, board).run();
}

}  // namespace findspace::io
