#include <algorithm>
#include <cmath>

#include "core/maths/turns.hpp"
#include "radar/path/path.hpp"
#include "signal/row/sinc_row.hpp"
#include "signal/sar/focus_frame.hpp"

namespace sarsim::signal {

namespace {

// Stolt, "Migration by Fourier transform", Geophysics 43, 1978; Cafforio, Prati, Rocca, IEEE Trans. AES-27, 1991.
//
// The spectrum of a target at the closest distance R is exp(-2 pi j (2 R/c) F'), F'^2 = F^2 - (a + b F)^2 with F the
// true frequency f0 + f, a = c fd/(2 V) of the Doppler frequency fd and b = V/c what the antenna's motion between
// sending and receiving does to it.
class OmegaK : public RowFocuser {
 public:
  explicit OmegaK(const FocusFrame& frame)
      : frame_(frame),
        fft_(frame.image_bins),
        runs_(frame.range_runs()),
        image_runs_(frame.image_runs()),
        interpolation_(frame.row_samples / static_cast<double>(frame.range_size)) {
    for (std::size_t k = 0; k < frame.image_bins; ++k) {
      const double hz = frame.range_middle_hz + frame.image_hz(k);
      const double across = frame.waveform.carrier_hz + hz;
      const double weight = across > 0.0 ? std::sqrt(frame.waveform.carrier_hz / across) : 0.0;
      to_begin_.emplace_back(weight * core::turned_exactly(turns_to_begin(hz, frame.reference_range_m)));
    }
    constexpr double min_turns = 1e-6;
    const double turns = frame.range.spectrum_centre_per_m * frame.range.step_m;
    if (std::abs(turns) * static_cast<double>(frame.range.count) < min_turns) return;
    for (std::size_t n = 0; n < frame.range.count; ++n)
      to_centre_.emplace_back(core::turned_exactly(turns * static_cast<double>(n)));
  }

  void focus(double doppler_hz, std::span<std::complex<float>> row, RowRoom& room) const override {
    const double a = radar::range_of(doppler_hz, frame_.waveform.light_speed_mps) / frame_.track.speed_mps;
    const double reference_m = frame_.row_reference(doppler_hz).range_m;
    refer(row.first(frame_.range_size), reference_m, doppler_hz, a, room);
    change_variable(row, a, room);
    to_begin(row.first(frame_.image_bins), reference_m, room);
    fft_.inverse(row.first(frame_.image_bins));
    // The image's band lies about f0 (Dc - 1), not about 0.
    if (!to_centre_.empty()) multiply_row(row.first(frame_.range.count), to_centre_);
  }

  double azimuth_turns(double /*range_m*/, double /*cosine*/) const override { return 0.0; }

 private:
  // Of the directions that are not along the track.
  inline static const double min_cosine = std::sqrt(1.0 - max_sine * max_sine);

  [[nodiscard]] double motion() const { return frame_.track.speed_mps / frame_.waveform.light_speed_mps; }
  // Takes the phase of the reference away: what remains is smooth enough to interpolate.
  void refer(std::span<std::complex<float>> row, double reference_m, double doppler_hz, double a, RowRoom& room) const {
    const double f0 = frame_.waveform.carrier_hz;
    const double reference_s = radar::delay_of(reference_m, frame_.waveform.light_speed_mps);
    const double early_s = frame_.early_s(doppler_hz);
    turn_spectrum(
        row, runs_,
        [&](double hz) {
          const double across = a + motion() * (f0 + hz);
          const double square = (f0 + hz) * (f0 + hz) - across * across;
          return reference_s * std::sqrt(std::max(square, 0.0)) - hz * frame_.first_delay_s +
                 turns_of_pulse(doppler_hz, hz, early_s);
        },
        room.turns);
  }

  // The spectrum from its lowest frequency to its highest, repeated at both ends.
  static void put_in_order(std::span<const std::complex<float>> bins, std::span<std::complex<float>> padded) {
    const std::size_t positive = (bins.size() + 1) / 2;
    const auto out = padded.begin() + SincRow::margin;
    std::ranges::copy(bins.first(positive), std::ranges::copy(bins.subspan(positive), out).out);
    std::copy_n(padded.end() - 2 * SincRow::margin, SincRow::margin, padded.begin());
    std::copy_n(out, SincRow::margin, padded.end() - SincRow::margin);
  }

  // What a frequency f' that is referred to a distance is to be turned by to where the image begins.
  [[nodiscard]] double turns_to_begin(double hz, double reference_m) const {
    const double c = frame_.waveform.light_speed_mps;
    return hz * radar::delay_of(frame_.range.first_m - reference_m, c) -
           frame_.waveform.carrier_hz * radar::delay_of(reference_m, c);
  }

  // The weight sqrt(f0/F'), F' = f0 + f', makes that of stationary phase with the change of the variable, D sqrt(f0/F)
  // D^-1.5, the same for all directions: F' = F D.
  void to_begin(std::span<std::complex<float>> row, double reference_m, RowRoom& room) const {
    multiply_row(row, to_begin_);
    if (reference_m == frame_.reference_range_m) return;
    const double moved_turns = turns_to_begin(0.0, reference_m) - turns_to_begin(0.0, frame_.reference_range_m);
    const double moved_s = radar::delay_of(frame_.reference_range_m - reference_m, frame_.waveform.light_speed_mps);
    turn_spectrum(
        row, image_runs_, [&](double hz) { return (frame_.range_middle_hz + hz) * moved_s + moved_turns; }, room.turns);
  }

  // From f to f'. No wave has an F' of 0 and less, and those along the track count as none.
  void change_variable(std::span<std::complex<float>> row, double a, RowRoom& room) const {
    const double f0 = frame_.waveform.carrier_hz;
    const double b = motion();
    const double bins_per_hz = static_cast<double>(frame_.range_size) / frame_.waveform.sample_rate_hz;
    const auto negative = static_cast<double>(frame_.range_size / 2);
    put_in_order(row.first(frame_.range_size), room.padded.span());
    const auto true_hz = [&](double across) {
      return (a * b + std::sqrt(a * a * b * b + (1.0 - b * b) * (a * a + across * across))) / (1.0 - b * b);
    };
    for (const FrequencyRun& run : image_runs_) {
      const auto across = [&](double bin) { return f0 + frame_.range_middle_hz + run.hz(bin); };
      const SamplePlaces places{std::span(room.whole).subspan(run.begin, run.count),
                                std::span(room.step).subspan(run.begin, run.count)};
      sample_places([&](double bin) { return (true_hz(across(bin)) - f0) * bins_per_hz + negative; }, SincRow::steps,
                    places);
      const auto least = [&](double hz) { return std::max(min_cosine * true_hz(hz), 0.0); };
      const auto factors = std::span(room.factors).subspan(run.begin, run.count);
      std::ranges::fill(factors, 1.0F);
      for (std::size_t k = 0; k < run.count; ++k) {
        const double hz = across(static_cast<double>(k));
        if (hz > least(hz)) break;
        factors[k] = 0.0F;
      }
    }
    const std::size_t count = frame_.image_bins;
    interpolation_.interpolate(room.padded.span(), std::span(room.whole).first(count),
                               std::span(room.step).first(count), std::span(room.factors).first(count), 0,
                               static_cast<std::ptrdiff_t>(frame_.range_size), row.first(count));
  }

  FocusFrame frame_;
  core::BasicFft<float> fft_;
  FrequencyRuns runs_;
  FrequencyRuns image_runs_;
  SincRow interpolation_;
  std::vector<std::complex<float>> to_begin_;   // Turns the spectrum to where the image begins.
  std::vector<std::complex<float>> to_centre_;  // Turns the image to its spectral centre; empty where that is 0.
};

}  // namespace

std::unique_ptr<RowFocuser> make_omega_k(const FocusFrame& frame) { return std::make_unique<OmegaK>(frame); }

}  // namespace sarsim::signal
