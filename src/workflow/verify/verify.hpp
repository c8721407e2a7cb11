#pragma once

#include <string>

#include "core/task/observer.hpp"
#include "workflow/verify/page.hpp"
#include "workflow/verify/record.hpp"

namespace sarsim::workflow::verify {

/// What is measured, and the page that is made of it.
struct VerifyRequest {
  bool quick = false;  ///< Fewer samples, and no measurement of speed.
  std::string html;    ///< File of a page with tables and charts; empty: none.
  bool force = false;  ///< Replace the page where it exists.
};

/// What was measured, where, and how long it took.
struct VerifyReport {
  Record record;
  Facts facts;
  double seconds = 0.0;
};

/// Holds the simulator against what must come out, on this machine. A statement that does not hold is a finding, no
/// failure. A requested stop throws Interrupted.
/// @throws core::InvalidRequest where something stands in the way of the page; nothing is measured then
[[nodiscard]] VerifyReport verify_program(const VerifyRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow::verify
