// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The frame that maps the scene (y up, or down where it says so) to pixels (y down), and paths in it with true arcs.
// Arcs are given in parts of less than half a circle, which no viewer can mistake. Keywords: vector graphics,
// elliptical arc command, viewport.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "plane/query/curve_net.h"

namespace findspace::io {

using plane::CurveNet;
using Curve = CurveNet::Curve;
using Ring = CurveNet::Ring;
using Side = CurveNet::Side;

/// Text fit for an XML text or attribute.
std::string xml_escaped(std::string_view text);

/// A number of pixels, to a thousandth.
std::string pixels(double value);

/// Where the scene is in the picture.
struct Frame {
  plane::Bounds world;       // what is shown
  double scale = 1;          // pixels per unit
  double left = 0, top = 0;  // of the world's upper left corner, in pixels
  bool y_down = false;       // the world's y axis runs downwards as well
  double x(double wx) const { return left + (wx - world.low[0]) * scale; }
  double y(double wy) const { return top + (y_down ? wy - world.low[1] : world.high[1] - wy) * scale; }
  double world_x(double px) const { return world.low[0] + (px - left) / scale; }
  double world_y(double py) const {
    return y_down ? world.low[1] + (py - top) / scale : world.high[1] - (py - top) / scale;
  }
  double width() const { return (world.high[0] - world.low[0]) * scale; }
  double height() const { return (world.high[1] - world.low[1]) * scale; }
};

/// Path data of a net's curves, moved by `offset`, in a frame's pixels.
class PathWriter {
 public:
  /// To a thousandth of a pixel, or to thirteen digits, which is what a double has without the noise of computing.
  enum class Digits { kPixels, kAll };

  PathWriter(const CurveNet& net, const Frame& frame, const plane::Place& offset = {}, Digits digits = Digits::kPixels)
      : net_(net), frame_(frame), offset_(offset), digits_(digits) {}

  /// All rings of a face, to be filled by the even-odd rule. Around an unbounded face that is the frame.
  void add_face(const plane::Face& face);
  /// All faces with a mark other than 0.
  void add_faces();
  void add_ring(const Ring& ring);
  /// Open: a whole circle is two arcs, so that no reader takes it for a disc.
  void add_curve(const Curve& curve);
  /// Those that meet at their ends as lines that go on, each from a curve that none has.
  void add_curves(std::span<const Curve* const> curves);
  const std::string& data() const { return data_; }

 private:
  void add_frame();
  std::string number(double value) const;
  void put(char command, const plane::Place& p);
  void travel(const Curve& curve, bool forward);
  void arc_to(const plane::Place& p, double radius, bool ccw);

  const CurveNet& net_;
  const Frame& frame_;
  plane::Place offset_;
  Digits digits_;
  std::string data_;
};

}  // namespace findspace::io
