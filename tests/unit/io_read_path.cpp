// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SVG path data and outlines made of it.
#include <gtest/gtest.h>

#include "findspace/error.h"
#include "io/text/outline_shapes.h"
#include "io/text/svg_path.h"

namespace findspace::io {
namespace io_read_path {

using exact::Real;
using plane::GridPoint;
using plane::Shape;
using plane::ShapePtr;

/// Writes down what it is decided.
class Recorder : public PathSink {
 public:
  std::string log;
  void move_to(const Real& x, const Real& y) override { put("M", {x, y}); }
  void line_to(const Real& x, const Real& y) override { put("L", {x, y}); }
  void arc_to(const Real& r, bool large, bool sweep, const Real& x, const Real& y) override {
    put(large ? sweep ? "A11" : "A10" : sweep ? "A01" : "A00", {r, x, y});
  }
  void curve_to(std::span<const plane::CurvePoint> points) override {
    log += "C";
    for (const plane::CurvePoint& p : points) log += " " + p.x.text() + " " + p.y.text();
    log += " ";
  }
  void ellipse_to(const EllipseArc&, const Real& x, const Real& y) override { put("E", {x, y}); }
  void close() override { log += "Z "; }

 private:
  void put(const char* command, std::initializer_list<Real> values) {
    log += command;
    for (const Real& v : values) log += " " + v.text();
    log += " ";
  }
};

std::string commands(const char* data) {
  Recorder recorder;
  read_svg_path(data, recorder);
  return recorder.log;
}

void expect_refused(const char* data, ErrorCode code, const std::string& place) {
  try {
    commands(data);
    ADD_FAILURE() << data;
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), code) << data << ": " << e.what();
    EXPECT_EQ(e.place(), place) << data << ": " << e.what();
  }
}

TEST(SvgPath, Refuses) {
  expect_refused("", ErrorCode::kSyntax, "path, character 1");
  expect_refused("  ", ErrorCode::kSyntax, "path, character 3");
  expect_refused("L 1 1", ErrorCode::kSyntax, "path, character 1");
  expect_refused("M", ErrorCode::kSyntax, "path, character 2");
  expect_refused("M1", ErrorCode::kSyntax, "path, character 3");
  expect_refused("M0 0 H", ErrorCode::kSyntax, "path, character 7");
  expect_refused("M0 0 X", ErrorCode::kSyntax, "path, character 6");
  expect_refused("M0 0 L1 1 2", ErrorCode::kSyntax, "path, character 12");
  expect_refused("M0 0, L1 1", ErrorCode::kSyntax, "path, character 7");
  expect_refused("M0 0 C1 1 2 2 3", ErrorCode::kSyntax, "path, character 16");
  expect_refused("M0 0 q1 1 2", ErrorCode::kSyntax, "path, character 12");
  expect_refused("M0 0 A5 5 0 2 1 1 1", ErrorCode::kSyntax, "path, character 13");
  expect_refused("M0 0 Z 3 3", ErrorCode::kSyntax, "path, character 8");
  expect_refused("M0 0 Lnan 1", ErrorCode::kSyntax, "path, character 7");
}

TEST(SvgPath, AbsoluteAndRelative) {
  EXPECT_EQ(commands("M1,2L3 4"), "M 1 2 L 3 4 ");
  EXPECT_EQ(commands("m1 2l3 4h5v-6z"), "M 1 2 L 4 6 L 9 6 L 9 0 Z ");
  EXPECT_EQ(commands("M0 0H7V8h-1"), "M 0 0 L 7 0 L 7 8 L 6 8 ");
  EXPECT_EQ(commands("M1 1 l1 0 z l0 5"), "M 1 1 L 2 1 Z L 1 6 ");  // goes on at the start of the closed part
  EXPECT_EQ(commands("M1 1h1zm5 5h1"), "M 1 1 L 2 1 Z M 6 6 L 7 6 ");
}

TEST(SvgPath, ImplicitRepeats) {
  EXPECT_EQ(commands("M0 0 1 1 2 0"), "M 0 0 L 1 1 L 2 0 ");
  EXPECT_EQ(commands("m1 1 1 1 2 0"), "M 1 1 L 2 2 L 4 2 ");
  EXPECT_EQ(commands("M0 0H1 2 3"), "M 0 0 L 1 0 L 2 0 L 3 0 ");
  EXPECT_EQ(commands("M.5.5-1-1+2e0,3"), "M 0.5 0.5 L -1 -1 L 2 3 ");
}

TEST(SvgPath, ArcFlagsNeedNoSeparators) {
  EXPECT_EQ(commands("M0 0A5 5 0 0 1 10 0"), "M 0 0 A01 5 10 0 ");
  EXPECT_EQ(commands("M0 0a5,5,30,1010,0"), "M 0 0 A10 5 10 0 ");
  EXPECT_EQ(commands("M0 0a5 5 0 01.5.5"), "M 0 0 A01 5 0.5 0.5 ");
  EXPECT_EQ(commands("M0 0a1 1 0 002 0 1 1 0 0 0-2 0"), "M 0 0 A00 1 2 0 A00 1 0 0 ");
  EXPECT_EQ(commands("M0 0A0 0 0 0 1 3 4"), "M 0 0 L 3 4 ");
  EXPECT_EQ(commands("M0 0A-5 5 0 0 1 3 4"), "M 0 0 A01 5 3 4 ");
}

TEST(SvgPath, Curves) {
  EXPECT_EQ(commands("M0 0 C1 1 2 2 3 3 4 4 5 5 6 6"), "M 0 0 C 1 1 2 2 3 3 C 4 4 5 5 6 6 ");
  EXPECT_EQ(commands("M1 1 c1 1 2 2 3 3 s2 2 3 3"), "M 1 1 C 2 2 3 3 4 4 C 5 5 6 6 7 7 ");
  EXPECT_EQ(commands("M1 1 S2 2 3 4"), "M 1 1 C 1 1 2 2 3 4 ");  // no curve before
  EXPECT_EQ(commands("M0 0 Q1 2 4 0 T8 0 10 0"), "M 0 0 C 1 2 4 0 C 7 -2 8 0 C 9 2 10 0 ");
  EXPECT_EQ(commands("M0 0 Q1 2 4 0 S5 5 6 0"), "M 0 0 C 1 2 4 0 C 4 0 5 5 6 0 ");  // of another kind
  EXPECT_EQ(commands("M0 0 A5 3 20 0 1 1 1"), "M 0 0 E 1 1 ");
  EXPECT_EQ(commands("M0 0 A5 0 20 0 1 1 1"), "M 0 0 L 1 1 ");
}

/// The shape of a path on a grid of whole units.
struct Drawn {
  ReadContext context;
  ShapePtr shape;

  explicit Drawn(const char* data) {
    context.grid = Grid(1);
    Outline outline(context);
    struct Sink : PathSink {
      Outline& out;
      explicit Sink(Outline& o) : out(o) {}
      void move_to(const Real& x, const Real& y) override { out.move_to(x, y); }
      void line_to(const Real& x, const Real& y) override { out.line_to(x, y); }
      void arc_to(const Real& r, bool l, bool s, const Real& x, const Real& y) override { out.arc_to(r, l, s, x, y); }
      void curve_to(std::span<const plane::CurvePoint> points) override { out.curve_to(points); }
      void ellipse_to(const EllipseArc& arc, const Real& x, const Real& y) override { out.ellipse_to(arc, x, y); }
      void close() override { out.close(); }
    } sink(outline);
    read_svg_path(data, sink);
    shape = shape_of(outline.take(), context, "here");
  }
};

TEST(Outline, RefusesWhatDrawsNothing) {
  EXPECT_THROW(Drawn("M0 0"), Error);
  EXPECT_THROW(Drawn("M0 0 Z"), Error);
  EXPECT_THROW(Drawn("M0 0 L5 0 Z"), Error);
  EXPECT_THROW(Drawn("M0 0 L9 9 L9 0 L0 9 Z"), Error);
  EXPECT_THROW(Drawn("M0 0H9V9H0Z M5 5H15V15H5Z"), Error);  // rings that cross
  EXPECT_THROW(Drawn("M0 0 A1e15 1e15 0 0 1 9e11 0"), Error);
}

TEST(Outline, OpenPartsArePolylines) {
  Drawn open("M0 0 L5 0 L5 5");
  EXPECT_EQ(open.shape->kind, Shape::Kind::kPolyline);
  EXPECT_EQ(open.shape->contours[0].size(), 3u);
  EXPECT_EQ(Drawn("M0 0 L5 0 L5 5 L0 0").shape->kind, Shape::Kind::kRings);  // came back to its start
  Drawn both("M0 0 L5 0 L5 5 Z M9 9 L9 12");
  EXPECT_EQ(both.shape->kind, Shape::Kind::kUnion);
  EXPECT_EQ(both.shape->children.size(), 2u);
}

TEST(Outline, SubpathsNest) {
  Drawn nested("M0 0H9V9H0Z M2 2H7V7H2Z M4 4H5V5H4Z M20 0H29V9H20Z");
  ASSERT_EQ(nested.shape->kind, Shape::Kind::kUnion);
  ASSERT_EQ(nested.shape->children.size(), 3u);
  EXPECT_EQ(nested.shape->children[0]->contours.size(), 2u);
  EXPECT_EQ(nested.shape->children[1]->contours.size(), 1u);  // the island in the hole
}

TEST(Outline, CircleOfTwoArcsAndHoles) {
  Drawn ring("M-5 0A5 5 0 0 1 5 0A5 5 0 0 1-5 0Z M-2 0A2 2 0 0 0 2 0A2 2 0 0 0-2 0Z");
  ASSERT_EQ(ring.shape->kind, Shape::Kind::kRings);
  ASSERT_EQ(ring.shape->contours.size(), 2u);
  EXPECT_TRUE(ring.shape->contours[0][0].ccw);
  EXPECT_FALSE(ring.shape->contours[1][0].ccw);
  EXPECT_EQ(ring.shape->contours[1][0].arc->r.integer(), exact::int128(2));
}

TEST(Outline, ArcsThatAreTooSmallGrowAndFlatOnesAreLines) {
  Drawn grown("M0 0A3 3 0 0 1 10 0Z");
  EXPECT_EQ(grown.context.grown_arcs, 1);
  EXPECT_EQ(grown.shape->contours[0][0].arc->r.integer(), exact::int128(5));
  Drawn flat("M0 0A100000 100000 0 0 1 10 0V10Z");
  EXPECT_FALSE(flat.shape->contours[0][0].arc);
  EXPECT_EQ(flat.context.rounding.points, 1);
}

TEST(Outline, RoundedEndsStayOnTheirCircle) {
  Drawn rounded("M0.3 0.2 A7.77 7.77 0 0 1 9.6 3.4 V-9 Z");
  const plane::Contour& ring = rounded.shape->contours[0];
  int arcs = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!ring[i].arc) continue;
    ++arcs;
    for (GridPoint p : {ring[i].start, ring[(i + 1) % ring.size()].start}) {
      Real dx = Real(p.x) - ring[i].arc->cx, dy = Real(p.y) - ring[i].arc->cy;
      EXPECT_EQ(compare(dx * dx + dy * dy, ring[i].arc->r * ring[i].arc->r), 0);
    }
  }
  EXPECT_EQ(arcs, 1);
  EXPECT_EQ(rounded.context.rounding.points, 3);
}

TEST(Outline, JoinsLinesEndToEnd) {
  ReadContext context;
  context.grid = Grid(1);
  Outline outline(context);
  auto line = [&](int ax, int ay, int bx, int by) {
    outline.move_to(ax, ay);
    outline.line_to(bx, by);
    outline.finish();
  };
  line(10, 10, 10, 0);  // against the others
  line(0, 0, 10, 0);
  line(10, 10, 0, 10);
  outline.move_to(0, 10);
  outline.arc_to(5, false, true, 0, 0);
  outline.finish();
  line(20, 0, 30, 0);
  line(20, 5, 20, 0);
  Drawing drawing = outline.take();
  join_open_chains(drawing, 1);
  EXPECT_EQ(drawing.chains.size(), 2u);
  EXPECT_EQ(open_chains(drawing), 1);
  std::vector<ShapePtr> parts = parts_of(std::move(drawing), context, "here");
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0]->kind, Shape::Kind::kRings);
  EXPECT_EQ(parts[0]->contours[0].size(), 4u);
  EXPECT_EQ(parts[1]->contours[0].size(), 3u);

  Outline fork(context);
  for (int i = 0; i < 3; ++i) {
    fork.move_to(0, 0);
    fork.line_to(5, i);
    fork.finish();
  }
  Drawing forked = fork.take();
  EXPECT_THROW(join_open_chains(forked, 1), Error);
}

}  // namespace io_read_path
}  // namespace findspace::io
