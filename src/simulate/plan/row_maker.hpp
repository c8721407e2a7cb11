#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "simulate/plan/plan.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/plan/row_kernel.hpp"

namespace sarsim::simulate {

/// Computes rows of a plan's product, one at a time; each thread has its own.
class RowMaker {
 public:
  /// Keeps a reference to the plan.
  explicit RowMaker(const Plan& plan);

  /// @param[out] out  plan.acquisition.reception.columns samples in volts
  void make_row(std::size_t row, std::span<std::complex<double>> out) { make_row(row, out, {0, out.size()}); }
  /// The same where most of `out` is 0 already, as in a row that is used again.
  /// @param stale  samples outside of which `out` is 0
  /// @return the samples outside of which `out` is 0 now
  radar::SampleSpan make_row(std::size_t row, std::span<std::complex<double>> out, const radar::SampleSpan& stale);

 private:
  radar::SampleSpan make_raw(std::int64_t pulse, std::span<std::complex<double>> raw, const radar::SampleSpan& stale);
  void make_compressed(std::int64_t pulse, std::span<std::complex<double>> out);
  void make_profile(std::size_t row, std::span<std::complex<double>> out);

  void clip_to_window(std::optional<double> since_s);
  void take_point_by_point(std::optional<double> since_s);
  void take_groups(std::span<std::complex<double>> raw, std::optional<double> since_s);
  radar::SampleSpan add_pulse(std::span<std::complex<double>> raw, std::optional<double> since_s);
  radar::SampleSpan add_range_ambiguities(std::int64_t pulse, std::span<std::complex<double>> raw);
  void blank_while_sending(std::int64_t pulse, std::span<std::complex<double>> raw) const;
  void add_receiver_noise(std::int64_t pulse, std::span<std::complex<double>> raw) const;

  const Plan* plan_;
  PulseGeometry geometry_;
  const RowKernelKind* kind_;
  std::unique_ptr<RowKernel> kernel_;
  radar::EchoBatch echoes_;
  std::vector<std::complex<double>> raw_;
  radar::SampleSpan raw_filled_;             // outside of which `raw_` is 0
  std::vector<std::complex<double>> other_;  // the echoes of one other pulse; 0 between rows
  std::vector<std::complex<double>> scratch_;
};

}  // namespace sarsim::simulate
