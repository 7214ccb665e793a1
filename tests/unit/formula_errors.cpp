// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Every mistake says what is wrong, where, and what was perhaps meant: the messages in full. Of words, structure and
// atoms.
#include "unit/formula_mistakes.h"

namespace findspace::formula {
namespace formula_errors {

TEST(FormulaErrors, Words) {
  expect("gamma1(chip, bord) >= 1",
         "1:14: unknown shape 'bord'; did you mean 'board'?\n"
         "  gamma1(chip, bord) >= 1\n"
         "               ^~~~");
  expect("gama1(chip, board) >= 1",
         "1:1: unknown distance or predicate 'gama1'; did you mean 'gamma1'?\n"
         "  gama1(chip, board) >= 1\n"
         "  ^~~~~");
  expect("Gap(chip, board) >= 1",
         "1:1: unknown distance or predicate 'Gap'; did you mean 'gap'?\n"
         "  Gap(chip, board) >= 1\n"
         "  ^~~");
  expect(
      "zebra(chip, board) >= 1",
      "1:1: unknown distance or predicate 'zebra'; the predicates are overlaps, touches, disjoint, clear, within, far, "
      "near, keepout, group, inside, covers, and 'findspace help formula' lists the distances\n"
      "  zebra(chip, board) >= 1\n"
      "  ^~~~~");
  expect("gamma1(chip, zebra) >= 1",
         "1:14: unknown shape 'zebra'; the shapes are 'board', 'chip', 'key', 'screws', 'my part'\n"
         "  gamma1(chip, zebra) >= 1\n"
         "               ^~~~~");
  expect("gamma1(chip, \"my prt\") > 0",
         "1:14: unknown shape 'my prt'; did you mean 'my part'?\n"
         "  gamma1(chip, \"my prt\") > 0\n"
         "               ^~~~~~~~");
  expect("gamma1(chip, my part) > 0",
         "1:14: unknown shape 'my'; the shapes are 'board', 'chip', 'key', 'screws', 'my part'; a name with blanks "
         "stands in quotes\n"
         "  gamma1(chip, my part) > 0\n"
         "               ^~");
  expect("γ₁(chip, bord) ≥ 1 ∧ true",
         "1:10: unknown shape 'bord'; did you mean 'board'?\n"
         "  γ₁(chip, bord) ≥ 1 ∧ true\n"
         "           ^~~~");
  expect("chip > 3",
         "1:1: 'chip' is a shape; a distance or predicate is meant here, such as gap(B, A)\n"
         "  chip > 3\n"
         "  ^~~~");
  expect("\"my part\" > 3",
         "1:1: a condition is meant here, found '\"my part\"'\n"
         "  \"my part\" > 3\n"
         "  ^~~~~~~~~");
}

TEST(FormulaErrors, Signs) {
  expect("gamma1(chip, board) >= 1 $",
         "1:26: stray character '$'\n"
         "  gamma1(chip, board) >= 1 $\n"
         "                           ^");
  expect("gamma1(chip, board) >= 1 && true",
         "1:26: unexpected '&&'; write 'and'\n"
         "  gamma1(chip, board) >= 1 && true\n"
         "                           ^~");
  expect("gamma1(chip, board) == 1",
         "1:21: unexpected '=='; write '='\n"
         "  gamma1(chip, board) == 1\n"
         "                      ^~");
  expect("gamma1(chip, board) => 1",
         "1:21: unexpected '=>'; write '>='\n"
         "  gamma1(chip, board) => 1\n"
         "                      ^~");
  expect("gamma1(chip, board, turning=(0, 0)) <= 5°",
         "1:41: unexpected '°'; write 'deg'\n"
         "  gamma1(chip, board, turning=(0, 0)) <= 5°\n"
         "                                          ^");
  expect("! overlaps(chip, board)",
         "1:1: unexpected '!'; write 'not'\n"
         "  ! overlaps(chip, board)\n"
         "  ^");
  expect("gamma1(chip, board) >= 0,5",
         "1:25: unexpected ','; decimals are written with a point\n"
         "  gamma1(chip, board) >= 0,5\n"
         "                          ^");
  expect("gamma1(chip, board) >= 5.",
         "1:25: stray '.' after a number\n"
         "  gamma1(chip, board) >= 5.\n"
         "                          ^");
  expect("gamma1(chip, \"my part) > 0",
         "1:14: the name that begins here has no closing quote\n"
         "  gamma1(chip, \"my part) > 0\n"
         "               ^");
  expect("gamma1(chip, board) > \xff",
         "1:23: a byte that is not UTF-8\n"
         "  gamma1(chip, board) > ?\n"
         "                        ^");
}

TEST(FormulaErrors, Structure) {
  expect("",
         "1:1: the formula is empty; a condition is meant, or true\n"
         "  \n"
         "  ^");
  expect("(gamma1(chip, board) >= 1",
         "1:26: missing ')' for the '(' at 1:1, found the end\n"
         "  (gamma1(chip, board) >= 1\n"
         "                           ^");
  expect("gamma1(chip, board) >= 1)",
         "1:25: this ')' closes nothing\n"
         "  gamma1(chip, board) >= 1)\n"
         "                          ^");
  expect("gamma1(chip, board >= 1",
         "1:20: missing ')' for the '(' at 1:7, found '>='\n"
         "  gamma1(chip, board >= 1\n"
         "                     ^~");
  expect("gamma1(chip, board) >= 1 and",
         "1:29: a condition is meant here, found the end\n"
         "  gamma1(chip, board) >= 1 and\n"
         "                              ^");
  expect("and gamma1(chip, board) > 0",
         "1:1: a condition is meant here, found 'and'\n"
         "  and gamma1(chip, board) > 0\n"
         "  ^~~");
  expect("not",
         "1:4: a condition is meant here, found the end\n"
         "  not\n"
         "     ^");
  expect("gamma1(chip, board) >= 1 AND true",
         "1:26: 'and' or 'or' is meant here, found 'AND'; did you mean 'and'?\n"
         "  gamma1(chip, board) >= 1 AND true\n"
         "                           ^~~");
  expect("gamma1(chip, board) >= 1 board",
         "1:26: 'and' or 'or' is meant here, found 'board'\n"
         "  gamma1(chip, board) >= 1 board\n"
         "                           ^~~~~");
  expect("(true false)",
         "1:7: 'and', 'or' or ')' is meant here, found 'false'\n"
         "  (true false)\n"
         "        ^~~~~");
  expect("true = 1",
         "1:6: 'and' or 'or' is meant here, found '='\n"
         "  true = 1\n"
         "       ^");
  expect("gamma1(chip, board) >= 0\n  and gamma1(chip board) >= 0",
         "2:19: a ',' and the second shape of 'gamma1' are meant here, found 'board'\n"
         "    and gamma1(chip board) >= 0\n"
         "                    ^~~~~");
}

TEST(FormulaErrors, Atoms) {
  expect("gamma1(chip, board)",
         "1:1: a distance is a number, not a condition; compare it, e.g. gamma1(chip, board) >= 0\n"
         "  gamma1(chip, board)\n"
         "  ^~~~~~~~~~~~~~~~~~~");
  expect("0.5 <= 2",
         "1:8: a distance is meant here, found a number; two numbers are not compared\n"
         "  0.5 <= 2\n"
         "         ^");
  expect("0.5 gamma1(chip, board)",
         "1:5: a relation (< <= = != >= >) is meant after the number, found 'gamma1'\n"
         "  0.5 gamma1(chip, board)\n"
         "      ^~~~~~");
  expect("0.5 <= overlaps(chip, board)",
         "1:8: a distance is meant here, not the predicate 'overlaps'\n"
         "  0.5 <= overlaps(chip, board)\n"
         "         ^~~~~~~~");
  expect("overlaps(chip, board) > 1",
         "1:23: 'overlaps' is true or false; it is not compared with anything\n"
         "  overlaps(chip, board) > 1\n"
         "                        ^");
  expect("overlaps(chip, board) -> min",
         "1:23: 'overlaps' is true or false; it is not compared with anything\n"
         "  overlaps(chip, board) -> min\n"
         "                        ^~");
  expect("gap(chip, board) <= gap(chip, key, along=(1, 0))",
         "1:1: sums and comparisons of distances are not computed along a direction or in rotation\n"
         "  gap(chip, board) <= gap(chip, key, along=(1, 0))\n"
         "  ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~");
  expect("2mm * gap(chip, board) <= 1",
         "1:2: the factor of a distance carries no unit\n"
         "  2mm * gap(chip, board) <= 1\n"
         "   ^~");
  expect("gap(chip, board) + gap(chip, key) -> min",
         "1:1: '-> min' is of one distance; \"minimize\" takes a sum\n"
         "  gap(chip, board) + gap(chip, key) -> min\n"
         "  ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~");
  expect("-gap(chip, board) -> min",
         "1:1: '-> min' is of a distance, not of minus one; \"maximize\" takes gap(chip, board)\n"
         "  -gap(chip, board) -> min\n"
         "  ^~~~~~~~~~~~~~~~~");
  expect("0 <= gamma1(chip, board) <= gap(chip, key)",
         "1:29: a number is meant at the end of a chain, found a distance\n"
         "  0 <= gamma1(chip, board) <= gap(chip, key)\n"
         "                              ^~~");
  expect("gamma1(chip, board) <= board",
         "1:24: a number is meant here, found 'board'\n"
         "  gamma1(chip, board) <= board\n"
         "                         ^~~~~");
  expect("gamma1(chip, board) <= 1 <= 2",
         "1:26: a chain has its distance in the middle: 0.5 <= gap(B, A) <= 2\n"
         "  gamma1(chip, board) <= 1 <= 2\n"
         "                           ^~");
  expect("0 <= gamma1(chip, board) <= 1 <= 2",
         "1:31: a chain has two relations at most: 0.5 <= gap(B, A) <= 2\n"
         "  0 <= gamma1(chip, board) <= 1 <= 2\n"
         "                                ^~");
  expect("gamma1(chip, board) > --1",
         "1:24: a distance is meant here, found '-'\n"
         "  gamma1(chip, board) > --1\n"
         "                         ^");
  expect("gamma1(chip, board) -> max",
         "1:24: only 'min' may follow '->', found 'max'\n"
         "  gamma1(chip, board) -> max\n"
         "                         ^~~");
  expect("argmin gamma1(chip, board)",
         "1:8: 'argmin' takes a distance: argmin(gap(B, A)), found 'gamma1'\n"
         "  argmin gamma1(chip, board)\n"
         "         ^~~~~~");
  expect("argmin(gamma1(chip, board) > 0",
         "1:28: missing ')' for the '(' at 1:7, found '>'\n"
         "  argmin(gamma1(chip, board) > 0\n"
         "                             ^");
  expect("margin(chip, board) -> min",
         "1:1: 'margin' has no least value; the positions of its greatest value are eta1(chip, board) -> min\n"
         "  margin(chip, board) -> min\n"
         "  ^~~~~~~~~~~~~~~~~~~");
  expect("inf gamma1(chip, board) > 0",
         "1:1: 'inf' is over the time of a motion, and the scene has none\n"
         "  inf gamma1(chip, board) > 0\n"
         "  ^~~");
}

}  // namespace formula_errors
}  // namespace findspace::formula
