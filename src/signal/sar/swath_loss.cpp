#include "signal/sar/swath_loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/focus_frame.hpp"
#include "signal/sar/phasor_sum.hpp"

namespace sarsim::signal {

namespace {

struct PointSpectrum {
  std::vector<SpectrumPhasor> pieces;  // those that the method keeps
  double whole = 0.0;                  // weights of all
};

class SpectrumMaker {
 public:
  SpectrumMaker(const FocusFrame& frame, double range_m)
      : frame_(frame),
        range_m_(range_m),
        row_m_(radar::range_of(frame.row_samples / frame.waveform.sample_rate_hz, frame.waveform.light_speed_mps)),
        in_azimuth_(weight_of(frame.options.azimuth_window)) {
    const auto in_range = weight_of(frame.options.range_window);
    for (int k = 0; k < count; ++k) in_range_[static_cast<std::size_t>(k)] = in_range(part_of(k));
  }

  // Adds what a pulse sees in a direction. Pulses count from -1/2 to 1/2 over the record.
  void add(PointSpectrum& spectrum, const SeenDirection& seen, double pulse) const {
    for (int k = 0; k < count; ++k) {
      const double hz = std::abs(frame_.waveform.bandwidth_hz) * part_of(k);
      const double doppler_hz = doppler_of(seen.sine, hz);
      const double weight = seen.weight * in_range_[static_cast<std::size_t>(k)] * azimuth_weight(doppler_hz, pulse);
      spectrum.whole += weight;
      if (keeps(hz, doppler_hz)) spectrum.pieces.push_back(piece_of(hz, doppler_hz, weight));
    }
  }

 private:
  static constexpr int count = 33;  // of frequencies over the band
  static double part_of(int k) { return (static_cast<double>(k) + 0.5) / count - 0.5; }

  [[nodiscard]] bool omega_k() const { return frame_.options.method == FocusMethod::omega_k; }

  [[nodiscard]] double doppler_of(double sine, double hz) const {
    return radar::turns_of(frame_.track.speed_mps * sine, frame_.waveform.carrier_hz + hz,
                           frame_.waveform.light_speed_mps);
  }

  [[nodiscard]] double azimuth_weight(double doppler_hz, double pulse) const {
    const double band_hz = frame_.options.doppler_bandwidth_hz;
    return in_azimuth_(band_hz > 0.0 ? (doppler_hz - frame_.options.doppler_centroid_hz) / band_hz : pulse);
  }

  [[nodiscard]] bool keeps(double hz, double doppler_hz) const {
    const double stretch = 1.0 + hz / frame_.waveform.carrier_hz;
    const double centroid_hz = frame_.unfolds ? stretch * frame_.options.doppler_centroid_hz : frame_.doppler_middle_hz;
    if (!(std::abs(doppler_hz - centroid_hz) <= 0.5 * frame_.prf_hz())) return false;
    const double sine = frame_.sine(doppler_hz);
    if (!omega_k()) return std::abs(sine) < max_sine && is_in_rows(range_m_ / std::sqrt(1.0 - sine * sine), hz);
    const double there = std::abs(sine) / stretch;
    if (!(there < max_sine)) return false;
    constexpr double spare = 1.1;
    const double from_reference_m = range_m_ - frame_.row_reference(doppler_hz).range_m;
    return std::abs(from_reference_m) / std::sqrt(1.0 - there * there) <= spare * 0.5 * row_m_;
  }

  // Range-Doppler and chirp scaling gather the echoes of a Doppler frequency where the carrier has it: those at an edge
  // of the band lie beyond the recorded ranges where these are tight about echoes that squint. Rows of chirp scaling
  // are circles with room at both ends, in which each frequency of the pulse has its time.
  [[nodiscard]] bool is_in_rows(double range_m, double hz) const {
    const SarWaveform& wave = frame_.waveform;
    const double first_m = radar::range_of(frame_.first_delay_s, wave.light_speed_mps);
    const double sample_m = radar::range_of(1.0 / wave.sample_rate_hz, wave.light_speed_mps);
    const double place = (range_m - first_m) / sample_m;
    const auto size = static_cast<double>(frame_.range_size);
    if (frame_.options.method != FocusMethod::chirp_scaling) return place > -1.0 && place < size;
    const double room = 0.5 * (size - static_cast<double>(frame_.samples));
    const double dispersed = place + hz / wave.sample_rate_hz * dispersed_samples(wave);
    return dispersed > -room && dispersed < size - room;
  }

  [[nodiscard]] SpectrumPhasor piece_of(double hz, double doppler_hz, double weight) const {
    SpectrumPhasor piece{.azimuth_per_m = doppler_hz / frame_.track.speed_mps, .weight = weight};
    if (omega_k()) return piece;
    const SarWaveform& wave = frame_.waveform;
    const double share = (range_m_ - frame_.reference_range_m) / frame_.reference_range_m;
    const double sine = frame_.sine(doppler_hz);
    const double cosine = std::sqrt(1.0 - sine * sine);
    piece.range_per_m = radar::turns_per_m(wave.carrier_hz * (cosine - 1.0) + hz / cosine, wave.light_speed_mps);
    piece.turns = -share * secondary_turns(frame_, hz, sine, cosine);
    return piece;
  }

  const FocusFrame& frame_;
  double range_m_;
  double row_m_;
  std::array<double, count> in_range_{};
  std::function<double(double)> in_azimuth_;
};

PointSpectrum spectrum_of_point(const FocusFrame& frame, double range_m, std::span<const SeenDirection> seen) {
  constexpr std::size_t most = 129;
  const std::size_t step = (seen.size() + most - 1) / most;
  const SpectrumMaker maker(frame, range_m);
  PointSpectrum spectrum;
  for (std::size_t i = step / 2; i < seen.size(); i += step)
    if (seen[i].weight > 0.0)
      maker.add(spectrum, seen[i], (static_cast<double>(i) + 0.5) / static_cast<double>(seen.size()) - 0.5);
  return spectrum;
}

double sum_of_weights(const std::vector<SpectrumPhasor>& pieces) {
  double weight = 0.0;
  for (const SpectrumPhasor& piece : pieces) weight += piece.weight;
  return weight;
}

// From the ideal place by the slope, otherwise in steps that are halved when none of them leads higher.
ImagePlace peak_of_pieces(const std::vector<SpectrumPhasor>& pieces, double azimuth_step_m, double range_step_m) {
  constexpr double is_sharp = 0.7;  // Below it the nearest peak may be one of several.
  if (const std::optional<ImagePlace> near = phasor_peak(pieces, {}))
    if (std::abs(phasor_sum(pieces, *near)) >= is_sharp * sum_of_weights(pieces)) return *near;
  constexpr int halvings = 8;
  ImagePlace peak;
  double height = std::abs(phasor_sum(pieces, peak));
  for (int i = 0; i < halvings; ++i, azimuth_step_m *= 0.5, range_step_m *= 0.5) {
    for (bool higher = true; higher;) {
      higher = false;
      for (const auto& [da, dr] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1),
                                   std::pair(1, 1), std::pair(-1, -1), std::pair(1, -1), std::pair(-1, 1)}) {
        const ImagePlace next{peak.azimuth_m + da * azimuth_step_m, peak.range_m + dr * range_step_m};
        const double there = std::abs(phasor_sum(pieces, next));
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

PointLosses::PointLosses(const EchoRows& echoes, const FocusOptions& options)
    : frame_(std::make_shared<const FocusFrame>(focus_frame(echoes, options))) {}

double PointLosses::middle_m() const { return frame_->reference_range_m; }

SwathLoss PointLosses::of(double range_m, std::span<const SeenDirection> seen) const {
  const FocusFrame& frame = *frame_;
  const PointSpectrum spectrum = spectrum_of_point(frame, range_m, seen);
  SwathLoss loss{.from_middle_m = range_m - frame.reference_range_m};
  if (!(spectrum.whole > 0.0)) return loss;
  if (spectrum.pieces.empty()) {
    loss.amplitude = 0.0;
    return loss;
  }
  if (frame.options.method == FocusMethod::omega_k) {
    loss.amplitude = sum_of_weights(spectrum.pieces) / spectrum.whole;
    return loss;
  }
  const double cell_m = radar::range_of_cycle(std::abs(frame.waveform.bandwidth_hz), frame.waveform.light_speed_mps);
  const auto [low, high] = std::ranges::minmax(spectrum.pieces, {}, &SpectrumPhasor::azimuth_per_m);
  const double width_per_m = high.azimuth_per_m - low.azimuth_per_m;
  loss.shift = peak_of_pieces(spectrum.pieces, 0.25 * (width_per_m > 0.0 ? 1.0 / width_per_m : cell_m), 0.25 * cell_m);
  const std::complex<double> peak = phasor_sum(spectrum.pieces, loss.shift);
  const double carried = frame.azimuth.spectrum_centre_per_m * loss.shift.azimuth_m +
                         frame.range.spectrum_centre_per_m * loss.shift.range_m;
  loss.amplitude = std::abs(peak) / spectrum.whole;
  loss.phase_rad = std::remainder(std::arg(peak) - 2.0 * core::pi * carried, 2.0 * core::pi);
  return loss;
}

double PointLosses::left_turns(double range_m, double low_sine, double high_sine) const {
  const FocusFrame& frame = *frame_;
  if (frame.options.method == FocusMethod::omega_k) return 0.0;
  const double share = (range_m - frame.reference_range_m) / frame.reference_range_m;
  double most = 0.0;
  for (const double part : {-0.5, 0.5})
    for (const double direction : {low_sine, high_sine}) {
      const double hz = part * std::abs(frame.waveform.bandwidth_hz);
      const double sine = std::clamp(direction * (1.0 + hz / frame.waveform.carrier_hz), -max_sine, max_sine);
      most = std::max(most, std::abs(share * secondary_turns(frame, hz, sine, std::sqrt(1.0 - sine * sine))));
    }
  return most;
}

}  // namespace sarsim::signal
