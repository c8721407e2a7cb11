#pragma once

#include <optional>
#include <string>

#include "cli/shell/options.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::cli {

/// --engine: which of the engines adds the echoes up.
CLI::Option* add_engine(CLI::App& app, std::optional<simulate::Engine>& engine, const std::string& description);

}  // namespace sarsim::cli
