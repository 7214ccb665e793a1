// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "in_plane/board_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "exact/margins/rounding.h"
#include "io/board/board.h"
#include "io/draw/draw_layout.h"
#include "io/write/write_json.h"
#include "io/write/write_position.h"
#include "plane/base/parallel.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/query/measure_cells_twofold.h"
#include "report/position_report.h"

namespace findspace::app {
namespace {

constexpr const char* kSelf = "self";
constexpr const char* kRules = "inside(self, board) and clear(self, others)";

/// A part, what it occupies and the box about that.
struct StandingPart {
  const io::Part* part;
  plane::Region region;
  plane::PieceBox box;
};

struct Broken {
  const StandingPart* body;
  formula::Check check;
};

class BoardCheck {
 public:
  explicit BoardCheck(const Session& session) : session_(session), board_(*session.scene().board) {
    rules_ = session.scene().where.empty() ? io::FormulaText{kRules, "--where", 1, 1} : session.scene().where;
    if (session.scene().where.empty() && !board_.keep_outs.empty()) rules_.text += " and clear(self, keepouts)";
    build_bodies();
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

 private:
  /// Lists of bodies: those of the scene, and `others`.
  bool is_list(const std::string& name) const { return name == "others" || session_.scene().groups.count(name) > 0; }

  std::vector<const StandingPart*> members(const std::string& list, const StandingPart& self) const {
    std::vector<const StandingPart*> out;
    const auto group = session_.scene().groups.find(list);
    for (const StandingPart& b : bodies_) {
      if (&b == &self) continue;
      const bool in = list == "others"
                          ? b.part->courtyard.meet(self.part->courtyard)
                          : std::find(group->second.begin(), group->second.end(), b.part->name) != group->second.end();
      if (in) out.push_back(&b);
    }
    return out;
  }

  void build_bodies() {
    std::vector<plane::ShapePtr> shapes;
    std::vector<const io::Part*> parts;
    for (const io::Part& p : board_.parts) {
      if (!p.body) continue;
      shapes.push_back(session_.scene().shape(p.name));
      parts.push_back(&p);
    }
    std::vector<plane::Region> built = session_.regions(shapes);
    for (std::size_t k = 0; k < built.size(); ++k) {
      const auto box = plane::extent(built[k]);
      if (box) bodies_.push_back({parts[k], std::move(built[k]), *box});
    }
  }

  /// The shapes of which the rules speak that are no lists of parts.
  void build_named() {
    if (bodies_.empty()) return;
    const formula::Formula formula = session_.formula(rules_, context(bodies_.front(), {}));
    std::vector<plane::ShapePtr> shapes;
    std::set<std::string> names;
    for (const formula::Atom& a : formula.atoms())
      for (const auto* side : {&a.distance.first, &a.distance.second}) names.insert(side->begin(), side->end());
    for (const std::string& name : names)
      if (const plane::ShapePtr shape = session_.scene().find(name); shape && !is_parts(name)) shapes.push_back(shape);
    std::vector<plane::Region> built = session_.regions(shapes);
    for (std::size_t k = 0; k < built.size(); ++k) named_.emplace(shapes[k]->name, std::move(built[k]));
  }

  /// A list whose members are bodies: not `holes` or the copper of a net.
  bool is_parts(const std::string& name) const {
    const auto group = session_.scene().groups.find(name);
    return name == "others" || (group != session_.scene().groups.end() && !group->second.empty());
  }

  formula::Context context(const StandingPart& self, const std::set<std::string>& empty) const {
    formula::Context context = session_.context();
    context.moving = {kSelf};
    std::erase(context.empty, "others");
    const auto gone = [&](const std::string& name) { return name == self.part->name || empty.count(name) > 0; };
    std::erase_if(context.shapes, gone);
    std::erase(context.shapes, "others");
    if (empty.count("others") == 0) context.shapes.push_back("others");
    context.empty.insert(context.empty.end(), empty.begin(), empty.end());
    for (auto& [list, names] : context.groups)
      std::replace(names.begin(), names.end(), self.part->name, std::string(kSelf));
    return context;
  }

  static bool is_gap(const formula::Atom& a) {
    return a.distance.mode == formula::Mode::kPlain && !a.minimum &&
           (a.distance.kind == formula::Kind::kGamma1 || a.distance.kind == formula::Kind::kD1);
  }

  /// The members of a list that matter: all, or those that may be nearer than the greatest level of a gap to them.
  std::vector<const StandingPart*> near(const std::string& list, const formula::Formula& formula,
                                        const StandingPart& self) const {
    std::vector<const StandingPart*> all = members(list, self);
    double level = 0;
    for (const formula::Atom& a : formula.atoms()) {
      const auto& names = a.distance.second;
      if (std::find(names.begin(), names.end(), list) == names.end()) continue;
      if (!is_gap(a)) return all;
      level = std::max(level, (a.level / session_.step()).to_double());
    }
    const double reach =
        level * (1 + margin::kWiderBox) + 1;  // no sign: what is left out is farther away than the level
    const plane::PieceBox& b = self.box;
    const plane::PieceBox grown{b.x0 - reach, b.y0 - reach, b.x1 + reach, b.y1 + reach};
    std::erase_if(all, [&](const StandingPart* other) { return !grown.meets(other->box); });
    return all;
  }

  formula::Check check(const StandingPart& self) const {
    const formula::Formula all = session_.formula(rules_, context(self, {}));
    formula::World world;
    world.step = session_.step();
    world.moving = {kSelf};
    world.shapes.emplace(kSelf, self.region);
    std::set<std::string> empty, names;
    for (const formula::Atom& a : all.atoms()) names.insert(a.distance.second.begin(), a.distance.second.end());
    for (const formula::Atom& a : all.atoms()) names.insert(a.distance.first.begin(), a.distance.first.end());
    for (const std::string& name : names) {
      if (name == kSelf) continue;
      if (!is_parts(name)) {
        world.shapes.emplace(name, named_.at(name));
        continue;
      }
      std::vector<const plane::Region*> regions;
      for (const StandingPart* b : near(name, all, self)) {
        regions.push_back(&b->region);
        world.parts[name].emplace_back(b->part->name, b->region);
      }
      if (regions.empty())
        empty.insert(name);
      else
        world.shapes.emplace(name, plane::unite(regions));
    }
    const formula::Formula formula = session_.formula(rules_, context(self, empty));
    return formula::Solver(std::move(world)).check(formula, {exact::Real(0), exact::Real(0)});
  }

  const Session& session_;
  const io::Board& board_;
  io::FormulaText rules_;
  std::vector<StandingPart> bodies_;
  std::map<std::string, plane::Region> named_;
};

std::string anchor(const io::Part& part, const exact::Real& step) {
  const double s = step.to_double();
  return fmt::format("({}, {})", io::shown(double(part.at.x) * s), io::shown(double(part.at.y) * s));
}

std::string text_of(const Session& session, const BoardCheck& board, const std::vector<Broken>& broken) {
  if (broken.empty()) return fmt::format("all {} parts keep the rules: {}\n", board.bodies().size(), board.rules());
  std::string out =
      fmt::format("{} of {} parts break the rules: {}\n", broken.size(), board.bodies().size(), board.rules());
  for (const Broken& b : broken)
    out += check_text(b.check, fmt::format("{} at {}", b.body->part->name, anchor(*b.body->part, session.step())), {},
                      session.unit(), nullptr, session.options().explain);
  return out;
}

std::string json_of(const Session& session, const BoardCheck& board, const std::vector<Broken>& broken) {
  std::string out = fmt::format("{{\"parts\": {}, \"holds\": {}, \"rules\": {}, \"broken\": [", board.bodies().size(),
                                broken.empty(), io::json_string(board.rules()));
  const char* between = "\n";
  for (const Broken& b : broken) {
    std::string check = io::check_json(b.check, {exact::Real(0), exact::Real(0)}, session.unit(), std::nullopt, nullptr,
                                       session.options().explain);
    while (!check.empty() && check.back() == '\n') check.pop_back();
    out += fmt::format("{}{{\"part\": {}, \"check\": {}}}", between, io::json_string(b.body->part->name), check);
    between = ",\n";
  }
  return out + "]}\n";
}

plane::Place spot(const distance::Coordinates& p) {
  return {plane::Twofold(p[0]).value(), plane::Twofold(p[1]).value()};
}

std::string picture_of(const Session& session, const BoardCheck& board, const std::vector<Broken>& broken) {
  io::Picture p;
  p.title = broken.empty() ? "All parts keep the rules"
                           : fmt::format("{} of {} parts break the rules", broken.size(), board.bodies().size());
  p.subtitle = board.rules();
  p.step = session.step();
  p.unit = session.unit();
  p.y_down = true;
  p.of_positions = false;
  std::set<const StandingPart*> bad;
  for (const auto& [name, region] : board.named())
    if (name == "board") p.fixed.push_back({name, &region});
  for (const Broken& b : broken) {
    bad.insert(b.body);
    p.placed.push_back({b.body->part->name, &b.body->region});
    for (const formula::AtomAt& a : b.check.atoms) {
      const auto& d = a.distance;
      if (a.holds || !d.answer || d.answer->witness.size() != 2) continue;
      p.dimensions.push_back(
          {spot(d.answer->witness[0].at), spot(d.answer->witness[1].at), io::shown(*d.value()), true});
    }
  }
  for (const StandingPart& b : board.bodies())
    if (bad.count(&b) == 0) p.fixed.push_back({b.part->name, &b.region});
  p.dimensions = io::without_repetition(std::move(p.dimensions));
  return io::picture_svg(p);
}

}  // namespace

Outcome check_board(const Session& session) {
  check_outputs(session.options(), {".svg", ".json"});
  session.reporter().stage("building the shapes");
  const BoardCheck board(session);
  session.reporter().stage("checking");
  const std::vector<Broken> broken = board.run();
  const auto json = [&] { return json_of(session, board, broken); };
  const auto svg = [&] { return picture_of(session, board, broken); };
  write_outputs(session.options(), {{".json", json}, {".svg", svg}});
  return {session.options().json ? json() : text_of(session, board, broken), broken.empty() ? kDone : kEmpty};
}

}  // namespace findspace::app
