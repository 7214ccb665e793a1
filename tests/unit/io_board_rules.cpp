// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The rule check of boards: what names mean in it, and of which parts a rule is asked.

#include <gtest/gtest.h>

#include <set>

#include "findspace/board.h"
#include "findspace/error.h"

namespace io_board_rules {

using namespace findspace;

/// A part with a square courtyard of two millimetres.
std::string part(const std::string& name, const std::string& at, const std::string& more = "(attr smd)",
                 const std::string& side = "F") {
  return "(footprint \"F\" (layer \"" + side + ".Cu\") (at " + at + ") " + more + "\n (fp_text reference \"" + name +
         "\" (at 0 0))\n (fp_rect (start -1 -1) (end 1 1) (layer \"" + side + ".CrtYd\")))\n";
}

std::string keep_out(const std::string& name, const std::string& corners, const std::string& layer = "F.Cu") {
  return "(zone (net 0) (net_name \"\") (layers \"" + layer + "\") (name \"" + name +
         "\") (keepout (footprints not_allowed)) (polygon (pts " + corners + ")))\n";
}

std::string hole(const std::string& drill) {
  return "(attr through_hole) (pad \"1\" thru_hole circle (at 0 0) (size 1 1) (drill " + drill + ") (layers \"*.Cu\"))";
}

/// Thirty by thirty.
Board board(const std::string& items, const std::vector<BoardGroup>& groups = {}) {
  return Board::text(
      "(kicad_pcb (version 20240108)\n (layers (0 \"F.Cu\" signal) (31 \"B.Cu\" signal))\n (net 0 \"\")\n"
      "(gr_rect (start 0 0) (end 30 30) (layer \"Edge.Cuts\"))\n" +
          items + ")\n",
      {.groups = groups});
}

/// What is broken: parts, and their conditions as the check writes them.
std::set<std::string> broken(const Board& board, const std::optional<Formula>& rules = {}) {
  std::set<std::string> out;
  const BoardVerdict verdict = board.check(rules);
  for (const BoardVerdict::Broken& b : verdict.broken())
    for (const AtomValue& a : b.check.atoms)
      if (!a.holds) out.insert(b.part + ": " + a.text);
  return out;
}

using Said = std::set<std::string>;
const std::string kAtFive = "(xy 4 4) (xy 6 4) (xy 6 6) (xy 4 6)", kAtTen = "(xy 9 9) (xy 11 9) (xy 11 11) (xy 9 11)";

TEST(BoardRules, AKeepOutIsNoGroup) {
  const Board both =
      board(part("AE1", "20 20") + part("L1", "20 25") + part("U1", "5 5") + keep_out("antenna", kAtFive),
            {{"antenna", {"AE1", "L1"}}});
  EXPECT_EQ(broken(both), Said{"U1: clear(self, \"keep-out antenna\")"});
  EXPECT_EQ(broken(both, "clear(self, antenna)"), Said{});  // the group
}

TEST(BoardRules, AKeepOutIsNotTheBoard) {
  for (const char* name : {"board", "self", "others", "parts", "U2"}) {
    const Board one = board(part("U1", "5 5") + part("U2", "20 20") + keep_out(name, kAtFive));
    EXPECT_EQ(broken(one), Said{std::string("U1: clear(self, \"keep-out ") + name + "\")"}) << name;
  }
}

TEST(BoardRules, AKeepOutCountsOnItsSides) {
  const auto with = [](const std::string& layer) {
    return board(part("U1", "5 5") + part("U2", "5 5", "(attr smd)", "B") + keep_out("area", kAtFive, layer));
  };
  EXPECT_EQ(broken(with("F.Cu")), Said{"U1: clear(self, area)"});
  EXPECT_EQ(broken(with("B.Cu")), Said{"U2: clear(self, area)"});
  EXPECT_EQ(broken(with("F&B.Cu")), (Said{"U1: clear(self, area)", "U2: clear(self, area)"}));
  EXPECT_EQ(broken(with("F.Cu"), "clear(self, area)").size(), 2u);  // it is named
  for (const char* list : {"others", "keepouts"}) {
    const std::string rule = std::string("clear(U2, ") + list + ")";
    EXPECT_TRUE(with("F.Cu").world({"U2"}).holds(rule, Point{5, 5})) << list;
    EXPECT_FALSE(with("B.Cu").world({"U2"}).holds(rule, Point{5, 5})) << list;
  }
}

TEST(BoardRules, APartMindsNotItsOwnKeepOut) {
  const Board one = board(part("U1", "5 5", "(attr smd) " + keep_out("mine", kAtFive)) + part("U2", "6.5 5"));
  EXPECT_EQ(broken(one, "clear(self, mine)"), Said{"U2: clear(self, mine)"});
  EXPECT_EQ(broken(one, "clear(self, keepouts)"), Said{"U2: clear(self, mine)"});
}

TEST(BoardRules, BetweenKnowsAllLists) {
  const std::string parts = part("J1", "20 20", hole("0.6")) + part("U1", "5 5") + part("U2", "9 5");
  const Board one = board(parts + "(via (at 6.5 5) (size 0.6) (drill 0.4) (layers \"F.Cu\" \"B.Cu\") (net 0))\n" +
                          keep_out("area", kAtTen));
  EXPECT_EQ(broken(one, "between(smd, holes) >= 0.5mm"), Said{"U1: between(self, \"hole at 6.5 5\") >= 0.5"});
  EXPECT_EQ(broken(one, "between(smd, vias) >= 0.5mm"), Said{"U1: between(self, vias) >= 0.5"});
  EXPECT_EQ(broken(one, "between(smd, keepouts) >= 3.5mm"), (Said{"U2: between(self, area) >= 3.5"}));
}

TEST(BoardRules, APartIsAGroupOfItself) {
  const Board one = board(part("J1", "20 20", hole("0.6")) + part("U1", "5 5") + part("U2", "9 5") +
                          "(via (at 6.5 5) (size 0.6) (drill 0.4) (layers \"F.Cu\" \"B.Cu\") (net 0))\n");
  EXPECT_EQ(broken(one, "between(U1, holes) >= 0.5mm"), Said{"U1: between(self, \"hole at 6.5 5\") >= 0.5"});
  EXPECT_EQ(broken(one, "between(U1, U2) >= 5mm"), (Said{"U1: between(self, U2) >= 5", "U2: between(self, U1) >= 5"}));
  EXPECT_EQ(broken(one, "between(U1, smd) >= 5mm"), (Said{"U1: between(self, U2) >= 5", "U2: between(self, U1) >= 5"}));
  EXPECT_EQ(broken(one, "between(U1, U1) >= 5mm"), Said{});
  EXPECT_EQ(broken(one, "between(U1, smd) <= 1mm").size(), 2u);  // not itself is near enough
  EXPECT_EQ(broken(one, "between(U1, smd) <= 5mm"), Said{});
}

TEST(BoardRules, HolesAtOnePlaceAllCount) {
  const std::string part_beside = part("U1", "8 5");  // from 7 on
  const std::string large = part("H1", "5 5", hole("3.2")), small = part("H2", "5 5", hole("0.3"));
  for (const std::string& holes : {large + small, small + large})
    EXPECT_EQ(broken(board(part_beside + holes), "between(U1, holes) >= 0.5mm").size(), 1u);
}

TEST(BoardRules, RulesAreReadWithoutParts) {
  EXPECT_TRUE(board("").check().holds());
  EXPECT_TRUE(board("").check("clear(self, others, 1mm) and between(smd, holes) >= 1mm").holds());
  EXPECT_THROW(board("").check("nonsense("), Error);
  EXPECT_THROW(board("").check("clear(self, U7)"), Error);
}

TEST(BoardRules, OneSidedDistancesAreDrawn) {
  const auto lines = [](const std::string& rules) {
    const std::string svg = board(part("J1", "5 5") + part("U1", "8 5")).check(rules).svg();
    std::size_t out = 0;
    for (std::size_t at = 0; (at = svg.find(">1<", at)) != std::string::npos; ++at) ++out;
    return out;
  };
  EXPECT_EQ(lines("clear(self, J1, 2mm)"), 1u);
  EXPECT_EQ(lines("clear(self, U1, 2mm)"), 1u);
  EXPECT_EQ(lines("clear(self, others, 2mm)"), 1u);
}

}  // namespace io_board_rules
