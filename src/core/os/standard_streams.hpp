#pragma once

namespace sarsim::core {

/// Takes the descriptors 0 to 2 where they are closed, so that no file gets one of them: what is printed would land in
/// it. Reading and printing fail there as on a closed stream. Comes first in a program.
void reserve_standard_streams();

/// Whether standard output is a terminal.
[[nodiscard]] bool output_is_terminal();
/// Whether standard error is.
[[nodiscard]] bool errors_are_on_terminal();

}  // namespace sarsim::core
