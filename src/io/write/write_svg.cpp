// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "findspace/error.h"
#include "io/draw/draw_labels.h"
#include "io/draw/draw_layout.h"
#include "io/draw/draw_legend.h"
#include "io/draw/draw_region.h"
#include "io/draw/face_rings.h"
#include "io/text/put.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace {

using plane::Bounds;
using plane::Place;

constexpr double kLeft = 64, kRight = 28, kTop = 16, kBelowMap = 34, kMargin = 0.05, kUnboundedMargin = 0.2;

Bounds moved(const Bounds& b, const Place& by) {
  return {{b.low[0] + by[0], b.low[1] + by[1]}, {b.high[0] + by[0], b.high[1] + by[1]}};
}

struct Drawn {
  std::string name;
  CurveNet net;
  bool behind;
  std::optional<Bounds> bounds;  // of curves and points

  Drawn(const NamedRegion& r, const exact::Real& step) : name(r.name), net(*r.region, step), behind(r.behind) {
    for (const Curve& k : net.curves()) include(bounds, net.bounds(k));
    for (plane::Index v : net.vertices()) include(bounds, {net.at(v), net.at(v)});
  }
};

class PictureWriter {
 public:
  explicit PictureWriter(const Picture& p) : p_(p), position_(p.position) {
    if (p.region != nullptr) region_.emplace(NamedRegion{"", p.region}, p.step);
    if (p.around != nullptr) around_.emplace(NamedRegion{"", p.around}, p.step);
    for (const NamedRegion& r : p.fixed) fixed_.emplace_back(r, p.step);
    for (const NamedRegion& r : p.moving) moving_.emplace_back(r, p.step);
    for (const NamedRegion& r : p.rotated) moving_.emplace_back(r, p.step);
    for (const NamedRegion& r : p.placed) placed_.emplace_back(r, p.step);
    const plane::Component* c = p.summary != nullptr ? largest(*p.summary) : nullptr;
    if (!position_ && p.of_positions) position_ = c != nullptr ? c->sample : p.home;
  }

  SvgDrawing run() {
    const Block title = title_block(p_.title, p_.subtitle, kLeft, kTop, kMapWidth);
    set_frame(kTop + title.height);
    const double width = std::max(frame_.width(), kMapWidth * 0.6), below = frame_.top + frame_.height() + kBelowMap;
    const Block bar = scale_bar(frame_, p_.unit, kLeft, below);
    const Block notes = legend(entries(), kLeft, below + bar.height, width);
    const double right = kLeft + std::max(width, title.svg.empty() ? 0 : title_width()) + kRight;
    const double bottom = below + bar.height + notes.height + 14;
    return {
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
                    "<title>{2}</title>\n{3}<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{4}{5}{6}{7}</svg>\n",
                    pixels(right), pixels(bottom), xml_escaped(p_.title), style_sheet(!p_.copper.empty()), title.svg,
                    map(), bar.svg, notes.svg),
        right, bottom};
  }

 private:
  double title_width() const {
    return std::min(kMapWidth, std::max(text_width(p_.title, 16), text_width(p_.subtitle)));
  }

  void set_frame(double top) {
    std::optional<Bounds> world;
    for (const Drawn& d : fixed_) {
      if (d.bounds) include(world, *d.bounds);
    }
    for (const Drawn& d : placed_) {
      if (d.bounds) include(world, *d.bounds);
    }
    if (region_ && region_->bounds) include(world, *region_->bounds);
    if (around_ && around_->bounds) include(world, *around_->bounds);
    if (position_) {
      if (!moving_.empty()) include(world, {*position_, *position_});
      for (const Drawn& d : moving_) {
        if (!d.bounds) continue;
        include(world, moved(*d.bounds, *position_));
        if (p_.nearest) include(world, moved(*d.bounds, *p_.nearest));
      }
    }
    for (const Arrow& a : p_.arrows) {
      if (a.kind != Arrow::Kind::kWay || (a.of_moving && !position_)) continue;
      const Place by = a.of_moving ? *position_ : Place{};
      for (const Place& p : a.points) include(world, moved({p, p}, by));
    }
    const bool unbounded = p_.summary != nullptr && !p_.summary->bounded;
    frame_ = fit(world.value_or(Bounds{{-1, -1}, {1, 1}}), unbounded ? kUnboundedMargin : kMargin, kLeft, top);
    frame_.y_down = p_.y_down;
  }

  std::string map() const {
    std::string out = fmt::format(
        "<clipPath id=\"frame{4}\"><rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\"/></clipPath>\n<g "
        "clip-path=\"url(#frame{4})\">\n",
        pixels(frame_.left), pixels(frame_.top), pixels(frame_.width()), pixels(frame_.height()), p_.panel);
    for (const CopperLayer& layer : p_.copper) out += filled(layer.regions, p_.step, frame_, layer.style);
    for (const Drawn& d : fixed_) out += outline(d.net, frame_, d.behind ? "behind" : "fixed");
    if (around_) out += outline(around_->net, frame_, "around");
    if (region_) out += region_faces(region_->net, frame_);
    if (position_) {
      for (const Drawn& d : moving_) out += outline(d.net, frame_, "moving", *position_);
      if (p_.nearest)
        for (const Drawn& d : moving_) out += outline(d.net, frame_, "nearest", *p_.nearest);
    }
    for (const Drawn& d : placed_) out += outline(d.net, frame_, p_.placed_style);
    if (region_) out += region_lines(region_->net, frame_);
    if (position_ && !moving_.empty()) {
      put(out, "<path class=\"pole\" d=\"M{} {}m-5 0h10m-5 -5v10\"/>\n", pixels(frame_.x((*position_)[0])),
          pixels(frame_.y((*position_)[1])));
    }
    out += arrows(p_.arrows, frame_, position_) + dimension_lines(p_.dimensions, frame_);
    return out + "</g>\n" + axes(frame_) + labels();
  }

  std::string labels() const {
    std::vector<LabelledShape> shapes;
    auto add = [&](const std::vector<Drawn>& drawn, const Place& offset) {
      for (const Drawn& d : drawn) {
        if (d.name.empty()) continue;
        shapes.push_back({d.name, &d.net, plane::summarize(d.net.complex(), p_.step), offset});
      }
    };
    add(fixed_, {});
    if (position_) add(moving_, *position_);
    add(placed_, {});
    Labeller labeller(frame_, p_.step, std::move(shapes), p_.small_names);
    if (position_ && !moving_.empty()) labeller.avoid(*position_, 7);
    const std::vector<Place> texts = text_places(p_.dimensions, frame_);
    for (std::size_t i = 0; i < texts.size(); ++i)
      labeller.avoid_text(texts[i], p_.dimensions[i].text, p_.dimensions[i].font);
    if (region_) labeller.avoid_region(region_->net);
    if (position_ && moving_.size() > 1 && !p_.small_names) {
      for (const Drawn& d : moving_) labeller.avoid_curves(d.net, *position_);
    }
    return labeller.labels();
  }

  std::string measure(double value, const char* power) const {
    return p_.unit.empty() ? shown(value) : fmt::format("{} {}{}", shown(value), p_.unit, power);
  }

  void add_region_entries(std::vector<LegendEntry>& out) const {
    using M = LegendEntry::Mark;
    const RegionParts parts = parts_of(*p_.region);
    const plane::Summary& s = *p_.summary;
    const std::string noun = p_.of_positions ? "positions" : "the shape";
    if (parts.faces) {
      out.push_back(
          {M::kFace, noun + (s.area ? ", area " + measure(*s.area, "²") : ", unbounded: they go on beyond the frame")});
    }
    if (parts.open_edges) {
      if (parts.closed_edges) out.push_back({M::kClosed, "edge that belongs"});
      out.push_back({M::kOpen, "edge that does not belong"});
    }
    if (parts.curves) out.push_back({M::kFree, "curve that belongs, length " + measure(s.dangling_length, "")});
    if (parts.points)
      out.push_back(
          {M::kPoint, s.isolated.size() == 1 ? "single point" : fmt::format("{} single points", s.isolated.size())});
    if (parts.full_dots) out.push_back({M::kFull, "point that belongs"});
    if (parts.hollow_dots) out.push_back({M::kHollow, "point that does not belong"});
  }

  std::vector<LegendEntry> entries() const {
    using M = LegendEntry::Mark;
    std::vector<LegendEntry> out;
    if (region_) add_region_entries(out);
    if (position_ && !moving_.empty()) {
      std::string names;
      for (const NamedRegion& r : p_.moving)
        if (!r.name.empty()) names += (names.empty() ? "" : ", ") + r.name;
      if (!p_.rotated.empty()) names += ", as drawn and rotated";
      out.push_back({M::kMoving, names});
      out.push_back({M::kPole, fmt::format("at p = ({}, {})", shown((*position_)[0]), shown((*position_)[1]))});
    }
    if (p_.nearest) out.push_back({M::kNearest, p_.nearest_text});
    for (LegendEntry& e : dimension_entries(p_.dimensions)) out.push_back(std::move(e));
    for (LegendEntry& e : arrow_entries(p_.arrows)) out.push_back(std::move(e));
    const auto pads = std::count_if(placed_.begin(), placed_.end(), [&](const Drawn& d) {
      return p_.small_names && d.name.find('.') != std::string::npos;
    });
    if (!placed_.empty())
      out.push_back({M::kMoving, fmt::format("{}: {}", p_.placed_text, std::ssize(placed_) - pads), p_.placed_style});
    if (around_) out.push_back({M::kAround, p_.around_text});
    for (const CopperLayer& layer : p_.copper)
      if (!layer.text.empty()) out.push_back({M::kCopper, layer.text, layer.style});
    if (!fixed_.empty()) out.push_back({M::kFixed, fixed_.size() == 1 ? "fixed shape" : "fixed shapes"});
    if (std::any_of(fixed_.begin(), fixed_.end(), [](const Drawn& d) { return d.behind; }))
      out.push_back({M::kBehind, "on the back"});
    return out;
  }

  const Picture& p_;
  std::optional<Place> position_;
  std::optional<Drawn> region_, around_;
  std::vector<Drawn> fixed_, moving_, placed_;
  Frame frame_;
};

}  // namespace

std::string picture_svg(const Picture& picture) { return picture_drawing(picture).svg; }

SvgDrawing picture_drawing(const Picture& picture) { return PictureWriter(picture).run(); }

namespace {

/// The bounds with some width and height, without which SVG shows nothing.
Bounds drawing_bounds(Bounds b) {
  const double size = std::max(b.high[0] - b.low[0], b.high[1] - b.low[1]);
  for (int i : {0, 1}) {
    if (b.high[i] - b.low[i] > 0) continue;  // no sign: the size of a page
    const double padding = size > 0 ? size / 20 : 1;
    b.low[i] -= padding;
    b.high[i] += padding;
  }
  return b;
}

}  // namespace

DrawingText shape_svg(const plane::Region& region, const exact::Real& step, std::string_view name,
                      std::optional<formula::Unit> unit) {
  if (!plane::is_bounded(region)) throw Error(ErrorCode::kUnsupported, "a drawing cannot hold an unbounded region");
  const NamedRegion named{std::string(name), &region};
  const Drawn shape(named, step);
  const Bounds b = drawing_bounds(shape.bounds.value_or(Bounds{}));
  const double width = b.high[0] - b.low[0], height = b.high[1] - b.low[1];
  const Frame frame{{{0, 0}, {0, 0}}, 1, 0, 0};  // only turns y down
  std::string paths;
  const auto add = [&](auto&& draw, std::string_view attributes) {
    PathWriter path(shape.net, frame, {}, PathWriter::Digits::kAll);
    draw(path);
    paths += fmt::format("<path{} d=\"{}\"/>\n", attributes, path.data());
  };
  const FaceRings rings(shape.net);
  const auto add_rings = [&](PathWriter& path, const plane::Face& f) {
    for (const CurveNet::Ring& ring : rings.of(f)) path.add_ring(ring);
  };
  for (const plane::Face& f : region.faces)
    if (f.mark != 0) add([&](PathWriter& path) { add_rings(path, f); }, "");
  for (const Curve& k : shape.net.curves())
    if (rings.is_free(k)) add([&](PathWriter& path) { path.add_curve(k); }, " fill=\"none\"");
  // SVG knows few units: the size is always in millimetres, where the scene has a unit at all.
  const double size = unit ? formula::factor(*unit, formula::Unit::kMillimetre).to_double() : 1;
  const char* size_unit = unit ? "mm" : "";
  DrawingText out;
  out.text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}{}\" height=\"{}{}\" viewBox=\"{} {} {} {}\">\n"
      "<g id=\"{}\" fill=\"#2a9d8f\" fill-opacity=\"0.38\" fill-rule=\"evenodd\" stroke=\"#14665c\" "
      "stroke-width=\"{}\">\n{}</g>\n</svg>\n",
      width * size, size_unit, height * size, size_unit, b.low[0], -b.high[1], width, height, xml_escaped(name),
      std::max(width, height) / 500, paths);
  const bool points = parts_of(region).points;
  if (points || !plane::is_closed(region)) {
    out.lost = fmt::format("a drawing cannot say {}{}{}: lost", points ? "where isolated points are" : "",
                           points && !plane::is_closed(region) ? " nor " : "",
                           plane::is_closed(region) ? "" : "which edges and points do not belong");
  }
  return out;
}

}  // namespace findspace::io
