// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/draw/draw_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/draw/draw_layout.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::Bounds;
using plane::Component;
using plane::Place;

constexpr int kColumns = 12, kRows = 9;  // places tried in a shape
constexpr double kClearance = 4;         // pixels kept from lines
constexpr double kCross = 8;             // half the width of the cross at a position, with some space
constexpr double kStride = 7;            // pixels between the points that stand for a line
constexpr double kHalo = 2.4;            // pixels of white about a small name, were it as large as others
constexpr double kSmall[] = {10, 8, 6.5, 5};
constexpr double kMostPoints = 20000;

std::array<double, 3> weight(const Component& c) { return {c.area ? 0.0 : 1.0, c.area.value_or(0), c.dangling_length}; }

Place middle(const Bounds& b) { return {(b.low[0] + b.high[0]) / 2, (b.low[1] + b.high[1]) / 2}; }

}  // namespace

const Component* largest(const plane::Summary& s) {
  if (s.components.empty()) return nullptr;
  return &*std::max_element(s.components.begin(), s.components.end(),
                            [](const Component& a, const Component& b) { return weight(a) < weight(b); });
}

std::string label_text(double x, double y, std::string_view text) { return label_text(x, y, text, kFontSize, false); }

std::string label_text(double x, double y, std::string_view text, double font, bool upwards) {
  std::string style;
  if (font < kFontSize)
    style = fmt::format(" style=\"font-size:{}px;stroke-width:{}\"", pixels(font), pixels(kHalo * font / kFontSize));
  if (upwards) style += fmt::format(" transform=\"rotate(-90 {} {})\"", pixels(x), pixels(y));
  return fmt::format("<text class=\"label\" x=\"{}\" y=\"{}\"{}>{}</text>\n", pixels(x), pixels(y + font * 0.36), style,
                     xml_escaped(text));
}

Labeller::Labeller(const Frame& frame, const Real& step, std::vector<LabelledShape> shapes, bool small)
    : frame_(frame), step_(step), shapes_(std::move(shapes)), small_(small) {
  std::erase_if(shapes_, [](const LabelledShape& s) { return s.summary.components.empty(); });
  std::stable_sort(shapes_.begin(), shapes_.end(), [](const LabelledShape& a, const LabelledShape& b) {
    return weight(*largest(a.summary)) < weight(*largest(b.summary));
  });
}

void Labeller::avoid(const Place& point, double radius) { taken_.push_back(around(point, radius)); }

Labeller::Box Labeller::around(const Place& point, double radius) const {
  const double x = frame_.x(point[0]), y = frame_.y(point[1]);
  return {{x - radius, y - radius}, {x + radius, y + radius}};
}

void Labeller::avoid_text(const Place& middle, std::string_view text, double font) {
  taken_.push_back(box_around(middle[0], middle[1], text, {font}));
}

void Labeller::avoid_region(const CurveNet& region) {
  region_.emplace(region.complex());
  avoid_curves(region, {});
}

void Labeller::avoid_curves(const CurveNet& net, const Place& offset) {
  double length = 0;
  std::vector<double> lengths;
  for (const Curve& k : net.curves()) {
    const Place from = net.at(k.from), to = net.at(k.to);
    lengths.push_back(frame_.scale * (k.arc ? k.radius * net.angle(k) : std::hypot(to[0] - from[0], to[1] - from[1])));
    length += lengths.back();
  }
  const double stride = std::max(kStride, length / kMostPoints);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Curve& k = net.curves()[i];
    const Place from = net.at(k.from), to = net.at(k.to);
    const auto keep = [&](double x, double y) { lines_.push_back(around({x + offset[0], y + offset[1]}, kClearance)); };
    const double first = std::atan2(from[1] - k.center[1], from[0] - k.center[0]);
    const double spanned = k.arc ? net.angle(k) : 0;
    for (double t = 0; t < lengths[i]; t += stride) {
      const double part = t / lengths[i], angle = first + spanned * part;
      if (k.arc)
        keep(k.center[0] + k.radius * std::cos(angle), k.center[1] + k.radius * std::sin(angle));
      else
        keep(from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part);
    }
  }
}

Labeller::Box Labeller::box_around(double x, double y, std::string_view text, const Size& size) {
  const double part = size.font / kFontSize;
  double w = text_width(text, size.font) / 2 + 3 * part, h = size.font / 2 + 2 * part;
  if (size.font < kFontSize) {
    h = size.font * 0.42;
    w = text_width(text, size.font) / 2;
  }
  if (size.upwards) std::swap(w, h);
  return {{x - w, y - h}, {x + w, y + h}};
}

bool Labeller::is_free(const Box& b) const {
  return is_open(b) && std::none_of(lines_.begin(), lines_.end(), [&](const Box& t) { return boxes_meet(b, t); });
}

bool Labeller::is_open(const Box& b) const {
  if (b.low[0] < frame_.left || b.high[0] > frame_.left + frame_.width()) return false;
  if (b.low[1] < frame_.top || b.high[1] > frame_.top + frame_.height()) return false;
  return std::none_of(taken_.begin(), taken_.end(), [&](const Box& t) { return boxes_meet(b, t); });
}

Labeller::Box Labeller::pixel_box(const LabelledShape& s, const Bounds& b) const {
  const double y[2] = {frame_.y(b.low[1] + s.offset[1]), frame_.y(b.high[1] + s.offset[1])};
  return {{frame_.x(b.low[0] + s.offset[0]), std::min(y[0], y[1])},
          {frame_.x(b.high[0] + s.offset[0]), std::max(y[0], y[1])}};
}

exact::RealPoint Labeller::position(double px, double py, const Place& offset) const {
  const double x = frame_.world_x(px) - offset[0], y = frame_.world_y(py) - offset[1];
  return {Real::from_double(x) / step_, Real::from_double(y) / step_};
}

/// Whether the box's corners and the middles of its sides belong to the shape.
bool Labeller::lies_in(const LabelledShape& s, plane::Locator& locator, const Box& b) const {
  const Place m = middle(b);
  for (double px : {b.low[0], m[0], b.high[0]}) {
    for (double py : {b.low[1], m[1], b.high[1]}) {
      if (locator.mark(position(px, py, s.offset)) == 0) return false;
    }
  }
  return true;
}

/// Its lines are kept away from already, so one point decides.
bool Labeller::is_on_region(const Box& b) {
  const Place m = middle(b);
  return region_ && region_->mark(position(m[0], m[1], {})) != 0;
}

bool Labeller::meets_smaller(std::size_t shape, const Box& b) const {
  for (std::size_t i = 0; i < shape; ++i) {
    for (const Component& c : shapes_[i].summary.components) {
      if (c.bbox && boxes_meet(pixel_box(shapes_[i], *c.bbox), b)) return true;
    }
  }
  return false;
}

/// Whether the box meets a shape that does not surround this one.
bool Labeller::meets_other(std::size_t shape, const Box& b) const {
  const std::optional<Bounds>& own = largest(shapes_[shape].summary)->bbox;
  if (!own) return false;
  const Box self = pixel_box(shapes_[shape], *own);
  const auto surrounds = [&](const Box& t) {
    return t.low[0] <= self.low[0] && t.low[1] <= self.low[1] && self.high[0] <= t.high[0] && self.high[1] <= t.high[1];
  };
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    if (i == shape) continue;
    for (const Component& c : shapes_[i].summary.components) {
      if (!c.bbox) continue;
      const Box t = pixel_box(shapes_[i], *c.bbox);
      if (boxes_meet(t, b) && !surrounds(t)) return true;
    }
  }
  return false;
}

/// The middle of the largest component, or else the first good place in it from the upper left on; off the region if
/// possible.
std::optional<Labeller::Box> Labeller::place_inside(std::size_t shape, const Size& size) {
  const LabelledShape& s = shapes_[shape];
  const Component& c = *largest(s.summary);
  const Box area = c.bbox
                       ? pixel_box(s, *c.bbox)
                       : Box{{frame_.left, frame_.top}, {frame_.left + frame_.width(), frame_.top + frame_.height()}};
  const Box own = box_around(frame_.x(c.sample[0] + s.offset[0]), frame_.y(c.sample[1] + s.offset[1]), s.name, size);
  const double room = 3 * size.font / kFontSize;
  const double w = (own.high[0] - own.low[0]) / 2 + room, h = (own.high[1] - own.low[1]) / 2 + room;
  std::vector<Box> boxes{own};
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const double x = area.low[0] + w + (area.high[0] - area.low[0] - 2 * w) * i / (kColumns - 1);
      const double y = area.low[1] + h + (area.high[1] - area.low[1] - 2 * h) * j / (kRows - 1);
      boxes.push_back(box_around(x, y, s.name, size));
    }
  }
  plane::Locator locator(s.net->complex());
  std::erase_if(boxes, [&](const Box& b) { return !is_free(b) || meets_smaller(shape, b) || !lies_in(s, locator, b); });
  if (boxes.empty()) return std::nullopt;
  const auto outside = std::find_if(boxes.begin(), boxes.end(), [this](const Box& b) { return !is_on_region(b); });
  return outside == boxes.end() ? boxes.front() : *outside;
}

/// Above, below, right or left of the largest component, or at a corner of its box; across a line where no place is
/// free of them. In its middle if all is taken, unless another name is there.
std::optional<Labeller::Box> Labeller::place_beside(std::size_t shape, const Size& size) const {
  const LabelledShape& s = shapes_[shape];
  const Component& c = *largest(s.summary);
  const Place at{frame_.x(c.sample[0] + s.offset[0]), frame_.y(c.sample[1] + s.offset[1])};
  const Box own = box_around(at[0], at[1], s.name, size);
  if (!c.bbox) return own;
  const Box box = pixel_box(s, *c.bbox);
  const auto away = [&](int i) {  // a shape smaller than the cross at its position stands under it
    return (own.high[i] - own.low[i]) / 2 + std::max(kClearance + 1, kCross - (box.high[i] - box.low[i]) / 2);
  };
  const double w = away(0), h = away(1);
  const Place m = middle(box);
  const double left = box.low[0] - w, right = box.high[0] + w, above = box.low[1] - h, below = box.high[1] + h;
  const std::array<Place, 8> ways{{{m[0], above},
                                   {m[0], below},
                                   {right, m[1]},
                                   {left, m[1]},
                                   {right, above},
                                   {left, above},
                                   {right, below},
                                   {left, below}}};
  for (const bool across : {false, true})
    for (const Place& way : ways) {
      const Box b = box_around(way[0], way[1], s.name, size);
      if ((across ? is_open(b) : is_free(b)) && !(small_ ? meets_other(shape, b) : meets_smaller(shape, b))) return b;
    }
  const bool named = std::any_of(names_.begin(), names_.end(), [&](const Box& n) { return boxes_meet(own, n); });
  return named ? std::nullopt : std::optional(own);
}

/// In the shape as large as may be, before it stands beside it.
std::optional<Labeller::Label> Labeller::place(std::size_t shape) {
  std::vector<Size> sizes{{kFontSize}};
  if (small_)
    for (const double font : kSmall) sizes.insert(sizes.end(), {{font, false}, {font, true}});
  for (const Size& size : sizes)
    if (const std::optional<Box> b = place_inside(shape, size)) return Label{*b, size};
  const Size beside{small_ ? kSmall[2] : kFontSize};
  if (const std::optional<Box> b = place_beside(shape, beside)) return Label{*b, beside};
  return std::nullopt;
}

std::string Labeller::labels() {
  std::string out;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const std::optional<Label> label = place(i);
    if (!label) continue;
    taken_.push_back(label->box);
    names_.push_back(label->box);
    const Place m = middle(label->box);
    out += label_text(m[0], m[1], shapes_[i].name, label->size.font, label->size.upwards);
  }
  return out;
}

}  // namespace findspace::io
