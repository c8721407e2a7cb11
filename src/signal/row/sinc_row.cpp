#include "signal/row/sinc_row.hpp"

#include "core/report/expect.hpp"

namespace sarsim::signal {

SincRow::SincRow(double band) {
  const core::SincTable table(band);
  weights_.reserve(2 * core::SincTable::taps * (core::SincTable::steps + 1));
  for (std::size_t step = 0; step <= core::SincTable::steps; ++step)
    for (const float weight : table.weights(step)) weights_.insert(weights_.end(), 2, weight);
}

void SincRow::interpolate(std::span<const std::complex<float>> padded, std::span<const std::int32_t> whole,
                          std::span<const std::int32_t> step, std::span<const float> factors, std::ptrdiff_t first,
                          std::ptrdiff_t last, std::span<std::complex<float>> out) const {
  constexpr std::ptrdiff_t before = core::SincTable::taps / 2 - 1;
  CORE_EXPECT(padded.size() >= 2 * margin);
  CORE_EXPECT(first >= -8);
  CORE_EXPECT(last <= static_cast<std::ptrdiff_t>(padded.size() - 2 * margin) + 8);
  const Interpolation from{padded.data() + margin - before, weights_.data(), static_cast<std::int32_t>(first),
                           static_cast<std::int32_t>(last)};
  interpolate_row(from, whole, step, factors, out);
}

}  // namespace sarsim::signal
