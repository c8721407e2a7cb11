#pragma once

#include <complex>
#include <memory>
#include <span>

#include "core/task/sample_rows.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::simulate {

/// Rows of an acquisition, computed when they are asked for, by any number of threads. How they are computed is decided
/// with the first of them: what needs the geometry alone does not pay for it.
[[nodiscard]] core::SampleRows<double> computed_rows(std::shared_ptr<const Acquisition> acquisition);

}  // namespace sarsim::simulate
