// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The program `findspace`. Under mpirun it would run once for each rank, so it says which program is meant there.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "command_line/command_line.h"

namespace {

/// What Open MPI, and MPICH and its kin, tell the processes that they start.
bool started_by_mpirun() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* size = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing here sets the environment
    if (size != nullptr && std::string_view(size) != "1") return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (started_by_mpirun()) {
    std::fputs(
        "findspace: started by mpirun: each rank would do the same; findspace-mpi shares the work (docs/batch.md)\n",
        stderr);
    return findspace::app::kUsage;
  }
  return findspace::app::run_program(argc, argv, nullptr);
}
