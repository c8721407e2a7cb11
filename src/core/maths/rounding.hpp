#pragma once

#include "core/maths/vector.hpp"

namespace sarsim::core {

/// The double nearest to a value's first significant decimal digits: what arithmetic leaves behind them is taken away,
/// 0.1 + 0.2 becomes 0.3. What is no finite number stays as it is; -0 becomes 0.
/// @param digits  1 to 17
[[nodiscard]] double tidy(double value, int digits = 13);

/// The multiple of a step that is nearest to a value, to 15 digits, so that its shortest text has no more decimals than
/// the step's: 9860.166 for steps of 0.001. The value itself where the step is not above 0.
[[nodiscard]] double rounded_to(double value, double step);

/// The same of each coordinate of a vector.
[[nodiscard]] Vec3 rounded_to(const Vec3& value, double step);

}  // namespace sarsim::core
