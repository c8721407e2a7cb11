#include "core/task/sample_rows.hpp"

#include <gtest/gtest.h>

#include "core/report/expect.hpp"

namespace sarsim::core {
namespace sample_rows_test {

using Values = std::vector<std::complex<double>>;

Values row_of(const SampleRows<double>& rows, std::size_t row) {
  Values out(rows.columns);
  rows.read(row, out);
  return out;
}

TEST(SampleRows, InMemoryAreTheValuesRowByRow) {
  const Values values{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const SampleRows<double> rows = rows_in_memory(std::span(values), 2, 3);
  EXPECT_EQ(rows.rows, 2U);
  EXPECT_EQ(rows.columns, 3U);
  EXPECT_EQ(row_of(rows, 0), (Values{1.0, 2.0, 3.0}));
  EXPECT_EQ(row_of(rows, 1), (Values{4.0, 5.0, 6.0}));
}

TEST(SampleRows, InMemoryKeepTheirValues) {
  auto values = std::make_shared<const Values>(Values{1.0, 2.0});
  const std::weak_ptr<const Values> watched = values;
  {
    const SampleRows<double> rows = rows_in_memory(values, 2, 1);
    values.reset();
    EXPECT_EQ(row_of(rows, 1), Values{2.0});
  }
  EXPECT_TRUE(watched.expired());
}

TEST(SampleRows, AreReadWithinTheirBoundsOnly) {
  if (!checks_expectations()) GTEST_SKIP() << "this build checks no expectations";
  const Values values{1.0, 2.0};
  const SampleRows<double> rows = rows_in_memory(std::span(values), 1, 2);
  Values out(2);
  EXPECT_THROW(rows.read(1, out), BrokenExpectation);
  EXPECT_THROW(rows.read(0, std::span(out).first(1)), BrokenExpectation);
  EXPECT_THROW(SampleRows<double>{}.read(0, {}), BrokenExpectation);
  EXPECT_THROW(rows_in_memory(std::span(values), 2, 2).read(1, out), BrokenExpectation);
}

}  // namespace sample_rows_test
}  // namespace sarsim::core
