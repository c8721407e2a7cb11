#include "simulate/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "receiver/converter.hpp"

namespace sarsim {

namespace {

// Rows that are computed and written together: enough work to hide the hand-over, little enough to keep memory small
// and to leave no thread without work for long while others finish their last block.
std::size_t rows_per_block(const Plan& plan) {
  constexpr std::size_t samples = 1U << 15U;
  constexpr std::size_t fair_blocks = 128;
  const std::size_t most = std::clamp<std::size_t>(plan.rows / fair_blocks, 1, 1024);
  return std::clamp<std::size_t>(samples / std::max<std::size_t>(plan.columns, 1), 1, most);
}

struct Encoded {
  std::vector<std::byte> bytes;
  ConversionTally tally;
  std::size_t first_row = 0;
  std::size_t rows = 0;
};

// No file may hold samples that are no numbers, whatever sum of extremes led to them.
void expect_finite(std::span<const std::complex<double>> row, std::size_t number) {
  constexpr double largest = std::numeric_limits<float>::max();
  bool good = true;
  for (const std::complex<double>& v : row) good &= std::abs(v.real()) <= largest && std::abs(v.imag()) <= largest;
  if (!good)
    throw std::overflow_error(fmt::format("row {} of the recording holds samples that are too large", number + 1));
}

// Each thread's own workshop: from a block number to the bytes of the block.
class BlockMaker {
 public:
  BlockMaker(const Plan& plan, const Sink* sink, double lsb_v, const StopFlag* stop)
      : plan_(plan), sink_(sink), lsb_v_(lsb_v), stop_(stop), rows_(plan) {}

  Encoded operator()(std::size_t block) {
    Encoded result;
    result.first_row = block * rows_per_block(plan_);
    result.rows = std::min(rows_per_block(plan_), plan_.rows - result.first_row);
    volts_.resize(result.rows * plan_.columns);
    for (std::size_t r = 0; r < result.rows; ++r) {
      if (stop_ != nullptr && stop_->requested()) throw Interrupted();
      const auto row = std::span(volts_).subspan(r * plan_.columns, plan_.columns);
      rows_.make_row(result.first_row + r, row);
      expect_finite(row, result.first_row + r);
    }
    if (sink_ == nullptr) {
      result.tally.maximum_v = largest_magnitude(volts_);
      return result;
    }
    convert(result);
    const Block ready{result.first_row, result.rows, plan_.columns, volts_, counts_};
    result.bytes = sink_->encode(ready);
    return result;
  }

 private:
  void convert(Encoded& result) {
    if (sink_->wants_counts()) counts_.resize(2 * volts_.size());
    if (lsb_v_ > 0.0) {
      Converter{plan_.simulation.bits, lsb_v_}.convert(volts_, counts_, result.tally);
      return;
    }
    result.tally.maximum_v = largest_magnitude(volts_);
    result.tally.zero = static_cast<std::uint64_t>(std::ranges::count(volts_, std::complex<double>()));
  }

  const Plan& plan_;
  const Sink* sink_;
  double lsb_v_;
  const StopFlag* stop_;
  RowMaker rows_;
  std::vector<std::complex<double>> volts_;
  std::vector<std::int64_t> counts_;
};

template <class Consume>
void run_blocks(const Plan& plan, const Sink* sink, double lsb_v, const RunControl& control, const Consume& consume) {
  const std::size_t blocks = (plan.rows + rows_per_block(plan) - 1) / rows_per_block(plan);
  ordered_parallel<Encoded>(
      blocks, thread_count(control.threads), [&] { return BlockMaker(plan, sink, lsb_v, control.stop); },
      [&](std::size_t, Encoded&& block) {
        consume(block);
        if (control.progress) control.progress({block.first_row + block.rows, plan.rows, plan.columns});
      },
      control.stop);
}

}  // namespace

double resolved_lsb_v(const Plan& plan, const RunControl& control) {
  if (plan.simulation.lsb_v > 0.0) return plan.simulation.lsb_v;
  double maximum_v = 0.0;
  run_blocks(plan, nullptr, 0.0, control,
             [&](const Encoded& block) { maximum_v = std::max(maximum_v, block.tally.maximum_v); });
  return maximum_v > 0.0 ? maximum_v / full_scale_count(plan.simulation.bits) : 1.0;
}

RunReport run(const Plan& plan, double lsb_v, Sink& sink, const RunControl& control) {
  const auto begin = std::chrono::steady_clock::now();
  ConversionTally tally;
  run_blocks(plan, &sink, lsb_v, control, [&](const Encoded& block) {
    sink.append(block.bytes, block.first_row, block.rows);
    tally.add(block.tally);
  });
  const double full_scale = full_scale_count(plan.simulation.bits);
  RunReport report;
  report.rows = plan.rows;
  report.columns = plan.columns;
  report.maximum_v = tally.maximum_v;
  report.best_lsb_v = tally.maximum_v / full_scale;
  report.lsb_v = lsb_v > 0.0 ? lsb_v : report.best_lsb_v;
  report.range_used = report.lsb_v > 0.0 ? tally.maximum_v / (report.lsb_v * full_scale) : 0.0;
  report.saturated = tally.saturated;
  report.zero = tally.zero;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  sink.finish(report);
  return report;
}

Recording record(const Plan& plan, const RunControl& control) {
  Recording recording;
  MemorySink sink(recording);
  run(plan, 0.0, sink, control);
  return recording;
}

}  // namespace sarsim
