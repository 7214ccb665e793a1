// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/contact_surface.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "plane/base/result_store.h"
#include "space/phi/gauss_overlay.h"

namespace findspace::space {
namespace {

/// The cyclic pair of coordinates that drops the longest component of the normal; `flip` keeps the sense when it is <
/// 0.
class Projection {
 public:
  explicit Projection(const Wide3& n) {
    const auto size = [](int128 v) { return v < 0 ? -v : v; };
    const int128 x = size(n.x), y = size(n.y), z = size(n.z);
    axis_ = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    flip_ = (axis_ == 0 ? n.x : axis_ == 1 ? n.y : n.z) < 0;
  }
  GaussOverlay::Flat operator()(const Grid3& p) const {
    const std::int64_t u = axis_ == 0 ? p.y : axis_ == 1 ? p.z : p.x;
    const std::int64_t v = axis_ == 0 ? p.z : axis_ == 1 ? p.x : p.y;
    return {u, flip_ ? -v : v};
  }

 private:
  int axis_ = 0;
  bool flip_ = false;
};

}  // namespace

/// The sum of a polygon (or edge) of A and the reflected one of B, both counter-clockwise about the normal: their edges
/// merged by angle, from the lowest points on (phi.md 5). Parallel edges of one sense advance together.
void GaussOverlay::add_planar_sum(std::span<const int> p, std::span<const int> q, const Wide3& normal) {
  const Projection project(normal);
  flat_p_.clear();
  flat_q_.clear();
  for (const int v : p) flat_p_.push_back(project(a_.vertices()[v]));
  for (const int v : q) flat_q_.push_back(project(-b_.vertices()[v]));
  const auto lowest = [](const std::pmr::vector<Flat>& ring) {
    return static_cast<std::size_t>(std::min_element(ring.begin(), ring.end()) - ring.begin());
  };
  const auto turn = [](const Flat& a, const Flat& b, const Flat& c, const Flat& d) {
    return exact::sign(int128(b.x - a.x) * (d.y - c.y) - int128(b.y - a.y) * (d.x - c.x));
  };
  const std::size_t n = p.size(), m = q.size();
  std::size_t i = lowest(flat_p_), j = lowest(flat_q_);
  for (std::size_t left_p = n, left_q = m; left_p + left_q > 0;) {
    out_.corners_.push_back(vertex(p[i], q[j]));
    const std::size_t next_i = i + 1 == n ? 0 : i + 1, next_j = j + 1 == m ? 0 : j + 1;
    const int order = left_p == 0   ? -1
                      : left_q == 0 ? 1
                                    : turn(flat_p_[i], flat_p_[next_i], flat_q_[j], flat_q_[next_j]);
    if (order >= 0) {
      i = next_i;
      --left_p;
    }
    if (order <= 0) {
      j = next_j;
      --left_q;
    }
  }
}

std::string_view contact_name(Contact contact) {
  constexpr std::string_view kNames[] = {"FV", "FE", "FF", "VF", "EF", "EE"};
  return kNames[static_cast<int>(contact)];
}

namespace {

/// Below that a surface is made sooner than it is found.
constexpr int kLeastStored = 200;  // vertices of one times those of the other

bool put_polytope(const Polytope& p, plane::ByteWriter& out) {
  out.put_all(p.vertices());
  out.put_all(p.half_edges());
  for (int v = 0; v < p.vertex_count(); ++v) out.put(p.outgoing(v));
  return true;
}

}  // namespace

ContactSurface::ContactSurface(const Polytope& a, const Polytope& b) {
  const auto make = [&] {
    ContactSurface made;
    GaussOverlay(a, b, made).run();
    return made;
  };
  if (std::int64_t(a.vertex_count()) * b.vertex_count() < kLeastStored)
    *this = make();
  else
    *this = plane::stored<ContactSurface>(
        {"contact surface", [&](plane::ByteWriter& out) { return put_polytope(a, out) && put_polytope(b, out); }, make,
         write, read});
}

bool ContactSurface::write(const ContactSurface& s, plane::ByteWriter& out) {
  out.put_all(std::span(s.vertices_));
  out.put_all(std::span(s.pairs_));
  out.put_all(std::span(s.first_));
  out.put_all(std::span(s.corners_));
  out.put_all(std::span(s.planes_));
  out.put_all(std::span(s.contacts_));
  out.put_all(std::span(s.features_));
  return true;
}

std::optional<ContactSurface> ContactSurface::read(plane::ByteReader& in) {
  ContactSurface s;
  s.vertices_ = in.take_all<Point>();
  s.pairs_ = in.take_all<std::array<int, 2>>();
  s.first_ = in.take_all<int>();
  s.corners_ = in.take_all<int>();
  s.planes_ = in.take_all<Plane>();
  s.contacts_ = in.take_all<Contact>();
  s.features_ = in.take_all<std::array<int, 2>>();
  return s;
}

ContactSurface::ContactSurface(const Polytope& a, const Point& b) : first_{0} {
  for (int v = 0; v < a.vertex_count(); ++v) {
    vertices_.push_back(a.vertices()[v] - b);
    pairs_.push_back({v, 0});
  }
  for (int f = 0; f < a.facet_count(); ++f) {
    const Plane& plane = a.planes()[f];
    add_facet(a.circuit(f), {plane.normal, plane.offset + exact::dot(plane.normal, b)}, Contact::kFV, {f, 0});
  }
}

ContactSurface::ContactSurface(const Point& a, const Polytope& b) : first_{0} {
  for (int v = 0; v < b.vertex_count(); ++v) {
    vertices_.push_back(a - b.vertices()[v]);
    pairs_.push_back({0, v});
  }
  for (int g = 0; g < b.facet_count(); ++g) {
    const Plane& plane = b.planes()[g];
    std::vector<int> circuit = b.circuit(g);
    std::reverse(circuit.begin(), circuit.end());  // the reflection reverses it
    add_facet(std::move(circuit), {-plane.normal, plane.offset + exact::dot(plane.normal, a)}, Contact::kVF, {0, g});
  }
}

namespace {

/// By how many corners of A and of B meet in a facet.
Contact contact_of(std::size_t a, std::size_t b) {
  if (a > 2) return b > 2 ? Contact::kFF : b == 2 ? Contact::kFE : Contact::kFV;
  if (a == 2) return b > 2 ? Contact::kEF : Contact::kEE;
  return Contact::kVF;
}

}  // namespace

ContactSurface::ContactSurface(std::span<const Point> a, std::span<const Point> b) : first_{0} {
  std::map<Point, std::array<int, 2>> pair_of;
  std::vector<Point> differences;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      differences.push_back(a[i] - b[j]);
      pair_of[differences.back()] = {static_cast<int>(i), static_cast<int>(j)};
    }
  const Polytope hull = Polytope::hull(differences);
  for (const Point& v : hull.vertices()) {
    vertices_.push_back(v);
    pairs_.push_back(pair_of.at(v));
  }
  for (int f = 0; f < hull.facet_count(); ++f) {
    std::vector<int> circuit = hull.circuit(f);
    std::array<std::set<int>, 2> meet;
    for (const int v : circuit)
      for (std::size_t k = 0; k < 2; ++k) meet[k].insert(pairs_[v][k]);
    add_facet(std::move(circuit), hull.planes()[f], contact_of(meet[0].size(), meet[1].size()), {-1, -1});
  }
}

void ContactSurface::add_facet(std::vector<int> circuit, const Plane& plane, Contact contact,
                               std::array<int, 2> features) {
  corners_.insert(corners_.end(), circuit.begin(), circuit.end());
  first_.push_back(static_cast<int>(corners_.size()));
  planes_.push_back(plane);
  contacts_.push_back(contact);
  features_.push_back(features);
}

Plane ContactSurface::plane(int f) const {
  const Plane& raw = planes_[f];
  if (contacts_[f] != Contact::kEE) return raw;
  const Wide3 normal = exact::primitive(raw.normal);
  return {normal, -exact::dot(normal, vertices_[corners_[first_[f]]])};
}

std::optional<std::string_view> ContactSurface::fault() const {
  std::vector<std::pair<int, int>> forward, backward;
  for (int f = 0; f < facet_count(); ++f) {
    const auto ring = circuit(f);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      forward.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
      backward.emplace_back(ring[(i + 1) % ring.size()], ring[i]);
    }
  }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  if (std::adjacent_find(forward.begin(), forward.end()) != forward.end()) return "a directed edge occurs twice";
  if (forward != backward) return "an edge has one side only";
  if (vertex_count() - edge_count() + facet_count() != 2) return "V - E + F is not 2";
  for (int f = 0; f < facet_count(); ++f) {
    for (const Point& v : vertices_) {
      if (exact::dot(planes_[f].normal, v) + planes_[f].offset > 0) return "a vertex lies above a plane";
    }
    for (const int c : circuit(f)) {
      if (exact::dot(planes_[f].normal, vertices_[c]) + planes_[f].offset != 0) return "a corner lies off its plane";
    }
  }
  return std::nullopt;
}

}  // namespace findspace::space
