#include "raster/table/raster_writer.hpp"

#include <gmock/gmock.h>

#include <array>

namespace sarsim::raster {
namespace raster_writer_test {

using testing::ElementsAre;

// Keeps what it is given.
class KeepingSink final : public Sink {
 public:
  KeepingSink(bool counts, std::vector<double>& numbers, std::vector<std::size_t>& rows)
      : counts_(counts), numbers_(numbers), rows_(rows) {}

  [[nodiscard]] bool wants_counts() const override { return counts_; }
  [[nodiscard]] std::vector<std::byte> encode(const Block& block) const override {
    if (counts_)
      for (const std::int64_t count : block.counts) numbers_.push_back(static_cast<double>(count));
    else
      for (const auto& sample : block.volts) numbers_.insert(numbers_.end(), {sample.real(), sample.imag()});
    return std::vector<std::byte>(block.rows);
  }
  void append(std::span<const std::byte> bytes, std::size_t first_row, std::size_t rows) override {
    EXPECT_EQ(bytes.size(), rows);
    rows_.insert(rows_.end(), {first_row, rows});
  }
  void finish(const RunReport& report) override { numbers_.push_back(report.lsb_v); }

 private:
  bool counts_;
  std::vector<double>& numbers_;
  std::vector<std::size_t>& rows_;
};

TEST(RasterWriter, MakesCountsOfNumbersWhereTheSinkWantsThem) {
  std::vector<double> numbers;
  std::vector<std::size_t> rows;
  RasterWriter writer(std::make_unique<KeepingSink>(true, numbers, rows), 1, {8, 0.5});
  EXPECT_TRUE(writer.wants_counts());
  const std::array<std::complex<double>, 3> first{{{1.0, -1.0}, {0.0, 0.1}, {1e3, 0.0}}};
  const std::array<std::complex<float>, 1> second{{{2.5F, 0.0F}}};
  writer.append(first);
  writer.append(second);
  EXPECT_THAT(numbers, ElementsAre(2, -2, 0, 0, 128, 0, 5, 0));
  EXPECT_THAT(rows, ElementsAre(0, 3, 3, 1));
  EXPECT_EQ(writer.tally().saturated, 1U);
  EXPECT_EQ(writer.tally().zero, 1U);
}

TEST(RasterWriter, PassesNumbersOnWhereTheSinkTakesVolts) {
  std::vector<double> numbers;
  std::vector<std::size_t> rows;
  RasterWriter writer(std::make_unique<KeepingSink>(false, numbers, rows), 2, {8, 0.5});
  EXPECT_FALSE(writer.wants_counts());
  writer.append(std::array<std::complex<double>, 2>{{{1.25, -1.0}, {0.0, 0.1}}});
  RunReport report;
  report.lsb_v = 7.0;
  writer.finish(report);
  EXPECT_THAT(numbers, ElementsAre(1.25, -1.0, 0.0, 0.1, 7.0));
  EXPECT_THAT(rows, ElementsAre(0, 1));
  EXPECT_EQ(writer.tally().zero, 0U);
}

}  // namespace raster_writer_test
}  // namespace sarsim::raster
