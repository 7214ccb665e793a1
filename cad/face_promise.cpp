// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "face_promise.h"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <algorithm>
#include <cmath>

#include "exact/margins/cad.h"

namespace findspace::cad {
namespace {

using io::CadPlace;

/// The parameters of the corners: a pole takes the middle of the side across from it.
std::array<std::array<double, 2>, 3> places_of(const FaceMesh& f, const Triangle& t, int& free) {
  std::array<std::array<double, 2>, 3> at{};
  for (std::size_t i = 0; i < 3; ++i) at[i] = f.at[std::size_t(t[i])];
  free = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    if (f.pole[std::size_t(t[i])] < 0) continue;
    free = f.pole[std::size_t(t[i])];
    const auto k = std::size_t(free);
    at[i][k] = (at[(i + 1) % 3][k] + at[(i + 2) % 3][k]) / 2;
  }
  return at;
}

Slack slack_of_sides(const FaceMesh& f, const Triangle& t) {
  Slack slack;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = f.boundary.find({t[i], t[(i + 1) % 3]});
    if (found == f.boundary.end()) continue;
    slack.u = std::max(slack.u, found->second.slack.u);
    slack.v = std::max(slack.v, found->second.slack.v);
  }
  return slack;
}

gp_XYZ way_off(const FaceMesh& f, int node, const std::vector<CadPlace>& places) {
  const CadPlace& p = places[std::size_t(f.corner[std::size_t(node)])];
  const auto& uv = f.at[std::size_t(node)];
  return f.surface->Value(uv[0], uv[1]).XYZ() - gp_XYZ(p[0], p[1], p[2]);
}

double off_along(const FaceMesh& f, const Triangle& t, const CadPlace& way, const std::vector<CadPlace>& places) {
  double off = 0;
  for (const int node : t) off = std::max(off, std::abs(way_off(f, node, places).Dot(gp_XYZ(way[0], way[1], way[2]))));
  return off;
}

}  // namespace

double off_surface(const FaceMesh& f, const Triangle& t, const std::vector<CadPlace>& places) {
  double off = 0;
  for (const int node : t) off = std::max(off, way_off(f, node, places).Modulus());
  return off;
}

CadPlace even_direction(const Handle(Geom_Surface) & surface) {
  gp_Dir way(0, 0, 1);
  if (const auto s = Handle(Geom_CylindricalSurface)::DownCast(surface))
    way = s->Axis().Direction();
  else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface))
    way = cone->Axis().Direction();
  else
    return {};
  return {way.X(), way.Y(), way.Z()};
}

Promise promise_of(const FaceMesh& f, const Triangle& t, const std::vector<CadPlace>& places) {
  Promise out;
  if (!f.bounds) return {off_surface(f, t, places), 0, 0, false};
  int free = -1;
  const auto at = places_of(f, t, free);
  Range range{at[0][0], at[0][0], at[0][1], at[0][1]};
  for (const auto& p : at) range.hold(p[0], p[1]);
  const Slack slack = slack_of_sides(f, t);
  const double wide = range.u1 - range.u0, high = range.v1 - range.v0;
  const double more_u = slack.u + (free == 0 ? wide : 0), more_v = slack.v + (free == 1 ? high : 0);
  range.hold(range.u0 - more_u, range.v0 - more_v);
  range.hold(range.u1 + more_u, range.v1 + more_v);
  const Derivatives d = f.bounds->over(range);
  double most = triangle_bound(d, at);
  // The wedges at a pole are no wider than the wider of the two triangles that they lie between, and a wedge with the
  // foot of its height anywhere varies by no more than 4/3 of one with a right angle.
  if (free >= 0) most = std::max(most, 4.0 / 3 * triangle_bound(d, {{{0, 0}, {wide, 0}, {0, high}}}));
  out.slack = d.u * slack.u + d.v * slack.v;
  out.bound = most + out.slack + off_surface(f, t, places);
  out.longest = longest_side(d, at);
  // Along the axis of a cylinder or cone nothing is lost where corners and edges are where v says.
  const CadPlace axis = even_direction(f.surface);
  out.even = axis != CadPlace{} && slack.v <= margin::kCornerAlongAxis &&
             off_along(f, t, axis, places) <= margin::kCornerAlongAxis;
  return out;
}

}  // namespace findspace::cad
