#include "workflow/record/row_trial.hpp"

#include <algorithm>
#include <complex>
#include <memory>
#include <optional>

#include "radar/receiver/converter.hpp"
#include "raster/format/sinks.hpp"
#include "simulate/plan/row_maker.hpp"

namespace sarsim::workflow {

namespace {

// Of the sequence of fractions k/phi, any beginning lies evenly in 0 to 1.
std::size_t spread_row(std::size_t k, std::size_t count) {
  constexpr double golden = 0.6180339887498949;
  const double place = static_cast<double>(k) * golden;
  return std::min(count - 1, static_cast<std::size_t>((place - std::floor(place)) * static_cast<double>(count)));
}

struct ThreadTrial {
  std::size_t rows = 0;
  double seconds = 0.0;
  double computing_s = 0.0;
};

ThreadTrial try_on_thread(std::size_t count, const TrialRules& rules, const TryRow& work,
                          std::atomic<std::size_t>& next) {
  ThreadTrial trial;
  work(spread_row(next++, count));
  const double begin_s = rules.now_s();
  do {
    trial.computing_s += work(spread_row(next++, count));
    ++trial.rows;
    trial.seconds = rules.now_s() - begin_s;
  } while (trial.seconds < rules.budget_s && next < count);
  return trial;
}

// Makes rows of a plan into bytes, as a run does.
class RowTrial {
 public:
  RowTrial(const simulate::Plan& plan, const raster::Sink& sink, const std::function<double()>& now_s,
           const core::StopFlag* stop)
      : plan_(plan), sink_(sink), now_s_(now_s), stop_(stop), rows_(plan), volts_(plan.acquisition.reception.columns) {
    if (sink.wants_counts()) counts_.resize(2 * plan.acquisition.reception.columns);
    lsb_v_ = plan.acquisition.simulation.lsb_v;
  }

  double operator()(std::size_t row) {
    if (stop_ != nullptr && stop_->requested()) throw core::Interrupted();
    const double begin_s = now_s_();
    rows_.make_row(row, volts_);
    const double computed_s = now_s_() - begin_s;
    const double maximum_v = radar::largest_magnitude(volts_);
    if (lsb_v_ <= 0.0)
      lsb_v_ = maximum_v > 0.0 ? maximum_v / radar::full_scale_count(plan_.acquisition.simulation.bits) : 0.0;
    radar::ConversionTally tally;
    if (!counts_.empty())
      radar::Converter{plan_.acquisition.simulation.bits, lsb_v_ > 0.0 ? lsb_v_ : 1.0}.convert(volts_, counts_, tally);
    const auto bytes = sink_.encode({row, 1, plan_.acquisition.reception.columns, volts_, counts_});
    return bytes.empty() ? 0.0 : computed_s;
  }

 private:
  const simulate::Plan& plan_;
  const raster::Sink& sink_;
  const std::function<double()>& now_s_;
  const core::StopFlag* stop_;
  simulate::RowMaker rows_;
  std::vector<std::complex<double>> volts_;
  std::vector<std::int64_t> counts_;
  double lsb_v_ = 0.0;
};

}  // namespace

Trial try_rows(std::size_t count, const TrialRules& rules, const std::function<TryRow()>& make_worker) {
  std::vector<ThreadTrial> trials(std::max(rules.threads, 1U));
  std::atomic<std::size_t> next{0};
  std::mutex lock;
  std::exception_ptr failure;
  const auto work = [&](std::size_t thread) {
    try {
      trials[thread] = try_on_thread(count, rules, make_worker(), next);
    } catch (...) {
      const std::scoped_lock hold(lock);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < trials.size(); ++i) helpers.emplace_back(work, i);
    work(0);
  }
  if (failure) std::rethrow_exception(failure);
  Trial trial;
  double rows_per_s = 0.0;
  double seconds = 0.0;
  double computing_s = 0.0;
  for (const ThreadTrial& thread : trials) {
    trial.rows += thread.rows;
    seconds += thread.seconds;
    computing_s += thread.computing_s;
    if (thread.seconds > 0.0) rows_per_s += static_cast<double>(thread.rows) / thread.seconds;
  }
  trial.seconds_per_row = rows_per_s > 0.0 ? 1.0 / rows_per_s : 0.0;
  if (seconds > 0.0) trial.computing_share = std::min(computing_s / seconds, 1.0);
  return trial;
}

Trial try_plan(const simulate::Plan& plan, const TrialRules& rules, const core::StopFlag* stop) {
  if (plan.acquisition.timing.rows == 0) return {};
  const std::unique_ptr<raster::Sink> sink =
      raster::make_discarding_sink(simulate::product_of(plan, {}), {plan.acquisition.simulation.format});
  TrialRules own = rules;
  own.threads =
      static_cast<unsigned>(std::clamp<std::size_t>(plan.acquisition.timing.rows, 1, std::max(rules.threads, 1U)));
  // A worker is too large to be copied into a function.
  return try_rows(plan.acquisition.timing.rows, own, [&]() -> TryRow {
    const auto worker = std::make_shared<RowTrial>(plan, *sink, own.now_s, stop);
    return [worker](std::size_t row) { return (*worker)(row); };
  });
}

double seconds_of_rows(const Trial& trial, double rows, bool twice) {
  return rows * trial.seconds_per_row * (twice ? 1.0 + trial.computing_share : 1.0);
}

}  // namespace sarsim::workflow
