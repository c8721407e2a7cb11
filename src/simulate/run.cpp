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

struct Rows {
  std::size_t first = 0;
  std::size_t count = 0;
};

// Rows that are computed and written together: enough work to hide the hand-over, little enough to keep memory small
// whatever the recording's length. The last of them come in smaller blocks, so that no thread is without work for long
// while others finish.
class Blocks {
 public:
  explicit Blocks(const Plan& plan) : rows_(plan.rows) {
    constexpr std::size_t samples = 1U << 14U;
    constexpr std::size_t fair_blocks = 128;
    constexpr std::size_t cut_blocks = 8;
    const std::size_t most = std::clamp<std::size_t>(plan.rows / fair_blocks, 1, 1024);
    large_ = std::clamp<std::size_t>(samples / std::max<std::size_t>(plan.columns, 1), 1, most);
    small_ = std::max<std::size_t>(large_ / 8, 1);
    large_count_ = rows_ / large_ - std::min(rows_ / large_, cut_blocks);
    count_ = large_count_ + (rows_ - large_count_ * large_ + small_ - 1) / small_;
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Rows operator[](std::size_t block) const {
    if (block < large_count_) return {block * large_, large_};
    const std::size_t first = large_count_ * large_ + (block - large_count_) * small_;
    return {first, std::min(small_, rows_ - first)};
  }

 private:
  std::size_t rows_;
  std::size_t large_ = 1;
  std::size_t small_ = 1;
  std::size_t large_count_ = 0;
  std::size_t count_ = 0;
};

struct Encoded {
  std::vector<std::byte> bytes;
  ConversionTally tally;
  Rows rows;
};

// No file may hold samples that are no numbers, whatever sum of extremes led to them.
void expect_finite(std::span<const std::complex<double>> row, std::size_t number) {
  constexpr double largest = std::numeric_limits<float>::max();
  bool good = true;
  for (const std::complex<double>& v : row) good &= std::abs(v.real()) <= largest && std::abs(v.imag()) <= largest;
  if (!good)
    throw std::overflow_error(fmt::format("row {} of the recording holds samples that are too large", number + 1));
}

// Each thread's own workshop: from some rows to their bytes, one after the other, so that all that happens to a row
// happens in a near cache.
class BlockMaker {
 public:
  BlockMaker(const Plan& plan, const Blocks& blocks, const Sink* sink, double lsb_v, const StopFlag* stop)
      : plan_(plan), blocks_(blocks), sink_(sink), lsb_v_(lsb_v), stop_(stop), rows_(plan), volts_(plan.columns) {
    if (sink_ != nullptr && sink_->wants_counts()) counts_.resize(2 * plan.columns);
  }

  Encoded operator()(std::size_t block) {
    Encoded result;
    const Rows rows = result.rows = blocks_[block];
    for (std::size_t row = rows.first; row < rows.first + rows.count; ++row) {
      if (stop_ != nullptr && stop_->requested()) throw Interrupted();
      rows_.make_row(row, volts_);
      expect_finite(volts_, row);
      convert(result.tally);
      if (sink_ != nullptr) encode(row, result);
    }
    return result;
  }

 private:
  void convert(ConversionTally& tally) {
    if (sink_ != nullptr && lsb_v_ > 0.0) {
      Converter{plan_.simulation.bits, lsb_v_}.convert(volts_, counts_, tally);
      return;
    }
    ConversionTally row;
    row.maximum_v = largest_magnitude(volts_);
    if (sink_ != nullptr) row.zero = static_cast<std::uint64_t>(std::ranges::count(volts_, std::complex<double>()));
    tally.add(row);
  }

  void encode(std::size_t row, Encoded& result) const {
    std::vector<std::byte> bytes = sink_->encode({row, 1, plan_.columns, volts_, counts_});
    if (result.rows.count == 1) {
      result.bytes = std::move(bytes);
      return;
    }
    if (row == result.rows.first) result.bytes.reserve(result.rows.count * (bytes.size() + bytes.size() / 16));
    result.bytes.insert(result.bytes.end(), bytes.begin(), bytes.end());
  }

  const Plan& plan_;
  const Blocks& blocks_;
  const Sink* sink_;
  double lsb_v_;
  const StopFlag* stop_;
  RowMaker rows_;
  std::vector<std::complex<double>> volts_;
  std::vector<std::int64_t> counts_;
};

template <class Consume>
void run_blocks(const Plan& plan, const Sink* sink, double lsb_v, const RunControl& control, const Consume& consume) {
  const Blocks blocks(plan);
  ordered_parallel<Encoded>(
      blocks.count(), thread_count(control.threads),
      [&] { return BlockMaker(plan, blocks, sink, lsb_v, control.stop); },
      [&](std::size_t, Encoded&& block) {
        consume(block);
        if (control.progress) control.progress({block.rows.first + block.rows.count, plan.rows, plan.columns});
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
    sink.append(block.bytes, block.rows.first, block.rows.count);
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
