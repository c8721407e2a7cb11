#pragma once

#include <optional>
#include <string>

#include "cli/shell/options.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::cli {

/// --engine: which of the engines adds the echoes up.
CLI::Option* add_engine(CLI::App& app, std::optional<simulate::Engine>& engine, const std::string& description);

/// Has everybody take one instruction set, so that different processors make the same bytes; an empty level leaves the
/// best there is. Throws core::Refused with the levels of this processor where it has no such one.
void choose_simd(const std::string& level);

}  // namespace sarsim::cli
