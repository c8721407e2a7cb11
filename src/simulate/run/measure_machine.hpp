#pragma once

#include "core/task/stop.hpp"
#include "simulate/plan/machine_speed.hpp"

namespace sarsim::simulate {

/// Times a few rows of small recordings with every engine, with noise and with a matched filter; takes some
/// tenths of a second. The least of several tries counts, so that other work on the machine matters
/// little. Only forecasts of time depend on it, never a sample.
/// @param stop  asked now and then; a requested stop throws Interrupted
[[nodiscard]] MachineSpeed measure_machine(const core::StopFlag* stop = nullptr);

}  // namespace sarsim::simulate
