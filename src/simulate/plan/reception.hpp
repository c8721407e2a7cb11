#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "radar/echo/reference_kernel.hpp"
#include "scene/model/recording.hpp"
#include "signal/compress/range_compression.hpp"
#include "signal/stepped/range_profile.hpp"
#include "simulate/resolve/link.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// What a receiver does with the echoes of a pulse until they are samples of a row.
struct Reception {
  scene::Processing processing = scene::Processing::raw;
  double sample_rate_hz = 0.0;
  radar::EchoPulse pulse;
  radar::SampleGrid raw_grid;  ///< Times of the samples that are simulated.
  std::int64_t noise_first_sample = 0;
  double noise_stddev_v = 0.0;                                ///< In I and in Q.
  std::vector<double> stc_gain;                               ///< Per raw sample; empty: 1.
  std::shared_ptr<const signal::RangeCompressor> compressor;  ///< Of range-compressed rows.
  std::shared_ptr<const signal::RangeProfiler> profiler;      ///< Of synthetic range profiles.
  std::size_t columns = 0;
  std::vector<double> column_range_m;  ///< Slant range: half of what light travels in the delay of a column.

  /// Whether rows are echoes as they are received.
  [[nodiscard]] bool is_raw() const { return processing == scene::Processing::raw; }
  /// Whether rows are range-compressed by the matched filter.
  [[nodiscard]] bool is_compressed() const { return processing == scene::Processing::matched_filter; }
  /// Whether rows are synthetic range profiles, each of a burst.
  [[nodiscard]] bool is_profile() const { return processing == scene::Processing::srp; }
};

/// Range samples of a window: floor(2 fs (end - start)/c + 1/2) (decision 2).
[[nodiscard]] double sample_count(const scene::Simulation& simulation, double light_speed_mps);

/// What the receiver of a recording does.
/// @throws std::invalid_argument where its window holds no sample, or more than a row may have.
[[nodiscard]] Reception reception_of(const Link& link, const ResolvedScene& scene, const scene::Simulation& simulation);

}  // namespace sarsim::simulate
