#include <algorithm>
#include <cmath>

#include "radar/path/path.hpp"
#include "signal/row/sinc_row.hpp"
#include "signal/sar/focus_frame.hpp"

namespace sarsim::signal {

namespace {

// Cumming and Wong, "Digital Processing of Synthetic Aperture Radar Data", 2005, chapter 6, with the secondary range
// compression of the middle of the swath in all its orders.
class RangeDoppler : public RowFocuser {
 public:
  explicit RangeDoppler(const FocusFrame& frame)
      : frame_(frame),
        fft_(frame.range_size),
        runs_(frame.range_runs()),
        interpolation_(std::abs(frame.waveform.bandwidth_hz) / frame.waveform.sample_rate_hz) {}

  void focus(double doppler_hz, std::span<std::complex<float>> row, RowRoom& room) const override {
    const double sine = frame_.sine(doppler_hz + frame_.motion_doppler_hz(frame_.waveform.carrier_hz));
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double early_s = frame_.early_s(doppler_hz);
    const auto bins = room.padded.span().subspan(SincRow::margin, frame_.range_size);
    std::ranges::copy(row.first(frame_.range_size), bins.begin());
    turn_spectrum(
        bins, runs_,
        [&](double hz) { return secondary_turns(frame_, hz, sine, cosine) + turns_of_pulse(doppler_hz, hz, early_s); },
        room.turns);
    weigh_by_frequency(frame_, sine, bins, runs_, room.factors);
    fft_.inverse(bins);
    straighten(row.first(frame_.range.count), cosine, room);
  }

  double azimuth_turns(double range_m, double cosine) const override {
    return radar::turns_of(range_m * (cosine - 1.0), frame_.wavelength_m());
  }

 private:
  // The target at the closest distance R stands at R/D.
  void straighten(std::span<std::complex<float>> row, double cosine, RowRoom& room) const {
    const double fs = frame_.waveform.sample_rate_hz;
    const double per_m = radar::delay_of(1.0, frame_.waveform.light_speed_mps * cosine) * fs;
    const SamplePlaces places{std::span(room.whole).first(row.size()), std::span(room.step).first(row.size())};
    sample_places([&](double n) { return frame_.range.at(n) * per_m - frame_.first_delay_s * fs; }, SincRow::steps,
                  places);
    std::ranges::fill(room.padded.span().first(SincRow::margin), std::complex<float>());
    std::ranges::fill(room.padded.span().last(SincRow::margin), std::complex<float>());
    std::ranges::fill(std::span(room.factors).first(row.size()), 1.0F);
    const auto beyond = static_cast<std::ptrdiff_t>(core::SincTable::taps / 2);
    interpolation_.interpolate(room.padded.span(), places.whole, places.step, std::span(room.factors).first(row.size()),
                               -beyond, static_cast<std::ptrdiff_t>(frame_.range_size) + beyond, row);
  }

  FocusFrame frame_;
  core::BasicFft<float> fft_;
  FrequencyRuns runs_;
  SincRow interpolation_;
};

}  // namespace

std::unique_ptr<RowFocuser> make_range_doppler(const FocusFrame& frame) {
  return std::make_unique<RangeDoppler>(frame);
}

}  // namespace sarsim::signal
