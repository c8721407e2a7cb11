#include "cli/command_line.hpp"

int main(int argc, char** argv) { return sarsim::cli::main_program(argc, argv); }
