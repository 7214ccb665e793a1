// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/export/arc_places.h"

#include <cmath>
#include <numbers>

namespace findspace::io {
namespace {

using plane::CurveNet;
using plane::Place;
using std::numbers::pi;

constexpr double kUndivided = 3.2;  // radians: half a circle, whatever its angle was rounded to

/// Counter-clockwise, in [0, 2 pi).
double angle_between(const Place& center, const Place& a, const Place& b) {
  const double ax = a[0] - center[0], ay = a[1] - center[1], bx = b[0] - center[0], by = b[1] - center[1];
  const double angle = std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  return angle < 0 ? angle + 2 * pi : angle;
}

class ArcDivider {
 public:
  ArcDivider(const CurveNet& net, const CurveNet::Curve& arc) : net_(net), arc_(arc), angle_(net.angle(arc)) {
    const Place begin = net.at(arc.from);
    for (const Place& p : net.extremes(arc)) extremes_.push_back({p, angle_between(arc.center, begin, p)});
  }

  ArcPlace begin() const { return {net_.at(arc_.from), 0}; }
  ArcPlace end() const { return {net_.at(arc_.to), angle_}; }
  const std::vector<ArcPlace>& extremes() const { return extremes_; }

  /// The extreme place in the middle third that is nearest to the middle, else the middle.
  ArcPlace middle(const ArcPlace& a, const ArcPlace& b) const {
    const double angle = (a.angle + b.angle) / 2;
    const ArcPlace* best = nullptr;
    const auto off = [angle](const ArcPlace& p) { return std::abs(p.angle - angle); };
    for (const ArcPlace& p : extremes_)
      if (6 * off(p) <= b.angle - a.angle && (best == nullptr || off(p) < off(*best))) best = &p;
    return best != nullptr ? *best : ArcPlace{on_arc(angle), angle};
  }

 private:
  Place on_arc(double angle) const {
    const Place begin = net_.at(arc_.from);
    const double turn = std::atan2(begin[1] - arc_.center[1], begin[0] - arc_.center[0]) + angle;
    return {arc_.center[0] + arc_.radius * std::cos(turn), arc_.center[1] + arc_.radius * std::sin(turn)};
  }

  const CurveNet& net_;
  const CurveNet::Curve& arc_;
  const double angle_;  // that it spans
  std::vector<ArcPlace> extremes_;
};

}  // namespace

std::vector<ArcPlace> divided_arc(const CurveNet& net, const CurveNet::Curve& arc) {
  const ArcDivider divider(net, arc);
  std::vector<ArcPlace> all{divider.begin()};
  if (divider.end().angle > kUndivided) all.insert(all.end(), divider.extremes().begin(), divider.extremes().end());
  all.push_back(divider.end());
  return all;
}

std::vector<ArcPlace> three_point_arcs(const CurveNet& net, const CurveNet::Curve& arc) {
  const ArcDivider divider(net, arc);
  const ArcPlace a = divider.begin(), b = divider.end(), middle = divider.middle(a, b);
  if (b.angle <= kUndivided) return {a, middle, b};
  return {a, divider.middle(a, middle), middle, divider.middle(middle, b), b};
}

}  // namespace findspace::io
