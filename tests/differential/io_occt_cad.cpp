// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids that Open CASCADE builds and writes as STEP and IGES, read here: volumes against those that it computes,
// within the bound and on the side that was asked for, and the corners of the meshes on that side of the true solid.
#include <findspace/error.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/cad/read_cad.h"
#include "space/mesh/mesh.h"

// Headers of Open CASCADE come last: they define names of their own.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

namespace findspace::io {
namespace io_occt_cad {

using exact::Real;

/// The file that `write` makes.
template <class Write>
std::string written(Write write) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const std::filesystem::path path = std::filesystem::temp_directory_path() / fmt::format("findspace-cad-{}", getpid());
  write(path.c_str());
  std::ifstream in(path);
  std::stringstream out;
  out << in.rdbuf();
  std::filesystem::remove(path);
  return out.str();
}

std::string step(const TopoDS_Shape& shape) {
  return written([&](const char* path) {
    STEPControl_Writer writer;
    writer.Transfer(shape, STEPControl_AsIs);
    writer.Write(path);
  });
}

std::string iges(const TopoDS_Shape& shape, bool solids) {
  return written([&](const char* path) {
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", solids ? 1 : 0);
    writer.AddShape(shape);
    writer.ComputeModel();
    writer.Write(path);
  });
}

struct Measured {
  double volume, area;
};
Measured measured(const TopoDS_Shape& shape) {
  GProp_GProps volume, area;
  BRepGProp::VolumeProperties(shape, volume, 1e-7);
  BRepGProp::SurfaceProperties(shape, area, 1e-7);
  return {volume.Mass(), area.Mass()};
}

std::vector<CadPart> parts(const std::string& bytes, const std::string& ending, CurveRule curves, double tolerance,
                           bool balls) {
  ReadContext context;
  context.unit = Unit::kMillimetre;
  DrawingRules rules;
  rules.curves = curves;
  rules.tolerance = fmt::format("{}", tolerance);
  context.use(rules);
  return read_cad(bytes, ending, context, Real(1), {.balls = balls});
}

space::Solid read(const std::string& bytes, const std::string& ending, CurveRule curves, double tolerance) {
  const std::vector<CadPart> all = parts(bytes, ending, curves, tolerance, false);
  EXPECT_EQ(all.size(), 1U);
  return all.at(0).solid;
}

double volume(const space::Solid& solid) { return space::six_volumes(solid.mesh).to_double() / 6e18; }

/// Corners on the wrong side of the true solid.
int wrong(const space::Solid& solid, const TopoDS_Shape& shape, TopAbs_State forbidden) {
  constexpr double kSurface = 1e-6;  // counts as on it
  int count = 0;
  BRepClass3d_SolidClassifier classifier(shape);
  for (std::size_t k = 0; k < solid.mesh.vertices.size(); k += 1 + solid.mesh.vertices.size() / 200) {
    const space::Point& p = solid.mesh.vertices[k];
    classifier.Perform(gp_Pnt(double(p.x) / 1e6, double(p.y) / 1e6, double(p.z) / 1e6), kSurface);
    count += classifier.State() == forbidden;
  }
  return count;
}

void check(const TopoDS_Shape& shape, const std::string& bytes, const std::string& ending, double tolerance = 0.05) {
  if (!has_cad()) GTEST_SKIP() << "libfindspace_cad.so is not built";
  const Measured truth = measured(shape);
  const double most = tolerance * truth.area * 1.2;
  const auto with = [&](CurveRule rule) { return read(bytes, ending, rule, tolerance); };
  EXPECT_NEAR(volume(with(CurveRule::kNear)), truth.volume, most);
  const space::Solid inside = with(CurveRule::kInside), outside = with(CurveRule::kOutside);
  EXPECT_LT(volume(inside), truth.volume);
  EXPECT_NEAR(volume(inside), truth.volume, most);
  EXPECT_GT(volume(outside), truth.volume);
  EXPECT_NEAR(volume(outside), truth.volume, most);
  EXPECT_EQ(wrong(inside, shape, TopAbs_OUT), 0);
  EXPECT_EQ(wrong(outside, shape, TopAbs_IN), 0);
}

std::size_t balls(const TopoDS_Shape& shape) {
  return parts(step(shape), ".step", CurveRule::kNear, 0.05, true).at(0).balls.size();
}

TopoDS_Shape plate() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 20, 10, 5);
  return BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(10, 5, -1), gp_Dir(0, 0, 1)), 2.5, 10).Shape());
}

TopoDS_Shape rounded_box() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(6, 5, 4);
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next()) fillet.Add(1, TopoDS::Edge(edge.Current()));
  return fillet.Shape();
}

TopoDS_Shape tilted(const TopoDS_Shape& shape) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 3)), 0.7);
  return BRepBuilderAPI_Transform(shape, turn).Shape();
}

TEST(IoOcctCad, PlateWithHole) { check(plate(), step(plate()), ".step"); }
TEST(IoOcctCad, PlateWithHoleTilted) { check(tilted(plate()), step(tilted(plate())), ".step"); }
TEST(IoOcctCad, Cylinder) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(3, 10);
  check(shape, step(shape), ".step");
  check(shape, iges(shape, true), ".igs");
  check(shape, iges(shape, false), ".igs");  // faces alone, sewn
}
TEST(IoOcctCad, Cone) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCone(4, 0, 6);
  check(shape, step(shape), ".step");
}
TEST(IoOcctCad, Frustum) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCone(4, 2, 6);
  check(shape, step(shape), ".step");
}
TEST(IoOcctCad, Sphere) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeSphere(gp_Pnt(1, 2, 3), 2.5);
  check(shape, step(shape), ".step");
}
TEST(IoOcctCad, Torus) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeTorus(6, 2);
  check(shape, step(shape), ".step");
}
TEST(IoOcctCad, RoundedBox) { check(rounded_box(), step(rounded_box()), ".step"); }
TEST(IoOcctCad, CrossedCylinders) {
  const TopoDS_Shape upright = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -5), gp_Dir(0, 0, 1)), 2, 10);
  const TopoDS_Shape lying = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-5, 0, 0), gp_Dir(1, 0, 0)), 1.5, 10);
  const TopoDS_Shape shape = BRepAlgoAPI_Fuse(upright, lying);
  check(shape, step(shape), ".step");
}
TEST(IoOcctCad, FreeForms) {
  const TopoDS_Shape shape = BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(6, 2).Shape()).Shape();
  check(shape, step(shape), ".step", 0.2);
}

TEST(IoOcctCad, HullsOfBallsAreExact) {
  if (!has_cad()) GTEST_SKIP() << "libfindspace_cad.so is not built";
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(0, 1, 0)), 1.5, 8);
  const TopoDS_Shape low = BRepPrimAPI_MakeSphere(gp_Pnt(1, 2, 3), 1.5),
                     high = BRepPrimAPI_MakeSphere(gp_Pnt(1, 10, 3), 1.5);
  const TopoDS_Shape capsule = BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(rod, low).Shape(), high);
  EXPECT_EQ(balls(capsule), 2U);
  EXPECT_EQ(balls(BRepAlgoAPI_Fuse(rod, low).Shape()), 0U);  // one end is flat
  EXPECT_EQ(balls(BRepAlgoAPI_Cut(rod, high).Shape()), 0U);  // one end is hollow
  EXPECT_EQ(balls(rounded_box()), 8U);
  EXPECT_EQ(balls(BRepPrimAPI_MakeSphere(2).Shape()), 1U);
  EXPECT_EQ(balls(BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 2, 0, 1.5).Shape()),
            0U);  // half of it
}

}  // namespace io_occt_cad
}  // namespace findspace::io
