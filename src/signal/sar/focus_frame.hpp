#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/maths/fft.hpp"
#include "radar/path/path.hpp"
#include "signal/row/raw_samples.hpp"
#include "signal/row/smooth_row.hpp"
#include "signal/sar/focus_options.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "signal/sar/sar_image.hpp"
#include "signal/sar/sar_track.hpp"

namespace sarsim::signal {

/// Bins, one after the other, whose frequencies are first_hz, first_hz + step_hz, ...
struct FrequencyRun {
  std::size_t begin = 0;
  std::size_t count = 0;
  double first_hz = 0.0;
  double step_hz = 0.0;

  [[nodiscard]] double hz(double bin) const { return first_hz + bin * step_hz; }
};

/// All bins of a spectrum.
using FrequencyRuns = std::array<FrequencyRun, 2>;

/// What the three methods have in common: sizes, axes and the hyperbola in numbers.
struct FocusFrame {
  SarWaveform waveform;
  StraightTrack track;
  FocusOptions options;
  std::size_t pulses = 0;
  std::size_t samples = 0;
  double first_delay_s = 0.0;

  std::size_t azimuth_size = 0;  ///< Of the Fourier transforms over pulses.
  std::size_t range_size = 0;    ///< Of those over samples.
  std::size_t image_rows = 0;    ///< Of the transforms back over Doppler frequencies: more where rows are closer.
  std::size_t image_bins = 0;    ///< Of those back over range frequencies.
  std::ptrdiff_t first_row = 0;  ///< Row, counted from that of pulse 0, at which the image begins.
  bool unfolds = false;  ///< The image holds more Doppler frequencies than the pulses sample at one range frequency.
  double doppler_middle_hz = 0.0;  ///< Of the Doppler frequencies that the image holds.
  double range_middle_hz = 0.0;    ///< Of its range frequencies.
  double azimuth_zero_m = 0.0;     ///< Where images count from, on the axis that counts from the track's origin.
  ImageAxis azimuth;               ///< This and the areas count from the track's origin.
  ImageAxis range;
  ImageAxis shown_azimuth;         ///< The part of `azimuth` that is wanted.
  ImageAxis shown_range;           ///< The part of `range` that is.
  std::size_t hidden_rows = 0;     ///< Before it.
  std::size_t hidden_columns = 0;  ///< Before it.
  double blur_m = 0.0;  ///< By which responses are wider along the track than the directions they are seen in.
  double reference_range_m = 0.0;  ///< Closest distance at the middle of the swath.
  double row_samples = 0.0;      ///< Span of echoes, in samples, for which a row's spectrum is interpolated (omega-k).
  double centroid_cosine = 1.0;  ///< D at the Doppler centroid.

  [[nodiscard]] double wavelength_m() const {
    return radar::wavelength_of(waveform.carrier_hz, waveform.light_speed_mps);
  }
  [[nodiscard]] double prf_hz() const { return 1.0 / track.interval_s; }
  /// Samples of a row of the matrix that is worked on.
  [[nodiscard]] std::size_t row_length() const { return std::max({range_size, image_bins, range.count}); }
  /// Doppler frequency of a row of the image's azimuth spectrum: within half a period of their middle.
  [[nodiscard]] double doppler_hz(std::size_t row) const;
  /// What the antenna's own motion between sending and receiving adds to a Doppler frequency at `hz`: 2 hz V^2/c^2.
  [[nodiscard]] double motion_doppler_hz(double hz) const;
  /// sin of the angle between the line of sight and the plane across track: wavelength f/(2 V).
  [[nodiscard]] double sine(double doppler_hz) const;
  /// Half of the pulse's band, in parts of the carrier.
  [[nodiscard]] double half_band_share() const { return 0.5 * std::abs(waveform.bandwidth_hz) / waveform.carrier_hz; }
  /// Sines of Doppler frequencies at the carrier: nothing beyond `low` and `high` is seen; inside of both edges
  /// everything is.
  struct Sines {
    double low = -1.0;
    double high = 1.0;
    double low_edge = 0.0;
    double high_edge = 0.0;
  };
  /// Those under which the pulses see the part of the image at a closest distance, above 0, at any frequency of the
  /// pulse. The edges are half a blur wide and lie outside that part.
  [[nodiscard]] Sines sines_at(double range_m) const;
  /// Closest distance to which the echoes at a Doppler frequency are referred, so that the remaining spectrum is as
  /// smooth as possible (omega-k), and the distance from it to the farthest of these echoes.
  struct RowReference {
    double range_m = 0.0;
    double half_span_m = 0.0;
  };
  /// The middle of the swath where that suffices.
  [[nodiscard]] RowReference row_reference(double doppler_hz) const;
  /// Frequency of a bin of a range spectrum, in [-fs/2, fs/2).
  [[nodiscard]] double range_hz(std::size_t bin) const;
  /// The same of the spectrum of the image's rows, from the middle of its range frequencies.
  [[nodiscard]] double image_hz(std::size_t bin) const;
  /// Bins of a range spectrum whose frequencies follow each other.
  [[nodiscard]] FrequencyRuns range_runs() const;
  /// The same of the spectrum of the image's rows.
  [[nodiscard]] FrequencyRuns image_runs() const;
  /// The same of rows of the image's azimuth spectrum.
  [[nodiscard]] FrequencyRuns doppler_runs() const;
  /// fd/K, by which a chirp of the rate K that is shifted by fd has its peak earlier; 0 where that is nothing over the
  /// band.
  [[nodiscard]] double early_s(double doppler_hz) const;
};

/// @param echoes  at least two pulses of an antenna that moves; std::invalid_argument for fewer
[[nodiscard]] FocusFrame focus_frame(const EchoRows& echoes, const FocusOptions& options);

/// Room for what is worked out for a row; one for each thread.
struct RowRoom {
  std::vector<float> turns;
  std::vector<float> factors;
  std::vector<std::int32_t> whole;
  std::vector<std::int32_t> step;
  RawSamples padded;  ///< The row with margins for SincRow.

  /// For rows of this frame.
  explicit RowRoom(const FocusFrame& frame);
};

/// Turns a spectrum by turns_of(hz) at each frequency.
template <class TurnsOf>
void turn_spectrum(std::span<std::complex<float>> bins, const FrequencyRuns& runs, const TurnsOf& turns_of,
                   std::span<float> turns) {
  for (const FrequencyRun& run : runs) {
    const auto value = [&](double bin) { return turns_of(run.hz(bin)); };
    sample_turns(knots_of(run.count, value), value, turns.subspan(run.begin, run.count));
  }
  turn_row(bins, turns.first(bins.size()));
}

/// What differs between the methods: how a row of the two-dimensional spectrum becomes one of ranges against Doppler
/// frequency, and what remains to be turned there.
class RowFocuser {
 public:
  RowFocuser() = default;
  RowFocuser(const RowFocuser&) = delete;
  RowFocuser& operator=(const RowFocuser&) = delete;
  virtual ~RowFocuser() = default;

  /// @param doppler_hz   of the row, the antenna's motion between sending and receiving not yet added. What it does to
  ///                     a chirp, whose peak it shifts by early_s and turns, is undone first
  /// @param[in,out] row  row_length() values, range_size bins first; then frame.range.count samples along frame.range
  /// and more of no use.
  ///                     The unscaled transforms leave a factor range_size
  virtual void focus(double doppler_hz, std::span<std::complex<float>> row, RowRoom& room) const = 0;
  /// Turns by which a sample at a closest distance is to be multiplied at each Doppler frequency.
  /// @param cosine  D
  [[nodiscard]] virtual double azimuth_turns(double range_m, double cosine) const = 0;
};

/// The methods (docs/theory/focusing.md). Each keeps what it needs of the frame.
[[nodiscard]] std::unique_ptr<RowFocuser> make_range_doppler(const FocusFrame& frame);
[[nodiscard]] std::unique_ptr<RowFocuser> make_chirp_scaling(const FocusFrame& frame);
[[nodiscard]] std::unique_ptr<RowFocuser> make_omega_k(const FocusFrame& frame);

/// Turns by which a range frequency is to be turned so that the peak of a chirp, `early_s` early and turned by half of
/// its Doppler frequency times that, stands where it would without.
[[nodiscard]] inline double turns_of_pulse(double doppler_hz, double range_hz, double early_s) {
  return (0.5 * doppler_hz - range_hz) * early_s;
}

/// Frequencies whose direction is within 2.6 degrees of the track are set to 0: their weight grows without bound, and
/// so would the noise of a platform so slow that its pulses sample more than all directions.
inline constexpr double max_sine = 0.999;

/// Multiplies a row of the two-dimensional spectrum by sqrt(f0/F) (D0/D)^1.5, with D the cosine of the direction at the
/// frequency F = f0 + f and D0 that at the carrier: this turns the weight at the carrier into that of each frequency.
/// Leaves rows unchanged if it would change the peak by less than 0.01 dB.
void weigh_by_frequency(const FocusFrame& frame, double sine, std::span<std::complex<float>> bins,
                        const FrequencyRuns& runs, std::span<float> factors);

/// Time-bandwidth product of the chirps that chirp scaling gives compressed echoes back.
inline constexpr double dispersed_time_bandwidth = 256.0;

/// Samples that such a chirp is long: 256 (fs/B)^2.
[[nodiscard]] double dispersed_samples(const SarWaveform& waveform);

/// (2 R/c) (sqrt((f0 + f)^2 - (f0 sine + f V/c)^2) - f0 D - f/D) of a range frequency f, in turns: what remains of the
/// spectrum's phase beyond f/D. The antenna flies on while an echo is under way, which adds V/c to the sine of every
/// frequency. Where no wave has both frequencies the root counts as 0.
[[nodiscard]] double secondary_turns(const FocusFrame& frame, double range_hz, double sine, double cosine);

}  // namespace sarsim::signal
