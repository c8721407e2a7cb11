#pragma once

#include <functional>
#include <string>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "core/task/stop.hpp"

namespace sarsim::core {

/// Who looks on while a workflow does its work. All functions may be empty; they are called on the thread that the
/// workflow was called on, one at a time, and must return soon.
struct Observer {
  /// How far a stage has come. The stage is named for people: "out/sar_r.img: motion compensation". A stage ends where
  /// another one begins, or anything else is said, or the workflow returns.
  std::function<void(const std::string& stage, const Progress& progress)> progress;
  /// What is wrong or worth knowing, before the work that it concerns begins; ranked.
  std::function<void(const Problems& problems)> remark;
  /// One line about what comes next: size, duration.
  std::function<void(const std::string& line)> announce;
  /// Asked now and then; a requested stop throws Interrupted. May be null.
  const StopFlag* stop = nullptr;

  /// Threads and stop as loops take them.
  [[nodiscard]] WorkControl control(unsigned threads) const { return {threads, stop}; }
  /// The progress of one stage as loops take it; empty where nobody looks on.
  [[nodiscard]] ProgressReport stage(std::string name) const {
    if (!progress) return {};
    return [this, name = std::move(name)](const Progress& p) { progress(name, p); };
  }
  /// Hands problems on, where there are any.
  void remarks(const Problems& problems) const {
    if (remark && !problems.empty()) remark(problems);
  }
  /// Hands a line on.
  void announces(const std::string& line) const {
    if (announce) announce(line);
  }
};

}  // namespace sarsim::core
