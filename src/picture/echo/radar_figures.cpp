#include "picture/echo/radar_figures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "picture/colour/colour_map.hpp"
#include "picture/colour/display_quantity.hpp"
#include "picture/figure/figure_axes.hpp"
#include "radar/path/path.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t max_samples = std::size_t{1} << 25;
double in_degrees(double radians) { return radians * core::deg_per_rad; }

FigureAxis range_axis(const EchoBlock& block) {
  FigureAxis axis = axis_along("Slant range", "m", block.range_m);
  axis.twin = FigureAxis::Twin{"Delay (there and back)", "s", radar::delay_of(1.0, block.light_speed_mps)};
  return axis;
}

std::string interval_text(const EchoBlock& block) {
  if (block.rows == 0) return "no pulse";
  return fmt::format("{} pulse{} from {} to {}", block.rows, block.rows == 1 ? "" : "s",
                     core::with_prefix(block.time_s.front(), "s"), core::with_prefix(block.time_s.back(), "s"));
}

// Spacing of an axis whose first and last cell have their centres at its ends.
double half_cell(const std::vector<double>& centres) {
  return centres.size() < 2 ? 0.5 : 0.5 * (centres.back() - centres.front()) / static_cast<double>(centres.size() - 1);
}

// What a map of cells is drawn from: [up][across].
struct Cells {
  const std::vector<double>& across;  // Centres of the cells.
  double half_across;                 // Of a cell's width.
  const std::vector<double>& up;
  const std::vector<std::complex<double>>& samples;
};

// Largest levels of as many neighbouring cells as make a picture of a modest width.
FigureImage map_image(const Cells& map, const std::vector<double>& level_db, const ColourLimits& limits,
                      const std::vector<raster::Rgb>& colours) {
  constexpr std::size_t max_columns = 1600;
  const std::size_t columns = map.across.size();
  const std::size_t step = (columns + max_columns - 1) / max_columns;
  FigureImage image;
  image.width = (columns + step - 1) / step;
  image.height = map.up.size();
  image.x_first = map.across.front() - map.half_across;
  image.x_last = image.x_first + 2.0 * map.half_across * static_cast<double>(image.width * step);
  image.y_first = map.up.front() - half_cell(map.up);
  image.y_last = map.up.back() + half_cell(map.up);
  image.cells.reserve(image.width * image.height);
  for (std::size_t d = 0; d < image.height; ++d)
    for (std::size_t c = 0; c < columns; c += step) {
      const auto begin = level_db.begin() + static_cast<std::ptrdiff_t>(d * columns + c);
      const auto end = begin + static_cast<std::ptrdiff_t>(std::min(step, columns - c));
      image.cells.push_back(colours[colour_index(*std::max_element(begin, end), limits, colours.size())]);
    }
  return image;
}

// Decibels below the largest, Doppler frequencies up.
void add_doppler_map(Figure& figure, const EchoBlock& block, const Cells& map, FigureAxis across, double range_db) {
  const Decibels decibels{Decibels::Reference::maximum, 1.0, range_db};
  const SampleStatistics statistics = statistics_of(map.samples);
  const ColourLimits limits = colour_limits(DisplayQuantity::decibels, {}, decibels, statistics);
  const std::vector<raster::Rgb> colours = colour_table(ColourMap::ember);
  std::vector<double> level_db;
  level_db.reserve(map.samples.size());
  for (const std::complex<double>& sample : map.samples)
    level_db.push_back(sample == std::complex<double>()
                           ? limits.low
                           : value_of(DisplayQuantity::decibels, sample, reference_v(decibels, statistics)));
  FigurePanel& panel = figure.panels.emplace_back();
  panel.image = map_image(map, level_db, limits, colours);
  panel.x = std::move(across);
  panel.x.first = panel.image->x_first;
  panel.x.last = map.across.back() + map.half_across;
  panel.y = {"Doppler frequency", "Hz", panel.image->y_first, panel.image->y_last, {}};
  panel.y.twin =
      FigureAxis::Twin{"Range rate", "m/s", -radar::range_of_cycle(block.carrier_hz[0], block.light_speed_mps)};
  panel.colour_bar =
      FigureColourBar{"Below the largest", "dB", limits.low, limits.high, colours, ColourMapKind::sequential};
}

std::size_t row_sent_nearest(const simulate::Acquisition& acquisition, double time_s) {
  const auto time_of = [&](std::size_t row) {
    return acquisition.link.repetition.send_time_s(acquisition.timing.first_pulse_of_row(row));
  };
  std::size_t low = 0;
  std::size_t high = acquisition.timing.rows;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    (time_of(middle) < time_s ? low : high) = time_of(middle) < time_s ? middle + 1 : middle;
  }
  if (low == acquisition.timing.rows) return acquisition.timing.rows - 1;
  return low > 0 && time_s - time_of(low - 1) < time_of(low) - time_s ? low - 1 : low;
}

// Whether curves share their places; those that are not known are alike.
bool same_places(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double p, double q) { return p == q || (std::isnan(p) && std::isnan(q)); });
}

}  // namespace

std::string_view title_of(RadarView view) {
  switch (view) {
    case RadarView::range_profile: return "Range profile";
    case RadarView::range_doppler: return "Range-Doppler map";
    case RadarView::doppler_time: return "Doppler against time";
    case RadarView::spectrum: return "Spectrum of the pulse";
    case RadarView::phase_history: break;
  }
  return "Phase history";
}

RadarViewPlace place_of(const simulate::Acquisition& acquisition, const RadarViewChoice& choice) {
  RadarViewPlace place;
  if (acquisition.timing.rows == 0) return place;
  place.row = row_sent_nearest(acquisition, choice.time_s);
  const auto distance = [&](double range_m) { return std::abs(range_m - choice.range_m); };
  const auto nearest = std::ranges::min_element(acquisition.reception.column_range_m, {}, distance);
  place.column = static_cast<std::size_t>(nearest - acquisition.reception.column_range_m.begin());
  const std::size_t count = std::clamp<std::size_t>(choice.pulses, 1, acquisition.timing.rows);
  place.rows.begin = std::min(place.row - std::min(place.row, count / 2), acquisition.timing.rows - count);
  place.rows.end = place.rows.begin + count;
  return place;
}

Figure radar_figure(const simulate::Plan& plan, const RadarViewChoice& choice, const core::WorkControl& control) {
  const simulate::Acquisition& acquisition = plan.acquisition;
  const RadarViewPlace place = place_of(acquisition, choice);
  const simulate::IndexSpan all_columns{0, acquisition.reception.columns};
  const bool one_pulse = choice.view == RadarView::spectrum;
  const bool one_range = choice.view == RadarView::phase_history || choice.view == RadarView::doppler_time;
  const simulate::IndexSpan rows = one_pulse ? simulate::IndexSpan{place.row, place.row + 1} : place.rows;
  const simulate::IndexSpan columns = one_range ? simulate::IndexSpan{place.column, place.column + 1} : all_columns;
  const std::size_t padding = choice.view == RadarView::range_doppler ? std::max<std::size_t>(choice.padding, 1) : 1;
  const double samples = static_cast<double>(rows.end - rows.begin) * static_cast<double>(columns.end - columns.begin) *
                         static_cast<double>(padding);
  if (samples > static_cast<double>(max_samples))
    throw std::runtime_error(
        fmt::format("{} pulses of {} samples are too many to show at once; choose fewer pulses or a narrower range",
                    rows.end - rows.begin, columns.end - columns.begin));
  const EchoBlock block = echo_block(plan, rows, columns, control);
  switch (choice.view) {
    case RadarView::range_profile: return range_profile_figure(block, choice);
    case RadarView::range_doppler: return range_doppler_figure(block, place.column, choice);
    case RadarView::doppler_time: return doppler_time_figure(block, 0, choice);
    case RadarView::spectrum: return spectrum_figure(block, 0, choice);
    case RadarView::phase_history: break;
  }
  return phase_figure(block, 0, choice);
}

Figure range_profile_figure(const EchoBlock& block, const RadarViewChoice& choice) {
  RangeProfile profile = range_profile(block, choice.mean);
  std::vector<double> values = std::move(profile.magnitude_v);
  FigureAxis up{"Magnitude", "V", 0.0, 1.0, {}};
  if (choice.decibels) {
    values = decibels_of(std::move(values), 20.0);
    up = {"Level above 1 V", "dB", 0.0, 1.0, {}};
  }
  Figure figure;
  const char* mean = choice.mean == ProfileMean::coherent ? "Coherent mean" : "Mean power";
  figure.title = std::string(title_of(RadarView::range_profile));
  figure.note = std::string(mean) + " of " + interval_text(block);
  figure.panels.push_back(
      curve_panel("", range_axis(block), std::move(up), std::move(profile.range_m), std::move(values)));
  return figure;
}

Figure range_doppler_figure(const EchoBlock& block, std::size_t column, const RadarViewChoice& choice) {
  const RangeDoppler map = range_doppler(block, choice.window, block.rows * std::max<std::size_t>(choice.padding, 1));
  Figure figure;
  figure.title = std::string(title_of(RadarView::range_doppler));
  figure.note = interval_text(block) + (map.remark.empty() ? "" : "; note: " + map.remark);
  if (block.rows == 0 || block.columns == 0) return figure;
  add_doppler_map(figure, block, {map.range_m, half_cell(map.range_m), map.doppler_hz, map.samples},
                  {"Slant range", "m", 0.0, 1.0, {}}, choice.range_db);

  std::vector<double> cut;
  for (std::size_t d = 0; d < map.doppler_hz.size(); ++d) cut.push_back(std::abs(map.at(d, column)));
  figure.panels.push_back(curve_panel(
      "At " + core::with_prefix(map.range_m[column], "m"), axis_along("Doppler frequency", "Hz", map.doppler_hz),
      {"Level above 1 V", "dB", 0.0, 1.0, {}}, map.doppler_hz, decibels_of(std::move(cut), 20.0)));
  return figure;
}

Figure doppler_time_figure(const EchoBlock& block, std::size_t column, const RadarViewChoice& choice) {
  Figure figure;
  figure.title = std::string(title_of(RadarView::doppler_time));
  if (block.rows == 0 || column >= block.columns) return figure;
  const DopplerTime history =
      doppler_time(block, column, choice.window, choice.interval, std::max<std::size_t>(choice.padding, 1));
  const std::size_t pulses = std::min(std::max<std::size_t>(choice.interval, 1), block.rows);
  figure.note = fmt::format("Range {}, spectra of {} of {}", core::with_prefix(block.range_m[column], "m"), pulses,
                            interval_text(block)) +
                (history.remark.empty() ? "" : "; note: " + history.remark);
  if (std::ranges::all_of(history.samples, [](std::complex<double> v) { return v == std::complex<double>(); }))
    figure.note += "; nothing is received at this range";
  // A single spectrum is as wide as its pulses.
  const double half_s = history.time_s.size() > 1 ? half_cell(history.time_s)
                                                  : 0.5 * std::max(block.time_s.back() - block.time_s.front(), 1e-9);
  add_doppler_map(figure, block, {history.time_s, half_s, history.doppler_hz, history.samples},
                  {"Azimuth time", "s", 0.0, 1.0, {}}, choice.range_db);
  const std::vector<double>& mean_hz = history.mean_hz;
  const std::vector<double>& width_hz = history.width_hz;
  FigurePanel& below = figure.panels.emplace_back();
  below.title = "Of the power in each spectrum";
  below.x = figure.panels.front().x;
  const double low = std::min(0.0, *std::ranges::min_element(mean_hz));
  const double high = std::max(*std::ranges::max_element(mean_hz), *std::ranges::max_element(width_hz));
  const double margin = std::max(0.05 * (high - low), 1e-3);
  below.y = {"Frequency", "Hz", low - margin, high + margin, {}};
  below.curves.push_back({"mean", Role::curve, false, history.time_s, mean_hz});
  below.curves.push_back({"width (r.m.s.)", Role::curve_2, false, history.time_s, width_hz});
  return figure;
}

Figure spectrum_figure(const EchoBlock& block, std::size_t row, const RadarViewChoice& choice) {
  Figure figure;
  figure.title = std::string(title_of(RadarView::spectrum));
  if (row >= block.rows || block.columns == 0) return figure;
  PowerSpectrum spectrum = power_spectrum(block, row, choice.window);
  std::vector<double> values = std::move(spectrum.density_w_per_hz);
  FigureAxis up{"Power density", "W/Hz", 0.0, 1.0, {}};
  if (choice.decibels) {
    values = decibels_of(std::move(values), 10.0);
    up = {"Density above 1 W/Hz", "dB", 0.0, 1.0, {}};
  }
  figure.note = "Pulse at " + core::with_prefix(block.time_s[row], "s") + ", carrier " +
                core::with_prefix(block.carrier_hz[row], "Hz");
  FigureAxis across = axis_along("Frequency from the carrier", "Hz", spectrum.frequency_hz);
  figure.panels.push_back(
      curve_panel("", std::move(across), std::move(up), std::move(spectrum.frequency_hz), std::move(values)));
  return figure;
}

Figure phase_figure(const EchoBlock& block, std::size_t column, const RadarViewChoice& choice) {
  Figure figure;
  figure.title = std::string(title_of(RadarView::phase_history));
  if (block.rows == 0 || column >= block.columns) return figure;
  PhaseHistory history = phase_history(block, column);
  std::vector<double> phase = choice.unwrapped ? history.unwrapped_rad : history.phase_rad;
  std::ranges::transform(phase, phase.begin(), in_degrees);
  std::vector<double> path = std::move(history.path_m);
  const double start_m = path.front();
  for (double& metres : path) metres -= start_m;
  figure.note = "Range " + core::with_prefix(block.range_m[column], "m") + ", " + interval_text(block);
  if (block.rows > 1)
    figure.note +=
        fmt::format(", mean step {:.6g} deg", in_degrees(history.unwrapped_rad.back() - history.unwrapped_rad.front()) /
                                                  static_cast<double>(block.rows - 1));
  const FigureAxis across = axis_along("Azimuth time", "s", history.time_s);
  figure.panels.push_back(curve_panel("", across, {choice.unwrapped ? "Unwrapped phase" : "Phase", "deg", 0.0, 1.0, {}},
                                      history.time_s, std::move(phase)));
  figure.panels.push_back(
      curve_panel("", across, {"Change of range", "m", 0.0, 1.0, {}}, std::move(history.time_s), std::move(path)));
  return figure;
}

std::string curves_table(const Figure& figure, char separator) {
  const auto heading = [](const FigureAxis& axis, const std::string& name) {
    return (name.empty() ? axis.label : name) + " [" + axis.unit + "]";
  };
  std::string text;
  for (const FigurePanel& panel : figure.panels) {
    for (std::size_t first = 0; first < panel.curves.size();) {
      const std::vector<double>& x = panel.curves[first].x;
      std::size_t end = first + 1;
      while (end < panel.curves.size() && same_places(panel.curves[end].x, x)) ++end;
      if (!text.empty()) text += '\n';
      text += heading(panel.x, {});
      for (std::size_t k = first; k < end; ++k) (text += separator) += heading(panel.y, panel.curves[k].name);
      text += '\n';
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::isfinite(x[i])) core::append_number(text, x[i]);
        for (std::size_t k = first; k < end; ++k) {
          text += separator;
          if (std::isfinite(panel.curves[k].y[i])) core::append_number(text, panel.curves[k].y[i]);
        }
        text += '\n';
      }
      first = end;
    }
  }
  return text;
}

}  // namespace sarsim::picture
