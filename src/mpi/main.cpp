#include <cstdint>
#include <cstdlib>

#include <mpi.h>

#include <hwy/nanobenchmark.h>

#include "cli/program/command_line.hpp"
#include "mpi/mpi_team.hpp"

// See cli/program/main.cpp.
std::uint64_t hwy::platform::TimerResolution() { return 1; }

namespace {

// What the launchers of Open MPI, MPICH and Slurm tell the processes that they start.
bool started_by_mpi() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK", "PMI_RANK", "MPI_LOCALNRANKS"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (!started_by_mpi()) return sarsim::cli::team_program(argc, argv, nullptr);
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  int status = 0;
  {
    sarsim::mpi::MpiTeam team;
    status = sarsim::cli::team_program(argc, argv, &team);
    // The others wait for this process, and would for ever.
    if (status != 0 && !team.failure_is_known()) MPI_Abort(MPI_COMM_WORLD, status);
  }
  MPI_Finalize();
  return status;
}
