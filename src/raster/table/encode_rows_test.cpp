#include "raster/table/encode_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "core/report/expect.hpp"

namespace sarsim::raster {
namespace encode_rows_test {

// Keeps what it is given: volts, or counts where it wants some.
class KeepingSink : public Sink {
 public:
  explicit KeepingSink(bool wants_counts) : wants_counts_(wants_counts) {}
  [[nodiscard]] bool wants_counts() const override { return wants_counts_; }
  [[nodiscard]] std::vector<std::byte> encode(const Block& block) const override {
    const auto encoded = wants_counts_ ? std::as_bytes(block.counts) : std::as_bytes(block.volts);
    return {encoded.begin(), encoded.end()};
  }
  void append(std::span<const std::byte> more, std::size_t first_row, std::size_t count) override {
    EXPECT_EQ(first_row, rows);
    rows += count;
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
  void finish(const RunReport& report) override { finished = report.rows == rows; }

  std::size_t rows = 0;
  std::vector<std::byte> bytes;
  bool finished = false;

 private:
  bool wants_counts_;
};

constexpr std::size_t columns = 7;

// Row 3 holds 3 + 0.5 i, and so on.
RowReader ramp() {
  return [](std::size_t row, std::span<std::complex<double>> volts) {
    std::ranges::fill(volts, std::complex<double>(static_cast<double>(row), 0.5));
  };
}

TEST(EncodeRows, AreTheSameForAnyNumberOfThreads) {
  KeepingSink one(true);
  KeepingSink four(true);
  const RunReport a = run_stored({300, columns, 16}, ramp, 0.5, one, {.threads = 1, .stop = nullptr, .progress = {}});
  const RunReport b = run_stored({300, columns, 16}, ramp, 0.5, four, {.threads = 4, .stop = nullptr, .progress = {}});
  EXPECT_TRUE(one.finished && four.finished);
  EXPECT_EQ(one.bytes, four.bytes);
  EXPECT_EQ(a.maximum_v, std::abs(std::complex<double>(299.0, 0.5)));
  EXPECT_EQ(a.maximum_v, b.maximum_v);
  std::vector<std::int64_t> counts(one.bytes.size() / sizeof(std::int64_t));
  std::memcpy(counts.data(), one.bytes.data(), one.bytes.size());
  ASSERT_EQ(counts.size(), 2 * 300 * columns);
  for (std::size_t i = 0; i < 300 * columns; ++i) {
    EXPECT_EQ(counts[2 * i], static_cast<std::int64_t>(2 * (i / columns)));
    EXPECT_EQ(counts[2 * i + 1], 1);
  }
}

// Rows are handed over with the span of the row before, outside of which their memory is 0.
TEST(EncodeRows, KeepWhatNoRowFills) {
  KeepingSink sink(false);
  const RowSource source = [] {
    return [](std::size_t row, std::span<std::complex<double>> volts, const radar::SampleSpan& stale) {
      std::fill(volts.begin() + static_cast<std::ptrdiff_t>(stale.begin),
                volts.begin() + static_cast<std::ptrdiff_t>(stale.end), 0.0);
      volts[row] = 1.0;
      return radar::SampleSpan{row, row + 1};
    };
  };
  const RunReport report = encode_all({columns, columns, 8}, 0.0, sink, {}, source);
  EXPECT_EQ(report.zero, columns * (columns - 1));
  std::vector<std::complex<double>> samples(columns * columns);
  ASSERT_EQ(sink.bytes.size(), samples.size() * sizeof(samples[0]));
  std::memcpy(static_cast<void*>(samples.data()), sink.bytes.data(), sink.bytes.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    EXPECT_EQ(samples[i], std::complex<double>(i / columns == i % columns ? 1.0 : 0.0)) << i;
}

TEST(EncodeRows, RefuseSamplesThatNoFileHolds) {
  KeepingSink sink(false);
  const auto reader = [] {
    return [](std::size_t, std::span<std::complex<double>> volts) {
      std::ranges::fill(volts, std::numeric_limits<double>::infinity());
    };
  };
  EXPECT_THROW(run_stored({1, columns, 8}, reader, 0.0, sink, {}), std::overflow_error);
  EXPECT_FALSE(sink.finished);
}

// A row may be long: what was asked for while it was made is not left until it is encoded.
TEST(EncodeRows, StopBetweenTheStepsOfARow) {
  core::StopFlag stop;
  RunControl control;
  control.stop = &stop;
  const auto read = [&](std::size_t, std::span<std::complex<double>> volts) {
    std::ranges::fill(volts, 1.0);
    stop.request();
  };
  class Encoder : public KeepingSink {
   public:
    Encoder() : KeepingSink(false) {}
    [[nodiscard]] std::vector<std::byte> encode(const Block&) const override {
      ADD_FAILURE() << "encoded";
      return {};
    }
  } sink;
  EXPECT_THROW(run_stored(
                   {1, 16, 8}, [&] { return RowReader(read); }, 0.0, sink, control),
               core::Interrupted);
}

TEST(EncodeRows, ExpectBitsAndAnLsbForCounts) {
  EXPECT_EQ(lsb_of_maximum_v(127.0, 8), 1.0);
  EXPECT_EQ(lsb_of_maximum_v(0.0, 8), 1.0);
  if (!core::checks_expectations()) GTEST_SKIP() << "this build does not check expectations";
  EXPECT_THROW(static_cast<void>(lsb_of_maximum_v(1.0, 0)), core::BrokenExpectation);
  KeepingSink sink(true);
  EXPECT_THROW(run_stored({1, columns, 8}, ramp, 0.0, sink, {}), core::BrokenExpectation);
}

}  // namespace encode_rows_test
}  // namespace sarsim::raster
