#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "cli/shell/context.hpp"

namespace sarsim::workflow {
class Team;
}

/// The commands, one file each. Each function adds a command's arguments to its application and returns what carries it
/// out once they have been parsed.
namespace sarsim::cli {

using Action = std::function<ExitStatus(Streams&)>;

/// @param team  processes that run together; none: this one alone
[[nodiscard]] Action add_run(CLI::App& app, workflow::Team* team = nullptr);
[[nodiscard]] Action add_new(CLI::App& app);
[[nodiscard]] Action add_merge(CLI::App& app);
[[nodiscard]] Action add_sweep(CLI::App& app);
[[nodiscard]] Action add_check(CLI::App& app);
[[nodiscard]] Action add_format_command(CLI::App& app);
[[nodiscard]] Action add_explain(CLI::App& app);
[[nodiscard]] Action add_info(CLI::App& app);
[[nodiscard]] Action add_geometry(CLI::App& app);
[[nodiscard]] Action add_motion(CLI::App& app);
[[nodiscard]] Action add_plot(CLI::App& app);
[[nodiscard]] Action add_convert(CLI::App& app);
[[nodiscard]] Action add_focus(CLI::App& app);
[[nodiscard]] Action add_measure(CLI::App& app);
[[nodiscard]] Action add_doppler(CLI::App& app);
[[nodiscard]] Action add_search(CLI::App& app);
[[nodiscard]] Action add_verify(CLI::App& app);
[[nodiscard]] Action add_profiles(CLI::App& app);
[[nodiscard]] Action add_isar(CLI::App& app);
/// @param root  the application whose commands and options are completed
[[nodiscard]] Action add_completion(CLI::App& app, const CLI::App& root);

}  // namespace sarsim::cli
