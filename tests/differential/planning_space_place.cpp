// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Placement in space against brute force over a lattice: solids of unit cells one after another, each at the first free
// lattice position in the order of the objectives. The positions as boxes, as polyhedra and on lines (one through every
// lattice position) all have to give these.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "formula/language/parse.h"
#include "planning/solid/space_sequence.h"
#include "space/polytope/solid.h"

namespace findspace::planning {
namespace planning_space_place {

using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;

constexpr int kSize = 5;

/// One or two boxes of cells from the origin.
struct Block {
  std::vector<Cell> boxes;  // their sizes

  Cells cells() const {
    Cells out;
    for (const Cell& b : boxes)
      for (int x = 0; x < b[0]; ++x)
        for (int y = 0; y < b[1]; ++y)
          for (int z = 0; z < b[2]; ++z) out.insert({x, y, z});
    return out;
  }
};

plane::ShapePtr box_shape(const Cell& size) {
  auto solid = std::make_shared<space::Solid>();
  for (int k = 0; k < 8; ++k)
    solid->mesh.vertices.push_back({(k & 1) * size[0], (k >> 1 & 1) * size[1], (k >> 2) * size[2]});
  plane::Shape shape;
  shape.solid = solid;
  return std::make_shared<const plane::Shape>(std::move(shape));
}

plane::ShapePtr shape_of(const std::string& name, const Block& block) {
  plane::Shape shape;
  shape.kind = plane::Shape::Kind::kUnion;
  shape.name = name;
  for (const Cell& b : block.boxes) shape.children.push_back(box_shape(b));
  return std::make_shared<const plane::Shape>(std::move(shape));
}

/// By axis: 1 up, -1 down; the first axis first.
struct Order {
  std::array<int, 3> axes, signs;
};

std::vector<std::optional<Cell>> placed_by_hand(const std::vector<Block>& blocks, const Order& order) {
  Cells taken;
  std::vector<std::optional<Cell>> out;
  for (const Block& block : blocks) {
    const Cells cells = block.cells();
    std::optional<Cell> best;
    const auto key = [&](const Cell& p) {
      Cell k{};
      for (std::size_t i = 0; i < 3; ++i) k[i] = order.signs[i] * p[static_cast<std::size_t>(order.axes[i])];
      return k;
    };
    for (int x = 0; x < kSize; ++x)
      for (int y = 0; y < kSize; ++y)
        for (int z = 0; z < kSize; ++z) {
          const Cell p{x, y, z};
          const bool fits = std::all_of(cells.begin(), cells.end(), [&](const Cell& c) {
            const Cell q{c[0] + x, c[1] + y, c[2] + z};
            return q[0] < kSize && q[1] < kSize && q[2] < kSize && !taken.contains(q);
          });
          if (fits && (!best || key(p) < key(*best))) best = p;
        }
    out.push_back(best);
    if (!best) continue;
    for (const Cell& c : cells) taken.insert({c[0] + (*best)[0], c[1] + (*best)[1], c[2] + (*best)[2]});
  }
  return out;
}

enum class Form { kBoxes, kFlat, kLines };

SpaceProblem problem_of(const std::vector<Block>& blocks, const Order& order, Form form) {
  SpaceProblem problem;
  problem.step = exact::Real(1);
  const auto add = [&](const std::string& name, const Block& block) {
    const plane::ShapePtr shape = shape_of(name, block);
    formula::SpaceShape built = formula::space_shape(*shape);
    if (form != Form::kBoxes) built.boxes.reset();
    if (form == Form::kLines) built.body = nullptr;
    problem.shapes.emplace(name, shape);
    problem.built.emplace(name, std::move(built));
  };
  add("bin", {{{kSize, kSize, kSize}}});
  formula::Context context;
  context.dimension = 3;
  context.shapes = {"bin"};
  context.moving = {"self"};
  const auto each = std::make_shared<const formula::Formula>(formula::parse_formula("inside(self, bin)", context));
  context.extra = {"other"};
  const auto pairs = std::make_shared<const formula::Formula>(formula::parse_formula("clear(self, other)", context));
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::string name = "block" + std::to_string(b);
    add(name, blocks[b]);
    problem.bodies.push_back({name, 0, {name}, {exact::Real()}, {{name}}});
    problem.conditions.push_back({each, {{"self", {b, {}}}}});
    for (std::size_t a = 0; a < b; ++a) problem.conditions.push_back({pairs, {{"self", {b, {}}}, {"other", {a, {}}}}});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    formula::Goal goal;
    goal.form.emplace();
    (*goal.form)[static_cast<std::size_t>(order.axes[i])] = exact::Real(order.signs[i]);
    problem.goals.push_back(goal);
  }
  return problem;
}

TEST(SpacePlace, BlocksOfCells) {
  std::mt19937 random(11);
  const auto pick = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  int placed = 0, refused = 0;
  for (int round = 0; round < 25; ++round) {
    std::vector<Block> blocks;
    for (int b = pick(3, 6); b > 0; --b) {
      Block block;
      for (int k = pick(1, 2); k > 0; --k) block.boxes.push_back({pick(1, 4), pick(1, 4), pick(1, 4)});
      blocks.push_back(block);
    }
    Order order{{0, 1, 2}, {1, 1, 1}};
    std::shuffle(order.axes.begin(), order.axes.end(), random);
    for (int& s : order.signs) s = pick(0, 1) ? 1 : -1;
    const auto expected = placed_by_hand(blocks, order);
    for (const Form form : {Form::kBoxes, Form::kFlat, Form::kLines}) {
      const SpacePlacement found = place_in_space(problem_of(blocks, order, form), {});
      ASSERT_EQ(found.poses.size(), expected.size());
      for (std::size_t b = 0; b < expected.size(); ++b) {
        ASSERT_EQ(found.poses[b].has_value(), expected[b].has_value()) << round << " " << b << " " << int(form);
        EXPECT_EQ(found.steps[b].best.on_lines, form == Form::kLines);
        (expected[b] ? placed : refused) += 1;
        for (std::size_t k = 0; expected[b] && k < 3; ++k)
          EXPECT_EQ(found.poses[b]->at[k], exact::Real((*expected[b])[k])) << round << " " << b << " " << int(form);
      }
    }
  }
  EXPECT_GT(placed, 100);
  EXPECT_GT(refused, 10);
}

}  // namespace planning_space_place
}  // namespace findspace::planning
