#include "core/task/sample_rows.hpp"

#include <algorithm>
#include <utility>

#include "core/report/expect.hpp"

namespace sarsim::core {

namespace {

template <class Real>
SampleRows<Real> kept_rows(std::span<const std::complex<Real>> values, std::shared_ptr<const void> keeper,
                           std::size_t rows, std::size_t columns) {
  return {rows, columns, [values, keeper = std::move(keeper)](std::size_t row, std::span<std::complex<Real>> out) {
            CORE_EXPECT((row + 1) * out.size() <= values.size());
            std::copy_n(values.data() + row * out.size(), out.size(), out.data());
          }};
}

}  // namespace

template <class Real>
void SampleRows<Real>::read(std::size_t row, std::span<std::complex<Real>> out) const {
  CORE_EXPECT(copy);
  CORE_EXPECT(row < rows);
  CORE_EXPECT(out.size() == columns);
  copy(row, out);
}

template struct SampleRows<float>;
template struct SampleRows<double>;

SampleRows<float> rows_in_memory(std::shared_ptr<const std::vector<std::complex<float>>> values, std::size_t rows,
                                 std::size_t columns) {
  CORE_EXPECT(values);
  return kept_rows<float>(*values, values, rows, columns);
}

SampleRows<double> rows_in_memory(std::shared_ptr<const std::vector<std::complex<double>>> values, std::size_t rows,
                                  std::size_t columns) {
  CORE_EXPECT(values);
  return kept_rows<double>(*values, values, rows, columns);
}

SampleRows<float> rows_in_memory(std::span<const std::complex<float>> values, std::size_t rows, std::size_t columns) {
  return kept_rows<float>(values, nullptr, rows, columns);
}

SampleRows<double> rows_in_memory(std::span<const std::complex<double>> values, std::size_t rows, std::size_t columns) {
  return kept_rows<double>(values, nullptr, rows, columns);
}

}  // namespace sarsim::core
