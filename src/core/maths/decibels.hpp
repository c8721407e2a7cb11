#pragma once

#include <cmath>

namespace sarsim::core {

/// Decibels of a ratio of powers, and of one of amplitudes; -inf for 0.
[[nodiscard]] inline double power_db(double ratio) { return 10.0 * std::log10(ratio); }
[[nodiscard]] inline double amplitude_db(double ratio) { return 20.0 * std::log10(ratio); }

}  // namespace sarsim::core
