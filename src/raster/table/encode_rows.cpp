#include "raster/table/encode_rows.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "core/task/parallel.hpp"

namespace sarsim::raster {

namespace {

// Rows that are computed and written together: enough work to hide the hand-over, little enough to keep memory small
// whatever the recording's length. The last of them come in smaller blocks, so that no thread is without work for long
// while others finish.
class Blocks {
 public:
  Blocks(RowRange all, std::size_t columns) : begin_(all.first), rows_(all.count) {
    constexpr std::size_t samples = 1U << 14U;
    constexpr std::size_t fair_blocks = 128;
    constexpr std::size_t cut_blocks = 8;
    const std::size_t most = std::clamp<std::size_t>(rows_ / fair_blocks, 1, 1024);
    large_ = std::clamp<std::size_t>(samples / std::max<std::size_t>(columns, 1), 1, most);
    small_ = std::max<std::size_t>(large_ / 8, 1);
    large_count_ = rows_ / large_ - std::min(rows_ / large_, cut_blocks);
    count_ = large_count_ + (rows_ - large_count_ * large_ + small_ - 1) / small_;
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] RowRange operator[](std::size_t block) const {
    if (block < large_count_) return {begin_ + block * large_, large_};
    const std::size_t first = large_count_ * large_ + (block - large_count_) * small_;
    return {begin_ + first, std::min(small_, rows_ - first)};
  }

 private:
  std::size_t begin_;
  std::size_t rows_;
  std::size_t large_ = 1;
  std::size_t small_ = 1;
  std::size_t large_count_ = 0;
  std::size_t count_ = 0;
};

// No file may hold samples that are no numbers, whatever sum of extremes led to them.
// @param met  what was met in the row: where its largest magnitude is small, no part of a sample is large
void expect_finite(std::span<const std::complex<double>> row, const radar::ConversionTally& met, std::size_t number) {
  constexpr double largest = std::numeric_limits<float>::max();
  if (met.maximum_v <= largest && met.not_numbers == 0) return;
  bool good = true;
  for (const std::complex<double>& v : row) good &= std::abs(v.real()) <= largest && std::abs(v.imag()) <= largest;
  if (!good)
    throw std::overflow_error(fmt::format("row {} of the recording holds samples that are too large", number + 1));
}

// What is done with rows: nothing is encoded without an encoder, and nothing converted without an LSB.
struct Treatment {
  Recorded recorded;
  const Sink* encoder = nullptr;
  double lsb_v = 0.0;
  const core::StopFlag* stop = nullptr;
};

// Each thread's own workshop: from some rows to their bytes, one after the other, so that all that happens to a row
// happens in a near cache.
class BlockMaker {
 public:
  BlockMaker(const Treatment& treatment, const Blocks& blocks, const RowSource& source)
      : treatment_(treatment),
        encoder_(treatment.encoder),
        blocks_(blocks),
        make_row_(source()),
        volts_(treatment.recorded.columns) {
    if (encoder_ != nullptr && encoder_->wants_counts()) counts_.resize(2 * volts_.size());
  }

  EncodedRows operator()(std::size_t block) {
    EncodedRows result;
    const RowRange rows = result.rows = blocks_[block];
    for (std::size_t row = rows.first; row < rows.end(); ++row) {
      end_if_wanted();
      const radar::SampleSpan before = filled_;
      filled_ = make_row_(row, volts_, before);
      end_if_wanted();  // A row may be long.
      const radar::ConversionTally met = convert(before);
      expect_finite(volts_, met, row);
      result.tally.add(met);
      end_if_wanted();
      if (encoder_ != nullptr) encode(row, result);
    }
    return result;
  }

 private:
  void end_if_wanted() const {
    if (treatment_.stop != nullptr && treatment_.stop->requested()) throw core::Interrupted();
  }

  // Of the row; samples that were 0 before and still are have the count 0 already.
  radar::ConversionTally convert(const radar::SampleSpan& before) {
    const radar::SampleSpan changed = before.with(filled_);
    const std::size_t count = changed.end - changed.begin;
    const std::span<const std::complex<double>> volts = std::span(volts_).subspan(changed.begin, count);
    const std::span<std::int64_t> counts(counts_);
    radar::ConversionTally met;
    met.zero = volts_.size() - count;
    if (encoder_ != nullptr && treatment_.lsb_v > 0.0)
      radar::Converter{treatment_.recorded.bits, treatment_.lsb_v}.convert(
          volts, counts.empty() ? counts : counts.subspan(2 * changed.begin, 2 * count), met);
    else
      radar::tally_volts(volts, met);
    return met;
  }

  void encode(std::size_t row, EncodedRows& result) const {
    std::vector<std::byte> bytes = encoder_->encode({row, 1, volts_.size(), volts_, counts_});
    if (result.rows.count == 1) {
      result.bytes = std::move(bytes);
      return;
    }
    if (row == result.rows.first) result.bytes.reserve(result.rows.count * (bytes.size() + bytes.size() / 16));
    result.bytes.insert(result.bytes.end(), bytes.begin(), bytes.end());
  }

  const Treatment& treatment_;
  const Sink* encoder_;
  const Blocks& blocks_;
  RowFill make_row_;
  std::vector<std::complex<double>> volts_;
  radar::SampleSpan filled_;          // outside of which `volts_` is 0,
  std::vector<std::int64_t> counts_;  // and `counts_` too
};

}  // namespace

void encode_rows(const Recorded& recorded, RowRange rows, double lsb_v, const Sink* encoder, const RunControl& control,
                 const RowSource& source, const std::function<void(const EncodedRows&)>& take) {
  CORE_EXPECT(rows.end() <= recorded.rows);
  CORE_EXPECT(lsb_v > 0.0 || (lsb_v == 0.0 && !(encoder != nullptr && encoder->wants_counts())));
  CORE_EXPECT(source);
  CORE_EXPECT(take);
  const Treatment treatment{recorded, encoder, lsb_v, control.stop};
  const Blocks blocks(rows, recorded.columns);
  core::ordered_parallel<EncodedRows>(
      blocks.count(), core::thread_count(control.threads), [&] { return BlockMaker(treatment, blocks, source); },
      [&](std::size_t, EncodedRows&& block) {
        take(block);
        if (control.progress) control.progress({block.rows.end() - rows.first, rows.count, recorded.columns});
      },
      control.stop);
}

RunReport encode_all(const Recorded& recorded, double lsb_v, Sink& sink, const RunControl& control,
                     const RowSource& source) {
  const auto begin = std::chrono::steady_clock::now();
  radar::ConversionTally tally;
  encode_rows(recorded, {0, recorded.rows}, lsb_v, &sink, control, source, [&](const EncodedRows& block) {
    sink.append(block.bytes, block.rows.first, block.rows.count);
    tally.add(block.tally);
  });
  RunReport report = report_of(recorded, lsb_v, tally);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  sink.finish(report);
  return report;
}

double lsb_of_maximum_v(double maximum_v, int bits) {
  CORE_EXPECT(maximum_v >= 0.0);
  CORE_EXPECT(bits >= 1 && bits <= 64);
  return maximum_v > 0.0 ? maximum_v / radar::full_scale_count(bits) : 1.0;
}

RunReport report_of(const Recorded& recorded, double lsb_v, const radar::ConversionTally& tally) {
  CORE_EXPECT(recorded.bits >= 1 && recorded.bits <= 64);
  CORE_EXPECT(lsb_v >= 0.0);
  const double full_scale = radar::full_scale_count(recorded.bits);
  RunReport report;
  report.rows = recorded.rows;
  report.columns = recorded.columns;
  report.maximum_v = tally.maximum_v;
  report.best_lsb_v = tally.maximum_v / full_scale;
  report.lsb_v = lsb_v > 0.0 ? lsb_v : report.best_lsb_v;
  report.range_used = report.lsb_v > 0.0 ? tally.maximum_v / (report.lsb_v * full_scale) : 0.0;
  report.saturated = tally.saturated;
  report.zero = tally.zero;
  return report;
}

RunReport run_stored(const Recorded& recorded, const std::function<RowReader()>& make_reader, double lsb_v, Sink& sink,
                     const RunControl& control) {
  CORE_EXPECT(make_reader);
  return encode_all(recorded, lsb_v, sink, control, [&]() -> RowFill {
    return [read = make_reader()](std::size_t row, std::span<std::complex<double>> volts, const radar::SampleSpan&) {
      read(row, volts);
      return radar::SampleSpan{0, volts.size()};
    };
  });
}

}  // namespace sarsim::raster
