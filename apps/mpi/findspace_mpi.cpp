// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The program `findspace-mpi`: the verbs of `findspace` under mpirun. Maps on lines are made by all ranks together, a
// batch is divided among them. Every other question is answered by rank 0.
#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include "command_line/command_line.h"
#include "mpi/mpi_team.h"

namespace {

/// The other ranks say nothing: rank 0 says the same.
void be_silent() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int status = 0;
  {
    findspace::app::MpiTeam team(MPI_COMM_WORLD);
    if (!team.leads()) be_silent();
    status = findspace::app::run_program(argc, argv, &team);
    if (!team.leads()) status = 0;
    team.finish();
  }
  MPI_Finalize();
  return status;
}
