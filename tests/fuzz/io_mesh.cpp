// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Any bytes are a mesh or an Error, read as STL, OBJ, OFF and PLY in turn; a mesh that is clean encloses the same
// volume when cleaned again.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "findspace/error.h"
#include "io/mesh/read_mesh.h"
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  for (const char* ending : {".stl", ".obj", ".off", ".ply", ".3mf", ".glb"}) read_as(bytes, ending);
  return 0;
}
