#include "workflow/record/row_trial.hpp"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace sarsim::workflow {
namespace row_trial_test {

// A clock that only work moves.
struct Machine {
  double now_s = 100.0;
  double computing_s = 0.003;
  double encoding_s = 0.001;
  std::multiset<std::size_t> rows;

  TrialRules rules(double budget_s) {
    return {1, budget_s, [this] { return now_s; }};
  }
  std::function<TryRow()> worker() {
    return [this] {
      return [this](std::size_t row) {
        rows.insert(row);
        now_s += computing_s + encoding_s;
        return computing_s;
      };
    };
  }
};

TEST(InfoTrial, FindsTheTimeOfARowAndTheShareOfComputing) {
  Machine machine;
  const Trial trial = try_rows(1000000, machine.rules(0.2), machine.worker());
  EXPECT_NEAR(trial.seconds_per_row, 0.004, 1e-12);
  EXPECT_NEAR(trial.computing_share, 0.75, 1e-9);
  EXPECT_EQ(trial.rows, 50U);
  EXPECT_NEAR(machine.now_s, 100.204, 1e-9);  // One more, uncounted, to begin with.
}

TEST(InfoTrial, TriesNoMoreRowsThanThereAre) {
  Machine machine;
  const Trial trial = try_rows(5, machine.rules(1e9), machine.worker());
  EXPECT_EQ(trial.rows, 4U);
  EXPECT_LE(*machine.rows.rbegin(), 4U);
  Machine single;
  EXPECT_EQ(try_rows(1, single.rules(1e9), single.worker()).rows, 1U);
  EXPECT_EQ(single.rows, (std::multiset<std::size_t>{0, 0}));
}

TEST(InfoTrial, RowsLieEvenlyInTheRecording) {
  Machine machine;
  (void)try_rows(1000, machine.rules(0.4), machine.worker());
  std::size_t before = 0;
  for (const std::size_t row : machine.rows) {
    EXPECT_LT(row - before, 40U);
    before = row;
  }
  EXPECT_GT(before, 960U);
}

TEST(InfoTrial, RatesOfThreadsAddUp) {
  // Each thread has a clock of its own here, so that both take 4 ms for a row at the same time.
  static thread_local double now_s;
  now_s = 0.0;
  TrialRules rules{2, 0.2, [] { return now_s; }};
  const Trial trial = try_rows(1000000, rules, [] {
    now_s = 0.0;
    return [](std::size_t) {
      now_s += 0.004;
      return 0.002;
    };
  });
  EXPECT_NEAR(trial.seconds_per_row, 0.002, 1e-12);
  EXPECT_EQ(trial.rows, 100U);
  EXPECT_NEAR(trial.computing_share, 0.5, 1e-9);
}

TEST(InfoTrial, CountsTheComputingOfASecondPass) {
  const Trial trial{10, 0.004, 0.75};
  EXPECT_NEAR(seconds_of_rows(trial, 100, false), 0.4, 1e-12);
  EXPECT_NEAR(seconds_of_rows(trial, 100, true), 0.7, 1e-12);
}

TEST(InfoTrial, PassesOnWhatARowFailsWith) {
  Machine machine;
  for (const unsigned threads : {1U, 3U}) {
    TrialRules rules = machine.rules(1.0);
    rules.threads = threads;
    EXPECT_THROW(
        (void)try_rows(10, rules,
                       []() -> TryRow { return [](std::size_t) -> double { throw std::runtime_error("no"); }; }),
        std::runtime_error);
  }
}

}  // namespace row_trial_test
}  // namespace sarsim::workflow
