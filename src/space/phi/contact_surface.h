// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The 0-level surface gamma12 of two convex polytopes: the frontier of A - B = {a - b : a in A, b in B}, that is the
// set of translations t at which B + t touches A without overlapping it. Each facet knows which features meet there: a
// facet, edge or vertex of A with a facet, edge or vertex of B. Guarantee: exact for every pair of polytopes on the
// grid; planes are integers with coprime normals; each vertex is the difference of one vertex of A and one of B;
// circuits run counter-clockwise seen from outside. Cost: proportional to what is read and written. The two Gauss maps
// (of A, and of B reflected) are overlaid by walking every arc of the first through the cells of the second: one sign
// for each facet corner passed, no pair is tried in vain. Source: Stoyan, Terno, Gil, Romanova, Scheithauer,
// "Construction of a Phi-function for two convex polytopes", with the errata of docs/phi.md; the overlay replaces its
// three stages, which the tests keep as the oracle. Keywords: Minkowski difference, configuration-space obstacle,
// C-obstacle, no-fit polyhedron, Gauss map.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "plane/base/bytes.h"
#include "space/polytope/polytope.h"

namespace findspace::space {

/// Feature of A, then of B.
enum class Contact : std::uint8_t { kFV, kFE, kFF, kVF, kEF, kEE };

std::string_view contact_name(Contact contact);

class ContactSurface {
 public:
  /// gamma12 of A and B.
  ContactSurface(const Polytope& a, const Polytope& b);
  /// The same where one of the two is a point, the core of a ball: FV or VF facets only.
  ContactSurface(const Polytope& a, const Point& b);
  ContactSurface(const Point& a, const Polytope& b);
  /// The same of two convex hulls of any dimension whose difference has interior, one of them flat: by the hull of all
  /// differences. The points are the corners of each.
  ContactSurface(std::span<const Point> a, std::span<const Point> b);

  int vertex_count() const { return static_cast<int>(vertices_.size()); }
  int facet_count() const { return static_cast<int>(contacts_.size()); }
  int edge_count() const { return static_cast<int>(corners_.size() / 2); }

  /// Vertices of the surface, and the vertices of A and B whose difference each of them is.
  std::span<const Point> vertices() const { return vertices_; }
  std::array<int, 2> vertex_pair(int v) const { return pairs_[v]; }

  std::span<const int> circuit(int f) const {
    return {corners_.data() + first_[f], static_cast<std::size_t>(first_[f + 1] - first_[f])};
  }
  /// The outward plane of facet f, with coprime normal.
  Plane plane(int f) const;
  /// The same plane with integers that may have a common factor (EE facets), as it was built: enough for every sign.
  const Plane& raw_plane(int f) const { return planes_[f]; }
  Contact contact(int f) const { return contacts_[f]; }
  /// The features of A and of B that meet in facet f: the index of a facet or a vertex, or a half-edge for an edge; -1
  /// where one of the two is flat.
  std::array<int, 2> features(int f) const { return features_[f]; }

  /// Every directed edge occurs once and its reverse once, V - E + F = 2, and every vertex lies below every plane.
  /// The reason when it does not hold. For tests and for `phi --check`; cost O(V F).
  std::optional<std::string_view> fault() const;

 private:
  friend class GaussOverlay;
  ContactSurface() = default;
  static bool write(const ContactSurface& surface, plane::ByteWriter& out);
  static std::optional<ContactSurface> read(plane::ByteReader& in);
  void add_facet(std::vector<int> circuit, const Plane& plane, Contact contact, std::array<int, 2> features);

  std::vector<Point> vertices_;
  std::vector<std::array<int, 2>> pairs_;
  std::vector<int> first_;
  std::vector<int> corners_;
  std::vector<Plane> planes_;
  std::vector<Contact> contacts_;
  std::vector<std::array<int, 2>> features_;
};

}  // namespace findspace::space
