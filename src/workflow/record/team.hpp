#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/report/retryable.hpp"
#include "core/task/progress.hpp"
#include "simulate/run/run.hpp"

namespace sarsim::workflow {

/// How a step ended.
enum class StepEnd {
  done,
  retryable_error,  ///< `core::RetryableError`.
  failed,
};

/// Processes that make recordings together; every function is called by all of them, in the same order.
class Team {
 public:
  Team() = default;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  virtual ~Team() = default;

  /// Whether this is the process that speaks for all.
  [[nodiscard]] virtual bool leads() const = 0;
  /// Name of this process among the others: "rank-3".
  [[nodiscard]] virtual std::string name() const = 0;
  /// How many of the processes share this machine.
  [[nodiscard]] virtual unsigned processes_here() const = 0;
  /// Waits for all, and tells them how a step ended here.
  /// @returns how it ended for all: as on the first of the processes on which it did not end well
  [[nodiscard]] virtual StepEnd agree(StepEnd here) = 0;
  /// Whether all know that one of them has failed; and whether it is this one, who says why.
  [[nodiscard]] virtual bool failure_is_known() const = 0;
  /// Whether this process is the one that says why they failed.
  [[nodiscard]] virtual bool speaks() const = 0;
  /// What the leader says.
  [[nodiscard]] virtual std::string from_leader(const std::string& text) = 0;
  /// Deals rows among all, some at a time to whoever is free. Returns when they are all made; an exception of `work`
  /// on one process must end all of them.
  /// @param todo      of the leader
  /// @param work      makes what was dealt
  /// @param progress  told on the leader
  virtual void deal(const std::vector<raster::RowRange>& todo, const std::function<void(raster::RowRange)>& work,
                    const core::ProgressReport& progress) = 0;
};

/// A step that all processes of a team take, or none; a process of its own has no team. Throws what the step throws,
/// and where it fails on another process, which says why, a core::InvalidRequest without problems.
template <class Step>
void take_together(Team* team, const Step& step) {
  const auto tell = [team](StepEnd here) { return team == nullptr ? here : team->agree(here); };
  try {
    step();
  } catch (const core::RetryableError&) {
    static_cast<void>(tell(StepEnd::retryable_error));
    throw;
  } catch (...) {
    static_cast<void>(tell(StepEnd::failed));
    throw;
  }
  const StepEnd end = tell(StepEnd::done);
  if (end == StepEnd::retryable_error) throw core::RetryableError(core::Problems());
  if (end == StepEnd::failed) throw core::InvalidRequest(core::Problems());
}

}  // namespace sarsim::workflow
