#include "workflow/focus/motion_residual.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/maths/sinc.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/ground_sight.hpp"
#include "signal/sar/phasor_sum.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/target_sights.hpp"

namespace sarsim::workflow {

namespace {

// Of one pulse.
struct ResidualEcho {
  double weight = 0.0;
  double true_m = 0.0;        // distance, more than the method assumes before its phases are corrected
  double left_m = 0.0;        // and after
  double cycles_per_m = 0.0;  // of azimuth: its place in the spectrum
};

// What a method takes the distances of a target for.
class ResidualsOfFlight {
 public:
  ResidualsOfFlight(const signal::EchoRows& echoes, const TakenFlight& flight)
      : echoes_(echoes),
        flight_(flight),
        straight_(signal::fit_straight(echoes.track)),
        sight_(flight.how.reference, flight.how.scene_m,
               flight.kind == TakenFlight::Kind::compensated ? flight.how.squint_rad : 0.0),
        per_m_(radar::turns_per_m(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps)) {}

  [[nodiscard]] ResidualEcho of(const PulseSight& sight) const {
    ResidualEcho echo = error_of(sight);
    echo.weight = sight.amplitude;
    return echo;
  }
  [[nodiscard]] double turns_per_m() const { return per_m_; }

 private:
  [[nodiscard]] ResidualEcho error_of(const PulseSight& sight) const {
    switch (flight_.kind) {
      case TakenFlight::Kind::even: return even(sight);
      case TakenFlight::Kind::compensated: return compensated(sight);
      case TakenFlight::Kind::flown: break;
    }
    return flown(sight);
  }

  [[nodiscard]] ResidualEcho even(const PulseSight& sight) const {
    const double along_m = straight_.speed_mps * straight_.time_s(static_cast<double>(sight.pulse));
    const core::Vec3 from_line_m = sight.point_m - (straight_.origin_m + along_m * straight_.along);
    const double assumed_m = core::norm(from_line_m);
    const double error_m = core::norm(sight.point_m - sight.antenna_m) - assumed_m;
    return {0.0, error_m, error_m, per_m_ * core::dot(from_line_m, straight_.along) / assumed_m};
  }

  [[nodiscard]] ResidualEcho compensated(const PulseSight& sight) const {
    const core::Vec3 foot_m = sight_.foot_of(sight.antenna_m);
    const core::Vec3 from_foot_m = sight.point_m - foot_m;
    const double distance_m = core::norm(from_foot_m);
    const double error_m = core::norm(sight.point_m - sight.antenna_m) - distance_m;
    // The pulse itself is moved by what the scene needs.
    const double moved_m = difference_m(sight.antenna_m, foot_m, sight_.range_m());
    const double turned_m = flight_.how.second_order ? difference_m(sight.antenna_m, foot_m, distance_m) : moved_m;
    return {0.0, error_m - moved_m, error_m - turned_m, per_m_ * core::dot(from_foot_m, sight_.ahead()) / distance_m};
  }

  // |P - X| - |Q - X| of the ground at a distance from Q.
  [[nodiscard]] double difference_m(const core::Vec3& antenna_m, const core::Vec3& foot_m, double range_m) const {
    const core::Vec3 ground_m = sight_.point_at(foot_m, range_m);
    return core::norm(antenna_m - ground_m) - core::norm(foot_m - ground_m);
  }

  [[nodiscard]] ResidualEcho flown(const PulseSight& sight) const {
    core::Vec3 point_m = sight.point_m;
    if (flight_.on_grid) {
      point_m.z = flight_.how.scene_m.z;
    } else {
      const core::Vec3 foot_m = sight_.foot_of(point_m);
      point_m = sight_.point_at(foot_m, core::norm(point_m - foot_m));
    }
    const core::Vec3 taken_m = point_m - sight.antenna_m;
    const double error_m = core::norm(sight.point_m - sight.antenna_m) - core::norm(taken_m);
    return {0.0, error_m, error_m, per_m_ * core::dot(taken_m, sight_.ahead()) / core::norm(taken_m)};
  }

  const signal::EchoRows& echoes_;
  const TakenFlight& flight_;
  signal::StraightTrack straight_;
  signal::GroundSight sight_;
  double per_m_;
};

// The echoes of a target that are within 20 dB of the strongest and kept, and the sum of their weights. What folds away
// is missing from the image whatever the flight.
struct KeptEchoes {
  std::vector<ResidualEcho> echoes;
  double ideal = 0.0;
};

KeptEchoes kept_echoes(std::span<const PulseSight> sights, const ResidualsOfFlight& residuals,
                       const TakenFlight& flight) {
  double strongest = 0.0;
  for (const PulseSight& sight : sights) strongest = std::max(strongest, sight.amplitude);
  KeptEchoes kept;
  for (const PulseSight& sight : sights) {
    if (!(sight.amplitude > 0.0 && sight.amplitude >= 0.1 * strongest)) continue;
    const ResidualEcho echo = residuals.of(sight);
    const bool inside = echo.cycles_per_m >= flight.kept.min_per_m && echo.cycles_per_m <= flight.kept.max_per_m;
    if (!inside) continue;
    kept.ideal += echo.weight;
    kept.echoes.push_back(echo);
  }
  return kept;
}

// An echo that lies beside the others in range adds less to their peak.
void weigh_by_lag(std::vector<ResidualEcho>& echoes, const signal::SarWaveform& wave) {
  double sum = 0.0;
  double lag = 0.0;
  for (const ResidualEcho& echo : echoes) {
    sum += echo.weight;
    lag += echo.weight * echo.true_m;
  }
  for (ResidualEcho& echo : echoes) {
    const double lag_s = radar::delay_of(echo.true_m - lag / sum, wave.light_speed_mps);
    echo.weight *= std::max(0.0, core::sinc(wave.bandwidth_hz * lag_s));
  }
}

std::vector<signal::SpectrumPhasor> phasors_of(std::span<const ResidualEcho> echoes, double turns_per_m) {
  std::vector<signal::SpectrumPhasor> phasors;
  phasors.reserve(echoes.size());
  for (const ResidualEcho& echo : echoes)
    phasors.push_back({.azimuth_per_m = echo.cycles_per_m, .weight = echo.weight, .turns = -turns_per_m * echo.left_m});
  return phasors;
}

// The largest sum near a place: on a grid of eighths of a cell, then by thirds of what is left.
double largest_near(std::span<const signal::SpectrumPhasor> phasors, double azimuth_m, double cell_m) {
  constexpr int steps = 24;
  const auto power_at = [&](double place_m) { return std::norm(signal::phasor_sum(phasors, {place_m, 0.0})); };
  double best_m = azimuth_m;
  double best = power_at(azimuth_m);
  for (int i = -steps; i <= steps; ++i) {
    const double place_m = azimuth_m + 0.125 * cell_m * i;
    if (const double power = power_at(place_m); power > best) {
      best = power;
      best_m = place_m;
    }
  }
  for (double half_m = 0.125 * cell_m; half_m > 1e-5 * cell_m; half_m *= 2.0 / 3.0) {
    const double third_m = half_m / 3.0;
    best_m += power_at(best_m - third_m) < power_at(best_m + third_m) ? third_m : -third_m;
  }
  return best_m;
}

// Moments of the phase over the spectrum: its straight line moves the peak.
struct ResidualLine {
  double rms_rad = 0.0;
  double bent_rad = 0.0;  // rms of what the line leaves
  double slope_m = 0.0;   // turns for each cycle per metre
  double cell_m = 0.0;
};

ResidualLine line_of(std::span<const ResidualEcho> echoes, double turns_per_m) {
  double sum = 0.0, turns = 0.0, square = 0.0, place = 0.0, place_square = 0.0, product = 0.0;
  double least = INFINITY, most = -INFINITY;
  for (const ResidualEcho& echo : echoes) {
    const double left = -turns_per_m * echo.left_m;
    sum += echo.weight;
    turns += echo.weight * left;
    square += echo.weight * left * left;
    place += echo.weight * echo.cycles_per_m;
    place_square += echo.weight * echo.cycles_per_m * echo.cycles_per_m;
    product += echo.weight * left * echo.cycles_per_m;
    least = std::min(least, echo.cycles_per_m);
    most = std::max(most, echo.cycles_per_m);
  }
  ResidualLine line;
  if (!(sum > 0.0)) return line;
  const double spread = place_square - place * place / sum;
  line.rms_rad = 2.0 * core::pi * std::sqrt(square / sum);
  line.slope_m = spread > 0.0 ? (product - turns * place / sum) / spread : 0.0;
  const double about_middle = square / sum - (turns / sum) * (turns / sum);
  line.bent_rad = 2.0 * core::pi * std::sqrt(std::max(0.0, about_middle - line.slope_m * line.slope_m * spread / sum));
  line.cell_m = most > least ? 1.0 / (most - least) : 0.0;
  return line;
}

double place_of_peak(std::span<const signal::SpectrumPhasor> phasors, const ResidualLine& line) {
  constexpr double nothing_rad = 1e-4;
  constexpr double max_bent_rad = 0.5;  // Below it the peak at the line's place is the largest.
  if (line.rms_rad < nothing_rad) return 0.0;
  if (line.bent_rad < max_bent_rad)
    if (const auto peak = signal::phasor_peak(phasors, {-line.slope_m, 0.0})) return peak->azimuth_m;
  return largest_near(phasors, -line.slope_m, line.cell_m);
}

std::optional<MotionResidual> residual_of(std::size_t target, KeptEchoes kept, const signal::SarWaveform& wave,
                                          const TakenFlight& flight, double turns_per_m) {
  std::vector<ResidualEcho>& echoes = kept.echoes;
  if (echoes.empty()) return std::nullopt;
  weigh_by_lag(echoes, wave);
  const ResidualLine line = line_of(echoes, turns_per_m);
  const std::vector<signal::SpectrumPhasor> phasors = phasors_of(echoes, turns_per_m);
  MotionResidual residual{.target = target, .rms_rad = line.rms_rad, .azimuth_m = place_of_peak(phasors, line)};
  residual.cell_m = line.cell_m;
  residual.cells = line.cell_m > 0.0 ? std::abs(residual.azimuth_m) / line.cell_m : 0.0;
  const std::complex<double> peak = signal::phasor_sum(phasors, {residual.azimuth_m, 0.0});
  residual.amplitude = std::abs(peak) / kept.ideal;
  residual.phase_rad =
      std::remainder(std::arg(peak) - 2.0 * core::pi * flight.carrier_per_m * residual.azimuth_m, 2.0 * core::pi);
  return residual;
}

// Frequencies of the pulse, in parts of its band.
constexpr int band_parts = 9;

// The part of the plane of wave numbers that the echoes of a target fill, with the phases that are left there: those of
// the carrier are corrected, those beside it follow where the echoes lie.
std::vector<signal::SpectrumPhasor> phasors_of_band(std::span<const ResidualEcho> echoes,
                                                    const signal::SarWaveform& wave, double turns_per_m) {
  std::vector<signal::SpectrumPhasor> phasors;
  phasors.reserve(echoes.size() * band_parts);
  for (int k = 0; k < band_parts; ++k) {
    const double beside = wave.bandwidth_hz / wave.carrier_hz * ((k + 0.5) / band_parts - 0.5);
    for (const ResidualEcho& echo : echoes) {
      const double sine = std::clamp(echo.cycles_per_m / turns_per_m, -1.0, 1.0);
      phasors.push_back({.azimuth_per_m = (1.0 + beside) * echo.cycles_per_m,
                         .range_per_m = turns_per_m * ((1.0 + beside) * std::sqrt(1.0 - sine * sine) - 1.0),
                         .weight = echo.weight / band_parts,
                         .turns = -turns_per_m * (echo.left_m + beside * echo.true_m)});
    }
  }
  return phasors;
}

// A displacement in cells, along the line of sight in the middle of the echoes or across it, the larger.
double cells_of(const signal::ImagePlace& moved, std::span<const ResidualEcho> echoes, const signal::SarWaveform& wave,
                double turns_per_m) {
  const auto angle = [&](const ResidualEcho& echo) {
    return std::asin(std::clamp(echo.cycles_per_m / turns_per_m, -1.0, 1.0));
  };
  const auto [low, high] = std::ranges::minmax(echoes, {}, &ResidualEcho::cycles_per_m);
  const double middle_rad = 0.5 * (angle(low) + angle(high));
  const double along_m = moved.azimuth_m * std::sin(middle_rad) + moved.range_m * std::cos(middle_rad);
  const double across_m = moved.azimuth_m * std::cos(middle_rad) - moved.range_m * std::sin(middle_rad);
  const double band_per_m = turns_per_m * std::abs(wave.bandwidth_hz) / wave.carrier_hz;
  return std::max(std::abs(along_m) * band_per_m, std::abs(across_m) * turns_per_m * (angle(high) - angle(low)));
}

// The same residual with its peak where it is in both coordinates; as it is where that leads to none.
void place_in_plane(MotionResidual& residual, const KeptEchoes& kept, const signal::SarWaveform& wave,
                    const TakenFlight& flight, double turns_per_m) {
  const std::vector<signal::SpectrumPhasor> phasors = phasors_of_band(kept.echoes, wave, turns_per_m);
  const auto peak = signal::phasor_peak(phasors, {residual.azimuth_m, 0.0});
  if (!peak) return;
  const std::complex<double> sum = signal::phasor_sum(phasors, *peak);
  const double carried = flight.carrier_per_m * peak->azimuth_m + flight.range_carrier_per_m * peak->range_m;
  residual.azimuth_m = peak->azimuth_m;
  residual.range_m = peak->range_m;
  residual.cells = cells_of(*peak, kept.echoes, wave, turns_per_m);
  residual.amplitude = std::abs(sum) / kept.ideal;
  residual.phase_rad = std::remainder(std::arg(sum) - 2.0 * core::pi * carried, 2.0 * core::pi);
}

}  // namespace

double MotionResidual::lost_db() const { return -core::amplitude_db(amplitude); }

double excess_of(const std::optional<MotionResidual>& residual) {
  if (!residual) return 0.0;
  return std::max({std::abs(residual->phase_rad) / max_residual_rad, residual->lost_db() / max_residual_db,
                   residual->cells / max_residual_cells});
}

std::optional<MotionResidual> worst_motion_residual(const simulate::Acquisition& acquisition,
                                                    const signal::EchoRows& echoes, const TakenFlight& flight,
                                                    const core::WorkControl& control) {
  const SightLimits limits;
  const std::size_t every = target_stride(acquisition, limits);
  if (every == 0 || echoes.track.size() < 2) return std::nullopt;
  const ResidualsOfFlight residuals(echoes, flight);
  std::vector<std::optional<MotionResidual>> all((acquisition.scene->scatterers.size() + every - 1) / every);
  std::vector<KeptEchoes> kept(all.size());
  each_target_in_sight(acquisition, echoes, limits, control,
                       [&](std::size_t target, std::span<const PulseSight> sights) {
                         const std::size_t t = target / every;
                         kept[t] = kept_echoes(sights, residuals, flight);
                         all[t] = residual_of(target, kept[t], echoes.waveform, flight, residuals.turns_per_m());
                       });
  std::vector<std::size_t> worst_first;
  for (std::size_t t = 0; t < all.size(); ++t)
    if (all[t]) worst_first.push_back(t);
  std::ranges::stable_sort(worst_first, std::greater<>(), [&](std::size_t t) { return excess_of(all[t]); });
  constexpr std::size_t most = 4;
  std::optional<MotionResidual> worst;
  for (const std::size_t t : std::span(worst_first).first(std::min(most, worst_first.size()))) {
    if (!flight.on_grid) place_in_plane(*all[t], kept[t], echoes.waveform, flight, residuals.turns_per_m());
    if (!worst || excess_of(all[t]) > excess_of(worst)) worst = all[t];
  }
  return worst;
}

std::string text_of(const std::optional<MotionResidual>& residual) {
  if (!residual) return "nothing";
  return fmt::format("{:.3f} rad and {:.2f} dB at target {}", std::abs(residual->phase_rad),
                     std::abs(residual->lost_db()), residual->target + 1);
}

core::Problems diagnose_residual(const std::optional<MotionResidual>& residual, TakenFlight::Kind kind) {
  if (!(excess_of(residual) > 1.0)) return {};
  const char* what = "motion compensation, computed for level ground at beam centre,";
  const char* hint = "use --algorithm back-projection, which follows the flown track";
  if (kind == TakenFlight::Kind::even) {
    what = "focusing along the fitted straight line at constant speed";
  } else if (kind == TakenFlight::Kind::flown) {
    what = "back-projection, computed for level ground,";
    hint = "give the height of the ground at the target by --height";
  }
  return {core::warning("focus.motion-residual",
                        fmt::format("{} leaves {:.2g} rad rms residual phase at target {}: peak loss {:.2g} dB, phase "
                                    "error {:.2g} rad, position error {:.2g} m in azimuth and {:.2g} m in range",
                                    what, residual->rms_rad, residual->target + 1, std::max(residual->lost_db(), 0.0),
                                    residual->phase_rad, std::abs(residual->azimuth_m), std::abs(residual->range_m)))
              .expected(fmt::format("up to {:.2f} rad, {:.1f} dB and {:.2f} of a resolution cell", max_residual_rad,
                                    max_residual_db, max_residual_cells))
              .hint(hint)};
}

}  // namespace sarsim::workflow
