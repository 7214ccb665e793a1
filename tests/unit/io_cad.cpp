// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// STEP and IGES as scenes read them: solids of planes with the file's decimals, balls, assemblies by name, units, and
// files that are cut off, empty, of another schema, or open (tests/cad). Without the library: what is said then.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "io/cad/read_cad.h"
#include "io/mesh/read_mesh.h"
#include "io/scene/scene.h"
#include "space/mesh/mesh.h"

namespace findspace::io {
namespace io_cad {

using exact::Real;
using space::Solid;

std::string bytes_of(const std::string& name) {
  std::ifstream in(std::string(FINDSPACE_SOURCE "/tests/cad/") + name);
  std::stringstream out;
  out << in.rdbuf();
  return out.str();
}

ReadContext context_with(std::optional<CurveRule> curves = {}, const char* tolerance = "0.01") {
  ReadContext context;
  context.unit = Unit::kMillimetre;
  DrawingRules rules;
  rules.curves = curves;
  rules.tolerance = tolerance;
  context.use(rules);
  return context;
}

std::vector<CadPart> read(const std::string& bytes, ReadContext& context, const CadChoice& choice = {},
                          const std::string& ending = ".step") {
  return read_cad(bytes, ending, context, Real(1), choice);
}

/// The error, or "".
std::string said(const std::string& bytes, const CadChoice& choice = {}, const std::string& ending = ".step") {
  ReadContext context = context_with();
  try {
    read(bytes, context, choice, ending);
  } catch (const Error& e) {
    return e.message();
  }
  return "";
}

/// In cubic millimetres.
double volume(const Solid& solid) { return space::six_volumes(solid.mesh).to_double() / 6e18; }

class IoCad : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_cad()) GTEST_SKIP() << "libfindspace_cad.so is not built";
  }
};

TEST(IoCadLibrary, SaysWhatIsMissing) {
  if (has_cad()) GTEST_SKIP();
  EXPECT_NE(said(bytes_of("bracket.step")).find("libocct-data-exchange-dev"), std::string::npos);
}

TEST_F(IoCad, SolidOfPlanesHasTheDecimalsOfTheFile) {
  ReadContext context = context_with();
  const std::vector<CadPart> parts = read(bytes_of("bracket.step"), context);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].solid.form, Solid::Form::kMesh);
  EXPECT_EQ(space::six_volumes(parts[0].solid.mesh), Real(6 * 2221) * Real::parse_decimal("1e18"));
  EXPECT_EQ(context.rounding.points, 0);
  const auto& vertices = parts[0].solid.mesh.vertices;
  EXPECT_EQ(std::count(vertices.begin(), vertices.end(), space::Point{4125000, 12250000, 4000000}), 1);
}

TEST_F(IoCad, UnitOfTheFileIsConverted) {
  ReadContext context = context_with();
  const std::vector<CadPart> parts = read(bytes_of("bracket.igs"), context, {}, ".igs");
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(volume(parts[0].solid), 2221, 1e-4);
}

TEST_F(IoCad, AssemblyIsPlacedAndNamed) {
  ReadContext context = context_with();
  const std::vector<CadPart> parts = read(bytes_of("assembly.step"), context);
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_EQ(parts[0].name, "plate");
  EXPECT_EQ(parts[2].name, "pin");
  const auto& turned = parts[1].solid.mesh.vertices;  // [0, 10] x [0, 6] x [0, 2] by 90 degrees, then up
  ASSERT_EQ(turned.size(), 8U);
  EXPECT_EQ(std::count(turned.begin(), turned.end(), space::Point{94000000, 0, 20000000}), 1);
  EXPECT_EQ(std::count(turned.begin(), turned.end(), space::Point{100000000, 10000000, 22000000}), 1);
  ASSERT_EQ(parts[3].balls.size(), 1U);
  EXPECT_EQ(parts[3].balls[0].form, Solid::Form::kBall);
  EXPECT_EQ(parts[3].balls[0].mesh.vertices[0], (space::Point{101000000, 2000000, 3000000}));
  EXPECT_EQ(parts[3].balls[0].radius, Real(2500000));
  EXPECT_EQ(context.rounding.points, 0);
}

TEST_F(IoCad, PartsAreChosen) {
  const std::string bytes = bytes_of("assembly.step");
  ReadContext context = context_with();
  EXPECT_EQ(read(bytes, context, {.id = "plate"}).size(), 2U);
  EXPECT_EQ(read(bytes, context, {.id = "plate turned"}).size(), 1U);
  EXPECT_EQ(read(bytes, context, {.id = "half"}).size(), 3U);
  EXPECT_EQ(read(bytes, context, {.id = "first half"}).size(), 3U);
  EXPECT_EQ(read(bytes, context, {.id = "assembly", .index = 3}).size(), 1U);
  EXPECT_EQ(read(bytes, context, {.id = "plate", .index = 1})[0].solid.mesh.vertices.size(), 8U);
  EXPECT_EQ(read(bytes, context, {.id = "ball", .balls = false})[0].solid.form, Solid::Form::kMesh);
  EXPECT_NE(said(bytes, {.id = "nut"}).find("there are plate, pin, ball"), std::string::npos);
  EXPECT_NE(said(bytes, {.index = 4}).find("4 solids"), std::string::npos);
}

TEST_F(IoCad, PinLiesOnItsSide) {
  const double exact = 1.5 * 1.5 * 8 * 3.14159265358979;
  const auto pin = [&](CurveRule rule) {
    ReadContext context = context_with(rule);
    return volume(read(bytes_of("assembly.step"), context, {.id = "pin"})[0].solid);
  };
  EXPECT_LT(pin(CurveRule::kInside), exact);
  EXPECT_GT(pin(CurveRule::kOutside), exact);
  const double area = 2 * 3.14159265358979 * 1.5 * (8 + 1.5);
  for (const CurveRule rule : {CurveRule::kInside, CurveRule::kOutside, CurveRule::kNear})
    EXPECT_NEAR(pin(rule), exact, 0.01 * area * 1.1);
}

TEST_F(IoCad, BadFilesAreRefused) {
  const std::string whole = bytes_of("bracket.step");
  EXPECT_NE(said("").find("no STEP file"), std::string::npos) << said("");
  for (const double part : {0.2, 0.5, 0.8})
    EXPECT_NE(said(whole.substr(0, std::size_t(double(whole.size()) * part))), "");
  EXPECT_NE(said("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n"), "");
  const std::string building =
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
      "FILE_SCHEMA(('IFC2X3'));\nENDSEC;\nDATA;\n#1=IFCCARTESIANPOINT((0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n";
  EXPECT_NE(said(building).find("no solid"), std::string::npos) << said(building);
  EXPECT_NE(said(bytes_of("open.step")).find("is not closed: 4 edges"), std::string::npos);
  EXPECT_NE(said("nothing of IGES", {}, ".igs"), "");
  const std::string cards = bytes_of("bracket.igs");
  EXPECT_NE(said(cards.substr(0, cards.size() / 2), {}, ".igs"), "");
}

/// The text with the first `from` after `at` as `to`.
std::string with(std::string text, const std::string& from, const std::string& to, const std::string& at = "") {
  const std::size_t found = text.find(from, text.find(at));
  EXPECT_NE(found, std::string::npos) << from;
  return found == std::string::npos ? text : text.replace(found, from.size(), to);
}

/// Open CASCADE drops what it does not know, or crashes on it.
TEST_F(IoCad, PartsThatAreNotUnderstoodAreRefused) {
  const std::string whole = bytes_of("assembly.step");
  const auto says = [](const std::string& bytes, const std::string& words) {
    EXPECT_NE(said(bytes).find(words), std::string::npos) << said(bytes) << " should say " << words;
  };
  says(with(whole, "MANIFOLD_SOLID_BREP", "MANIFOLD_SOLID_BREX", "#242 ="), "#242 (MANIFOLD_SOLID_BREX)");
  says(with(whole, "SPHERICAL_SURFACE", "SPHERICAL_SURFAXE"), "(SPHERICAL_SURFAXE)");
  says(with(whole, "NEXT_ASSEMBLY_USAGE", "NEXT_ASSEMBLY_USE"), "(NEXT_ASSEMBLY_USE_OCCURRENCE)");
  says(with(whole, "= SHAPE_DEFINITION_", "= SHAPED_DEFINITION_"), "(SHAPED_DEFINITION_REPRESENTATION)");
  says(with(whole, "= CONTEXT_DEPENDENT_", "= CONTEXT_FREE_"), "(CONTEXT_FREE_SHAPE_REPRESENTATION)");
  const std::string bracket = bytes_of("bracket.step");
  says(with(bracket, "'',#", "'',#99999", "= VECTOR("), "Unresolved Reference");
  says(with(bracket, "'',#", "'',#99999", "= VERTEX_POINT("), "Unresolved Reference");
  says(with(bracket, "CARTESIAN_POINT", "CARTESIAN_PIONT"), "(CARTESIAN_PIONT)");
}

/// Open CASCADE runs without end on nan.
TEST_F(IoCad, WhatIsNoNumberIsRefused) {
  const auto says = [](const std::string& bytes, const std::string& words, const std::string& ending = ".step") {
    EXPECT_NE(said(bytes, {}, ending).find(words), std::string::npos)
        << said(bytes, {}, ending) << " should say " << words;
  };
  const std::string step = bytes_of("bracket.step"), iges = bytes_of("bracket.igs");
  const std::string at = "VERTEX_POINT";
  says(with(step, "(0.", "(nan", at), "'nan' is not a value");
  says(with(step, "(0.", "(1.2.3", at), "'1.2.3' is not a number");
  says(with(step, "(0.", "(1.E300", at), ", line ");
  says(with(step, "(0.", "(1.E300", at), "'1.E300' is too large");
  EXPECT_EQ(said(with(step, "('',", "('nan /* 1.E300',", at)), "");
  says(with(iges, "123,0.", "123,na"), "'na' is not a number", ".igs");
  says(with(iges, "123,0.,0.,1.;    ", "123,0.,0.,1.E300;"), "'1.E300' is too large", ".igs");
  says(with(iges, "123,0.,0.,1.;", "123,0.,0.,1.E3;"), "column 73", ".igs");
  says(step.substr(0, step.size() / 2), "cut off");
  says(iges.substr(0, iges.size() / 2), "cut off", ".igs");
}

/// A face of no loop, as the card has it.
TEST_F(IoCad, CrashesAreRefusals) {
  const std::string problem = said(with(bytes_of("bracket.igs"), "510,197,1,1,205;", "510,197,0,1,205;"), {}, ".igs");
  EXPECT_NE(problem.find("Open CASCADE"), std::string::npos) << problem;
}

TEST_F(IoCad, OneMeshOfAllSolids) {
  ReadContext context = context_with();
  space::Mesh mesh = parse_mesh(bytes_of("assembly.step"), ".step", context, [](const auto& mm) { return *mm; });
  space::clean(mesh, 1e-6);
  EXPECT_NEAR(space::six_volumes(mesh).to_double() / 6e18, 120 + 120 + 56.55 + 65.45, 1);
}

TEST_F(IoCad, ScenesTakeParts) {
  const auto scene = [](const std::string& more) {
    return R"({"findspace": 1, "unit": "mm", "shapes": {"a": {"file": ")" FINDSPACE_SOURCE
           R"(/tests/cad/assembly.step")" +
           more + "}}}";
  };
  EXPECT_EQ(read_scene_text(scene(""), "", "s").shapes.size(), 1U);
  EXPECT_EQ(read_scene_text(scene(R"(, "id": "plate", "index": 0)"), "", "s").shapes.size(), 1U);
  EXPECT_THROW(read_scene_text(scene(R"(, "layer": "x")"), "", "s"), Error);
  EXPECT_THROW(read_scene_text(scene(R"(, "unit": "in")"), "", "s"), Error);
}

}  // namespace io_cad
}  // namespace findspace::io
