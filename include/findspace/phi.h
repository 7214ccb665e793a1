// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Phi-function of two shapes A and B as a function of the translation u of B: negative where their interiors meet,
// 0 where they touch, positive where they are apart. Of flat parts it is the greatest of linear functions (the max
// form), of round ones the distance outside. The normalised form is the distance of A and B + u outside. It has a
// gradient, and says which facet of which pair of convex parts is active, so that optimisers of smooth functions can
// use it. Guarantee: state and `compare` are exact at every real position; values have a relative error of 2^-50, also
// next to contact. Inside unions minus the value is a lower bound of the true depth (docs/phi.md). Shapes of the plane
// that are not unions of polygons and discs go by curves: the value is `gap`, the true depth inside. Cost: building
// takes one surface for each pair of convex parts; a value takes a filter over their facets. Errors: kUnsupported for
// shapes of space that are not unions of convex parts, kGeometry for those that are not bodies, kBadValue for positions
// more than 2^500 grid steps away. Source: Stoyan et al., docs/phi.md. Keywords: phi-function, signed distance, no-fit
// polygon, penetration depth, gradient.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/number.h"
#include "findspace/shape.h"
#include "findspace/values.h"

namespace findspace {

class AdjustedPhi;

/// What a Phi-function is written with.
struct PhiQuestion {
  /// The name of A.
  std::string a = "A";
  /// The name of B.
  std::string b = "B";
  /// Of the shapes, or empty.
  std::string unit = {};
  /// Where B is translated to: two or three coordinates, or none.
  std::vector<Number> at = {};
  /// A least distance that is allowed there.
  std::optional<Number> least = {};
  /// A greatest one.
  std::optional<Number> greatest = {};
};

class Phi {
 public:
  /// A stands still, B moves. Both of the plane, or both of space.
  Phi(const Shape& a, const Shape& b);

  /// Of the two shapes: their interiors meet, only their boundaries meet, they have no common point.
  enum class State { kOverlap, kContact, kApart };
  struct Value {
    /// Of Phi.
    double value = 0;
    /// Of the normalised form: outside the distance.
    double normalised = 0;
    /// Exact.
    State state = State::kContact;
    Place gradient;               // of `value`: two or three coordinates; of length 1, or 0 where it is not defined
    Place normalised_gradient{};  // of `normalised`: outside it leads straight away from the nearest contact
    std::size_t pair = 0;         // the convex part of A times the number of those of B, plus that of B
    std::vector<int> active;      // facets (edges in the plane) of the pair that are highest, ties included
  };
  /// Where B is translated by u.
  Value at(const Point& u) const;
  Value at(const Point3& u) const;
  /// Value and gradient at each position, side by side; `values` and `gradients` are as long as `positions`.
  void evaluate(std::span<const Position> positions, std::span<double> values, std::span<Position> gradients) const;
  void evaluate(std::span<const Position3> positions, std::span<double> values, std::span<Position3> gradients) const;

  /// The sign of the normalised form minus a distance, for a distance >= 0, exactly: not negative where B + u is at
  /// least so far from A.
  int compare(const Point& u, const Number& distance) const;
  int compare(const Point3& u, const Number& distance) const;

  /// Adjusted for a least and for a greatest distance of A and B + u, which is not negative: Error(kBadValue).
  AdjustedPhi at_least(const Number& distance) const;
  AdjustedPhi at_most(const Number& distance) const;

  /// What it is of.
  const Shape& a() const;
  const Shape& b() const;
  /// 2 or 3.
  int dimension() const;
  /// By which way it is had: all convex parts of both, or the curves of contact, with `pair` 0 and nothing active.
  enum class Form { kParts, kCurves };
  Form form() const;
  /// Convex parts of A and of B; 0 by curves.
  std::size_t parts_of_a() const;
  std::size_t parts_of_b() const;
  /// Of space: the vertices of convex parts that had to be rounded.
  Shape::Rounded rounded_of_a() const;
  Shape::Rounded rounded_of_b() const;

  /// As `findspace phi` writes it, by the ending: ".json" and ".txt" have all parts and lines or planes, and the value
  /// at the position; ".svg" is a picture of the positions of overlap, or in space of the surface of contact, which
  /// ".obj", ".off" and ".stl" are too. Error(kUnsupported) for other endings, and for such a surface of a ball;
  /// Error(kBadValue) for a position with another number of coordinates, or a negative distance.
  std::string text(std::string_view ending, const PhiQuestion& question = {}) const;

  struct Data;
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// The Phi-function adjusted for a limit D of the distance: for a least one the normalised form minus D, for a greatest
/// one D minus the normalised form. It is not negative exactly where the limit is kept; overlap counts as near.
class AdjustedPhi {
 public:
  /// Which limit it is.
  enum class Limit { kLeast, kGreatest };
  /// Error(kBadValue) for a negative distance.
  AdjustedPhi(Phi phi, Limit limit, Number distance);

  struct Value {
    /// Its error is 2^-50 of the distance of the two and of the limit.
    double value = 0;
    /// Exact.
    int sign = 0;
    Place gradient;  // of `value`: of length 1, or 0 where it is not defined
  };
  /// Where B is translated by u.
  Value at(const Point& u) const;
  Value at(const Point3& u) const;
  /// Value and gradient at each position, as Phi::evaluate.
  void evaluate(std::span<const Position> positions, std::span<double> values, std::span<Position> gradients) const;
  void evaluate(std::span<const Position3> positions, std::span<double> values, std::span<Position3> gradients) const;

  /// What it is made of.
  const Phi& phi() const { return phi_; }
  Limit limit() const { return limit_; }
  const Number& distance() const { return distance_; }

 private:
  Value adjusted(const Phi::Value& found, int order) const;

  Phi phi_;
  Limit limit_;
  Number distance_;
  double rounded_ = 0;
};

}  // namespace findspace
