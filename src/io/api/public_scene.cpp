// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/api/public_scene.h"

#include <findspace/error.h>
#include <findspace/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <set>

#include "api/query/world_data.h"
#include "api/values/limits.h"
#include "formula/planar/solve_rotation.h"
#include "io/api/changed_scene.h"
#include "io/api/edited_scene.h"
#include "io/question/answer_data.h"
#include "io/question/asked_scene.h"
#include "io/question/map_answer.h"
#include "io/question/placement_answer.h"
#include "io/question/position_answer.h"
#include "io/question/ray_map.h"
#include "io/question/shape_answer.h"
#include "io/question/space_map.h"
#include "io/question/space_shapes.h"
#include "io/team/row_team.h"
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
  data.options.work_limit = scene.work_limit;
  return data;
}

}  // namespace

World public_world(const Scene& scene, std::shared_ptr<const formula::Solver> built) {
  auto data = std::make_shared<World::Data>(data_of(scene));
  data->planar = std::move(built);
  return World(std::move(data));
}

World public_solid_world(const Scene& scene, std::shared_ptr<const formula::SpaceSolver> built) {
  auto data = std::make_shared<World::Data>(data_of(scene));
  data->solid = std::move(built);
  return World(std::move(data));
}

World public_world(const Scene& scene) {
  auto data = std::make_shared<World::Data>(data_of(scene));
  api::make_solver(*data);
  return World(std::move(data));
}

}  // namespace io

namespace {

Number grid_number(const io::Scene& scene, std::int64_t steps) {
  return io::number(exact::Real(steps) * scene.grid.step());
}

std::vector<Number> grid_numbers(const io::Scene& scene, const io::GridPosition& p) {
  std::vector<Number> out;
  for (int k = 0; k < scene.dimension; ++k) out.push_back(grid_number(scene, p[std::size_t(k)]));
  return out;
}

Scene::Free free_of(const io::Scene& scene) {
  using Kind = Scene::Free::Kind;
  static_assert(int(io::Free::Kind::kPose) == int(Kind::kPose));
  const io::Free& free = scene.free;
  Scene::Free out{Kind(free.kind)};
  if (out.kind == Kind::kLine) {
    out.through = grid_numbers(scene, free.through);
    for (int k = 0; k < scene.dimension; ++k) out.direction.emplace_back(free.direction[std::size_t(k)]);
  }
  if (out.kind == Kind::kAngle || out.kind == Kind::kPose) out.about = grid_numbers(scene, free.about);
  for (const exact::Real& angle : free.angles) out.angles.push_back(io::number(scene.seen(angle)));
  for (const io::Orientation& o : free.orientations)
    out.rotations.push_back(Rotation(std::make_shared<const Rotation::Data>(Rotation::Data{o.text, o.rotation, true})));
  return out;
}

}  // namespace

struct Scene::Data {
  /// Where it comes from, and how it is asked.
  struct Source {
    std::string text, folder;
    ReadOptions reading{};
    std::vector<Change> changes{};
    Options options{};
    Listener listener{};
    std::optional<exact::Real> turned{};
    std::shared_ptr<const io::KeptWork> kept{};  // where it was prepared
    std::optional<Board> board{};
    BoardQuestion question{};  // of the board
  };

  io::Scene read;
  Source source;
  Formula where;
  Free free;

  Data(io::Scene scene, Source from)
      : read(std::move(scene)),
        source(std::move(from)),
        where(read.where.empty() ? Formula("true") : Formula(read.where.text)),
        free(free_of(read)) {}

  const std::map<std::string, Shape>& shapes() const {
    if (source.kept) return source.kept->shapes->shown.get([&] { return io::shapes_of(read); });
    std::call_once(shown_, [&] { shapes_ = io::shapes_of(read); });
    return shapes_;
  }
  const World& world() const {
    std::call_once(made_, [&] {
      if (read.moving.empty())
        throw Error(ErrorCode::kBadValue, "the scene does not say which shape is \"moving\"", read.file);
      if (!source.kept)
        world_.emplace(io::public_world(read));
      else if (read.dimension == 3)
        world_.emplace(io::public_solid_world(read, io::space_solver(heard_by(source.listener))));
      else
        world_.emplace(io::public_world(read, heard_by(source.listener).solver()));
    });
    return *world_;
  }
  io::AskedScene heard_by(Listener listener, std::optional<exact::Real> time = {}) const {
    // Who owns the data is known to the caller.
    return {std::shared_ptr<const io::Scene>(std::shared_ptr<const void>(), &read),
            {std::move(listener), std::move(time), source.turned, source.kept}};
  }
  /// As many numbers as the scene has dimensions, within the grid's reach.
  std::vector<exact::Real> position(const Pose& pose) const {
    if (pose.at.empty()) return std::vector<exact::Real>(std::size_t(read.dimension));
    if (pose.at.size() != std::size_t(read.dimension))
      throw Error(ErrorCode::kBadValue, fmt::format("a position of this scene has {} numbers", read.dimension),
                  read.file);
    std::vector<exact::Real> out;
    for (const Number& c : pose.at) {
      out.push_back(api::real_of(c));
      read.grid.steps(out.back());  // refuses what is out of reach
    }
    return out;
  }
  std::optional<exact::Real> instant(const Pose& pose) const {
    if (!pose.time) return std::nullopt;
    if (!read.motion.given()) throw Error(ErrorCode::kBadValue, "the scene has no \"motion\"", read.file);
    exact::Real time = api::real_of(*pose.time);
    if (time < read.motion.start || read.motion.end < time)
      throw Error(ErrorCode::kBadValue, "that instant lies outside the motion", read.file);
    return time;
  }

 private:
  mutable std::once_flag made_{}, shown_{};
  mutable std::optional<World> world_{};
  mutable std::map<std::string, Shape> shapes_{};
};

namespace {

/// What ask(scene) says, under the limits, and heard. The data are let go of before.
template <class Ask>
Answer asked(std::shared_ptr<const Scene::Data> data, std::optional<exact::Real> time, const Ask& ask) {
  struct Heard {
    std::mutex guard{};
    std::vector<std::string> notes{};
  };
  const auto heard = std::make_shared<Heard>();
  Options options = data->source.options;
  if (options.work_limit == 0) options.work_limit = data->read.work_limit;
  Scene::Listener listener = data->source.listener;
  listener.note = [heard, told = listener.note](const std::string& text) {
    const std::lock_guard held(heard->guard);
    heard->notes.push_back(text);
    if (told) told(text);
  };
  io::AskedScene scene(std::shared_ptr<const io::Scene>(data, &data->read),
                       {std::move(listener), std::move(time), data->source.turned, data->source.kept});
  data.reset();
  return api::limited(options, [&] {
    auto out = std::make_shared<Answer::Data>(ask(std::move(scene)));
    const std::lock_guard held(heard->guard);
    out->notes = heard->notes;
    return Answer(std::move(out));
  });
}

/// What in_plane(scene, pose) or in_space(scene, position) says.
template <class InPlane, class InSpace>
Answer at_pose(std::shared_ptr<const Scene::Data> data, const Pose& pose, const InPlane& in_plane,
               const InSpace& in_space) {
  const bool solid = data->read.dimension == 3;
  const std::vector<exact::Real> at = data->position(pose);
  const std::optional<exact::Real> instant = data->instant(pose);
  if (solid && pose.degrees)
    throw Error(ErrorCode::kUnsupported, "in space an orientation says how a shape is turned", data->read.file);
  return asked(std::move(data), instant, [&](io::AskedScene scene) {
    if (solid) return in_space(std::move(scene), space::RealVector{at[0], at[1], at[2]});
    io::PlanarPose where_it_is{{at[0], at[1]}};
    if (pose.degrees) where_it_is.degrees = api::real_of(*pose.degrees);
    return in_plane(std::move(scene), where_it_is);
  });
}

/// Positions, exactly where they have such a form and no lines are asked for.
Answer::Data in_space(const io::AskedScene& scene, const MapQuestion& question) {
  const io::Applied apply{question.apply, question.before};
  if (question.lines)
    return io::map_on_lines(scene, io::ray_choice(scene, *question.lines, question.before, question.listed), apply);
  if (auto found = io::map_of_space(scene, apply, question.surface, io::public_solid_world)) return *std::move(found);
  const io::RayChoice usual = io::usual_lines(scene, "map", question.before, question.listed, question.resolution);
  return io::map_on_lines(scene, usual, apply);
}

Answer check_of(std::shared_ptr<const Scene::Data> data, const Pose& pose, const CheckQuestion& question) {
  if (data->read.free.kind == io::Free::Kind::kTime && !pose.time)
    throw Error(ErrorCode::kBadValue, "where \"free\" is \"time\" a check wants an instant", data->read.file);
  io::CheckWishes wishes{question.nearest};
  if (question.snap) wishes.snap = api::real_of(*question.snap);
  if (wishes.snap.sign() < 0) throw Error(ErrorCode::kBadValue, "snap is a distance, not below 0", data->read.file);
  return at_pose(
      std::move(data), pose,
      [&](io::AskedScene scene, const io::PlanarPose& at) { return io::check_in_plane(std::move(scene), at, wishes); },
      [&](io::AskedScene scene, const space::RealVector& at) {
        return io::check_in_space(std::move(scene), at, wishes);
      });
}

Answer map_of(std::shared_ptr<const Scene::Data> data, const MapQuestion& question) {
  using Kind = Scene::Free::Kind;
  io::begin_question();
  const Kind free = data->free.kind;
  const bool solid = data->read.dimension == 3;
  if (free != Kind::kPosition && !question.apply.empty())
    throw Error(ErrorCode::kBadValue, question.before + "apply is for maps of all positions", data->read.file);
  if (question.lines && (!solid || free == Kind::kLine))
    throw Error(ErrorCode::kBadValue, "lines are for maps of positions in space", data->read.file);
  const std::vector<exact::Real> p = data->position(question.pose);
  const exact::RealPoint at{p[0], p[1]};
  return asked(std::move(data), std::nullopt, [&](io::AskedScene scene) {
    if (solid && free == Kind::kLine) return io::map_of_space_line(std::move(scene));
    if (solid) return in_space(scene, question);
    if (free == Kind::kPose) return io::map_of_poses(std::move(scene));
    if (free == Kind::kAngle) return io::map_of_angles(std::move(scene), at);
    if (free != Kind::kTime)
      return io::map_of_positions(std::move(scene), {question.apply, question.before}, question.pictures);
    std::vector<std::string> numbers;
    for (const Number& n : question.pose.at) numbers.push_back(n.text());
    return io::map_of_instants(std::move(scene), at,
                               numbers.empty() ? "0,0" : fmt::format("{}", fmt::join(numbers, ",")));
  });
}

std::vector<io::Placement::Near> near_of(const PlaceQuestion& question) {
  std::vector<io::Placement::Near> out;
  for (const PlaceQuestion::Near& near : question.near) {
    io::Placement::Near& one = out.emplace_back(io::Placement::Near{near.name, near.copy, {}, {}});
    for (const Number& c : near.at) one.at.push_back(api::real_of(c));
    if (near.degrees) one.degrees = api::real_of(*near.degrees);
  }
  return out;
}

Explanation explained(const io::AskedScene& scene, const Pose& pose) {
  const std::vector<Number>& at = pose.at;
  const io::Free::Kind free = scene.scene().free.kind;
  if (free == io::Free::Kind::kTime && pose.degrees)
    throw Error(ErrorCode::kUnsupported, "an explanation over time at an angle is not computed", scene.scene().file);
  if (free == io::Free::Kind::kTime || (!pose.degrees && free == io::Free::Kind::kAngle)) {
    exact::RealPoint place;
    if (!at.empty()) place = {api::real_of(at[0]), api::real_of(at[1])};
    return free == io::Free::Kind::kTime ? io::explain_instants(scene, place) : io::explain_angles(scene, place);
  }
  if (!scene.in_space() && (pose.degrees || free == io::Free::Kind::kPose)) {
    std::optional<exact::Real> degrees;
    std::optional<exact::RealPoint> p;
    if (pose.degrees) degrees = api::real_of(*pose.degrees);
    if (!at.empty()) p = exact::RealPoint{api::real_of(at[0]), api::real_of(at[1])};
    return io::explain_poses(scene, degrees, p);
  }
  if (scene.in_space())
    scene.require_positions_in_space(false, true);
  else
    scene.require_positions(false);
  scene.where();  // says where a mistake is
  const Formula where = scene.scene().where.empty() ? Formula("true") : Formula(scene.scene().where.text);
  const World world = scene.in_space() ? io::public_solid_world(scene.scene(), io::space_solver(scene))
                                       : io::public_world(scene.scene(), scene.solver());
  scene.stage("explaining");
  if (at.empty()) return world.explain(where);
  return at.size() == 3 ? world.explain(where, Point3{at[0], at[1], at[2]}) : world.explain(where, Point{at[0], at[1]});
}

}  // namespace

namespace io {

findspace::Scene public_scene(Scene scene, const findspace::Board& board, const findspace::BoardQuestion& question) {
  findspace::Scene::Data::Source source;
  source.text = board.source();
  source.board = board;
  source.question = question;
  return findspace::Scene(std::make_shared<const findspace::Scene::Data>(std::move(scene), std::move(source)));
}

}  // namespace io

Scene Scene::file(const std::string& path, const ReadOptions& reading) {
  std::string text = io::read_text(path, reading.input_limit);  // refuses what is no path
  return json(text, std::filesystem::absolute(path).parent_path().string(), reading, path);
}

Scene Scene::json(std::string_view text, const std::string& folder, const ReadOptions& reading,
                  const std::string& name) {
  return Scene(std::make_shared<const Data>(io::read_scene_text(text, folder, name, reading),
                                            Data::Source{std::string(text), folder, reading}));
}

const std::map<std::string, Shape>& Scene::shapes() const { return data_->shapes(); }
Shape Scene::shape(std::string_view name) const { return shapes().at(data_->read.shape(name)->name); }
std::vector<std::string> Scene::names() const {
  std::vector<std::string> out;
  for (const plane::ShapePtr& s : data_->read.shapes) out.push_back(s->name);
  return out;
}
const std::map<std::string, std::vector<std::string>>& Scene::groups() const { return data_->read.groups; }
int Scene::dimension() const { return data_->read.dimension; }
std::string Scene::unit() const {
  return data_->read.unit ? std::string(formula::name(*data_->read.unit)) : std::string();
}
const std::vector<std::string>& Scene::moving() const { return data_->read.moving; }
bool Scene::asks() const { return !data_->read.where.empty(); }
std::vector<std::string> Scene::used() const {
  const std::set<std::string> names = data_->heard_by(data_->source.listener).where().shapes();
  return {names.begin(), names.end()};
}
Grid Scene::grid() const { return {io::number(data_->read.grid.step())}; }
bool Scene::y_down() const { return data_->read.y_down; }
bool Scene::clockwise() const { return data_->read.y_down != data_->read.mirrors_angles(); }
const World& Scene::world() const { return data_->world(); }
const Formula& Scene::where() const { return data_->where; }
const std::string& Scene::minimize() const { return data_->read.minimize.text; }
const std::string& Scene::maximize() const { return data_->read.maximize.text; }
const Scene::Free& Scene::free() const { return data_->free; }
std::optional<Motion> Scene::motion() const {
  return data_->read.motion.given() ? std::optional(io::public_motion(data_->read)) : std::nullopt;
}
const std::string& Scene::text() const { return data_->source.text; }
const std::string& Scene::folder() const { return data_->source.folder; }
const std::string& Scene::name() const { return data_->read.file; }
std::optional<Board> Scene::board() const { return data_->source.board; }
std::optional<BoardQuestion> Scene::board_question() const {
  return data_->source.board ? std::optional(data_->source.question) : std::nullopt;
}
const ReadOptions& Scene::reading() const { return data_->source.reading; }
const std::vector<std::string>& Scene::notes() const { return data_->read.notes; }
const std::vector<Scene::Change>& Scene::changes() const { return data_->source.changes; }

Scene Scene::asking(const Question& question) const {
  Data::Source source = data_->source;
  source.changes.push_back({question, {}, {}});
  io::Scene scene = io::asking_scene(data_->read, question);
  if (source.kept) {
    auto kept = std::make_shared<io::KeptWork>();
    const bool same =
        !question.moving && (!scene.named_only || !(question.where || question.minimize || question.maximize));
    if (same) kept->shapes = source.kept->shapes;
    source.kept = std::move(kept);
  }
  return Scene(std::make_shared<const Data>(std::move(scene), std::move(source)));
}

Scene Scene::rotated(const Rotation& rotation) const {
  Data::Source source = data_->source;
  source.changes.push_back({{}, rotation, {}});
  if (source.kept) source.kept = std::make_shared<const io::KeptWork>();
  return Scene(std::make_shared<const Data>(io::rotated_scene(data_->read, rotation.data()), std::move(source)));
}

Scene Scene::rotated(const Number& degrees) const {
  Data::Source source = data_->source;
  source.changes.push_back({{}, {}, degrees});
  const exact::Real asked_for = api::real_of(degrees), by = data_->read.seen(asked_for);
  source.turned = source.turned ? *source.turned + asked_for : asked_for;
  io::Scene scene = io::turned_scene(data_->read, by);
  if (source.kept) {
    auto kept = std::make_shared<io::KeptWork>();
    if (by.sign() == 0) {
      kept->shapes = source.kept->shapes;
    } else {
      auto shapes = std::make_shared<io::KeptShapes>();
      shapes->world = [before = data_, by](const io::AskedScene& asked) {
        const io::GridPosition& about = before->read.free.about;
        plane::Rounding rounding;
        formula::World out = formula::rotated_world(before->heard_by(asked.listener()).solver()->world(),
                                                    {exact::Real(about[0]), exact::Real(about[1])}, by, rounding);
        asked.note_rotated(rounding);
        return out;
      };
      kept->shapes = std::move(shapes);
    }
    source.kept = std::move(kept);
  }
  return Scene(std::make_shared<const Data>(std::move(scene), std::move(source)));
}

Scene Scene::prepared() const {
  if (data_->source.kept) return *this;
  Data::Source source = data_->source;
  source.kept = std::make_shared<const io::KeptWork>();
  return Scene(std::make_shared<const Data>(data_->read, std::move(source)));
}

bool Scene::is_prepared() const { return data_->source.kept != nullptr; }

std::string Scene::edited_text() const {
  std::string out = text();
  if (out.empty() || data_->source.board)
    throw Error(ErrorCode::kBadValue, "this scene has no text of its own", name());
  Question last;  // of each word what was said last
  for (const Change& change : changes()) {
    if (!change.question || change.question->free)
      throw Error(ErrorCode::kUnsupported, "the text of a scene does not say that it is rotated or over what it ranges",
                  name());
    const Question& question = *change.question;
    if (question.where) last.where = question.where;
    if (question.moving) last.moving = question.moving;
    if (!question.minimize && !question.maximize) continue;
    last.minimize = question.minimize.value_or("");
    last.maximize = question.maximize.value_or("");
  }
  const auto put = [&](const char* key, const std::optional<std::string>& value) {
    if (value) out = io::edited_scene(out, key, value->empty() ? std::vector<std::string>() : std::vector{*value});
  };
  put("where", last.where);
  put("minimize", last.minimize);
  put("maximize", last.maximize);
  if (last.moving) out = io::edited_scene(out, "moving", *last.moving);
  return out;
}

Scene Scene::with(const Options& options) const {
  Data::Source source = data_->source;
  source.options = options;
  return Scene(std::make_shared<const Data>(data_->read, std::move(source)));
}

const Options& Scene::options() const { return data_->source.options; }

Scene Scene::with(const Listener& listener) const {
  Data::Source source = data_->source;
  source.listener = listener;
  return Scene(std::make_shared<const Data>(data_->read, std::move(source)));
}

void Scene::require(const Pose& pose) const {
  data_->position(pose);
  data_->instant(pose);
  if (pose.degrees) api::real_of(*pose.degrees);
}

Answer Scene::check(const Pose& pose, const CheckQuestion& question) const& { return check_of(data_, pose, question); }
Answer Scene::check(const Pose& pose, const CheckQuestion& question) && {
  return check_of(std::move(data_), pose, question);
}

Answer Scene::nearest(const Pose& pose) const {
  if (pose.degrees) throw Error(ErrorCode::kUnsupported, "no degrees: the scene may be rotated by them", name());
  return at_pose(
      data_, pose,
      [](io::AskedScene scene, const io::PlanarPose& at) { return io::nearest_in_plane(std::move(scene), at.at); },
      [](io::AskedScene scene, const space::RealVector& at) { return io::nearest_in_space(std::move(scene), at); });
}

Answer Scene::between(const Point& first, const Point& second, const Pose& pose) const {
  if (pose.degrees) throw Error(ErrorCode::kUnsupported, "no degrees: the scene may be rotated by them", name());
  const auto place = [](const Point& p) { return exact::RealPoint{api::real_of(p.x), api::real_of(p.y)}; };
  return at_pose(
      data_, pose,
      [&](io::AskedScene scene, const io::PlanarPose& at) {
        return io::between_in_plane(std::move(scene), at.at, {place(first), place(second)});
      },
      [&](io::AskedScene, const space::RealVector&) -> Answer::Data {
        throw Error(ErrorCode::kUnsupported, "the distance between features in space is not computed", name());
      });
}

Answer Scene::measure(const Pose& pose, const std::vector<std::string>& words) const {
  const io::WantedDistances wanted = io::wanted_distances(words);
  return at_pose(
      data_, pose,
      [&](io::AskedScene scene, const io::PlanarPose& at) {
        return io::measure_in_plane(std::move(scene), at, wanted);
      },
      [&](io::AskedScene scene, const space::RealVector& at) {
        return io::measure_in_space(std::move(scene), at, wanted);
      });
}

Answer Scene::map(const MapQuestion& question) const& { return map_of(data_, question); }
Answer Scene::map(const MapQuestion& question) && { return map_of(std::move(data_), question); }

Answer Scene::describe(const std::string& shape, const ShapeQuestion& question) const {
  io::begin_question();
  if (question.lines && dimension() == 2) throw Error(ErrorCode::kBadValue, "lines are for shapes of space", name());
  const Shape made = this->shape(shape);
  return asked(data_, std::nullopt, [&](io::AskedScene scene) {
    return scene.in_space() ? io::described_in_space(std::move(scene), shape, question)
                            : io::described_in_plane(scene, shape, made);
  });
}

bool Scene::places() const { return data_->read.place.given(); }

Answer Scene::place(const PlaceQuestion& question) const {
  const planning::Limit limit(data_->source.options.seconds);
  Options others = data_->source.options;
  others.seconds = 0;  // what was found by then is given
  return asked(with(others).data_, std::nullopt, [&](io::AskedScene scene) {
    scene.want(near_of(question));
    const io::PlacementQuestion wanted{limit, question.lines, data_->source.text};
    return scene.in_space() ? io::place_in_space(std::move(scene), wanted)
                            : io::place_in_plane(std::move(scene), wanted);
  });
}

Answer Scene::explain(const Pose& pose) const {
  data_->position(pose);  // refuses what is none
  if (pose.time || (pose.degrees && dimension() == 3))
    throw Error(ErrorCode::kUnsupported, "an explanation has no instant, and in space no degrees", name());
  return asked(data_, std::nullopt, [&](const io::AskedScene& scene) {
    Answer::Data out;
    out.explanation = explained(scene, pose);
    const Explanation& found = *out.explanation;
    out.found = (found.here ? found.here->holds : found.feasible) ? Answer::Found::kYes : Answer::Found::kNo;
    out.text = [text = found.text](const Telling&) { return text; };
    out.json = [text = found.json](const Telling&) { return text; };
    return out;
  });
}

}  // namespace findspace
