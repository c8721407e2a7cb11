#pragma once

#include <cstddef>
#include <memory>

#include "simulate/plan/plan.hpp"

namespace sarsim::test {

/// How far an engine is from the reference.
struct EngineErrors {
  double worst_share = 0.0;  ///< Largest error of a row over what is promised.
  std::size_t worst_row = 0;
  bool finite = true;  ///< All samples of both.
};

/// Compares all rows of a plan with those of the same plan of the reference engine.
/// @param tolerance  that the plan was made for
[[nodiscard]] EngineErrors compare_rows(const simulate::Plan& fast, const simulate::Plan& reference, double tolerance);

}  // namespace sarsim::test
