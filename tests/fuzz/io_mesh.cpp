// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Any bytes are a mesh or an Error, read as STL, OBJ, OFF, PLY, 3MF and GLB in turn, and as the model of a 3MF package;
// a mesh that is clean encloses the same volume when cleaned again. Read as a grid of heights they are a clean mesh.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "findspace/error.h"
#include "io/mesh/read_height_grid.h"
#include "io/mesh/read_mesh.h"
#include "io/mesh/zip_archive.h"
#include "space/mesh/mesh.h"

namespace {

void read_as(const std::string& bytes, const char* ending) {
  using namespace findspace;
  io::ReadContext context;
  context.options.files = false;
  context.unit = io::Unit::kMillimetre;
  try {
    space::Mesh mesh =
        io::parse_mesh(bytes, ending, context, [](const auto& stated) { return stated.value_or(exact::Real(1)); });
    space::clean(mesh, context.grid.step_size());
    const exact::Real once = space::six_volumes(mesh);
    space::clean(mesh, context.grid.step_size());
    if (space::six_volumes(mesh) != once) std::abort();
  } catch (const Error& error) {
    if (error.message().empty()) std::abort();
  }
}

void read_as_heights(const std::string& bytes) {
  using namespace findspace;
  io::ReadContext context;
  try {
    space::Mesh mesh = io::read_height_grid(bytes, 1, -1, context).mesh;
    const exact::Real once = space::six_volumes(mesh);
    if (!space::clean(mesh, context.grid.step_size()).empty() || space::six_volumes(mesh) != once) std::abort();
  } catch (const Error& error) {
    if (error.message().empty()) std::abort();
  }
}

// A 3MF package of this model. (Of mutated packages hardly one has the right sums.)
std::string package(const std::string& model) {
  return findspace::io::zip_bytes(
      {{"_rels/.rels", R"(<Relationships><Relationship Target="/3D/3dmodel.model" Id="r" )"
                       R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
                       R"(</Relationships>)"},
       {"3D/3dmodel.model", model}});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  for (const char* ending : {".stl", ".obj", ".off", ".ply", ".3mf", ".glb"}) read_as(bytes, ending);
  read_as_heights(bytes);
  if (bytes.starts_with('<')) read_as(package(bytes), ".3mf");
  return 0;
}
