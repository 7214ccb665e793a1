// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/loaded_space.h"

#include "findspace/error.h"

namespace findspace::app {
namespace {

/// Lines each way where none are asked for: of a region, and of a shape that has no surface of flat faces.
constexpr int kLines = 64, kShapeLines = 48;

}  // namespace

LoadedSpace::LoadedSpace(const Scene& given) : Loaded(given) {
  if (!scene().moving().empty()) scene().world();  // builds its shapes
}

std::string LoadedSpace::drawing_of(const std::string& name) const {
  return SpaceDrawing{scene().shapes().at(name).drawn_surface(kShapeLines), {}}.json();
}

const SpaceWindow& LoadedSpace::window() const {
  if (!window_) {
    SpaceWindow all;
    for (const auto& [name, shape] : scene().shapes()) all.include(shape.drawn_surface(0));
    window_ = all.wider();
  }
  return *window_;
}

std::string LoadedSpace::map_json(const RegionQuery& query) const {
  require_moving();
  if (query.angle) refuse("an angle in space");
  const bool drawn = query.drawing || query.brief;
  MapQuestion question;
  question.apply = query.apply;
  question.before = "--";
  question.surface = true;
  question.listed = false;
  question.resolution = query.resolution > 0 ? query.resolution : kLines;
  const Answer map = (query.where ? asking(asked(), *query.where) : asked()).map(question);
  std::string out = map.json();
  if (!drawn) return out;
  SpaceDrawing drawing;
  if (is_free(Scene::Free::Kind::kLine))
    drawing = drawing_of_line(map.intervals(), scene().free(), window());
  else if (const auto region = map.space_region())
    drawing = app::drawing_of(*region, window());
  else if (auto surface = map.surface())
    drawing.solid = *std::move(surface);
  return with_member(std::move(out), "drawing", drawing.json());
}

std::string LoadedSpace::check_json(const Spot& spot, const CheckQuestion& question) const {
  require_moving();
  if (spot.angle || spot.time) refuse("an angle or an instant in space");
  return asked().check({spot.at, {}, {}}, question).json();
}

std::string LoadedSpace::nearest_json(const Spot& spot) const {
  require_moving();
  return asked().nearest({spot.at, {}, {}}).json();
}

std::string LoadedSpace::measure_json(const Spot& spot) const {
  require_moving();
  return asked().measure({spot.at, {}, {}}).json();
}

std::string LoadedSpace::angles_json(const Spot&) const { refuse("a map of angles in space"); }
std::string LoadedSpace::instants_json(const Spot&) const { refuse("a motion in space"); }
std::string LoadedSpace::between_json(const Spot&, const Point&, const Point&) const {
  refuse("the distance between features in space");
}

}  // namespace findspace::app
