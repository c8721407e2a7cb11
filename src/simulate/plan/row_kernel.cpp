#include "simulate/plan/row_kernel.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "radar/echo/direct_kernel.hpp"
#include "simulate/plan/point_groups.hpp"

namespace sarsim::simulate {

namespace {

// What kernels need that add echoes to the row as they take them.
struct BegunRow {
  double carrier_hz = 0.0;
  std::span<std::complex<double>> samples;
  radar::SampleSpan touched;
};

class ReferenceKernel final : public RowKernel {
 public:
  ReferenceKernel(const radar::EchoPulse& pulse, const radar::SampleGrid& grid) : pulse_(pulse), grid_(grid) {}

  void begin(double carrier_hz, std::size_t /*expected*/, std::span<std::complex<double>> row) override {
    row_ = {carrier_hz, row, {}};
  }
  void take(const radar::EchoBatch& echoes) override {
    if (echoes.size() == 0) return;
    radar::add_echoes(row_.samples, grid_, pulse_, row_.carrier_hz, echoes);
    row_.touched = {0, row_.samples.size()};
  }
  radar::SampleSpan finish() override { return row_.touched; }

 private:
  const radar::EchoPulse& pulse_;
  radar::SampleGrid grid_;
  BegunRow row_;
};

class DirectRows final : public RowKernel {
 public:
  DirectRows(const radar::EchoPulse& pulse, const radar::SampleGrid& grid, double tolerance)
      : kernel_(pulse, grid, tolerance) {}

  void begin(double carrier_hz, std::size_t /*expected*/, std::span<std::complex<double>> row) override {
    row_ = {carrier_hz, row, {}};
  }
  void take(const radar::EchoBatch& echoes) override {
    if (echoes.size() > 0) row_.touched = row_.touched.with(kernel_.add(row_.samples, row_.carrier_hz, echoes));
  }
  radar::SampleSpan finish() override { return row_.touched; }

 private:
  radar::DirectKernel kernel_;
  BegunRow row_;
};

class SpectralRows final : public RowKernel {
 public:
  SpectralRows(const radar::EchoPulse& pulse, const radar::SampleGrid& grid, double tolerance,
               const radar::RowFilter& filter)
      : kernel_(pulse, grid, tolerance, filter), filtered_(!filter.taps.empty()) {}

  void begin(double carrier_hz, std::size_t expected, std::span<std::complex<double>> row) override {
    kernel_.begin(carrier_hz, expected);
    row_ = row;
    any_ = false;
  }
  void take(const radar::EchoBatch& echoes) override {
    kernel_.take(echoes);
    any_ = any_ || echoes.size() > 0;
  }
  radar::SampleSpan finish() override {
    if (!any_) return {};
    filtered_ ? kernel_.finish_filtered(row_) : kernel_.finish(row_);
    return {0, row_.size()};
  }

 private:
  radar::SpectralKernel kernel_;
  bool filtered_ = false;
  bool any_ = false;
  std::span<std::complex<double>> row_;
};

KernelCost reference_cost(const PulseCost& pulse, const radar::PulseRange& /*pulses*/) {
  return {.pulse_ns = pulse.reference_ns()};
}

KernelCost direct_cost(const PulseCost& pulse, const radar::PulseRange& /*pulses*/) {
  return {.pulse_ns = pulse.direct_ns(), .start_s = 0.8e-3};
}

KernelCost spectral_cost(const PulseCost& pulse, const radar::PulseRange& pulses) {
  constexpr std::size_t max_transform = std::size_t{1} << 27U;
  constexpr int max_doppler_terms = 20;
  const SpectralEstimate spectral = pulse.spectral(pulses);
  KernelCost cost;
  cost.pulse_ns = spectral.ns;
  cost.transform_points = static_cast<double>(spectral.cost.transform_size);
  cost.transforms = static_cast<double>(spectral.cost.doppler_terms);
  cost.start_s = 3.5e-3;
  cost.reaches = spectral.cost.doppler_terms <= max_doppler_terms && spectral.cost.transform_size <= max_transform;
  cost.work = spectral.in_bins
                  ? fmt::format("{} transforms of {} points", spectral.cost.bin_transforms, spectral.cost.bin_points)
                  : fmt::format("transforms of {} points with {} Doppler terms", spectral.cost.transform_size,
                                spectral.cost.doppler_terms);
  return cost;
}

const std::array<RowKernelKind, 3> kinds{{
    {.engine = Engine::reference,
     .name = "reference",
     .point_by_point = true,
     .speed = &MachineSpeed::reference,
     .to_measure = {.targets = 16, .rows = 16},
     .cost = reference_cost,
     .make = [](const radar::EchoPulse& pulse, const radar::SampleGrid& grid, double, const radar::RowFilter&)
         -> std::unique_ptr<RowKernel> { return std::make_unique<ReferenceKernel>(pulse, grid); }},
    {.engine = Engine::direct,
     .name = "direct",
     .speed = &MachineSpeed::direct,
     .to_measure = {.targets = 200, .rows = 128},
     .cost = direct_cost,
     .make = [](const radar::EchoPulse& pulse, const radar::SampleGrid& grid, double tolerance, const radar::RowFilter&)
         -> std::unique_ptr<RowKernel> { return std::make_unique<DirectRows>(pulse, grid, tolerance); }},
    {.engine = Engine::spectral,
     .name = "spectral",
     .filters = true,
     .points_at_once = simulate::points_at_once,
     .speed = &MachineSpeed::spectral,
     .to_measure = {.targets = 20000, .rows = 16},
     .cost = spectral_cost,
     .make = [](const radar::EchoPulse& pulse, const radar::SampleGrid& grid, double tolerance,
                const radar::RowFilter& filter) -> std::unique_ptr<RowKernel> {
       return std::make_unique<SpectralRows>(pulse, grid, tolerance, filter);
     }},
}};

}  // namespace

std::span<const RowKernelKind> row_kernels() { return kinds; }

const RowKernelKind& row_kernel(Engine engine) {
  const auto found = std::ranges::find(kinds, engine, &RowKernelKind::engine);
  CORE_EXPECT(found != kinds.end());
  return *found;
}

}  // namespace sarsim::simulate
