#include "signal/sar/swath_loss.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/focus_frame.hpp"

namespace sarsim::signal {

namespace {

// A piece of the spectrum of a point: its wave numbers, and the error of its phase in turns.
struct SpectrumPiece {
  double azimuth_per_m = 0.0;
  double range_per_m = 0.0;
  double turns = 0.0;
};

std::vector<SpectrumPiece> pieces_of(const FocusFrame& frame, double range_m, double lowest_hz, double highest_hz) {
  constexpr int count = 33;
  const SarWaveform& wave = frame.waveform;
  const double share = (range_m - frame.reference_range_m) / frame.reference_range_m;
  std::vector<SpectrumPiece> pieces;
  for (int d = 0; d < count; ++d) {
    const double doppler_hz = lowest_hz + (highest_hz - lowest_hz) * (static_cast<double>(d) + 0.5) / count;
    const double sine = std::clamp(frame.sine(doppler_hz), -0.999, 0.999);
    const double cosine = std::sqrt(1.0 - sine * sine);
    for (int k = 0; k < count; ++k) {
      const double hz = std::abs(wave.bandwidth_hz) * ((static_cast<double>(k) + 0.5) / count - 0.5);
      pieces.push_back({doppler_hz / frame.track.speed_mps,
                        radar::turns_per_m(wave.carrier_hz * (cosine - 1.0) + hz / cosine, wave.light_speed_mps),
                        -share * secondary_turns(frame, hz, sine, cosine)});
    }
  }
  return pieces;
}

std::complex<double> mean_at(const std::vector<SpectrumPiece>& pieces, const ImagePlace& place) {
  std::complex<double> sum;
  for (const SpectrumPiece& piece : pieces)
    sum +=
        std::polar(1.0, 2.0 * core::pi *
                            (piece.turns + piece.azimuth_per_m * place.azimuth_m + piece.range_per_m * place.range_m));
  return sum / static_cast<double>(pieces.size());
}

// Climbs from the ideal place, in steps that are halved when none of them leads higher.
ImagePlace peak_of_pieces(const std::vector<SpectrumPiece>& pieces, double azimuth_step_m, double range_step_m) {
  constexpr int halvings = 8;
  ImagePlace peak;
  double height = std::abs(mean_at(pieces, peak));
  for (int i = 0; i < halvings; ++i, azimuth_step_m *= 0.5, range_step_m *= 0.5) {
    for (bool higher = true; higher;) {
      higher = false;
      for (const auto& [da, dr] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1),
                                   std::pair(1, 1), std::pair(-1, -1), std::pair(1, -1), std::pair(-1, 1)}) {
        const ImagePlace next{peak.azimuth_m + da * azimuth_step_m, peak.range_m + dr * range_step_m};
        const double there = std::abs(mean_at(pieces, next));
        if (!(there > height)) continue;
        height = there;
        peak = next;
        higher = true;
      }
    }
  }
  return peak;
}

}  // namespace

SwathLoss loss_off_mid_swath(const EchoRows& echoes, const FocusOptions& options, double range_m,
                             double lowest_doppler_hz, double highest_doppler_hz) {
  CORE_EXPECT(options.method != FocusMethod::omega_k);
  CORE_EXPECT(highest_doppler_hz >= lowest_doppler_hz);
  const FocusFrame frame = focus_frame(echoes, options);
  const std::vector<SpectrumPiece> pieces = pieces_of(frame, range_m, lowest_doppler_hz, highest_doppler_hz);
  const double cell_m = radar::range_of_cycle(std::abs(frame.waveform.bandwidth_hz), frame.waveform.light_speed_mps);
  const double line_m = highest_doppler_hz > lowest_doppler_hz
                            ? frame.track.speed_mps / (highest_doppler_hz - lowest_doppler_hz)
                            : cell_m;
  SwathLoss loss{.from_middle_m = range_m - frame.reference_range_m};
  loss.shift = peak_of_pieces(pieces, 0.25 * line_m, 0.25 * cell_m);
  const std::complex<double> peak = mean_at(pieces, loss.shift);
  loss.amplitude = std::abs(peak);
  loss.phase_rad = std::arg(peak);
  return loss;
}

}  // namespace sarsim::signal
