#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"
#include "radar/echo/doppler_coupling.hpp"
#include "radar/echo/doppler_terms.hpp"
#include "radar/echo/gridding.hpp"
#include "radar/echo/pulse_body.hpp"
#include "radar/echo/slepian_row.hpp"
#include "radar/echo/spectral_kernel.hpp"
#include "radar/echo/spectral_settings.hpp"

namespace sarsim::radar {

SpectralCost SpectralKernel::cost(const EchoPulse& pulse, const SampleGrid& grid, double tolerance, double carrier_hz,
                                  double lowest_doppler, double highest_doppler) {
  CORE_EXPECT(grid.interval_s > 0.0);
  CORE_EXPECT(tolerance > 0.0);
  CORE_EXPECT(lowest_doppler <= highest_doppler);
  const SpectralSettings settings(tolerance);
  const PulseBody body(pulse, grid.interval_s, settings.edge_samples, settings.beta);
  const auto row = static_cast<double>(grid.count) + body.last() - body.first();
  const double shift = std::max(std::abs(lowest_doppler), std::abs(highest_doppler)) *
                       body.largest_frequency_hz(carrier_hz) * grid.interval_s;
  const DopplerSpan span = span_covering(lowest_doppler, highest_doppler);
  SpectralCost cost;
  cost.gridding_width = GriddingKernel(settings.share).width;
  cost.edge_samples = body.edges().size() * settings.edge_samples;
  cost.transform_size = static_cast<std::size_t>(4.0 * (body.half_band() + allowance_for(shift)) * row);
  if (span.half > 0.0)
    cost.doppler_terms = best_coupling(coupling_of(pulse, body, grid.interval_s, carrier_hz), body, carrier_hz,
                                       span.half, grid.interval_s, settings.motion_share())
                             .terms_for(span.half, settings.motion_share());
  if (!body.has_body()) cost.doppler_terms = max_doppler_terms + 1;
  if (settings.single_precision && SlepianRow::suits(pulse, body)) {
    cost.bin_transforms = SlepianRow::transforms_about(pulse, grid.interval_s, carrier_hz, span.half, settings.share);
    cost.bin_points = static_cast<std::size_t>(row);
  }
  return cost;
}

}  // namespace sarsim::radar
