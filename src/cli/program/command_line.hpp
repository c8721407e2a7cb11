#pragma once

#include "cli/shell/context.hpp"

namespace sarsim::workflow {
class Team;
}

namespace sarsim::cli {

/// Runs one command line of the program `sarsim` and returns its exit status: 0 done, 1 failed, 2 bad input, 75 try
/// again, 128 + the signal when interrupted. `sarsim SCENE ...` means `sarsim run SCENE ...`. Throws nothing.
int run_command_line(int argc, const char* const* argv, Streams streams);

/// The program: signals, standard streams, `run_command_line`.
int main_program(int argc, const char* const* argv);

/// The program sarsim-mpi: the command `run`, carried out by processes together, of which only the leader writes to
/// standard output and error; another one does where it fails alone.
/// @param team  nothing where the program was not started by an MPI launcher; it then says how to start it
int team_program(int argc, const char* const* argv, workflow::Team* team);

}  // namespace sarsim::cli
