// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Mistakes in the arguments of distances and predicates, in roles and in numbers: the messages in full.
#include "unit/formula_mistakes.h"

namespace findspace::formula {
namespace formula_errors_arguments {

TEST(FormulaErrors, Arguments) {
  expect("gamma1 >= 1",
         "1:8: 'gamma1' takes two shapes: gamma1(B, A), found '>='\n"
         "  gamma1 >= 1\n"
         "         ^~");
  expect("gamma1() >= 1",
         "1:8: 'gamma1' takes two shapes: gamma1(B, A)\n"
         "  gamma1() >= 1\n"
         "         ^");
  expect("gamma1(chip) >= 1",
         "1:12: 'gamma1' takes two shapes: gamma1(B, A); the second is missing\n"
         "  gamma1(chip) >= 1\n"
         "             ^");
  expect("gamma1(chip, 3) > 0",
         "1:14: a shape of 'gamma1' is meant here, found the number '3'; a name that begins with a digit stands in "
         "quotes\n"
         "  gamma1(chip, 3) > 0\n"
         "               ^");
  expect("gamma1(chip, gap(chip, board)) > 0",
         "1:14: a shape is meant here, not 'gap'\n"
         "  gamma1(chip, gap(chip, board)) > 0\n"
         "               ^~~");
  expect("gamma1(chip, board, key) >= 1",
         "1:21: 'gamma1' takes two shapes: gamma1(B, A), found 'key'\n"
         "  gamma1(chip, board, key) >= 1\n"
         "                      ^~~");
  expect("gamma1(chip, board, 3) >= 1",
         "1:21: 'gamma1' takes no number; compare it with one: gamma1(B, A) >= 1\n"
         "  gamma1(chip, board, 3) >= 1\n"
         "                      ^");
  expect("gamma1(chip, board, along=(1,0), 3) >= 1",
         "1:32: too many arguments; 'gamma1' is written gamma1(B, A)\n"
         "  gamma1(chip, board, along=(1,0), 3) >= 1\n"
         "                                 ^");
  expect("overlaps(chip, board, 3)",
         "1:23: 'overlaps' takes no number: overlaps(B, A)\n"
         "  overlaps(chip, board, 3)\n"
         "                        ^");
  expect("within(chip, board)",
         "1:19: 'within' needs a number: within(B, A, number)\n"
         "  within(chip, board)\n"
         "                    ^");
  expect("clear(chip, board, key)",
         "1:20: 'clear' takes two shapes: clear(B, A) or clear(B, A, number), found 'key'\n"
         "  clear(chip, board, key)\n"
         "                     ^~~");
  expect("clear(chip, board, 1, 2)",
         "1:21: too many arguments; 'clear' is written clear(B, A) or clear(B, A, number)\n"
         "  clear(chip, board, 1, 2)\n"
         "                      ^");
  expect("overlaps(chip, board, along=(1,0))",
         "1:23: the predicate 'overlaps' has no directional form; write it as a distance\n"
         "  overlaps(chip, board, along=(1,0))\n"
         "                        ^~~~~");
  expect("mu(chip, board, along=(1,0)) >= 1",
         "1:17: 'mu' has no directional or rotational form; gap, reach, margin, cover, eta2 and delta2 have\n"
         "  mu(chip, board, along=(1,0)) >= 1\n"
         "                  ^~~~~");
  expect("gamma1(chip, board, allong=(1,0)) >= 1",
         "1:21: unknown argument 'allong='; did you mean 'along'?\n"
         "  gamma1(chip, board, allong=(1,0)) >= 1\n"
         "                      ^~~~~~");
  expect("gamma1(chip, board, speed=(1,0)) >= 1",
         "1:21: unknown argument 'speed='; known are along, toward and rotating\n"
         "  gamma1(chip, board, speed=(1,0)) >= 1\n"
         "                      ^~~~~");
  expect("gamma1(chip, board, along=1) >= 1",
         "1:27: a vector such as (1, 0) is meant here, found '1'\n"
         "  gamma1(chip, board, along=1) >= 1\n"
         "                            ^");
  expect("gamma1(chip, board, along=(0,0)) >= 1",
         "1:27: the zero vector is not a direction\n"
         "  gamma1(chip, board, along=(0,0)) >= 1\n"
         "                            ^~~~~");
  expect("gamma1(chip, board, along=(1,0,0)) >= 1",
         "1:28: 3 coordinates where the scene has 2 dimensions\n"
         "  gamma1(chip, board, along=(1,0,0)) >= 1\n"
         "                             ^~~~~");
  expect("gamma1(chip, board, along=(1;0)) >= 1",
         "1:29: stray character ';'\n"
         "  gamma1(chip, board, along=(1;0)) >= 1\n"
         "                              ^");
}

TEST(FormulaErrors, Roles) {
  expect("gamma1(board, key) >= 1",
         "1:8: neither 'board' nor 'key' moves; one of the two has to be the moving shape 'chip'\n"
         "  gamma1(board, key) >= 1\n"
         "         ^~~~~~~~~~");
  expect("gamma1(chip, chip) >= 1",
         "1:8: a distance of 'chip' to itself\n"
         "  gamma1(chip, chip) >= 1\n"
         "         ^~~~~~~~~~");
  expect("gamma1(chip+board, key) >= 1",
         "1:8: only a part of the union 'chip+board' moves; take the parts one by one\n"
         "  gamma1(chip+board, key) >= 1\n"
         "         ^~~~~~~~~~");
}

TEST(FormulaErrors, Numbers) {
  expect("gamma1(chip, board) >= 1furlong",
         "1:25: unknown unit 'furlong'; the units are um, mm, cm, m, in, mil, deg\n"
         "  gamma1(chip, board) >= 1furlong\n"
         "                          ^~~~~~~");
  expect("gamma1(chip, board) >= 1nm",
         "1:25: unknown unit 'nm'; did you mean 'um'?\n"
         "  gamma1(chip, board) >= 1nm\n"
         "                          ^~");
  expect("gamma1(chip, board) >= 10deg",
         "1:26: a length is meant here, not an angle\n"
         "  gamma1(chip, board) >= 10deg\n"
         "                           ^~~");
  expect("gamma1(chip, board, turning=(0,0)) >= 10mm",
         "1:41: a distance in rotation is an angle in degrees, not a length\n"
         "  gamma1(chip, board, turning=(0,0)) >= 10mm\n"
         "                                          ^~");
  expect("gamma1(chip, board, along=(1mm,0)) >= 1",
         "1:29: a direction carries no unit\n"
         "  gamma1(chip, board, along=(1mm,0)) >= 1\n"
         "                              ^~");
  expect("gamma1(chip, board) > 1e999",
         "1:23: a number too long or too large for any coordinate\n"
         "  gamma1(chip, board) > 1e999\n"
         "                        ^~~~~");
  expect("gamma1(chip, board) > 2 + 1e30*1e30",
         "1:1: a number too long or too large for any coordinate\n"
         "  gamma1(chip, board) > 2 + 1e30*1e30\n"
         "  ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~");
  expect("0 < gamma1(chip, board) < 1e-40/3 - 1",
         "1:27: a number too long or too large for any coordinate\n"
         "  0 < gamma1(chip, board) < 1e-40/3 - 1\n"
         "                            ^~~~~~~~~~~");
  expect("gamma1(chip, board) > 1/(2 - 2)",
         "1:25: a division by 0\n"
         "  gamma1(chip, board) > 1/(2 - 2)\n"
         "                          ^~~~~~~");
  expect("gamma1(chip, board) > (1mm + 2)",
         "1:25: a unit stands behind the parentheses: (1 + 2)mm, found 'mm'\n"
         "  gamma1(chip, board) > (1mm + 2)\n"
         "                          ^~");
  expect("gamma1(chip, board) > 2mm * 3",
         "1:24: a unit stands behind the whole product: 2 * 3mm\n"
         "  gamma1(chip, board) > 2mm * 3\n"
         "                         ^~");
  expect("clear(chip, board, 2 * mm)",
         "1:24: a number is meant after '*', as in 2 * 0.25mm; found 'mm'\n"
         "  clear(chip, board, 2 * mm)\n"
         "                         ^~");
  expect("gamma1(chip, board) > 2/",
         "1:25: a number is meant here, found the end\n"
         "  gamma1(chip, board) > 2/\n"
         "                          ^");
}
}  // namespace formula_errors_arguments
}  // namespace findspace::formula
