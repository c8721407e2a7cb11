#include <algorithm>
#include <cmath>

#include "core/maths/sinc_table.hpp"
#include "core/maths/turns.hpp"
#include "radar/path/path.hpp"
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
        table_(static_cast<double>(frame.samples) / static_cast<double>(frame.range_size)) {}

  void focus(double doppler_hz, std::span<std::complex<float>> row) const override {
    const double a = radar::range_of(doppler_hz, frame_.waveform.light_speed_mps) / frame_.track.speed_mps;
    refer_to_middle(row.first(frame_.range_size), a);
    change_variable(row, a);
    fft_.inverse(row.first(frame_.image_bins));
    // The image's band lies about f0 (Dc - 1), not about 0.
    for (std::size_t n = 0; n < frame_.range.count; ++n)
      row[n] = core::product(
          row[n], core::turned(frame_.range.spectrum_centre_per_m * frame_.range.step_m * static_cast<double>(n)));
  }

  double azimuth_turns(double /*range_m*/, double /*cosine*/) const override { return 0.0; }

 private:
  [[nodiscard]] double motion() const { return frame_.track.speed_mps / frame_.waveform.light_speed_mps; }
  [[nodiscard]] double reference_delay_s() const {
    return radar::delay_of(frame_.reference_range_m, frame_.waveform.light_speed_mps);
  }

  // Takes the phase of the reference away: what remains is smooth enough to interpolate.
  void refer_to_middle(std::span<std::complex<float>> row, double a) const {
    const double f0 = frame_.waveform.carrier_hz;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const double hz = frame_.range_hz(k);
      const double across = a + motion() * (f0 + hz);
      const double square = (f0 + hz) * (f0 + hz) - across * across;
      const double turns = reference_delay_s() * std::sqrt(std::max(square, 0.0)) - hz * frame_.first_delay_s;
      row[k] = core::product(row[k], core::turned(turns));
    }
  }

  // From f to f' and to where the image begins.
  void change_variable(std::span<std::complex<float>> row, double a) const {
    const double f0 = frame_.waveform.carrier_hz;
    const double c = frame_.waveform.light_speed_mps;
    const double fs = frame_.waveform.sample_rate_hz;
    const double b = motion();
    const double first_s = radar::delay_of(frame_.range.first_m - frame_.reference_range_m, c);
    const double bins_per_hz = static_cast<double>(frame_.range_size) / fs;
    const auto bins = row.first(frame_.range_size);
    const std::vector<std::complex<float>> spectrum(bins.begin(), bins.end());
    for (std::size_t k = 0; k < frame_.image_bins; ++k) {
      const double image_hz = frame_.range_middle_hz + frame_.image_hz(k);
      const double across = f0 + image_hz;
      const double true_hz =
          (a * b + std::sqrt(a * a * b * b + (1.0 - b * b) * (a * a + across * across))) / (1.0 - b * b);
      const double hz = true_hz - f0;
      row[k] = {};
      if (!(std::abs(hz) < 0.5 * fs)) continue;
      const double turns = image_hz * first_s - f0 * reference_delay_s();
      const auto slope = static_cast<float>(across / true_hz);
      row[k] = slope * core::product(table_.circular(spectrum, hz * bins_per_hz), core::turned(turns));
    }
  }

  FocusFrame frame_;
  core::BasicFft<float> fft_;
  core::SincTable table_;
};

}  // namespace

std::unique_ptr<RowFocuser> make_omega_k(const FocusFrame& frame) { return std::make_unique<OmegaK>(frame); }

}  // namespace sarsim::signal
