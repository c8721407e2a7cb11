#include "picture/echo/echo_readout.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"

namespace sarsim::picture {

namespace {

// Pixel that a coordinate lies in; nothing outside.
std::optional<std::size_t> pixel_at(double px, std::size_t count) {
  const double pixel = std::floor(px + 0.5);
  if (!(pixel >= 0.0) || pixel >= static_cast<double>(count)) return std::nullopt;
  return static_cast<std::size_t>(pixel);
}

}  // namespace

std::optional<ReadOut> read_out(const EchoMatrix& matrix, const EchoColours& colours, double x_px, double y_px) {
  const auto x = pixel_at(x_px, matrix.size().width_px);
  const auto y = pixel_at(y_px, matrix.size().height_px);
  if (!x || !y) return std::nullopt;
  ReadOut out;
  out.row = matrix.places().row_of_pixel[*y];
  out.column = matrix.places().column_of_pixel[*x];
  if (!matrix.ready(out.row)) return std::nullopt;
  out.range_m = matrix.range_m(out.column);
  out.delay_s = radar::delay_of(out.range_m, matrix.plan().acquisition.scene->conventions.light_speed_mps);
  out.time_s = matrix.time_s(out.row);
  out.pulse = matrix.pulse(out.row);
  out.carrier_hz = matrix.carrier_hz(out.row);
  out.sample_v = matrix.row(out.row)[out.column];
  out.magnitude_v = std::abs(out.sample_v);
  out.phase_deg = value_of(DisplayQuantity::phase, out.sample_v);
  out.level_db = value_of(DisplayQuantity::decibels, out.sample_v, colours.reference_v);
  return out;
}

std::vector<ReadOutLine> lines_of(const ReadOut& r) {
  const auto volts = [](double v) { return fmt::format("{:.6g} V", v); };
  return {{"Slant range", fmt::format("{:.3f} m", r.range_m)},
          {"Delay", core::with_prefix(r.delay_s, "s", 9)},
          {"Azimuth", fmt::format("{:.6f} s", r.time_s)},
          {"Pulse", fmt::format("{}", r.pulse)},
          {"Frequency", core::with_prefix(r.carrier_hz, "Hz", 9)},
          {"I", volts(r.sample_v.real())},
          {"Q", volts(r.sample_v.imag())},
          {"Magnitude", volts(r.magnitude_v)},
          {"Phase", fmt::format("{:.3f} deg", r.phase_deg)},
          {"Level", fmt::format("{:.2f} dB", r.level_db)}};
}

CursorDifference difference(const ReadOut& first, const ReadOut& second) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  CursorDifference d;
  d.range_m = second.range_m - first.range_m;
  d.delay_s = second.delay_s - first.delay_s;
  d.time_s = second.time_s - first.time_s;
  d.pulses = second.pulse - first.pulse;
  d.level_db =
      first.magnitude_v > 0.0 ? value_of(DisplayQuantity::decibels, second.magnitude_v, first.magnitude_v) : none;
  const double turns = (second.phase_deg - first.phase_deg) / 360.0;
  d.phase_deg = 360.0 * (turns - std::ceil(turns - 0.5));
  d.range_rate_mps = d.time_s != 0.0 ? d.range_m / d.time_s : none;
  return d;
}

SideCut row_cut(const EchoMatrix& matrix, const EchoColours& colours, std::size_t row) {
  SideCut cut;
  if (!matrix.ready(row)) return cut;
  const auto samples = matrix.row(row);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    cut.position.push_back(matrix.range_m(k));
    cut.value.push_back(value_of(colours.quantity, samples[k], colours.reference_v));
  }
  return cut;
}

SideCut column_cut(const EchoMatrix& matrix, const EchoColours& colours, std::size_t column) {
  SideCut cut;
  for (std::size_t r = 0; r < matrix.rows(); ++r) {
    if (!matrix.ready(r)) continue;
    cut.position.push_back(matrix.time_s(r));
    cut.value.push_back(value_of(colours.quantity, matrix.row(r)[column], colours.reference_v));
  }
  return cut;
}

}  // namespace sarsim::picture
