// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/report/board_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <set>

#include "exact/margins/boards.h"
#include "exact/margins/rounding.h"
#include "formula/planar/solve.h"
#include "io/draw/draw_dimensions.h"
#include "io/draw/draw_layout.h"
#include "io/report/board_picture.h"
#include "io/report/position_report.h"
#include "io/scene/scene_formulas.h"
#include "io/scene/scene_regions.h"
#include "io/write/write_json.h"
#include "io/write/write_position.h"
#include "io/write/write_svg.h"
#include "plane/base/parallel.h"
#include "plane/complex/extent.h"
#include "plane/query/measure_cells_twofold.h"
#include "plane/walk/unite.h"

namespace findspace::io {
namespace board_check {

constexpr const char *kSelf = "self", *kHoles = "holes", *kKeepOuts = "keepouts";

/// What the rules are without --where.
std::string own_rules(const Board& board) {
  const bool turned = std::any_of(board.parts.begin(), board.parts.end(), [](const Part& p) {
    const exact::Real quarters = p.degrees / exact::Real(90);
    return p.body && !(exact::Real(floor(quarters)) == quarters);
  });
  const std::string room = turned ? fmt::format(", -{:f}mm", margin::kTurnedBodies) : "";
  return fmt::format("inside(self, board{0}) and clear(self, others{0}){1}", room,
                     board.keep_outs.empty() ? "" : fmt::format(" and clear(self, keepouts{})", room));
}

/// A part, what it occupies and the box about that.
struct StandingPart {
  const Part* part;
  plane::Region region;
  plane::PieceBox box;
};

/// A drilled hole or a keep-out; `part` owns it, or is empty.
struct OwnedArea {
  std::string part;
  Sides sides;
  plane::Region region;
  plane::PieceBox box;
};

struct Broken {
  const StandingPart* body;
  formula::Check check;
};

bool is_gap(const formula::Atom& a) {
  const auto& d = a.distance;
  return d.mode == formula::Mode::kPlain && !a.minimum && a.more.empty() &&
         (d.kind == formula::Kind::kGamma1 || d.kind == formula::Kind::kD1) &&
         d.first == std::vector<std::string>{kSelf};
}

/// Whether the atom is asked of every pair: a gap that is least over a list keeps a distance from all of it.
bool is_of_pairs(const formula::Atom& a) {
  return is_gap(a) && (a.relation == formula::Relation::kGreater || a.relation == formula::Relation::kGreaterEqual);
}

/// The rules of a board, asked of its parts.
class BoardRules {
 public:
  BoardRules(Scene scene, const std::string& place) : scene_(std::move(scene)), board_(*scene_.board) {
    rules_ = {scene_.where.empty() ? own_rules(board_) : scene_.where.text, place, 1, 1};
    build_bodies();
    build_lists();
    read_rules();
    build_named();
  }

  std::vector<Broken> run() const {
    std::vector<std::optional<formula::Check>> checks(bodies_.size());
    plane::parallel_for(bodies_.size(), [&](std::size_t k) { checks[k] = check(bodies_[k]); });
    std::vector<Broken> out;
    for (std::size_t k = 0; k < bodies_.size(); ++k)
      if (!checks[k]->holds) out.push_back({&bodies_[k], *std::move(checks[k])});
    return out;
  }

  const std::vector<StandingPart>& bodies() const { return bodies_; }
  const std::map<std::string, plane::Region>& named() const { return named_; }
  const std::string& rules() const { return rules_.text; }
  const Scene& scene() const { return scene_; }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::vector<const StandingPart*> members(const std::string& list, const StandingPart& self) const {
    std::vector<const StandingPart*> out;
    if (list != "others") {
      for (const std::size_t k : lists_.at(list))
        if (&bodies_[k] != &self) out.push_back(&bodies_[k]);
      return out;
    }
    for (const StandingPart& b : bodies_)
      if (&b != &self && b.part->courtyard.meet(self.part->courtyard)) out.push_back(&b);
    return out;
  }

  void build_bodies() {
    std::vector<plane::ShapePtr> shapes;
    std::vector<const Part*> parts;
    for (const Part& p : board_.parts) {
      if (!p.body) continue;
      shapes.push_back(scene_.shape(p.name));
      parts.push_back(&p);
    }
    std::vector<plane::Region> built = regions_of(scene_, shapes, notes_);
    for (std::size_t k = 0; k < built.size(); ++k) {
      const auto box = plane::extent(built[k]);
      if (!box) continue;
      by_name_.emplace(parts[k]->name, bodies_.size());
      bodies_.push_back({parts[k], std::move(built[k]), *box});
    }
  }

  void build_lists() {
    for (const auto& [list, names] : scene_.groups) {
      std::set<std::size_t> members;
      for (const std::string& name : names)
        if (const auto part = by_name_.find(name); part != by_name_.end()) members.insert(part->second);
      lists_[list].assign(members.begin(), members.end());
    }
  }

  /// The rules as each part reads them; without parts they are read all the same.
  void read_rules() {
    if (bodies_.empty()) {
      formula::Context context = context_of(scene_);
      context.moving = {kSelf};
      read_formula(rules_, context);
    }
    std::mutex guard;
    plane::parallel_for(bodies_.size(), [&](std::size_t k) {
      std::set<std::string> names = read_formula(rules_, context(bodies_[k], {})).shapes();
      std::erase_if(names, [&](const std::string& name) { return by_name_.count(name) > 0; });
      const std::lock_guard held(guard);
      names_.merge(names);
    });
  }

  /// The shapes of which the rules speak, of whatever part, but for parts and lists of them.
  void build_named() {
    if (names_.count(kHoles) > 0) build_holes();
    if (names_.count(kKeepOuts) > 0) build_keep_outs();
    std::vector<plane::ShapePtr> shapes;
    for (const std::string& name : names_)
      if (const plane::ShapePtr shape = scene_.find(name); shape && !is_parts(name)) shapes.push_back(shape);
    std::vector<plane::Region> built = regions_of(scene_, shapes, notes_);
    for (std::size_t k = 0; k < built.size(); ++k) named_.emplace(shapes[k]->name, std::move(built[k]));
  }

  void build_holes() {
    std::vector<plane::ShapePtr> shapes;
    for (const Hole& hole : board_.holes) shapes.push_back(hole.shape);
    std::vector<plane::Region> built = regions_of(scene_, shapes, notes_);
    const double step = scene_.grid.step().to_double();
    for (std::size_t k = 0; k < built.size(); ++k) {
      const auto box = plane::extent(built[k]);
      if (!box) continue;
      const std::string name =
          fmt::format("hole at {} {}", shown((box->x0 + box->x1) / 2 * step), shown((box->y0 + box->y1) / 2 * step));
      add_owned(kHoles, own_name(name), {board_.holes[k].part, {true, true}, std::move(built[k]), *box});
    }
  }

  void build_keep_outs() {
    std::vector<plane::ShapePtr> shapes;
    for (const KeepOut& k : board_.keep_outs) shapes.push_back(k.area);
    std::vector<plane::Region> built = regions_of(scene_, shapes, notes_);
    for (std::size_t k = 0; k < built.size(); ++k) {
      const KeepOut& area = board_.keep_outs[k];
      const auto box = plane::extent(built[k]);
      if (box)
        add_owned(kKeepOuts, is_known_by_name(area) ? area.name : own_name("keep-out " + area.name),
                  {area.part, area.sides, std::move(built[k]), *box});
    }
  }

  /// Whether rules mean this keep-out by its name, and not a part, a list or a word.
  bool is_known_by_name(const KeepOut& area) const {
    if (area.name == kSelf || by_name_.count(area.name) > 0 || is_parts(area.name)) return false;
    const plane::ShapePtr known = scene_.find(area.name);
    return known && known->collection && known->children.size() == 1 && known->children[0]->name == area.name;
  }

  bool is_own_keep_out(const std::string& name, const Part& part) const {
    return std::any_of(board_.keep_outs.begin(), board_.keep_outs.end(),
                       [&](const KeepOut& k) { return k.name == name && k.part == part.name && is_known_by_name(k); });
  }

  /// The name, with a number where something else has it.
  std::string own_name(const std::string& name) const {
    std::string out = name;
    const auto taken = [&] { return owned_.count(out) > 0 || by_name_.count(out) > 0 || scene_.groups.count(out) > 0; };
    for (int k = 2; taken(); ++k) out = fmt::format("{} ({})", name, k);
    return out;
  }

  void add_owned(const std::string& list, const std::string& name, OwnedArea area) {
    owned_lists_[list].push_back(name);
    owned_.emplace(name, std::move(area));
  }

  /// A list whose members are bodies: not `holes` or the copper of a net.
  bool is_parts(const std::string& name) const {
    if (by_name_.count(name) > 0) return false;
    const auto group = scene_.groups.find(name);
    return name == "others" || (group != scene_.groups.end() && !group->second.empty());
  }

  formula::Context context(const StandingPart& self, const std::set<std::string>& empty) const {
    formula::Context context = context_of(scene_);
    context.moving = {kSelf};
    std::erase(context.empty, "others");
    const auto gone = [&](const std::string& name) { return empty.count(name) > 0; };
    std::erase_if(context.shapes, gone);
    std::erase(context.shapes, "others");
    if (empty.count("others") == 0) context.shapes.push_back("others");
    context.all.emplace();
    for (const StandingPart* other : members("others", self)) context.all->push_back(other->part->name);
    context.empty.insert(context.empty.end(), empty.begin(), empty.end());
    for (auto& [list, names] : context.groups)
      std::replace(names.begin(), names.end(), self.part->name, std::string(kSelf));
    context.groups.try_emplace(self.part->name, std::vector<std::string>{kSelf});  // a shape is a group of itself
    return context;
  }

  /// Whether the part may be as near as the level of a gap.
  bool is_near(const plane::PieceBox& other, const exact::Real& level, const StandingPart& self) const {
    const double steps = std::max(0.0, (level / scene_.grid.step()).to_double());
    const double reach =
        steps * (1 + margin::kWiderBox) + 1;  // no sign: what is left out is farther away than the level
    const plane::PieceBox& b = self.box;
    return plane::PieceBox{b.x0 - reach, b.y0 - reach, b.x1 + reach, b.y1 + reach}.meets(other);
  }

  /// What a rule about these shapes and lists is asked of, one by one.
  std::set<std::string> others(const formula::Atom& atom, const StandingPart& self) const {
    std::set<std::string> out;
    const auto add = [&](const StandingPart& part) {
      if (&part != &self && is_near(part.box, atom.level, self)) out.insert(part.part->name);
    };
    for (const std::string& name : atom.distance.second) {
      if (const auto part = by_name_.find(name); part != by_name_.end())
        add(bodies_[part->second]);
      else if (const auto list = owned_lists_.find(name); list != owned_lists_.end())
        for (const std::string& member : list->second) {
          const OwnedArea& area = owned_.at(member);
          if (area.part != self.part->name && area.sides.meet(self.part->courtyard) &&
              is_near(area.box, atom.level, self))
            out.insert(member);
        }
      else if (is_parts(name))
        for (const StandingPart* other : members(name, self)) add(*other);
      else if (!is_own_keep_out(name, *self.part))
        out.insert(name);
    }
    return out;
  }

  /// The formula's tree with an atom for each pair.
  formula::Node by_pairs(const formula::Node& node, const formula::Formula& formula, const StandingPart& self,
                         std::vector<formula::Atom>& atoms) const {
    using Op = formula::Node::Op;
    const auto add = [&](formula::Atom atom) {
      atoms.push_back(std::move(atom));
      return formula::Node{Op::kAtom, atoms.size() - 1, {}};
    };
    formula::Node out = node;
    if (node.op != Op::kAtom) {
      for (formula::Node& operand : out.operands) operand = by_pairs(operand, formula, self, atoms);
      return out;
    }
    formula::Atom atom = formula.atoms()[node.atom];
    // A part is neither too near to itself nor too far from itself.
    if (is_gap(atom) && atom.distance.second == std::vector<std::string>{self.part->name}) return {Op::kTrue, 0, {}};
    if (is_gap(atom)) std::erase(atom.distance.second, self.part->name);
    if (!is_of_pairs(atom)) return add(atom);
    out = {Op::kAnd, 0, {}};
    for (const std::string& other : others(atom, self)) {
      formula::Atom pair = atom;
      pair.distance.second = {other};
      if (!pair.distance.lists.empty()) pair.distance.lists = {pair.distance.first.front(), other};
      out.operands.push_back(add(std::move(pair)));
    }
    if (out.operands.size() == 1) return formula::Node(out.operands.front());
    return out;
  }

  formula::Check check(const StandingPart& self) const {
    const formula::Formula named = read_formula(rules_, context(self, {}));  // as the part reads them
    std::set<std::string> empty;
    for (const std::string& name : named.shapes())
      if (is_parts(name) && members(name, self).empty()) empty.insert(name);
    const formula::Formula all = empty.empty() ? named : read_formula(rules_, context(self, empty));
    std::vector<formula::Atom> atoms;
    formula::Node root = by_pairs(all.root(), all, self, atoms);
    const formula::Formula pairs(std::move(root), std::move(atoms));
    formula::Check out = formula::Solver(world(pairs, self)).check(pairs, {exact::Real(0), exact::Real(0)});
    // Of the pairs those that break the rule are said.
    std::erase_if(out.atoms, [&](const formula::AtomAt& a) {
      return a.holds && std::find(all.atoms().begin(), all.atoms().end(), a.atom) == all.atoms().end();
    });
    return out;
  }

  formula::World world(const formula::Formula& formula, const StandingPart& self) const {
    formula::World world;
    world.step = scene_.grid.step();
    world.moving = {kSelf};
    world.shapes.emplace(kSelf, self.region);
    for (const std::string& name : formula.shapes()) {
      if (name == kSelf) continue;
      if (!is_parts(name)) {
        if (const auto part = by_name_.find(name); part != by_name_.end())
          world.shapes.emplace(name, bodies_[part->second].region);
        else if (const auto area = owned_.find(name); area != owned_.end())
          world.shapes.emplace(name, area->second.region);
        else
          world.shapes.emplace(name, named_.at(name));
        continue;
      }
      std::vector<const plane::Region*> regions;
      for (const StandingPart* b : members(name, self)) {
        regions.push_back(&b->region);
        world.parts[name].emplace_back(b->part->name, b->region);
      }
      world.shapes.emplace(name, plane::unite(regions));
    }
    return world;
  }

  const Scene scene_;
  const Board& board_;
  std::vector<std::string> notes_;
  FormulaText rules_;
  std::vector<StandingPart> bodies_;
  std::map<std::string, std::size_t> by_name_;             // of bodies
  std::map<std::string, std::vector<std::size_t>> lists_;  // of bodies, in their order
  std::set<std::string> names_;                            // that the rules name, of whatever part
  std::map<std::string, plane::Region> named_;
  std::map<std::string, OwnedArea> owned_;                       // by the names that results have
  std::map<std::string, std::vector<std::string>> owned_lists_;  // of `holes` and `keepouts`
};

std::string unit_of(const Scene& scene) { return scene.unit ? std::string(formula::name(*scene.unit)) : ""; }

std::string anchor(const Part& part, const exact::Real& step) {
  const double s = step.to_double();
  return fmt::format("({}, {})", shown(double(part.at.x) * s), shown(double(part.at.y) * s));
}

std::string text_of(const BoardRules& board, const std::vector<Broken>& broken, bool explain) {
  if (broken.empty()) return fmt::format("all {} parts keep the rules: {}\n", board.bodies().size(), board.rules());
  std::string out =
      fmt::format("{} of {} parts break the rules: {}\n", broken.size(), board.bodies().size(), board.rules());
  for (const Broken& b : broken)
    out += check_text(b.check,
                      fmt::format("{} at {}", b.body->part->name, anchor(*b.body->part, board.scene().grid.step())), {},
                      unit_of(board.scene()), {}, explain);
  return out;
}

std::string json_of(const BoardRules& board, const std::vector<Broken>& broken, bool explain) {
  std::string out = fmt::format("{{\"parts\": {}, \"holds\": {}, \"rules\": {}, \"broken\": [", board.bodies().size(),
                                broken.empty(), json_string(board.rules()));
  const char* between = "\n";
  for (const Broken& b : broken) {
    std::string check =
        check_json(b.check, {exact::Real(0), exact::Real(0)}, unit_of(board.scene()), std::nullopt, {}, explain);
    while (!check.empty() && check.back() == '\n') check.pop_back();
    out += fmt::format("{}{{\"part\": {}, \"check\": {}}}", between, json_string(b.body->part->name), check);
    between = ",\n";
  }
  return out + "]}\n";
}

plane::Place spot(const distance::Coordinates& p) {
  return {plane::Twofold(p[0]).value(), plane::Twofold(p[1]).value()};
}

std::string picture_of(const BoardRules& board, const std::vector<Broken>& broken) {
  Picture p;
  p.title = broken.empty() ? "All parts keep the rules"
                           : fmt::format("{} of {} parts break the rules", broken.size(), board.bodies().size());
  p.subtitle = board.rules();
  p.step = board.scene().grid.step();
  p.unit = unit_of(board.scene());
  p.y_down = p.small_names = true;
  const Board& on = *board.scene().board;
  p.copper = copper_of(on, {}, p.step.to_double());
  p.of_positions = false;
  constexpr double kSmall = 8;  // pixels of a number
  p.placed_text = "parts that break the rules";
  p.placed_style = "broken";
  std::set<const StandingPart*> bad;
  for (const auto& [name, region] : board.named())
    if (name == "board") p.fixed.push_back({"", &region});
  std::set<std::pair<std::string, std::string>> drawn;  // from which part to which
  for (const Broken& b : broken) {
    bad.insert(b.body);
    p.placed.push_back({b.body->part->name, &b.body->region});
    for (const formula::AtomAt& a : b.check.atoms) {
      const auto& d = a.distance;
      if (a.holds || !d.answer || d.answer->witness.size() != 2) continue;
      // Of a pair that both break the rule the distance is drawn once.
      const std::string &self = b.body->part->name, &other = a.atom.distance.second[0];
      if (drawn.count({other, self}) > 0) continue;
      drawn.emplace(self, other);
      p.dimensions.push_back({spot(d.answer->witness[0].at), spot(d.answer->witness[1].at),
                              fmt::format("{:.3g}", *d.value()), true, kSmall});
    }
  }
  for (const StandingPart& b : board.bodies())
    if (bad.count(&b) == 0) p.fixed.push_back({b.part->name, &b.region, is_behind(&on, b.part->name)});
  p.dimensions = without_repetition(std::move(p.dimensions));
  return picture_svg(p);
}

}  // namespace board_check

using namespace board_check;

struct BoardCheck::Work {
  BoardRules rules;
  std::vector<Broken> broken;

  Work(Scene scene, const std::string& place) : rules(std::move(scene), place), broken(rules.run()) {}
};

BoardCheck::BoardCheck(Scene scene, const std::string& place)
    : work_(std::make_unique<const Work>(std::move(scene), place)) {}
BoardCheck::~BoardCheck() = default;

std::size_t BoardCheck::parts() const { return work_->rules.bodies().size(); }
const std::string& BoardCheck::rules() const { return work_->rules.rules(); }
const std::vector<std::string>& BoardCheck::notes() const { return work_->rules.notes(); }

std::vector<BoardCheck::BrokenPart> BoardCheck::broken() const {
  std::vector<BrokenPart> out;
  for (const Broken& b : work_->broken) out.push_back({b.body->part, &b.check});
  return out;
}

std::string BoardCheck::text(bool explain) const { return text_of(work_->rules, work_->broken, explain); }
std::string BoardCheck::json(bool explain) const { return json_of(work_->rules, work_->broken, explain); }
std::string BoardCheck::svg() const { return picture_of(work_->rules, work_->broken); }

}  // namespace findspace::io
