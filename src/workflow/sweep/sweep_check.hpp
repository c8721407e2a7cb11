#pragma once

#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "raster/format/sinks.hpp"
#include "scene/script/field_places.hpp"
#include "simulate/plan/engine.hpp"
#include "workflow/record/products.hpp"
#include "workflow/sweep/sweep_axes.hpp"

namespace sarsim::workflow {

/// How large a product of a variation will be.
struct ProductSize {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double bytes = 0.0;
  double min_bytes = 0.0;  ///< The size of text is an estimate from above.
  double seconds = 0.0;    ///< Roughly, on one thread.
};

/// What `check_sweep` works with.
struct SweepToCheck {
  const scene::Scene& base;
  const scene::FieldPlaces& places;
  const Sweep& sweep;
  const std::vector<workflow::ProductJob>& products;
  const std::vector<std::size_t>& variations;             ///< Those that are to be looked at, ascending.
  bool counts = false;                                    ///< As in SinkOptions.
  simulate::Engine engine = simulate::Engine::automatic;  ///< That will run, for the time that is announced.
};

/// What there is to know before the first variation is run.
struct SweepChecks {
  core::Problems
      problems;  ///< Each cause once, with the variations that have it; errors first, then by the first of them.
  /// Of each of `variations`, and in it of each product; empty where there are errors.
  std::vector<std::vector<ProductSize>> sizes;
};

/// A member of all sizes, added up.
[[nodiscard]] double sum_of(const SweepChecks& checks, double ProductSize::*member);

/// Looks at every variation as `sarsim check` looks at a script, on all threads; variations that differ by the seed
/// alone are looked at once. The outcome does not depend on the number of threads.
[[nodiscard]] SweepChecks check_sweep(const SweepToCheck& work, const core::WorkControl& control);

}  // namespace sarsim::workflow
