#include "signal/sar/work_matrix.hpp"

#include <gtest/gtest.h>

#include <system_error>

namespace sarsim::signal {
namespace work_matrix_test {

using Value = WorkMatrix::Value;

void number(WorkMatrix& matrix, const core::WorkControl& control) {
  WorkCounter counter({}, 1, 1);
  matrix.each_row(0, matrix.rows(), control, counter, [](std::size_t r, std::span<Value> row) {
    for (std::size_t c = 0; c < row.size(); ++c) row[c] = {static_cast<float>(r), static_cast<float>(c)};
  });
}

// Every value of a matrix that was numbered and whose columns were then doubled from `first` to `last`.
void expect_doubled(const WorkMatrix& matrix, std::size_t first, std::size_t last) {
  std::vector<Value> row(matrix.columns());
  for (std::size_t r = 0; r < matrix.rows(); ++r) {
    matrix.read_row(r, 0, row);
    for (std::size_t c = 0; c < row.size(); ++c) {
      const float factor = c >= first && c < last ? 2.0F : 1.0F;
      ASSERT_EQ(row[c], Value(factor * static_cast<float>(r), factor * static_cast<float>(c))) << r << ' ' << c;
    }
  }
}

TEST(WorkMatrix, IsGoneThroughByRowsAndColumnsInMemoryAndOnDisk) {
  // 0: no limit; 4000: pieces of a few rows or columns; 1: the least that is possible.
  for (const std::size_t memory : {std::size_t{0}, std::size_t{4000}, std::size_t{1}}) {
    WorkMatrix matrix(37, 53, memory);
    EXPECT_EQ(matrix.on_disk(), memory != 0);
    number(matrix, {.threads = 3});
    WorkCounter counter({}, 1, 1);
    matrix.each_column(5, 50, {.threads = 3}, counter, [](std::size_t c, std::span<Value> column) {
      ASSERT_EQ(column.size(), 37U);
      for (std::size_t r = 0; r < column.size(); ++r) {
        ASSERT_EQ(column[r], Value(static_cast<float>(r), static_cast<float>(c)));
        column[r] *= 2.0F;
      }
    });
    expect_doubled(matrix, 5, 50);
  }
}

// Rows and pieces may be long: nothing more is begun of either.
TEST(WorkMatrix, StopsBetweenRowsAndColumns) {
  for (const std::size_t memory : {std::size_t{0}, std::size_t{4000}}) {
    WorkMatrix matrix(37, 53, memory);
    number(matrix, {.threads = 1});
    core::StopFlag stop;
    int calls = 0;
    const auto body = [&](std::size_t, std::span<Value>) {
      ++calls;
      stop.request();
    };
    const core::WorkControl control{1, &stop};
    WorkCounter counter({}, 1, 1);
    EXPECT_THROW(matrix.each_row(0, 37, control, counter, body), core::Interrupted);
    EXPECT_EQ(calls, 1);
    // Asked for before: a piece on the disk is not even read.
    EXPECT_THROW(matrix.each_column(0, 53, control, counter, body), core::Interrupted);
    EXPECT_EQ(calls, 1);
  }
}

TEST(WorkMatrix, StaysInMemoryWhereThatIsEnough) { EXPECT_FALSE(WorkMatrix(10, 10, 100000).on_disk()); }

TEST(WorkMatrix, CountsCopiesOfColumnsInItsMemory) {
  // An eighth of 64 kB holds 10 columns of 100 values of 8 bytes, on one thread.
  EXPECT_EQ(WorkMatrix(100, 10, 64000).columns_at_once(1), 10U);
  EXPECT_EQ(WorkMatrix(100, 10, 64000).columns_at_once(3), 3U);
  EXPECT_EQ(WorkMatrix(100, 10, 64000).columns_at_once(100), 1U);
  EXPECT_EQ(WorkMatrix(100, 10, 1000000).columns_at_once(2), 16U);
  EXPECT_EQ(WorkMatrix(100, 10, 0).columns_at_once(100), 16U);
  // 8000 bytes of the matrix and an eighth of all for copies.
  EXPECT_TRUE(WorkMatrix(100, 10, 9000).on_disk());
  EXPECT_FALSE(WorkMatrix(100, 10, 9200).on_disk());
}

TEST(WorkMatrix, NamesTheFolderWhereItCannotMakeItsFile) {
  try {
    const WorkMatrix matrix(100, 100, 1, "/no/such/folder");
    FAIL() << "made a matrix nowhere";
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder"), std::string::npos);
  }
}

TEST(WorkMatrix, ReadsPartsOfRows) {
  for (const std::size_t memory : {std::size_t{0}, std::size_t{1}}) {
    WorkMatrix matrix(4, 9, memory);
    number(matrix, {});
    std::vector<Value> part(3);
    matrix.read_row(2, 5, part);
    EXPECT_EQ(part[1], Value(2.0F, 6.0F));
  }
}

TEST(WorkCounter, TellsInRowsAndNeverMoreThanAll) {
  std::vector<std::size_t> told;
  WorkCounter counter([&](const core::Progress& progress) { told.push_back(progress.done); }, 100, 10);
  counter.add(15);
  counter.add(80);
  counter.add(80);
  EXPECT_EQ(told, (std::vector<std::size_t>{1, 9, 10}));
}

}  // namespace work_matrix_test
}  // namespace sarsim::signal
