#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/task/stop.hpp"
#include "simulate/plan/machine_speed.hpp"

/// What forecasts of time know of the machine. Measured once, kept in a file, never of influence on a sample.
namespace sarsim::workflow {

/// The speed of this machine, from the user's cache folder; measured (some tenths of a second) and kept there at
/// first use, and again for another processor, other instructions or another version of the program. Without a cache
/// folder it is that of the constants. What cannot be kept is measured again.
/// @param stop  asked now and then; a requested stop throws Interrupted
[[nodiscard]] simulate::MachineSpeed known_machine(const core::StopFlag* stop = nullptr);

/// Same, with the folder said.
[[nodiscard]] simulate::MachineSpeed known_machine(const std::filesystem::path& folder, const core::StopFlag* stop);

/// The file of a machine's speed in a folder.
[[nodiscard]] std::filesystem::path machine_file(const std::filesystem::path& folder);

/// A speed as text, a line for each part, and back; nothing where a line is missing, strange or out of range.
[[nodiscard]] std::string text_of(const simulate::MachineSpeed& speed);
/// See `text_of`.
[[nodiscard]] std::optional<simulate::MachineSpeed> machine_speed_from(std::string_view text);

}  // namespace sarsim::workflow
