#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/observer.hpp"
#include "workflow/record/products.hpp"
#include "workflow/sweep/sweep_axes.hpp"
#include "workflow/sweep/sweep_check.hpp"
#include "workflow/sweep/sweep_request.hpp"
#include "workflow/sweep/sweep_row.hpp"
#include "workflow/sweep/sweep_table.hpp"

namespace sarsim::workflow {

/// A sweep before its first variation.
struct SweepPlan {
  Sweep sweep;
  std::vector<ProductJob> products;          ///< With their files in the script as `path`.
  std::vector<std::size_t> variations = {};  ///< Of the part, ascending.
  std::vector<SweepRow> rows = {};           ///< Of each of these, each product; some may be done.
  std::vector<std::size_t> open = {};        ///< Variations that something is left to do for.
  SweepChecks checks = {};                   ///< Of these.
  bool refused = false;                      ///< Problems forbid to run it; then there are no sizes.
  unsigned jobs = 1;                         ///< Variations at a time.
  unsigned threads = 1;                      ///< Of each variation.
};

/// Names the products of all variations and looks at each variation as `sarsim check` looks at a script. The observer
/// is told the problems where they do not forbid to run the sweep; otherwise the plan is `refused`.
/// @throws core::InvalidRequest for settings, products and parts that do not exist
[[nodiscard]] SweepPlan plan_sweep(const SweepRequest& request, const core::Observer& observer);

/// Completes the rows of products that are there already, from the same scene, where the sweep is resumed.
void take_finished(const SweepRequest& request, std::vector<SweepRow>& rows);

/// Throws core::InvalidRequest with the first of the problems of a plan that is refused.
void expect_sound(const SweepPlan& plan);

/// How large a product will be that is not done.
/// @param variation  one of `plan.open`
[[nodiscard]] const ProductSize& size_of(const SweepPlan& plan, std::size_t variation, std::size_t product);

/// "scene.scr: 6 variations, 4 to run, 1.2 MB, about 3 s, 2 at a time with 1 thread".
[[nodiscard]] std::string announcement(const SweepRequest& request, const SweepPlan& plan);

/// What the table of a plan says besides its rows; refers to the plan.
/// @param status  "planned", "done", ...
[[nodiscard]] SweepFrame frame_of(const SweepRequest& request, const SweepPlan& plan, std::string status);

/// The first twenty problems, and a note that says how many there are besides.
[[nodiscard]] core::Problems shortened(core::Problems problems);

}  // namespace sarsim::workflow
