#include "cli/command/plot_samples.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace sarsim::cli {

namespace {

constexpr std::size_t max_samples = std::size_t{1} << 25U;

// The place nearest to the wanted one; the middle where none is wanted.
std::size_t nearest(const std::vector<double>& places, std::optional<double> wanted, const picture::CutPlaces& names) {
  if (!wanted) return places.size() / 2;
  const auto [low, high] = std::ranges::minmax(places);
  const double spacing = places.size() < 2 ? 1.0 : (high - low) / static_cast<double>(places.size() - 1);
  const auto with_unit = [&](double value) {
    return fmt::format("{:.6g}{}{}", value, names.unit.empty() ? "" : " ", names.unit);
  };
  if (*wanted < low - spacing || *wanted > high + spacing)
    throw core::InvalidRequest(fmt::format("{} {} is outside the view", names.label, with_unit(*wanted)),
                               fmt::format("it goes from {:.6g} to {}", low, with_unit(high)));
  const auto distance = [&](double place) { return std::abs(place - *wanted); };
  return static_cast<std::size_t>(std::ranges::min_element(places, {}, distance) - places.begin());
}

// So many rows about the chosen one, moved so that they are there; all where nothing is chosen.
simulate::IndexSpan burst(const PlotArguments& a, std::size_t row, std::size_t rows) {
  const auto count = a.pulses ? std::min(static_cast<std::size_t>(*a.pulses), rows) : rows;
  const std::size_t begin = std::min(row - std::min(row, count / 2), rows - count);
  return {begin, begin + count};
}

picture::RadarViewChoice choice_of(const PlotArguments& a) {
  picture::RadarViewChoice choice;
  choice.mean = a.mean.value_or(picture::ProfileMean::power);
  choice.window = a.window.value_or(picture::SpectrumWindow::hann);
  choice.padding = static_cast<std::size_t>(a.padding.value_or(1));
  choice.interval = static_cast<std::size_t>(a.interval.value_or(picture::usual_doppler_interval));
  choice.decibels = a.quantity.value_or(picture::DisplayQuantity::decibels) == picture::DisplayQuantity::decibels;
  choice.unwrapped = !a.wrapped;
  choice.range_db = a.span_db.value_or(60.0);
  return choice;
}

void expect_quantity(const PlotArguments& a) {
  const bool levels = a.kind == PlotKind::profile || a.kind == PlotKind::spectrum;
  if (!a.quantity || a.kind == PlotKind::pulse || a.kind == PlotKind::range) return;
  if (levels &&
      (*a.quantity == picture::DisplayQuantity::decibels || *a.quantity == picture::DisplayQuantity::magnitude))
    return;
  const bool map = a.kind == PlotKind::range_doppler || a.kind == PlotKind::doppler_time;
  if (map && *a.quantity == picture::DisplayQuantity::decibels) return;
  if (a.kind == PlotKind::phase && *a.quantity == picture::DisplayQuantity::phase) return;
  throw core::InvalidRequest(
      fmt::format("--show: {} is not shown by this kind of plot", picture::title_of(*a.quantity)),
      levels ? "profiles and spectra are shown as magnitude or db"
      : map  ? "maps of Doppler frequencies are shown in db"
             : "phase histories are shown as phase");
}

picture::EchoBlock read_block(const picture::SampleSource& samples, simulate::IndexSpan rows,
                              simulate::IndexSpan columns, std::size_t times) {
  const double count = static_cast<double>(rows.end - rows.begin) * static_cast<double>(columns.end - columns.begin);
  if (count * static_cast<double>(times) > static_cast<double>(max_samples))
    throw core::InvalidRequest(fmt::format("{} pulses of {} samples are too many to show at once",
                                           rows.end - rows.begin, columns.end - columns.begin),
                               "choose fewer with --pulses, or a narrower --range");
  return samples.read(rows, columns);
}

// The middle of the places about the largest power that have half of it: so all samples of a long pulse, whose powers
// differ by rounding alone, lead to its middle.
std::size_t strongest_of(const std::vector<double>& power) {
  const auto strongest = std::ranges::max_element(power);
  const auto weak = [half = 0.5 * *strongest](double value) { return value < half; };
  const auto end = std::find_if(strongest, power.end(), weak);
  const auto begin = std::find_if(std::make_reverse_iterator(strongest), power.rend(), weak).base();
  return static_cast<std::size_t>(begin - power.begin() + (end - begin - 1) / 2);
}

// Calls `take(row, column, power)` for up to so many of the rows.
template <class Take>
void each_power(const picture::SampleSource& samples, simulate::IndexSpan rows, std::size_t max_rows,
                const Take& take) {
  const std::size_t step = (rows.end - rows.begin + max_rows - 1) / max_rows;
  for (std::size_t row = rows.begin + (step - 1) / 2; row < rows.end; row += step) {
    const picture::EchoBlock block = samples.read({row, row + 1}, {0, samples.column_place.size()});
    for (std::size_t column = 0; column < samples.column_place.size(); ++column)
      if (const double power = std::norm(block.samples[column]); std::isfinite(power)) take(row, column, power);
  }
}

// Of the kinds that show one range, or add the spectrum of one.
bool needs_column(PlotKind kind) {
  return kind == PlotKind::range || kind == PlotKind::range_doppler || kind == PlotKind::doppler_time ||
         kind == PlotKind::phase;
}

picture::Figure radar_view(const PlotArguments& a, const picture::SampleSource& samples, std::size_t row,
                           std::size_t column) {
  const picture::RadarViewChoice choice = choice_of(a);
  const simulate::IndexSpan all{0, samples.column_place.size()};
  const simulate::IndexSpan rows = burst(a, row, samples.row_place.size());
  switch (a.kind) {
    case PlotKind::profile: return picture::range_profile_figure(read_block(samples, rows, all, 1), choice);
    case PlotKind::range_doppler:
      return picture::range_doppler_figure(read_block(samples, rows, all, choice.padding), column, choice);
    case PlotKind::doppler_time:
      return picture::doppler_time_figure(read_block(samples, rows, {column, column + 1}, 8 * choice.padding), 0,
                                          choice);
    case PlotKind::spectrum: return picture::spectrum_figure(read_block(samples, {row, row + 1}, all, 1), 0, choice);
    default: return picture::phase_figure(read_block(samples, rows, {column, column + 1}, 1), 0, choice);
  }
}

}  // namespace

std::size_t strongest_column(const picture::SampleSource& samples, simulate::IndexSpan rows) {
  constexpr std::size_t max_rows = 64;
  std::vector<double> power(samples.column_place.size(), 0.0);
  each_power(samples, rows, max_rows, [&](std::size_t, std::size_t column, double p) { power[column] += p; });
  return strongest_of(power);
}

std::size_t strongest_row(const picture::SampleSource& samples) {
  const std::size_t rows = samples.row_place.size();
  if (static_cast<double>(rows) * static_cast<double>(samples.column_place.size()) > static_cast<double>(max_samples))
    return rows / 2;
  std::vector<double> power(rows, 0.0);
  each_power(samples, {0, rows}, rows,
             [&](std::size_t row, std::size_t, double p) { power[row] = std::max(power[row], p); });
  return static_cast<std::size_t>(std::ranges::max_element(power) - power.begin());
}

bool is_of_samples(PlotKind kind) {
  switch (kind) {
    case PlotKind::pulse:
    case PlotKind::range:
    case PlotKind::profile:
    case PlotKind::range_doppler:
    case PlotKind::doppler_time:
    case PlotKind::spectrum:
    case PlotKind::phase: return true;
    default: return false;
  }
}

Plotted plot_samples(const PlotArguments& a, const picture::SampleSource& samples) {
  expect_quantity(a);
  if (samples.row_place.empty() || samples.column_place.empty())
    throw core::InvalidRequest("there are no samples to show");
  const std::size_t row = nearest(samples.row_place, a.at_s, samples.look.rows);
  const std::size_t column = a.at_m || !needs_column(a.kind)
                                 ? nearest(samples.column_place, a.at_m, samples.look.columns)
                                 : strongest_column(samples, burst(a, row, samples.row_place.size()));
  Plotted plotted;
  if (a.kind == PlotKind::pulse || a.kind == PlotKind::range) {
    picture::CutLook look = samples.look;
    look.quantity = a.quantity.value_or(look.quantity);
    look.span_db = a.span_db.value_or(look.span_db);
    look.peaks = static_cast<std::size_t>(a.peaks.value_or(0));
    const bool pulse = a.kind == PlotKind::pulse;
    const simulate::IndexSpan rows =
        pulse ? simulate::IndexSpan{row, row + 1} : burst(a, row, samples.row_place.size());
    const simulate::IndexSpan columns =
        pulse ? simulate::IndexSpan{0, samples.column_place.size()} : simulate::IndexSpan{column, column + 1};
    const picture::EchoBlock block = read_block(samples, rows, columns, 1);
    plotted.figure = pulse ? picture::row_figure(block, 0, look) : picture::column_figure(block, 0, look);
    if (!a.csv.empty()) plotted.table = picture::sample_table(block, look, !pulse, pulse, ',');
    return plotted;
  }
  if (!samples.timed)
    throw core::InvalidRequest("the file lacks the times, ranges and carriers that this kind of plot needs",
                               "name the script that wrote it with --script, or use an HDF5 file");
  plotted.figure = radar_view(a, samples, row, column);
  picture::say_unit(plotted.figure, samples.look.unit);
  if (!a.csv.empty()) plotted.table = picture::curves_table(plotted.figure, ',');
  return plotted;
}

}  // namespace sarsim::cli
