#include <cstdint>

#include <hwy/nanobenchmark.h>

#include "cli/program/command_line.hpp"

// Highway's library times the processor's clock for 2.5 ms whenever it is loaded, for benchmarks that this program does
// not run. It finds this answer in the place of its own.
std::uint64_t hwy::platform::TimerResolution() { return 1; }

int main(int argc, char** argv) { return sarsim::cli::main_program(argc, argv); }
