// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the names of shapes stand: in the shape, on no smaller one, clear of the region's lines and of other names;
// beside the shape where it is too small. Where all cannot be had, a name stands in the middle of its shape. In
// pictures of many small shapes a name is written small, or upwards, before it leaves its shape. Keywords: label
// placement, cartographic labelling.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/draw/draw_canvas.h"
#include "plane/query/locate.h"

namespace findspace::io {

/// A shape in the picture, drawn moved by `offset`.
struct LabelledShape {
  std::string name;
  const CurveNet* net = nullptr;
  plane::Summary summary;
  plane::Place offset{};
};

class Labeller {
 public:
  /// Keeps references to all of them. `small`: names may be small.
  Labeller(const Frame& frame, const exact::Real& step, std::vector<LabelledShape> shapes, bool small = false);

  /// Keeps labels away from a point, from the curves of a shape moved by `offset`, and from those of the region.
  void avoid(const plane::Place& point, double radius);
  void avoid_curves(const CurveNet& shape, const plane::Place& offset);
  void avoid_region(const CurveNet& region);
  /// Keeps them away from a text whose middle is at a place in pixels.
  void avoid_text(const plane::Place& middle, std::string_view text, double font);

  /// The labels as SVG; smaller shapes choose first.
  std::string labels();

 private:
  using Box = plane::Bounds;  // in pixels
  /// How large a name is written, and whether upwards.
  struct Size {
    double font;
    bool upwards = false;
  };
  struct Label {
    Box box;
    Size size;
  };
  static Box box_around(double x, double y, std::string_view text, const Size& size);
  Box around(const plane::Place& point, double radius) const;
  /// Within the frame and off what is to be avoided; lines may cross an open place.
  bool is_free(const Box& b) const;
  bool is_open(const Box& b) const;
  bool lies_in(const LabelledShape& shape, plane::Locator& locator, const Box& b) const;
  bool meets_smaller(std::size_t shape, const Box& b) const;
  Box pixel_box(const LabelledShape& shape, const plane::Bounds& b) const;
  bool is_on_region(const Box& b);
  exact::RealPoint position(double px, double py, const plane::Place& offset) const;
  bool meets_other(std::size_t shape, const Box& b) const;
  std::optional<Box> place_inside(std::size_t shape, const Size& size);
  std::optional<Box> place_beside(std::size_t shape, const Size& size) const;
  std::optional<Label> place(std::size_t shape);

  const Frame& frame_;
  const exact::Real& step_;
  std::vector<LabelledShape> shapes_;  // from small to large
  bool small_;
  std::vector<Box> taken_, lines_, names_;
  std::optional<plane::Locator> region_;
};

/// The component people look at first: unbounded ones, then large ones. Null if there is none.
const plane::Component* largest(const plane::Summary& summary);

/// One label, its middle at (x, y).
std::string label_text(double x, double y, std::string_view text);
std::string label_text(double x, double y, std::string_view text, double font, bool upwards);

}  // namespace findspace::io
