// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Phi-functions of the public header as text: JSON, tables, pictures and surfaces.

#include <findspace/error.h>
#include <findspace/phi.h>
#include <fmt/format.h>

#include <functional>
#include <map>

#include "api/query/phi_data.h"
#include "io/write/write_json.h"
#include "io/write/write_phi.h"
#include "io/write/write_planar_phi.h"
#include "io/write/write_svg.h"
#include "plane/build/build.h"
#include "plane/query/summary.h"

namespace findspace {
namespace {

using exact::Real;
using exact::RealPoint;

using Writers = std::map<std::string, std::function<std::string()>, std::less<>>;

std::string title_of(const PhiQuestion& question) {
  return fmt::format("Phi-function of {} and {}", question.a, question.b);
}

/// Where B is; nothing where that is not asked.
std::optional<std::vector<Real>> place_of(const PhiQuestion& question, std::size_t dimension) {
  if (question.at.empty()) {
    if (question.least || question.greatest)
      throw Error(ErrorCode::kBadValue, "a least and a greatest distance are looked at where a position is given");
    return std::nullopt;
  }
  if (question.at.size() != dimension)
    throw Error(ErrorCode::kBadValue, fmt::format("a position of these shapes has {} coordinates", dimension));
  std::vector<Real> place;
  for (const Number& c : question.at) place.push_back(api::real_of(c));
  return place;
}

/// `sign(rho)` is that of Phi - rho with Phi normalised, `normalised` its value.
std::vector<io::PhiLimit> limits_of(const PhiQuestion& question, double normalised,
                                    const std::function<int(const Real&)>& sign) {
  std::vector<io::PhiLimit> limits;
  const auto add = [&](const Number& distance, bool least) {
    const Real rho = api::real_of(distance);
    if (rho.sign() < 0) throw Error(ErrorCode::kBadValue, "a distance is not negative");
    const double off = normalised - rho.to_double();
    limits.push_back({least, rho, least ? off : -off, least ? sign(rho) : -sign(rho)});
  };
  if (question.least) add(*question.least, true);
  if (question.greatest) add(*question.greatest, false);
  return limits;
}

// ---- of the plane

/// What is said of two shapes of the plane; what costs is made when it is asked for.
class PlanarText {
 public:
  PlanarText(const Phi::Data& data, const PhiQuestion& question) : data_(data), question_(question) {
    const auto at = place_of(question, 2);
    if (at) at_ = RealPoint{(*at)[0], (*at)[1]};
  }

  Writers writers() const {
    const Writers::mapped_type svg = [this] { return picture(); };
    if (data_.plane().parts() != nullptr)
      return {{".json", [this] { return io::planar_phi_json(report()); }},
              {".txt", [this] { return io::planar_phi_table(report()); }},
              {".svg", svg}};
    return {{".json", [this] { return curve_json(); }}, {".txt", [this] { return curve_table(); }}, {".svg", svg}};
  }

 private:
  // ---- by convex parts
  io::PlanarPhiReport report() const {
    const distance::PhiParts& parts = *data_.plane().parts();
    io::PlanarPhiReport report;
    report.first = question_.a;
    report.second = question_.b;
    report.phi = &parts.phi;
    report.parts_second = static_cast<int>(parts.b);
    report.step = parts.unit;
    if (!at_) return report;
    report.at = at_;
    const RealPoint u{at_->x / report.step, at_->y / report.step};
    report.value = parts.phi.at(u);
    report.limits = limits_of(question_, report.value->at.normalised * report.step.to_double(),
                              [&](const Real& rho) { return parts.phi.compare_distance(u, rho / report.step); });
    return report;
  }

  // ---- by curves
  struct CurveValue {
    space::PlanarAt phi;
    std::vector<io::PhiLimit> limits;
  };
  CurveValue value() const {
    const distance::ShapePhi& phi = data_.plane();
    CurveValue value{phi.at(*at_).at, {}};
    value.limits =
        limits_of(question_, value.phi.normalised, [&](const Real& rho) { return phi.compare_distance(*at_, rho); });
    return value;
  }

  std::string curve_json() const {
    const plane::Region overlap = data_.plane().curves()->overlap();
    std::string out = fmt::format("{{\"dimension\":2,\"form\":\"curves\",\"overlap\":{}",
                                  io::region_json(overlap, plane::summarize(overlap, step()), step(), question_.unit));
    if (!at_) return out + "}\n";
    const CurveValue found = value();
    const space::PlanarAt& phi = found.phi;
    out += fmt::format(
        ",\n\"at\":{{\"position\":[{},{}],\"phi\":{},\"normalised\":{},\"distance\":{},\"state\":\"{}\",\"gradient\":",
        at_->x.text(), at_->y.text(), phi.phi, phi.normalised, phi.distance, io::state_name(phi.state));
    const bool defined = phi.gradient.x != 0 || phi.gradient.y != 0;  // not on the curve itself
    out += defined ? fmt::format("[{},{}]", phi.gradient.x, phi.gradient.y) : "null";
    return out + io::limits_json(found.limits) + "}}\n";
  }

  std::string curve_table() const {
    const plane::Region overlap = data_.plane().curves()->overlap();
    const plane::Summary summary = plane::summarize(overlap, step());
    std::string out = fmt::format("{}: the boundary of a region of positions with area {} and {} components\n",
                                  title_of(question_), summary.area.value_or(0), summary.components.size());
    if (!at_) return out;
    const CurveValue found = value();
    out += fmt::format("\nat ({}, {}): {}, Phi = {}\n", at_->x.text(), at_->y.text(), io::state_name(found.phi.state),
                       found.phi.phi);
    return out + io::limits_table(found.limits);
  }

  /// With outlines as they are put together, as in every picture.
  plane::Region outline(const Shape& shape) const {
    return plane::build(*api::tree_on(shape, grid_), grid_.step_size(), shape.data().work).region;
  }

  std::string picture() const {
    const distance::PhiCurves curves(outline(data_.first), outline(data_.second));
    const plane::Region overlap = curves.overlap();
    const plane::Summary summary = plane::summarize(overlap, step());
    io::Picture picture;
    picture.title = title_of(question_);
    picture.subtitle = fmt::format("positions of {} where the two overlap; gamma12 is the boundary", question_.b);
    picture.step = step();
    picture.unit = question_.unit;
    picture.region = &overlap;
    picture.summary = &summary;
    picture.fixed = {{question_.a, &*curves.a()}};
    picture.moving = {{question_.b, &*curves.b()}};
    if (at_) picture.position = plane::Place{at_->x.to_double(), at_->y.to_double()};
    return io::picture_svg(picture);
  }

  const Real& step() const { return grid_.step(); }

  const Phi::Data& data_;
  const PhiQuestion& question_;
  plane::Grid grid_ = api::common_grid(data_.first.data().grid, data_.second.data().grid);
  std::optional<RealPoint> at_;
};

// ---- of space

io::PhiReport solid_report(const Phi::Data& data, const PhiQuestion& question) {
  const space::RoundedPhi& phi = data.space();
  io::PhiReport report;
  report.first = question.a;
  report.second = question.b;
  report.phi = &phi;
  report.parts_second = static_cast<int>(data.b);
  report.step = data.step;
  const auto at = place_of(question, 3);
  if (!at) return report;
  space::RealVector u;
  for (std::size_t k = 0; k < 3; ++k) {
    report.at[k] = (*at)[k];
    u[k] = (*at)[k] / report.step;
  }
  report.value = phi.at(u);
  report.limits = limits_of(question, report.value->at.normalised * report.step.to_double(),
                            [&](const Real& rho) { return phi.compare_distance(u, rho / report.step); });
  return report;
}

Writers solid_writers(const io::PhiReport& report, const std::string& title) {
  Writers out{{".json", [&] { return io::phi_json(report); }}, {".txt", [&] { return io::phi_table(report); }}};
  for (const char* ending : {".obj", ".off", ".stl", ".svg"})
    out.emplace(ending, [&, ending] { return io::surface_text(io::phi_surface(report), title, ending, ""); });
  return out;
}

std::string written(const Writers& writers, std::string_view ending) {
  const auto writer = writers.find(ending);
  if (writer == writers.end())
    throw Error(ErrorCode::kUnsupported, fmt::format("a Phi-function is not written as '{}'", ending));
  return writer->second();
}

}  // namespace

std::string Phi::text(std::string_view ending, const PhiQuestion& question) const {
  if (dimension() == 2) return written(PlanarText(*data_, question).writers(), ending);
  const io::PhiReport report = solid_report(*data_, question);
  return written(solid_writers(report, title_of(question)), ending);
}

}  // namespace findspace
