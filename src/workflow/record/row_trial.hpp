#pragma once

#include <atomic>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "core/task/stop.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::workflow {

/// What trying some rows of a recording says about all of them.
struct Trial {
  std::size_t rows = 0;          ///< Rows that were tried.
  double seconds_per_row = 0;    ///< With all threads at work.
  double computing_share = 1.0;  ///< Part of it that goes into the samples; the rest converts and encodes them.
};

/// How long a trial takes and what measures it.
struct TrialRules {
  unsigned threads = 1;
  double budget_s = 0.2;          ///< Of each thread, after a first row that is not counted.
  std::function<double()> now_s;  ///< Any zero; called on all threads.
};

/// What a thread of a trial does with a row; returns the seconds that went into the samples.
using TryRow = std::function<double(std::size_t row)>;

/// Tries rows that are spread evenly over `count`, each thread its own, until the time is over or there are no more.
/// The rates of the threads add up: while others work, too, each of them is as slow as it would be in the run.
/// @param make_worker  called once on each thread
[[nodiscard]] Trial try_rows(std::size_t count, const TrialRules& rules, const std::function<TryRow()>& make_worker);

/// Tries rows of a plan as a run computes, converts and encodes them; nothing is written.
[[nodiscard]] Trial try_plan(const simulate::Plan& plan, const TrialRules& rules, const core::StopFlag* stop);

/// Seconds that a share of the rows of a recording takes: once, or, where the LSB has to be found first, computed
/// twice.
[[nodiscard]] double seconds_of_rows(const Trial& trial, double rows, bool twice);

}  // namespace sarsim::workflow
