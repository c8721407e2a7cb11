#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/report/problem.hpp"
#include "workflow/record/products.hpp"
#include "workflow/sweep/sweep_axes.hpp"
#include "workflow/sweep/sweep_row.hpp"

namespace sarsim::workflow {

/// What the table of a sweep says besides its rows.
struct SweepFrame {
  std::string script;
  const Sweep* sweep = nullptr;
  const std::vector<workflow::ProductJob>* products = nullptr;
  std::string status;  ///< "done", "failed", ...
  const core::Problems* problems = nullptr;
};

/// The table as comma-separated values (RFC 4180, lines end in LF): a line with the names of the columns, then a line
/// for each row in their order. A column for each axis, with its unit in brackets, in that base unit; behind all others
/// one for each figure of follow-ups.
[[nodiscard]] std::string sweep_csv(const SweepFrame& frame, const std::vector<SweepRow>& rows);

/// The same as a JSON object, exact, with the values as typed.
[[nodiscard]] std::string sweep_json(const SweepFrame& frame, const std::vector<SweepRow>& rows);

/// Whether a file begins as the tables of a sweep do.
/// @param beginning  of the file; of a long one, the first million bytes are enough
[[nodiscard]] bool begins_as_sweep_csv(std::string_view beginning);
[[nodiscard]] bool begins_as_sweep_json(std::string_view beginning);

}  // namespace sarsim::workflow
