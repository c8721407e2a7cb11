#include <algorithm>
#include <cmath>

#include "radar/path/path.hpp"
#include "signal/sar/focus_frame.hpp"

namespace sarsim::signal {

namespace {

// Raney, Runge, Bamler, Cumming, Wong, "Precision SAR processing using chirp scaling", IEEE Trans. GRS-32, 1994. The
// echoes come compressed: they are dispersed again, to chirps of a rate K of our choice, in the same multiplication
// that removes the secondary compression of the middle of the swath. So K is the rate at every Doppler frequency.
class ChirpScaling : public RowFocuser {
 public:
  explicit ChirpScaling(const FocusFrame& frame)
      : frame_(frame),
        fft_(frame.range_size),
        image_fft_(frame.image_bins),
        runs_(frame.range_runs()),
        rate_hzps_(std::pow(frame.waveform.bandwidth_hz, 2) / dispersed_time_bandwidth) {}

  void focus(double doppler_hz, std::span<std::complex<float>> row, RowRoom& room) const override {
    const double sine = frame_.sine(doppler_hz + frame_.motion_doppler_hz(frame_.waveform.carrier_hz));
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double early_s = frame_.early_s(doppler_hz);
    const auto bins = row.first(frame_.range_size);
    turn_spectrum(
        bins, runs_,
        [&](double hz) {
          return turns_of_pulse(doppler_hz, hz, early_s) + secondary_turns(frame_, hz, sine, cosine) -
                 0.5 * hz * hz / rate_hzps_;
        },
        room.turns);
    weigh_by_frequency(frame_, sine, bins, runs_, room.factors);
    fft_.inverse(bins);
    scale(bins, cosine, room);
    fft_.forward(bins);
    compress(bins, cosine, room);
    if (frame_.image_bins > bins.size()) widen(row.first(frame_.image_bins));
    image_fft_.inverse(row.first(frame_.image_bins));
  }

  double azimuth_turns(double range_m, double cosine) const override {
    const double c = frame_.waveform.light_speed_mps;
    const double from_reference_m = (range_m - frame_.reference_range_m) / cosine;
    const double scaling = 2.0 * rate_hzps_ / (c * c) * (1.0 - cosine / frame_.centroid_cosine);
    return radar::turns_of(range_m * (cosine - 1.0), frame_.wavelength_m()) -
           scaling * from_reference_m * from_reference_m;
  }

 private:
  // Makes the curves of all ranges the same as that of the reference.
  void scale(std::span<std::complex<float>> row, double cosine, RowRoom& room) const {
    const double fs = frame_.waveform.sample_rate_hz;
    const double half_rate = 0.5 * rate_hzps_ * (frame_.centroid_cosine / cosine - 1.0);
    const double centre_s = radar::delay_of(frame_.reference_range_m, frame_.waveform.light_speed_mps * cosine);
    // Half the room beyond the samples stands for times before them.
    const std::size_t before = (row.size() - frame_.samples) / 2;
    const std::size_t wrapped = row.size() - before;
    const auto fill = [&](std::size_t begin, std::size_t count, double first) {
      const auto turns_of = [&](double n) {
        const double time_s = frame_.first_delay_s + (first + n) / fs - centre_s;
        return half_rate * time_s * time_s;
      };
      sample_turns(knots_of(count, turns_of), turns_of, std::span(room.turns).subspan(begin, count));
    };
    fill(0, wrapped, 0.0);
    fill(wrapped, before, -static_cast<double>(before));
    turn_row(row, std::span(room.turns).first(row.size()));
  }

  // Compresses and moves everything by the curve of the reference. Scaling has changed the band by Dc/D.
  void compress(std::span<std::complex<float>> row, double cosine, RowRoom& room) const {
    const double to_centroid = cosine / frame_.centroid_cosine;
    const double half_inverse_rate = 0.5 * to_centroid / rate_hzps_;
    const double shift_s = radar::delay_of(frame_.reference_range_m, frame_.waveform.light_speed_mps) *
                           (1.0 / cosine - 1.0 / frame_.centroid_cosine);
    const auto size = static_cast<float>(std::sqrt(to_centroid) / static_cast<double>(row.size()));
    turn_spectrum(
        row, runs_, [&](double hz) { return half_inverse_rate * hz * hz + shift_s * hz; }, room.turns);
    std::ranges::fill(std::span(room.factors).first(row.size()), 1.0F);
    scale_row(row, std::span(room.factors).first(row.size()), size);
  }

  // The spectrum with zeros between its halves, for closer samples.
  void widen(std::span<std::complex<float>> row) const {
    const auto kept = static_cast<std::ptrdiff_t>((frame_.range_size + 1) / 2);
    const auto end = row.begin() + static_cast<std::ptrdiff_t>(frame_.range_size);
    std::move_backward(row.begin() + kept, end, row.end());
    const auto zeros = static_cast<std::ptrdiff_t>(row.size() - frame_.range_size);
    std::fill(row.begin() + kept, row.begin() + kept + zeros, std::complex<float>());
  }

  FocusFrame frame_;
  core::BasicFft<float> fft_;
  core::BasicFft<float> image_fft_;
  FrequencyRuns runs_;
  double rate_hzps_;
};

}  // namespace

std::unique_ptr<RowFocuser> make_chirp_scaling(const FocusFrame& frame) {
  return std::make_unique<ChirpScaling>(frame);
}

}  // namespace sarsim::signal
