#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "radar/echo/echo_batch.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "radar/echo/spectral_kernel.hpp"
#include "simulate/plan/cost_of_pulse.hpp"
#include "simulate/plan/engine_kind.hpp"
#include "simulate/plan/machine_speed.hpp"

namespace sarsim::simulate {

/// Adds the echoes of a pulse to a row; each thread has its own. To begin again forgets what was taken in parts.
class RowKernel {
 public:
  RowKernel() = default;
  RowKernel(const RowKernel&) = delete;
  RowKernel& operator=(const RowKernel&) = delete;
  virtual ~RowKernel() = default;

  /// Begins a pulse.
  /// @param expected  about how many echoes will be taken; 0: unknown
  /// @param row       raw samples; compressed ones of a kernel that was made with a filter
  virtual void begin(double carrier_hz, std::size_t expected, std::span<std::complex<double>> row) = 0;
  /// Takes some of its echoes.
  virtual void take(const radar::EchoBatch& echoes) = 0;
  /// All that was taken is in the row.
  /// @return the samples outside of which the row is left as it was
  virtual radar::SampleSpan finish() = 0;
};

/// What a kernel needs for the echoes of one pulse, as if the radar saw all scatterers.
struct KernelCost {
  double pulse_ns = 0.0;
  double transform_points = 0.0;  ///< Of one pulse and Doppler term.
  double transforms = 0.0;        ///< Terms.
  double start_s = 0.0;           ///< Before the first pulse: tables of the pulse, plans of transforms.
  bool reaches = true;            ///< Whether the kernel is made for such a recording.
  std::string work = {};          ///< In words: "64 transforms of 4096 points".
};

/// By what the speed of a kernel is measured: pulses, each with the echoes of so many targets.
struct RecordingToMeasure {
  int targets = 0;
  double pulse_samples = 400.0;
  int rows = 16;
};

/// A way to sum echoes. All compute the same definition of a row.
struct RowKernelKind {
  Engine engine = Engine::reference;
  std::string_view name;           ///< On the command line and in files.
  bool point_by_point = false;     ///< Takes the echoes of the plain geometry, not those of `PointGroups`.
  bool filters = false;            ///< The matched filter can be one more factor of what it sums.
  std::size_t points_at_once = 0;  ///< Scatterers whose echoes it takes together; 0: all.
  double MachineSpeed::*speed = nullptr;
  RecordingToMeasure to_measure;
  /// What it needs for the echoes of a pulse.
  /// @param pulses  of the recording
  KernelCost (*cost)(const PulseCost& pulse, const radar::PulseRange& pulses) = nullptr;
  /// @param pulse   outlives the kernel
  /// @param filter  empty where the row is raw
  std::unique_ptr<RowKernel> (*make)(const radar::EchoPulse& pulse, const radar::SampleGrid& grid, double tolerance,
                                     const radar::RowFilter& filter) = nullptr;
};

/// All of them: the reference first, then those among which `Engine::automatic` chooses, the first where little is to
/// be summed.
[[nodiscard]] std::span<const RowKernelKind> row_kernels();
/// That of an engine, which is not automatic.
[[nodiscard]] const RowKernelKind& row_kernel(Engine engine);

}  // namespace sarsim::simulate
