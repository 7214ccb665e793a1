// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// STEP written: numbers, names, units, pieces and labels, open surfaces; read back where CAD files are read.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include "io/cad/read_cad.h"
#include "io/mesh/mesh_step.h"
#include "space/mesh/mesh.h"

namespace findspace::io {
namespace io_mesh_step {

/// A box [x, x + 1] x [0, 0.1] x [0, 2].
void add_box(Surface& s, double x, const char* label) {
  const int first = int(s.vertices.size());
  for (int i = 0; i < 8; ++i) s.vertices.push_back({i & 1 ? x + 1 : x, i & 2 ? 0.1 : 0, i & 4 ? 2.0 : 0.0});
  for (std::vector<int> face : std::vector<std::vector<int>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    for (int& v : face) v += first;
    s.faces.push_back(std::move(face));
    s.labels.emplace_back(label);
  }
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(IoMeshStep, SolidsAndProducts) {
  Surface s;
  add_box(s, 0, "a#0");
  add_box(s, 1e-7, "a#0");
  add_box(s, 2.5, "b's \xC3\xBC");
  const std::string text = step_text(s, "title", "mm");
  EXPECT_EQ(count(text, "=FACETED_BREP("), 3U);
  EXPECT_EQ(count(text, "=PRODUCT("), 3U);  // two parts and what holds them
  EXPECT_EQ(count(text, "=NEXT_ASSEMBLY_USAGE_OCCURRENCE("), 2U);
  EXPECT_NE(text.find("PRODUCT('b''s __','b''s __'"), std::string::npos);
  EXPECT_NE(text.find("(1.E-07,0.,0.)"), std::string::npos);
  EXPECT_NE(text.find("(2.5,0.1,0.)"), std::string::npos);
  EXPECT_NE(text.find(".MILLI."), std::string::npos);
  EXPECT_NE(step_text(s, "title", "mil").find("0.0254"), std::string::npos);
}

TEST(IoMeshStep, OpenSurfacesAreRefused) {
  Surface s;
  add_box(s, 0, "a");
  s.faces.pop_back();
  EXPECT_THROW(step_text(s, "", "mm"), Error);
  s.faces = {{0, 1}};
  EXPECT_THROW(step_text(s, "", "mm"), Error);
}

TEST(IoMeshStep, ReadsBack) {
  if (!has_cad()) GTEST_SKIP() << "libfindspace_cad.so is not built";
  Surface s;
  add_box(s, 0, "one");
  add_box(s, 7, "two");
  for (const auto& [unit, factor] : {std::pair{"mm", 1.0}, {"in", 25.4}, {"cm", 10.0}, {"um", 0.001}}) {
    ReadContext context;
    context.grid = Grid(exact::Real::parse_decimal("1e-8"));
    context.unit = Unit::kMillimetre;
    context.use({});
    const std::vector<CadPart> parts = read_cad(step_text(s, "t", unit), ".step", context, exact::Real(1));
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[1].name, "two");
    EXPECT_NEAR(space::six_volumes(parts[1].solid.mesh).to_double() / 6e24 / (factor * factor * factor), 0.2, 1e-9);
  }
}

}  // namespace io_mesh_step
}  // namespace findspace::io
