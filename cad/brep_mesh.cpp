// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "brep_mesh.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <ShapeUpgrade_ShapeDivideContinuity.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "deviation.h"

namespace findspace::cad {
namespace {

using io::CadFace;
using io::CadFault;
using io::CadMesh;
using io::CadPlace;

using Handle_Surface = Handle(Geom_Surface);

Handle_Surface untrimmed(Handle_Surface surface) {
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    surface = trimmed->BasisSurface();
  return surface;
}

Handle_Surface surface_of(const TopoDS_Face& face) {
  Handle_Surface surface = BRep_Tool::Surface(face);
  return surface.IsNull() ? surface : untrimmed(surface);
}

/// The direction along which a straight-lined surface is a linear function of its parameters.
CadPlace even_direction(const Handle_Surface& surface) {
  gp_Dir way(0, 0, 1);
  if (const auto s = Handle(Geom_CylindricalSurface)::DownCast(surface))
    way = s->Axis().Direction();
  else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface))
    way = cone->Axis().Direction();
  else
    return {};
  return {way.X(), way.Y(), way.Z()};
}

struct Slack {
  double u = 0, v = 0;
};
/// A part of an edge of the solid as a side of a triangle. Places along the edge are counted by the nodes of its first
/// polygon, and halved from there, so that they are the same for both faces.
struct EdgePart {
  int edge = 0;
  double place0 = 0, place1 = 0, t0 = 0, t1 = 0;  // t: parameters of the curve
  Slack slack{};
};
using Segment = std::pair<int, int>;

/// One face, its triangles in the plane of parameters, counter-clockwise there.
struct FaceMesh {
  int number = 0;
  TopoDS_Face face;  // forward
  bool reversed = false;
  Handle_Surface surface;
  std::unique_ptr<const SurfaceBounds> bounds;  // null: flat
  std::vector<std::array<double, 2>> at;        // of each node
  std::vector<int> corner;                      // of the solid
  std::vector<signed char> pole;                // -1, or which parameter is free there
  std::vector<std::array<int, 3>> triangles;
  std::map<Segment, EdgePart> boundary;
  std::map<int, std::pair<Handle(Geom2d_Curve), int>> curves;  // of edge parts, by use

  std::string name() const { return "face " + std::to_string(number) + " (" + kind_of(surface) + ")"; }
};

/// What one triangle promises.
struct Promise {
  double bound = 0, slack = 0;  // slack: how much of it the boundary takes
  int longest = 0;              // side, as the bound measures
  bool even = false;
};

class SolidMesh {
 public:
  explicit SolidMesh(const TopoDS_Shape& solid) : solid_(solid) {
    TopExp::MapShapes(solid, TopAbs_VERTEX, vertices_);
    TopExp::MapShapes(solid, TopAbs_EDGE, edges_);
    int number = 0;
    for (TopExp_Explorer at(solid_, TopAbs_FACE); at.More(); at.Next()) {
      ++number;
      const TopAbs_Orientation sense = at.Current().Orientation();
      if (sense == TopAbs_FORWARD || sense == TopAbs_REVERSED) face(TopoDS::Face(at.Current()), number);
    }
  }

  /// Halves sides until no bound is above the tolerance.
  CadMesh read(double tolerance, std::size_t most) {
    for (int pass = 0; pass < kMostPasses; ++pass) {
      std::size_t count = 0;
      Marks marks;
      for (std::size_t f = 0; f < faces_.size(); ++f) {
        count += faces_[f].triangles.size();
        for (int k = 0; k < kSweeps && flip(faces_[f], tolerance); ++k) {
        }
        mark(f, tolerance, marks);
      }
      if (count > most)
        fail(CadFault::kUnsupported, "more than " + std::to_string(most) +
                                         " triangles are needed for this tolerance; raise it with --tolerance");
      if (marks.inner.empty() && marks.parts.empty()) return taken();
      for (std::size_t f = 0; f < faces_.size(); ++f) split(f, marks);
    }
    fail(CadFault::kUnsupported,
         "no bound within the tolerance could be proved for it; give the part as a mesh (STL, 3MF)");
  }

 private:
  struct Marks {
    std::set<std::pair<std::size_t, Segment>> inner;            // of a face, the lesser node first
    std::set<std::pair<int, std::pair<double, double>>> parts;  // of edges
  };

  void face(const TopoDS_Face& given, int number) {
    FaceMesh& f = faces_.emplace_back();
    f.number = number;
    f.face = TopoDS::Face(given.Oriented(TopAbs_FORWARD));
    f.reversed = given.Orientation() == TopAbs_REVERSED;
    f.surface = surface_of(given);
    TopLoc_Location placed;
    const Handle(Poly_Triangulation) proposed = BRep_Tool::Triangulation(f.face, placed);
    if (f.surface.IsNull() || proposed.IsNull() || !proposed->HasUVNodes() || proposed->NbTriangles() == 0)
      fail(CadFault::kUnsupported, f.name() + " could not be meshed by Open CASCADE");
    if (Handle(Geom_Plane)::DownCast(f.surface).IsNull()) {
      f.bounds = SurfaceBounds::of(f.surface);
      if (!f.bounds)
        fail(CadFault::kUnsupported,
             f.name() + " has no proved bound here; give the part as a mesh (STL, 3MF) instead");
    }
    for (int k = 1; k <= proposed->NbNodes(); ++k) {
      const gp_Pnt2d uv = proposed->UVNode(k);
      f.at.push_back({uv.X(), uv.Y()});
    }
    f.corner.assign(f.at.size(), -1);
    f.pole.assign(f.at.size(), -1);
    for (int k = 1; k <= proposed->NbTriangles(); ++k) {
      std::array<int, 3> n{};
      proposed->Triangle(k).Get(n[0], n[1], n[2]);
      f.triangles.push_back({n[0] - 1, n[1] - 1, n[2] - 1});
    }
    for (TopExp_Explorer at(f.face, TopAbs_EDGE); at.More(); at.Next()) {
      const TopAbs_Orientation sense = at.Current().Orientation();
      if (sense == TopAbs_FORWARD || sense == TopAbs_REVERSED) edge(f, TopoDS::Edge(at.Current()), proposed);
    }
    check_chain(f);
    for (std::size_t k = 0; k < f.at.size(); ++k)
      if (f.corner[k] < 0) f.corner[k] = add(proposed->Node(int(k) + 1).Transformed(placed));
    join_poles(f);
  }

  void edge(FaceMesh& f, const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & proposed) {
    double from = 0, to = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, f.face, from, to);
    const Handle(Poly_PolygonOnTriangulation) polygon = polygon_of(edge, proposed, curve);
    if (polygon.IsNull() || polygon->NbNodes() < 2 || !polygon->HasParameters() || curve.IsNull())
      fail(CadFault::kUnsupported, f.name() + " has an edge that could not be meshed by Open CASCADE");
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    if (first.IsNull() || last.IsNull()) fail(CadFault::kGeometry, f.name() + " has an edge without end points");
    const bool point = BRep_Tool::Degenerated(edge);
    const int count = polygon->NbNodes(), index = edges_.FindIndex(edge), use = int(f.curves.size());
    f.curves[use] = {curve, index};
    for (int k = 1; k <= count; ++k) {
      const auto node = std::size_t(polygon->Node(k)) - 1;
      f.corner[node] = point || k == 1 ? of_vertex(first)
                       : k == count    ? of_vertex(last)
                                       : of_edge(f, index, k, polygon->Parameter(k), f.at[node]);
      if (point) f.pole[node] = free_parameter(f, node);
    }
    for (int k = 1; k < count; ++k) {
      int a = polygon->Node(k) - 1, b = polygon->Node(k + 1) - 1;
      EdgePart part{use, double(k), double(k + 1), polygon->Parameter(k), polygon->Parameter(k + 1), {}};
      if (edge.Orientation() == TopAbs_REVERSED) {
        std::swap(a, b);
        std::swap(part.place0, part.place1);
        std::swap(part.t0, part.t1);
      }
      part.slack = slack_of(f, part, a, b);
      if (!f.boundary.emplace(Segment{a, b}, part).second) fail(CadFault::kGeometry, f.name() + " has an edge twice");
    }
  }

  /// A seam has two: that which runs with the edge's curve in the plane of parameters.
  static Handle(Poly_PolygonOnTriangulation)
      polygon_of(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & proposed,
                 const Handle(Geom2d_Curve) & curve) {
    Handle(Poly_PolygonOnTriangulation) best;
    double least = 0;
    const auto take = [&](const Handle(Poly_PolygonOnTriangulation) & next) {
      if (next.IsNull()) return;
      const bool known = !curve.IsNull() && next->HasParameters();
      const double off = known ? proposed->UVNode(next->Node(1)).Distance(curve->Value(next->Parameter(1))) : 0;
      if (!best.IsNull() && off >= least) return;
      best = next;
      least = off;
    };
    for (const Handle(BRep_CurveRepresentation) & one : Handle(BRep_TEdge)::DownCast(edge.TShape())->Curves()) {
      if (!one->IsPolygonOnTriangulation() || one->Triangulation() != proposed) continue;
      take(one->PolygonOnTriangulation());
      if (one->IsPolygonOnClosedTriangulation()) take(one->PolygonOnTriangulation2());
    }
    return best;
  }

  /// How far the boundary curve is from its chord, in parameters.
  static Slack slack_of(const FaceMesh& f, const EdgePart& part, int a, int b) {
    if (!f.bounds) return {};
    const Handle(Geom2d_Curve)& curve = f.curves.at(part.edge).first;
    const auto chord = chord_bound(curve, part.t0, part.t1);
    if (!chord) fail(CadFault::kUnsupported, f.name() + " has an edge of a kind that has no proved bound here");
    const auto off = [&](int node, double t) {
      const gp_Pnt2d p = curve->Value(t);
      const int free = f.pole[std::size_t(node)];  // is no way off
      const auto& at = f.at[std::size_t(node)];
      return Slack{free == 0 ? 0 : std::abs(at[0] - p.X()), free == 1 ? 0 : std::abs(at[1] - p.Y())};
    };
    const Slack x = off(a, part.t0), y = off(b, part.t1);
    return {(*chord)[0] + std::max(x.u, y.u), (*chord)[1] + std::max(x.v, y.v)};
  }

  /// Along which the surface stands still.
  static signed char free_parameter(const FaceMesh& f, std::size_t node) {
    gp_Pnt p;
    gp_Vec du, dv;
    f.surface->D1(f.at[node][0], f.at[node][1], p, du, dv);
    return du.SquareMagnitude() <= dv.SquareMagnitude() ? 0 : 1;
  }

  /// Nodes of one pole become one, and triangles that are no more than a side then are dropped.
  static void join_poles(FaceMesh& f) {
    std::set<int> poles;
    for (std::size_t k = 0; k < f.at.size(); ++k)
      if (f.pole[k] >= 0) poles.insert(f.corner[k]);
    for (std::size_t k = 0; k < f.at.size(); ++k)  // the end of a seam is there too
      if (f.pole[k] < 0 && poles.count(f.corner[k]) > 0) f.pole[k] = free_parameter(f, k);
    std::map<int, int> first;
    std::vector<int> to(f.at.size());
    for (std::size_t k = 0; k < f.at.size(); ++k)
      to[k] = f.pole[k] < 0 ? int(k) : first.emplace(f.corner[k], int(k)).first->second;
    if (first.empty()) return;
    std::vector<std::array<int, 3>> kept;
    for (std::array<int, 3> t : f.triangles) {
      for (int& v : t) v = to[std::size_t(v)];
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) kept.push_back(t);
    }
    f.triangles = std::move(kept);
    std::map<Segment, EdgePart> parts;
    for (const auto& [segment, part] : f.boundary) {
      const Segment joined{to[std::size_t(segment.first)], to[std::size_t(segment.second)]};
      if (joined.first != joined.second) parts.emplace(joined, part);
    }
    f.boundary = std::move(parts);
  }

  int of_vertex(const TopoDS_Vertex& vertex) {
    const auto [at, fresh] = at_vertex_.emplace(vertices_.FindIndex(vertex), 0);
    if (fresh) at->second = add(BRep_Tool::Pnt(vertex));
    return at->second;
  }

  /// The corner at a place of an edge: on its curve, else on the face that asks first.
  int of_edge(const FaceMesh& f, int index, double place, double t, const std::array<double, 2>& uv) {
    const auto [at, fresh] = at_edge_.emplace(std::pair{index, place}, 0);
    if (!fresh) return at->second;
    double from = 0, to = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges_(index)), from, to);
    at->second = add(curve.IsNull() ? f.surface->Value(uv[0], uv[1]) : curve->Value(t));
    return at->second;
  }

  int add(const gp_Pnt& p) {
    out_.places.push_back({p.X(), p.Y(), p.Z()});
    return int(out_.places.size()) - 1;
  }

  /// Inner sides of triangles run both ways, the others are the boundary.
  static void check_chain(const FaceMesh& f) {
    std::map<Segment, int> balance;
    const auto count = [&](int a, int b, int by) { balance[std::minmax(a, b)] += a < b ? by : -by; };
    for (const auto& t : f.triangles)
      for (std::size_t i = 0; i < 3; ++i) count(t[i], t[(i + 1) % 3], 1);
    for (const auto& [segment, part] : f.boundary) count(segment.first, segment.second, -1);
    for (const auto& [segment, left] : balance)
      if (left != 0) fail(CadFault::kUnsupported, f.name() + " could not be meshed by Open CASCADE up to its edges");
  }

  /// The parameters of the corners: a pole takes the middle of the side across from it.
  static std::array<std::array<double, 2>, 3> places_of(const FaceMesh& f, const std::array<int, 3>& t, int& free) {
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

  Promise promise(const FaceMesh& f, const std::array<int, 3>& t) const {
    Promise out;
    if (!f.bounds) return {off_surface(f, t), 0, 0, false};
    int free = -1;
    const auto at = places_of(f, t, free);
    Range range{at[0][0], at[0][0], at[0][1], at[0][1]};
    for (const auto& p : at) range.hold(p[0], p[1]);
    Slack slack;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = f.boundary.find({t[i], t[(i + 1) % 3]});
      if (found == f.boundary.end()) continue;
      slack.u = std::max(slack.u, found->second.slack.u);
      slack.v = std::max(slack.v, found->second.slack.v);
    }
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
    out.bound = most + out.slack + off_surface(f, t);
    out.longest = longest_side(d, at);
    // Along the axis of a cylinder or cone nothing is lost where corners and edges are where v says.
    const CadPlace axis = even_direction(f.surface);
    out.even = axis != CadPlace{} && slack.v <= kSame && off_along(f, t, axis) <= kSame;
    return out;
  }

  /// Of the corners from the surface; a pole is there for any free parameter.
  double off_surface(const FaceMesh& f, const std::array<int, 3>& t) const {
    double off = 0;
    for (const int node : t) off = std::max(off, way_off(f, node).Modulus());
    return off;
  }
  double off_along(const FaceMesh& f, const std::array<int, 3>& t, const CadPlace& way) const {
    double off = 0;
    for (const int node : t) off = std::max(off, std::abs(way_off(f, node).Dot(gp_XYZ(way[0], way[1], way[2]))));
    return off;
  }
  gp_XYZ way_off(const FaceMesh& f, int node) const {
    const CadPlace& p = out_.places[std::size_t(f.corner[std::size_t(node)])];
    const auto& uv = f.at[std::size_t(node)];
    return f.surface->Value(uv[0], uv[1]).XYZ() - gp_XYZ(p[0], p[1], p[2]);
  }

  /// Changes the diagonal of two triangles where that lowers a bound that is too high. True if any was changed.
  bool flip(FaceMesh& f, double tolerance) const {
    if (!f.bounds) return false;
    std::map<Segment, std::size_t> left;  // the triangle to the left of each side
    for (std::size_t k = 0; k < f.triangles.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) left[{f.triangles[k][i], f.triangles[k][(i + 1) % 3]}] = k;
    std::vector<bool> changed(f.triangles.size());
    bool any = false;
    for (std::size_t k = 0; k < f.triangles.size(); ++k) {
      const Promise p = promise(f, f.triangles[k]);
      if (changed[k] || p.bound <= tolerance) continue;
      const auto i = std::size_t(p.longest);
      const int a = f.triangles[k][i], b = f.triangles[k][(i + 1) % 3], c = f.triangles[k][(i + 2) % 3];
      const auto across = left.find({b, a});
      if (across == left.end() || f.boundary.count({a, b}) > 0 || changed[across->second]) continue;
      const std::array<int, 3>& other = f.triangles[across->second];
      const int d = other[0] + other[1] + other[2] - a - b;
      const std::array<int, 3> one{a, d, c}, two{d, b, c};
      if (d == c || left.count({c, d}) > 0 || left.count({d, c}) > 0 || !runs_left(f, one) || !runs_left(f, two))
        continue;
      const double before = std::max(p.bound, promise(f, other).bound);
      if (std::max(promise(f, one).bound, promise(f, two).bound) >= before * kGain) continue;
      changed[k] = changed[across->second] = any = true;
      f.triangles[across->second] = two;
      f.triangles[k] = one;
    }
    return any;
  }

  /// Counter-clockwise in the plane of parameters, and not at a pole, which has no one place there.
  static bool runs_left(const FaceMesh& f, const std::array<int, 3>& t) {
    for (const int v : t)
      if (f.pole[std::size_t(v)] >= 0) return false;
    const auto &a = f.at[std::size_t(t[0])], &b = f.at[std::size_t(t[1])], &c = f.at[std::size_t(t[2])];
    return (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]);
  }

  void mark(std::size_t index, double tolerance, Marks& marks) const {
    const FaceMesh& f = faces_[index];
    for (const auto& t : f.triangles) {
      const Promise p = promise(f, t);
      if (f.bounds) mark_ears(index, t, marks);
      if (p.bound <= tolerance) continue;
      if (off_surface(f, t) > tolerance / 2)
        fail(CadFault::kGeometry, f.name() + " has edges that are farther from it than the tolerance allows");
      if (!f.bounds) continue;
      bool any = false;
      for (std::size_t i = 0; i < 3 && p.slack > p.bound / 2; ++i) {
        const auto found = f.boundary.find({t[i], t[(i + 1) % 3]});
        if (found == f.boundary.end() || found->second.slack.u + found->second.slack.v <= 0) continue;
        mark_part(f, found->second, marks);
        any = true;
      }
      if (any) continue;
      const int a = t[std::size_t(p.longest)], b = t[(std::size_t(p.longest) + 1) % 3];
      if (const auto found = f.boundary.find({a, b}); found != f.boundary.end())
        mark_part(f, found->second, marks);
      else
        marks.inner.insert({index, std::minmax(a, b)});
    }
  }

  /// An inner side between two nodes of one edge is halved: the triangle beyond could lie in the plane of that edge,
  /// and fold back on the face across it.
  void mark_ears(std::size_t index, const std::array<int, 3>& t, Marks& marks) const {
    const FaceMesh& f = faces_[index];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto one = f.boundary.find({t[i], t[(i + 1) % 3]}), two = f.boundary.find({t[(i + 1) % 3], t[(i + 2) % 3]});
      const Segment across{t[(i + 2) % 3], t[i]};
      if (one == f.boundary.end() || two == f.boundary.end() || f.boundary.count(across) > 0) continue;
      if (one->second.edge == two->second.edge) marks.inner.insert({index, std::minmax(across.first, across.second)});
    }
  }

  static std::pair<int, std::pair<double, double>> key_of(const FaceMesh& f, const EdgePart& part) {
    return {f.curves.at(part.edge).second, std::minmax(part.place0, part.place1)};
  }
  static void mark_part(const FaceMesh& f, const EdgePart& part, Marks& marks) { marks.parts.insert(key_of(f, part)); }

  /// The node in the middle of each marked side, made where it is first met.
  void split(std::size_t index, const Marks& marks) {
    FaceMesh& f = faces_[index];
    std::map<Segment, int> middle;
    std::vector<std::array<int, 3>> out;
    for (const auto& t : f.triangles) {
      std::array<int, 3> m{};
      for (std::size_t i = 0; i < 3; ++i) m[i] = middle_of(index, t[i], t[(i + 1) % 3], marks, middle);
      cut(f, t, m, out);
    }
    f.triangles = std::move(out);
  }

  int middle_of(std::size_t index, int a, int b, const Marks& marks, std::map<Segment, int>& middle) {
    FaceMesh& f = faces_[index];
    if (const auto known = middle.find({a, b}); known != middle.end()) return known->second;
    if (const auto part = f.boundary.find({a, b}); part != f.boundary.end()) {
      if (marks.parts.count(key_of(f, part->second)) == 0) return -1;
      return middle[{a, b}] = halve(f, a, b, part->second);
    }
    if (marks.inner.count({index, std::minmax(a, b)}) == 0) return -1;
    std::array<double, 2> uv{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double x = f.at[std::size_t(a)][k], y = f.at[std::size_t(b)][k];
      uv[k] = f.pole[std::size_t(a)] == int(k) ? y : f.pole[std::size_t(b)] == int(k) ? x : (x + y) / 2;
    }
    const int node = node_at(f, uv, add(f.surface->Value(uv[0], uv[1])));
    return middle[{a, b}] = middle[{b, a}] = node;
  }

  static int node_at(FaceMesh& f, const std::array<double, 2>& uv, int corner) {
    f.at.push_back(uv);
    f.corner.push_back(corner);
    f.pole.push_back(-1);
    return int(f.at.size()) - 1;
  }

  /// Replaces the part of an edge by its halves.
  int halve(FaceMesh& f, int a, int b, const EdgePart whole) {
    const double place = (whole.place0 + whole.place1) / 2, t = (whole.t0 + whole.t1) / 2;
    const gp_Pnt2d p = f.curves.at(whole.edge).first->Value(t);
    const std::array<double, 2> uv{p.X(), p.Y()};
    const int node = node_at(f, uv, of_edge(f, f.curves.at(whole.edge).second, place, t, uv));
    f.boundary.erase({a, b});
    EdgePart first = whole, second = whole;
    first.place1 = second.place0 = place;
    first.t1 = second.t0 = t;
    first.slack = slack_of(f, first, a, node);
    second.slack = slack_of(f, second, node, b);
    f.boundary.emplace(Segment{a, node}, first);
    f.boundary.emplace(Segment{node, b}, second);
    return node;
  }

  /// The triangle cut at the middles of its sides, where it has them.
  static void cut(const FaceMesh& f, const std::array<int, 3>& t, const std::array<int, 3>& m,
                  std::vector<std::array<int, 3>>& out) {
    const auto count = std::count_if(m.begin(), m.end(), [](int v) { return v >= 0; });
    if (count == 0) {
      out.push_back(t);
      return;
    }
    if (count == 3) {
      for (std::size_t i = 0; i < 3; ++i) out.push_back({t[i], m[i], m[(i + 2) % 3]});
      out.push_back(m);
      return;
    }
    std::size_t i = 0;  // the side that has one, and with two the one before has one as well
    while (m[i] < 0 || (count == 2 && m[(i + 2) % 3] < 0)) ++i;
    const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], ab = m[i], ca = m[(i + 2) % 3];
    if (count == 1) {
      out.push_back({a, ab, c});
      out.push_back({ab, b, c});
      return;
    }
    out.push_back({a, ab, ca});
    const auto apart = [&](int v, int w) {
      return std::hypot(f.at[std::size_t(v)][0] - f.at[std::size_t(w)][0],
                        f.at[std::size_t(v)][1] - f.at[std::size_t(w)][1]);
    };
    if (apart(ab, c) <= apart(b, ca)) {
      out.push_back({ab, b, c});
      out.push_back({ab, c, ca});
    } else {
      out.push_back({ab, b, ca});
      out.push_back({b, c, ca});
    }
  }

  CadMesh taken() {
    const bool all_flat = std::all_of(faces_.begin(), faces_.end(), [](const FaceMesh& f) { return !f.bounds; });
    for (const FaceMesh& f : faces_) {
      if (all_flat && ring(f)) continue;
      for (const auto& t : f.triangles) {
        const Promise p = promise(f, t);
        CadFace face{{f.corner[std::size_t(t[0])], f.corner[std::size_t(t[1])], f.corner[std::size_t(t[2])]},
                     f.number,
                     !f.bounds,
                     p.bound,
                     p.even ? even_direction(f.surface) : CadPlace{}};
        if (f.reversed) std::swap(face.corners[1], face.corners[2]);
        out_.faces.push_back(std::move(face));
      }
    }
    for (const CadFace& f : out_.faces) out_.bound = std::max(out_.bound, f.bound);
    return std::move(out_);
  }

  /// The flat face as one polygon, where one circuit bounds it.
  bool ring(const FaceMesh& f) {
    std::map<int, int> next;
    for (const auto& [segment, part] : f.boundary)
      if (!next.emplace(f.corner[std::size_t(segment.first)], f.corner[std::size_t(segment.second)]).second)
        return false;
    std::vector<int> corners;
    for (auto at = next.begin(); at != next.end() && corners.size() <= next.size(); at = next.find(at->second)) {
      if (!corners.empty() && at == next.begin()) break;
      corners.push_back(at->first);
    }
    if (corners.size() != next.size()) return false;
    if (f.reversed) std::reverse(corners.begin(), corners.end());
    out_.faces.push_back({std::move(corners), f.number, true, 0, {}});
    return true;
  }

  static constexpr int kMostPasses = 60, kSweeps = 8;
  static constexpr double kGain = 0.9;    // of the bound before
  static constexpr double kSame = 1e-10;  // mm: what doubles lose

  const TopoDS_Shape& solid_;
  TopTools_IndexedMapOfShape vertices_, edges_;
  std::map<int, int> at_vertex_;
  std::map<std::pair<int, double>, int> at_edge_;
  std::vector<FaceMesh> faces_;
  CadMesh out_;
};

}  // namespace

void fail(CadFault fault, const std::string& message) { throw Problem{{fault, message}}; }

TopoDS_Shape smooth_faces(const TopoDS_Shape& solid) {
  bool creased = false;
  for (TopExp_Explorer f(solid, TopAbs_FACE); f.More() && !creased; f.Next()) {
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface_of(TopoDS::Face(f.Current())));
    creased = !spline.IsNull() && !(spline->IsCNu(1) && spline->IsCNv(1));
  }
  if (!creased) return solid;
  ShapeUpgrade_ShapeDivideContinuity divide(solid);
  divide.SetSurfaceCriterion(GeomAbs_C1);
  divide.SetPCurveCriterion(GeomAbs_C0);
  divide.SetBoundaryCriterion(GeomAbs_C0);
  return divide.Perform() ? divide.Result() : solid;
}

namespace {

bool has_free_forms(const TopoDS_Shape& solid) {
  for (TopExp_Explorer f(solid, TopAbs_FACE); f.More(); f.Next()) {
    const std::string kind = kind_of(surface_of(TopoDS::Face(f.Current())));
    if (kind != "plane" && kind != "cylinder" && kind != "cone" && kind != "sphere" && kind != "torus") return true;
  }
  return false;
}

}  // namespace

/// The mesher's own search for nodes within faces makes fewer triangles, but on free forms it may not end.
io::CadMesh mesh_of(const TopoDS_Shape& solid, double tolerance, std::size_t most) {
  constexpr double kPart = 0.5;  // the bound counts a side's error twice: along the face, and from it
  IMeshTools_Parameters asked;
  asked.Deflection = tolerance * kPart;
  asked.Angle = 0.8;
  asked.InParallel = Standard_False;
  asked.ControlSurfaceDeflection = !has_free_forms(solid);
  asked.InternalVerticesMode = Standard_False;
  BRepTools::Clean(solid);
  const BRepMesh_IncrementalMesh mesher(solid, asked);
  return SolidMesh(solid).read(tolerance, most);
}

}  // namespace findspace::cad
