#include <algorithm>
#include <cmath>

#include "core/maths/sinc_table.hpp"
#include "core/maths/turns.hpp"
#include "radar/path/path.hpp"
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
        table_(std::abs(frame.waveform.bandwidth_hz) / frame.waveform.sample_rate_hz) {}

  void focus(double doppler_hz, std::span<std::complex<float>> row) const override {
    const double sine = frame_.sine(doppler_hz + frame_.motion_doppler_hz(frame_.waveform.carrier_hz));
    const double cosine = std::sqrt(1.0 - sine * sine);
    const auto bins = row.first(frame_.range_size);
    for (std::size_t k = 0; k < bins.size(); ++k)
      bins[k] = core::product(bins[k], core::turned(secondary_turns(frame_, frame_.range_hz(k), sine, cosine)));
    fft_.inverse(bins);
    straighten(row, cosine);
  }

  double azimuth_turns(double range_m, double cosine) const override {
    return radar::turns_of(range_m * (cosine - 1.0), frame_.wavelength_m());
  }

 private:
  // The target at the closest distance R stands at R/D.
  void straighten(std::span<std::complex<float>> row, double cosine) const {
    const double fs = frame_.waveform.sample_rate_hz;
    const double per_m = radar::delay_of(1.0, frame_.waveform.light_speed_mps * cosine) * fs;
    const auto samples = row.first(frame_.range_size);
    const std::vector<std::complex<float>> curved(samples.begin(), samples.end());
    for (std::size_t n = 0; n < frame_.range.count; ++n) {
      const double position = frame_.range.at(static_cast<double>(n)) * per_m - frame_.first_delay_s * fs;
      row[n] = table_.value(curved, position);
    }
  }

  FocusFrame frame_;
  core::BasicFft<float> fft_;
  core::SincTable table_;
};

}  // namespace

std::unique_ptr<RowFocuser> make_range_doppler(const FocusFrame& frame) {
  return std::make_unique<RangeDoppler>(frame);
}

}  // namespace sarsim::signal
