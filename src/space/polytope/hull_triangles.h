// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The triangulated hull that quickhull grows (hull.cpp), and its facets (hull_facets.cpp). Internal to these.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "space/polytope/polytope.h"

namespace findspace::space {

struct Triangle {
  std::array<int, 3> v{};     // counter-clockwise from outside
  std::array<int, 3> next{};  // the triangle across the edge v[i] v[i + 1]
  Wide3 normal;
  Approx3 approx;
  std::vector<int> outside;  // points strictly above that no other triangle owns
  bool alive = true;
  int mark = -1;
  int number = 0;  // how many were made before it
};

class Hull {
 public:
  explicit Hull(std::vector<Point> points) : points_(std::move(points)) {
    for (const Point& p : points_) approx_.push_back(exact::approx(p));
  }

  /// What leaves the points without interior, if something does.
  std::optional<std::string> run() {
    if (auto flat = start()) return flat;
    for (std::size_t k = 0; k < todo_.size(); ++k) {
      const auto [t, number] = todo_[k];
      if (triangles_[t].alive && triangles_[t].number == number) add(t);
    }
    return std::nullopt;
  }

  /// The facets as circuits of indices of the points.
  std::vector<std::vector<int>> merged() const;

 private:
  int side(const Triangle& t, int p) const {
    const int fast = exact::filtered_sign_dot(t.approx, approx_[p] - approx_[t.v[0]]);
    if (fast != 2) return fast;
    return exact::sign(exact::dot(t.normal, points_[p] - points_[t.v[0]]));
  }
  double height(const Triangle& t, int p) const {
    const Approx3 e = approx_[p] - approx_[t.v[0]];
    return t.approx.x * e.x + t.approx.y * e.y + t.approx.z * e.z;
  }
  /// In the place of one that is dead, where there is one.
  int make(int a, int b, int c) {
    const int at = dead_.empty() ? static_cast<int>(triangles_.size()) : dead_.back();
    if (dead_.empty())
      triangles_.emplace_back();
    else
      dead_.pop_back();
    Triangle& t = triangles_[at];
    t.v = {a, b, c};
    t.normal = exact::cross(points_[b] - points_[a], points_[c] - points_[a]);
    t.approx = exact::approx(t.normal);
    t.alive = true;
    t.number = made_++;
    return at;
  }
  /// A triangle without points outside is done.
  void note_todo(int t) {
    if (!triangles_[t].outside.empty()) todo_.emplace_back(t, triangles_[t].number);
  }
  int farthest_from(int a) const;
  int off_line(int a, int b) const;
  int off_plane(const Triangle& t) const;
  std::optional<std::string> start();
  void add(int t);
  void find_visible(int t, int apex);
  void cover_horizon(int apex);
  void hand_over();
  std::vector<int> in_order() const;
  std::vector<int> groups(const std::vector<int>& triangles) const;

  std::vector<Point> points_;
  std::vector<Approx3> approx_;
  std::vector<Triangle> triangles_;
  std::vector<std::pair<int, int>> todo_;  // triangles that had points outside, and their numbers
  std::vector<int> visible_, fresh_, dead_;
  int round_ = 0, made_ = 0;
};

}  // namespace findspace::space
