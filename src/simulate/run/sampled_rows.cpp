#include "simulate/run/sampled_rows.hpp"

#include <algorithm>
#include <atomic>
#include <bit>

#include "core/report/expect.hpp"

namespace sarsim::simulate {

SampledRowMaker::SampledRowMaker(const Plan& plan, const SampleSelection& selection, const core::StopFlag* stop)
    : plan_(&plan), selection_(&selection), stop_(stop), rows_(plan), row_(plan.acquisition.reception.columns) {}

void SampledRowMaker::make_row(std::size_t row, std::span<std::complex<double>> out) {
  CORE_EXPECT(row < selection_->rows.size());
  CORE_EXPECT(out.size() == selection_->columns.size());
  const IndexSpan wanted = selection_->rows[row];
  const bool peak = selection_->pick == SampleSelection::Pick::peak;
  const std::size_t end = peak ? wanted.end : wanted.begin + 1;
  for (std::size_t r = wanted.begin; r < end; ++r) {
    if (stop_ != nullptr && stop_->requested()) throw core::Interrupted();
    rows_.make_row(r, row_);
    if (r == wanted.begin) pick_firsts(out);
    if (peak) raise_to_peaks(out);
  }
}

void SampledRowMaker::pick_firsts(std::span<std::complex<double>> out) const {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = row_[selection_->columns[k].begin];
}

void SampledRowMaker::raise_to_peaks(std::span<std::complex<double>> out) const {
  for (std::size_t k = 0; k < out.size(); ++k) {
    double largest = std::norm(out[k]);
    for (std::size_t c = selection_->columns[k].begin; c < selection_->columns[k].end; ++c) {
      const double power = std::norm(row_[c]);
      if (!(power > largest)) continue;
      largest = power;
      out[k] = row_[c];
    }
  }
}

std::vector<std::size_t> refinement_order(std::size_t count) {
  std::vector<std::size_t> order;
  order.reserve(count);
  const int bits = count > 1 ? static_cast<int>(std::bit_width(count - 1)) : 0;
  for (std::size_t i = 0; i < std::size_t{1} << bits; ++i) {
    std::size_t reversed = 0;
    for (int b = 0; b < bits; ++b) reversed |= (i >> b & 1U) << (bits - 1 - b);
    if (reversed < count) order.push_back(reversed);
  }
  return order;
}

void compute_sampled_rows(const Plan& plan, const SampleSelection& selection, std::span<const std::size_t> order,
                          const core::WorkControl& control, std::span<std::complex<double>> out,
                          const std::function<void(std::size_t row)>& on_row) {
  CORE_EXPECT(out.size() == selection.rows.size() * selection.columns.size());
  CORE_EXPECT(std::ranges::all_of(order, [&](std::size_t row) { return row < selection.rows.size(); }));
  const std::size_t columns = selection.columns.size();
  std::atomic<std::size_t> next{0};
  const std::size_t threads = std::clamp<std::size_t>(order.size(), 1, std::max(control.threads, 1U));
  core::parallel_ranges(threads, 1, control, [&](std::size_t, std::size_t) {
    try {
      SampledRowMaker maker(plan, selection, control.stop);
      for (std::size_t n = next++; n < order.size(); n = next++) {
        maker.make_row(order[n], out.subspan(order[n] * columns, columns));
        if (on_row) on_row(order[n]);
      }
    } catch (...) {
      next.store(order.size());
      throw;
    }
  });
}

}  // namespace sarsim::simulate
