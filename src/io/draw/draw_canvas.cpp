// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/draw/draw_canvas.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/text/put.h"

namespace findspace::io {

using plane::Index;
using plane::Place;

namespace {

constexpr double kMostAngle = 3;  // of one arc command, in radians: safely less than half a circle
/// Of one that is read again: where its ends are rounded the arc moves by less than twice as much.
constexpr double kMostExactAngle = 2;

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

std::string pixels(double value) {
  std::string out = fmt::format("{:.3f}", value);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string PathWriter::number(double value) const {
  return digits_ == Digits::kPixels ? pixels(value) : fmt::format("{:.13g}", value == 0 ? 0.0 : value);
}

void PathWriter::put(char command, const Place& p) {
  io::put(data_, "{}{} {}", command, number(frame_.x(p[0] + offset_[0])), number(frame_.y(p[1] + offset_[1])));
}

void PathWriter::arc_to(const Place& p, double radius, bool ccw) {
  const std::string r = number(radius * frame_.scale);
  io::put(data_, "A{0} {0} 0 0 {1}", r, ccw != frame_.y_down ? 0 : 1);
  put(' ', p);
}

void PathWriter::travel(const Curve& curve, bool forward) {
  const Place from = net_.at(curve.from), to = net_.at(curve.to), end = forward ? to : from;
  if (!curve.arc) return put('L', end);
  if (net_.angle(curve) > (digits_ == Digits::kPixels ? kMostAngle : kMostExactAngle)) {
    std::vector<Place> stops = net_.extremes(curve);
    if (!forward) std::reverse(stops.begin(), stops.end());
    for (const Place& p : stops) arc_to(p, curve.radius, forward);
  }
  arc_to(end, curve.radius, forward);
}

void PathWriter::add_ring(const Ring& ring) {
  const Curve& first = net_.curves()[ring.front().curve];
  put('M', net_.at(ring.front().forward ? first.from : first.to));
  for (const Side& side : ring) travel(net_.curves()[side.curve], side.forward);
  data_ += 'Z';
}

void PathWriter::add_curve(const Curve& curve) {
  put('M', net_.at(curve.from));
  if (curve.from != curve.to) return travel(curve, true);
  const std::vector<Place> stops = net_.extremes(curve);  // lowest, rightmost, highest
  for (std::size_t k = 0; k < stops.size(); ++k) {
    arc_to(stops[k], curve.radius, true);
    if (k == 1) put('M', stops[k]);
  }
  arc_to(net_.at(curve.to), curve.radius, true);
}

void PathWriter::add_curves(std::span<const Curve* const> curves) {
  std::vector<std::vector<std::size_t>> at(net_.vertices().size());
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (curves[k]->from == curves[k]->to) continue;
    for (const plane::Index v : {curves[k]->from, curves[k]->to}) at[net_.number(v)].push_back(k);
  }
  std::vector<bool> drawn(curves.size());
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (drawn[k]) continue;
    drawn[k] = true;
    add_curve(*curves[k]);
    if (curves[k]->from == curves[k]->to) continue;
    for (plane::Index v = curves[k]->to;;) {
      std::vector<std::size_t>& next = at[net_.number(v)];
      while (!next.empty() && drawn[next.back()]) next.pop_back();
      if (next.empty()) break;
      const Curve& curve = *curves[next.back()];
      drawn[next.back()] = true;
      travel(curve, curve.from == v);
      v = curve.from == v ? curve.to : curve.from;
    }
  }
}

void PathWriter::add_frame() {
  io::put(data_, "M{0} {1}H{2}V{3}H{0}Z", pixels(frame_.left), pixels(frame_.top), pixels(frame_.left + frame_.width()),
          pixels(frame_.top + frame_.height()));
}

void PathWriter::add_face(const plane::Face& face) {
  if (face.outer == plane::kNone)
    add_frame();
  else
    add_ring(net_.ring(face.outer));
  for (Index h : face.inner) add_ring(net_.ring(h));
}

void PathWriter::add_faces() {
  for (const plane::Face& f : net_.complex().faces) {
    if (f.mark != 0) add_face(f);
  }
}

}  // namespace findspace::io
