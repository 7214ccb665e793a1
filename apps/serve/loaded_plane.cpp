// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/loaded_plane.h"

#include <fmt/format.h>

#include <algorithm>

#include "findspace/board.h"
#include "findspace/error.h"
#include "findspace/text.h"

namespace findspace::app {
namespace {

using Kind = Scene::Free::Kind;

/// Where unbounded sets are cut off in drawings, in sizes of what is bounded in the scene.
constexpr double kAround = 3;

void include(std::optional<Bounds>& all, const std::optional<Bounds>& more) {
  if (!more) return;
  if (!all) all = more;
  for (const std::size_t k : {0, 1}) {
    all->low[k] = std::min(all->low[k], more->low[k]);
    all->high[k] = std::max(all->high[k], more->high[k]);
  }
}

std::string position_json(const Position& p) { return fmt::format("[{}, {}]", json_number(p[0]), json_number(p[1])); }

std::string places_json(const std::vector<Position>& places) { return json_list(places, position_json); }

bool is_exact(const RegionBounds& region) { return region.outer.shared_data() == region.inner.shared_data(); }

}  // namespace

LoadedPlane::LoadedPlane(const Scene& given) : Loaded(given) {
  if (!scene().moving().empty()) scene().world();  // builds its shapes
  extent();
}

void LoadedPlane::forget_answers() {
  upright_.reset();
  rotated_.reset();
  if (scene().board()) extent_.reset();  // other shapes are looked at
}

const Scene& LoadedPlane::rotated(const std::optional<Number>& degrees) const {
  const bool turns = degrees || is_free(Kind::kAngle) || is_free(Kind::kPose);
  const bool upright = !degrees || *degrees == Number(0);
  if (!turns || (upright && scene().motion())) return asked();
  if (upright) {
    if (!upright_) upright_ = asked().rotated(Number(0));
    return *upright_;
  }
  if (!rotated_ || !(rotated_->degrees == *degrees)) rotated_ = Rotated{*degrees, asked().rotated(*degrees)};
  return rotated_->scene;
}

const std::optional<Bounds>& LoadedPlane::extent() const {
  if (extent_) return *extent_;
  extent_.emplace();
  const bool board = scene().board().has_value();
  std::vector<std::string> looked_at = board ? scene().used() : scene().names();
  if (board) looked_at.insert(looked_at.end(), scene().moving().begin(), scene().moving().end());
  for (const std::string& name : looked_at) include(*extent_, scene().shapes().at(name).region().extent());
  return *extent_;
}

std::string LoadedPlane::drawing_json(const Region& region) const {
  std::optional<Bounds> box = region.extent();
  include(box, extent());
  Bounds window = box.value_or(Bounds{{-1, -1}, {1, 1}});
  const double more = kAround * std::max(window.high[0] - window.low[0], window.high[1] - window.low[1]);
  for (const std::size_t k : {0, 1}) {
    window.low[k] -= more;
    window.high[k] += more;
  }
  const Region::Paths d = region.paths(window, scene().y_down());
  return fmt::format(R"({{"faces": {}, "closed": {}, "open": {}, "free": {}, "points": {}, "full": {}, "hollow": {}}})",
                     json_string(d.faces), json_string(d.closed), json_string(d.open), json_string(d.free),
                     places_json(d.points), places_json(d.full), places_json(d.hollow));
}

std::string LoadedPlane::drawing_of(const std::string& shape) const {
  return drawing_json(scene().shapes().at(shape).region());
}

std::string LoadedPlane::brief_json(const RegionBounds& region) const {
  const std::optional<Position> some = region.inner.some();
  std::string out = fmt::format(R"({{"empty": {}, "sample": {}, "drawing": {})", !some,
                                some ? position_json(*some) : "null", drawing_json(region.inner));
  if (!is_exact(region)) out += ", \"outer_drawing\": " + drawing_json(region.outer);
  return out + "}";
}

std::string LoadedPlane::map_json(const RegionQuery& query) const {
  require_moving();
  const Scene& world = rotated(query.angle);
  MapQuestion question;
  question.apply = query.apply;
  question.before = "--";
  question.pictures = false;
  const Answer map = (query.where ? asking(world, *query.where) : world).map(question);
  if (query.brief) return brief_json(*map.region());
  std::string out = map.json();
  if (!query.drawing) return out;
  const RegionBounds region = *map.region();
  out = with_member(std::move(out), "drawing", drawing_json(region.inner));
  return is_exact(region) ? out : with_member(std::move(out), "outer_drawing", drawing_json(region.outer));
}

std::string LoadedPlane::check_json(const Spot& spot, const CheckQuestion& question) const {
  require_moving();
  CheckQuestion wanted = question;
  wanted.nearest = question.nearest && !spot.time;
  return rotated(spot.angle).check({spot.at, {}, spot.time}, wanted).json();
}

std::string LoadedPlane::nearest_json(const Spot& spot) const {
  require_moving();
  return rotated(spot.angle).nearest({spot.at, {}, {}}).json();
}

std::string LoadedPlane::measure_json(const Spot& spot) const {
  require_moving();
  return rotated(spot.angle).measure({spot.at, {}, {}}).json();
}

std::string LoadedPlane::angles_json(const Spot& spot) const {
  require_moving();
  if (scene().motion()) refuse("a map of angles in a scene with \"motion\"");
  Scene::Question angles;
  angles.free = Kind::kAngle;
  MapQuestion question;
  question.pose.at = spot.at;
  return asked().asking(angles).map(question).json();
}

std::string LoadedPlane::instants_json(const Spot& spot) const {
  require_moving();
  Scene::Question instants;
  instants.free = Kind::kTime;
  MapQuestion question;
  question.pose.at = spot.at;
  return asked().asking(instants).map(question).json();
}

std::string LoadedPlane::between_json(const Spot& spot, const Point& from, const Point& to) const {
  return rotated(spot.angle).between(from, to, {spot.at, {}, {}}).json();
}

}  // namespace findspace::app
