#pragma once

#include <CLI/CLI.hpp>

#include "workflow/record/part_choice.hpp"

namespace sarsim::cli {

/// Adds --part, --pulses, --part-file, --resume and --save-every.
void add_part_options(CLI::App& app, workflow::PartChoice& choice);

}  // namespace sarsim::cli
