// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Questions about many positions. The region of a formula is made when first many positions are asked, and marks many
// positions from then on; where there is no such region each position is asked alone.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <mutex>

#include "api/query/world_data.h"
#include "distance/planar/at_position.h"
#include "formula/language/lexer.h"
#include "formula/planar/solve_region.h"
#include "plane/base/parallel.h"

namespace findspace {

using distance::Coordinates;

namespace {

/// Whether a text states a distance, and not a formula.
bool states_a_distance(std::string_view text) {
  using Kind = formula::Token::Kind;
  formula::Lexer lexer(text);
  bool name_before = false;
  for (std::string before;;) {
    const formula::Token token = lexer.next();
    switch (token.kind) {
      case Kind::kEnd:
        return name_before || !before.empty();
      case Kind::kRelation:
      case Kind::kArrow:
      case Kind::kAnd:
      case Kind::kOr:
      case Kind::kNot:
      case Kind::kFault:
        return false;
      case Kind::kOpen:
        if (formula::find_predicate(before) != nullptr) return false;
        name_before = true;
        break;
      default:
        break;
    }
    before = token.kind == Kind::kName ? token.text : "";
    if (before == "true" || before == "false" || before == "and" || before == "or" || before == "not") return false;
  }
}

/// Answers blocks of positions side by side.
template <class Out, class Answer>
void each_block(const Options& options, std::size_t count, std::size_t block, std::span<Out> out,
                const Answer& answer) {
  if (out.size() != count) throw Error(ErrorCode::kBadValue, "as many answers as positions are wanted");
  const std::size_t blocks = (count + block - 1) / block;
  api::Progress progress(options, blocks);
  api::limited(options, [&] {
    plane::parallel_for(blocks, [&](std::size_t k) {
      const std::size_t first = k * block;
      answer(first, std::min(count, first + block));
      progress.add();
    });
    return true;
  });
}

constexpr std::size_t kMarkedBlock = 65536, kAskedBlock = 64;

}  // namespace

struct Query::Data {
  World world;
  std::string written;
  std::optional<formula::Formula> formula{};  // one of these two
  std::optional<formula::Objective> distance{};
  mutable std::once_flag made{};
  mutable std::optional<Region> known{};

  Data(World w, std::string text) : world(std::move(w)), written(std::move(text)) {
    if (states_a_distance(written))
      distance = world.data().distance(written);
    else
      formula = world.data().formula(written);
  }
  const formula::Formula& asked() const {
    if (!formula)
      throw Error(ErrorCode::kBadValue, fmt::format("'{}' is a distance: compare it with a level", written));
    return *formula;
  }
  const formula::Objective& measured() const {
    if (!distance) throw Error(ErrorCode::kBadValue, fmt::format("'{}' is a formula, which has no values", written));
    return *distance;
  }
  const Region& region() const {
    const World::Data& of = world.data();
    const formula::Solver& solver = of.plane("the region of a formula");
    std::call_once(made, [&] {
      known = api::limited(of.options, [&] { return of.region(formula::exact_region(solver, asked()).or_throw()); });
    });
    return *known;
  }
  bool has_region() const { return world.dimension() == 2 && !world.data().planar->known_between_bounds(asked()); }

  template <std::size_t N>
  void holds(std::span<const std::array<double, N>> positions, std::span<bool> out) const {
    const World::Data& of = world.data();
    if (N == 2 && has_region()) return marked(positions, out);
    each_block(of.options, positions.size(), kAskedBlock, out, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) out[k] = of.holds(asked(), api::place_of(of, positions[k]));
    });
  }
  template <std::size_t N>
  void marked(std::span<const std::array<double, N>> positions, std::span<bool> out) const {
    if constexpr (N == 2) {
      const Region& all = region();
      each_block(world.options(), positions.size(), kMarkedBlock, out, [&](std::size_t first, std::size_t last) {
        all.contains(positions.subspan(first, last - first), out.subspan(first, last - first));
      });
    }
  }
  template <std::size_t N>
  void values(std::span<const std::array<double, N>> positions, std::span<double> out) const {
    const World::Data& of = world.data();
    const Values ask(of, measured());
    each_block(of.options, positions.size(), kAskedBlock, out, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) out[k] = ask(api::place_of(of, positions[k]));
    });
  }

  /// The values of one distance; of a plain one of shapes at rest in the plane without the names of what takes it.
  class Values {
   public:
    Values(const World::Data& of, const formula::Objective& wanted) : of_(of), wanted_(wanted) {
      if (!of.planar || of.motion || wanted.distance.mode != formula::Mode::kPlain) return;
      const formula::PreparedWorld& prepared = of.planar->prepared();
      const formula::Roles roles = prepared.roles(wanted.distance);
      pair_ = prepared.pair(roles.names);
      which_ = roles.which();
    }
    double operator()(const Coordinates& p) const {
      constexpr double kNone = std::numeric_limits<double>::infinity();
      if (!pair_) return of_.value(wanted_, p).value().value_or(kNone);
      const auto found = pair_->measure(which_, of_.planar->prepared().steps({p[0], p[1]}));
      if (!found) return wanted_.negated ? -kNone : kNone;
      if (found->minus_infinity) return wanted_.negated ? kNone : -kNone;
      const double value = (found->value * of_.grid.step()).to_double();
      return wanted_.negated ? -value : value;
    }

   private:
    const World::Data& of_;
    const formula::Objective& wanted_;
    std::shared_ptr<const distance::AtPosition> pair_;
    distance::Which which_{};
  };

  template <class P>
  std::optional<formula::NearestFeasible> nearest(const P& from) const {
    const World::Data& of = world.data();
    return api::limited(of.options, [&] {
      const Coordinates p = api::place_of(of, from);
      return (of.solid ? formula::nearest_feasible(*of.solid, asked(), {p[0], p[1], p[2]})
                       : of.planar->nearest_feasible(asked(), {p[0], p[1]}))
          .or_throw();
    });
  }
};

Query World::query(const Formula& formula) const {
  return Query(std::make_shared<const Query::Data>(*this, formula.text()));
}
Query World::query(const Distance& distance) const {
  return Query(std::make_shared<const Query::Data>(*this, distance.text()));
}

namespace {

template <class P>
bool holds_alone(const Query::Data& data, const P& p) {
  const World::Data& of = data.world.data();
  return api::limited(of.options, [&] { return of.holds(data.asked(), api::place_of(of, p)); });
}

template <class P>
DistanceValue value_alone(const Query::Data& data, const P& p) {
  const World::Data& of = data.world.data();
  return api::limited(of.options, [&] { return api::public_value(of.value(data.measured(), api::place_of(of, p))); });
}

}  // namespace

bool Query::holds(const Point& p) const { return holds_alone(*data_, p); }
bool Query::holds(const Point3& p) const { return holds_alone(*data_, p); }
bool Query::holds_at(const Position& p) const { return holds_alone(*data_, p); }
void Query::holds(std::span<const Position> positions, std::span<bool> out) const { data_->holds(positions, out); }
void Query::holds(std::span<const Position3> positions, std::span<bool> out) const { data_->holds(positions, out); }

DistanceValue Query::value(const Point& p) const { return value_alone(*data_, p); }
DistanceValue Query::value(const Point3& p) const { return value_alone(*data_, p); }
void Query::values(std::span<const Position> positions, std::span<double> out) const { data_->values(positions, out); }
void Query::values(std::span<const Position3> positions, std::span<double> out) const { data_->values(positions, out); }

const World& Query::world() const { return data_->world; }
const std::string& Query::text() const { return data_->written; }
const Region& Query::region() const { return data_->region(); }

std::optional<Region::Nearest> Query::nearest(const Position& from) const {
  const auto found = data_->nearest(from);
  if (!found) return std::nullopt;
  return Region::Nearest{
      {found->at[0].to_double(), found->at[1].to_double()}, found->distance.to_double(), found->attained};
}

std::optional<Nearest3> Query::nearest(const Position3& from) const {
  const auto found = data_->nearest(from);
  if (!found) return std::nullopt;
  return Nearest3{{found->at[0].to_double(), found->at[1].to_double(), found->at[2].to_double()},
                  found->distance.to_double(),
                  found->attained};
}

}  // namespace findspace
