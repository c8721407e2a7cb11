#pragma once

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::core {

/// sin(pi x)/(pi x), 1 at 0.
inline double sinc(double x) { return x == 0.0 ? 1.0 : std::sin(pi * x) / (pi * x); }

}  // namespace sarsim::core
