#pragma once

#include "core/report/problem.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::workflow {

/// Says by how much the atmosphere of the scene delays the echoes from its middle, which focusing does not correct: a
/// note with the excess path, by which targets appear farther away. Nothing without an atmosphere that delays.
[[nodiscard]] core::Problems diagnose_air(const simulate::Acquisition& acquisition);

}  // namespace sarsim::workflow
