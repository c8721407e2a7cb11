#include "simulate/plan/cost_of_pulse.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"
#include "radar/echo/shape_table.hpp"
#include "radar/echo/slepian_row.hpp"
#include "radar/path/path.hpp"
#include "simulate/plan/point_groups.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

namespace {

// Nanoseconds on one core of 2024 with AVX-512. The choice needs their ratios alone.
constexpr double reference_echo_ns = 150.0;
constexpr double reference_sample_ns = 18.0;
constexpr double direct_echo_ns = 40.0;
constexpr double direct_sample_ns = 0.13;
constexpr double envelope_sample_ns = 0.22;
constexpr double user_sample_ns = 0.25;
constexpr double band_limited_sample_ns = 0.62;
constexpr double knot_ns = 5.0;       // of a curve, which ends a run of samples
constexpr double untabled_ns = 20.0;  // pulses too long for a table take the reference
constexpr double spread_ns = 4.0;
constexpr double doppler_term_ns = 1.0;  // the weight of each further one
constexpr double edge_sample_ns = 0.28;
// Where many echoes fall on each sample: each of them, what motion adds, and each point of each transform.
constexpr double bin_echo_ns = 3.7;
constexpr double bin_motion_ns = 0.8;
constexpr double bin_point_ns = 1.9;
constexpr double transform_point_ns = 2.2;
// Of a point, for each doubling beyond what stays in the cache of a core.
constexpr double transform_octave_ns = 1.7;
constexpr double bin_octave_ns = 0.5;
constexpr double cached_points = 32768.0;
constexpr double double_precision_times = 2.6;
constexpr double min_single_tolerance = 9.9e-7;

// Of transforms of so many points in all.
double point_ns(double cached_ns, double octave_ns, double points) {
  return cached_ns + octave_ns * std::max(0.0, std::log2(std::max(points, 1.0) / cached_points));
}

struct DopplerRange {
  double lowest = 0.0;
  double highest = 0.0;
};

// The widest range of 2v/c among the echoes of any of a few pulses, of at most a thousand scatterers each.
DopplerRange widest_doppler(const ResolvedScene& scene, const Link& radar, const radar::PulseRange& pulses) {
  constexpr std::size_t most = 1000;
  PulseGeometry geometry(scene, radar);
  const std::size_t stride = scene.scatterers.size() / most + 1;
  DopplerRange widest;
  for (const double share : {0.0, 0.5, 1.0}) {
    geometry.set_pulse(pulses.first + std::llround(share * static_cast<double>(pulses.count() - 1)));
    const radar::Pointing pointing = geometry.pointing();
    DopplerRange here{1.0, -1.0};
    for (std::size_t i = 0; i < scene.scatterers.size(); i += stride) {
      const double d = geometry.view(i, pointing).clock.doppler;
      here = {std::min(here.lowest, d), std::max(here.highest, d)};
    }
    if (here.highest - here.lowest >= widest.highest - widest.lowest) widest = here;
  }
  return widest;
}

double scatterer_count(const ResolvedScene& scene) {
  auto count = static_cast<double>(scene.scatterers.size());
  for (const ScattererSheet& sheet : scene.sheets) count += static_cast<double>(sheet.points_m.size());
  return count;
}

double direct_ns_per_sample(const radar::EchoPulse& pulse, const radar::SampleGrid& grid, double samples,
                            double tolerance) {
  const bool user = pulse.pulse.kind == radar::Pulse::Kind::user;
  if (!pulse.band_limited && !user && pulse.pulse.envelope == radar::Pulse::Envelope::rectangular)
    return direct_sample_ns;
  if (!radar::ShapeTable::is_worth_making(pulse, grid, tolerance >= 1e-6)) return untabled_ns;
  if (pulse.band_limited) return band_limited_sample_ns;
  const double knots = std::min(static_cast<double>(pulse.pulse.breaks_s().size()), samples);
  return (user ? user_sample_ns : envelope_sample_ns) + knot_ns * knots / std::max(samples, 1.0);
}

}  // namespace

PulseCost::PulseCost(const ResolvedScene& scene, const Link& radar, const radar::EchoPulse& pulse,
                     const radar::SampleGrid& grid, double tolerance)
    : scene_(scene),
      radar_(radar),
      pulse_(pulse),
      grid_(grid),
      tolerance_(tolerance),
      echoes_(scatterer_count(scene)),
      samples_(std::min((pulse.last_s() - pulse.first_s()) / grid.interval_s, static_cast<double>(grid.count))) {
  CORE_EXPECT(grid.interval_s > 0.0);
  CORE_EXPECT(tolerance > 0.0);
}

double PulseCost::reference_ns() const { return echoes_ * (reference_echo_ns + samples_ * reference_sample_ns); }

double PulseCost::direct_ns() const {
  return echoes_ * (direct_echo_ns + samples_ * direct_ns_per_sample(pulse_, grid_, samples_, tolerance_));
}

SpectralEstimate PulseCost::spectral(const radar::PulseRange& pulses) const {
  const DopplerRange doppler = widest_doppler(scene_, radar_, pulses);
  SpectralEstimate estimate;
  estimate.cost = radar::SpectralKernel::cost(pulse_, grid_, tolerance_, radar_.carrier.highest_hz(), doppler.lowest,
                                              doppler.highest);
  const auto terms = static_cast<double>(estimate.cost.doppler_terms);
  const double precision = tolerance_ < min_single_tolerance ? double_precision_times : 1.0;
  const auto points = terms * static_cast<double>(estimate.cost.transform_size);
  estimate.ns = precision * echoes_ *
                    (spread_ns + doppler_term_ns * (terms - 1.0) +
                     edge_sample_ns * static_cast<double>(estimate.cost.edge_samples)) +
                precision * points * point_ns(transform_point_ns, transform_octave_ns, points);
  const std::size_t transforms = estimate.cost.bin_transforms;
  const auto bin_points = static_cast<double>(transforms * estimate.cost.bin_points);
  estimate.in_bins = transforms > 0 && radar::SlepianRow::is_worth(echoes_, transforms, estimate.cost.bin_points,
                                                                   estimate.cost.doppler_terms);
  if (estimate.in_bins)
    estimate.ns = echoes_ * (bin_echo_ns + (terms > 1.0 ? bin_motion_ns : 0.0)) +
                  bin_points * point_ns(bin_point_ns, bin_octave_ns, bin_points);
  return estimate;
}

}  // namespace sarsim::simulate
