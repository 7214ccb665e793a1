// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/api/public_scene.h"

#include <findspace/error.h>
#include <findspace/scene.h>
#include <fmt/format.h>

#include <filesystem>
#include <mutex>

#include "api/query/world_data.h"
#include "io/text/read_text.h"
#include "packing/problem/fraction.h"

namespace findspace {
namespace io {
namespace {

Number number(const exact::Real& value) {
  const auto fraction = value.fraction();  // what scenes state is rational
  return packing::Fraction((*fraction)[0], (*fraction)[1]).text();
}

findspace::Motion public_motion(const Scene& scene) {
  findspace::Motion out{number(scene.motion.start), number(scene.motion.end), {}};
  for (const Movement& m : scene.motion.movements)
    for (std::size_t k = 0; k < m.path.size(); ++k) {
      const auto coordinate = [&](int i) { return number(exact::Real(m.path[k][std::size_t(i)]) * scene.grid.step()); };
      out.paths[m.shape].push_back({number(m.times[k]), {coordinate(0), coordinate(1)}, number(m.angles[k])});
    }
  return out;
}

Shape shape_of(const Scene& scene, const plane::ShapePtr& shape) {
  return api::make_shape(shape, scene.grid, scene.dimension, {}, scene.work_limit,
                         scene.unit ? std::string(formula::name(*scene.unit)) : "");
}

std::map<std::string, Shape> shapes_of(const Scene& scene) {
  std::map<std::string, Shape> out;
  for (const plane::ShapePtr& s : scene.shapes) out.emplace(s->name, shape_of(scene, s));
  return out;
}

World::Data data_of(const Scene& scene) {
  World::Data data{shapes_of(scene), scene.grid, context_of(scene)};
  if (scene.motion.given()) data.motion = public_motion(scene);
  return data;
}

}  // namespace

formula::Motion motion_of(const Scene& scene) {
  formula::Motion out{scene.motion.start, scene.motion.end, {}};
  for (const Movement& m : scene.motion.movements) {
    formula::Trajectory t{m.times, {}, m.angles};
    for (const GridPosition& p : m.path) t.path.push_back({exact::Real(p[0]), exact::Real(p[1])});
    out.of.emplace(m.shape, std::move(t));
  }
  return out;
}

Shape public_shape(const Scene& scene, std::string_view name) { return shape_of(scene, scene.shape(name)); }

World public_world(const Scene& scene, formula::World built) {
  auto data = std::make_shared<World::Data>(data_of(scene));
  data->planar = std::make_shared<const formula::Solver>(std::move(built));
  return World(std::move(data));
}

World public_world(const Scene& scene) {
  auto data = std::make_shared<World::Data>(data_of(scene));
  api::make_solver(*data);
  return World(std::move(data));
}

}  // namespace io

struct Scene::Data {
  io::Scene read;
  std::string text, folder;
  ReadOptions reading;
  std::map<std::string, Shape> shapes;
  Formula where;

  Data(std::string from, std::string beside, const std::string& name, const ReadOptions& how)
      : read(io::read_scene_text(from, beside, name, how)),
        text(std::move(from)),
        folder(std::move(beside)),
        reading(how),
        shapes(io::shapes_of(read)),
        where(read.where.empty() ? Formula("true") : Formula(read.where.text)) {}

  const World& world() const {
    std::call_once(made_, [&] {
      if (read.moving.empty())
        throw Error(ErrorCode::kBadValue, "the scene does not say which shape is \"moving\"", read.file);
      world_.emplace(io::public_world(read));
    });
    return *world_;
  }

 private:
  mutable std::once_flag made_{};
  mutable std::optional<World> world_{};
};

Scene Scene::file(const std::string& path, const ReadOptions& reading) {
  std::string text = io::read_text(path, reading.input_limit);  // refuses what is no path
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  return Scene(std::make_shared<const Data>(std::move(text), folder.string(), path, reading));
}

Scene Scene::json(std::string_view text, const std::string& folder, const ReadOptions& reading) {
  return Scene(std::make_shared<const Data>(std::string(text), folder, "scene", reading));
}

const std::map<std::string, Shape>& Scene::shapes() const { return data_->shapes; }
const World& Scene::world() const { return data_->world(); }
const Formula& Scene::where() const { return data_->where; }
const std::string& Scene::minimize() const { return data_->read.minimize.text; }
const std::string& Scene::maximize() const { return data_->read.maximize.text; }
const std::string& Scene::text() const { return data_->text; }
const std::string& Scene::folder() const { return data_->folder; }
const ReadOptions& Scene::reading() const { return data_->reading; }
const std::vector<std::string>& Scene::notes() const { return data_->read.notes; }

}  // namespace findspace
