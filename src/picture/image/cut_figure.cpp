#include "picture/image/cut_figure.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "picture/figure/figure_axes.hpp"
#include "radar/path/path.hpp"

namespace sarsim::picture {

namespace {

std::string place_text(const CutPlaces& places, double value) {
  return places.label + " " +
         (places.unit.empty() ? core::format_number(value) : core::with_prefix(value, places.unit));
}

// The shown quantity of some samples, and its axis without limits.
struct Shown {
  std::vector<double> values;
  FigureAxis axis;
  double largest = 0.0;  // magnitude
};

Shown shown(std::vector<std::complex<double>> samples, const CutLook& look) {
  Shown out;
  out.largest = statistics_of(samples).largest_v;
  out.axis.label = axis_title_of(look.quantity);
  out.axis.unit = unit_of(look.quantity) == "V" ? look.unit : unit_of(look.quantity);
  if (look.quantity == DisplayQuantity::decibels) {
    out.axis.label = "Below the largest";
    for (const std::complex<double>& sample : samples) out.values.push_back(std::abs(sample));
    if (out.largest > 0.0)
      for (double& value : out.values) value /= out.largest;
    out.values = decibels_of(std::move(out.values), 20.0, look.span_db);
    return out;
  }
  for (const std::complex<double>& sample : samples) out.values.push_back(value_of(look.quantity, sample));
  return out;
}

std::string largest_text(double largest, const std::string& unit) {
  return "Highest magnitude: " +
         (unit == "V" ? core::with_prefix(largest, unit) : core::format_number(largest) + " " + unit);
}

Figure cut(std::string title, FigureAxis across, std::vector<double> x, Shown up, const CutLook& look) {
  Figure figure;
  figure.note = largest_text(up.largest, look.unit);
  figure.panels.push_back(
      curve_panel(std::move(title), std::move(across), std::move(up.axis), std::move(x), std::move(up.values)));
  FigurePanel& panel = figure.panels.back();
  // Magnitudes are seen against 0.
  if (look.quantity == DisplayQuantity::magnitude) panel.y.first = std::min(panel.y.first, -0.05 * panel.y.last);
  mark_peaks(panel, look.peaks);
  break_where_it_turns_back(panel.curves[0]);
  return figure;
}

}  // namespace

Figure row_figure(const EchoBlock& block, std::size_t row, const CutLook& look) {
  FigureAxis across = axis_along(look.columns.label, look.columns.unit, block.range_m);
  if (look.columns.label == "Slant range" && look.columns.unit == "m" && block.light_speed_mps > 0.0)
    across.twin = FigureAxis::Twin{"Delay (there and back)", "s", radar::delay_of(1.0, block.light_speed_mps)};
  std::vector<std::complex<double>> samples;
  for (std::size_t c = 0; c < block.columns; ++c) samples.push_back(block.at(row, c));
  return cut(place_text(look.rows, block.time_s[row]), std::move(across), block.range_m,
             shown(std::move(samples), look), look);
}

Figure column_figure(const EchoBlock& block, std::size_t column, const CutLook& look) {
  std::vector<std::complex<double>> samples;
  for (std::size_t r = 0; r < block.rows; ++r) samples.push_back(block.at(r, column));
  return cut(place_text(look.columns, block.range_m[column]), axis_along(look.rows.label, look.rows.unit, block.time_s),
             block.time_s, shown(std::move(samples), look), look);
}

std::string sample_table(const EchoBlock& block, const CutLook& look, bool rows, bool columns, char separator) {
  const auto heading = [](const CutPlaces& places) {
    std::string words = places.label;
    words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
    return places.unit.empty() ? words : words + " [" + places.unit + "]";
  };
  std::string text;
  if (rows) (text += heading(look.rows)) += separator;
  if (columns) (text += heading(look.columns)) += separator;
  for (const char* name : {"I", "Q", "magnitude"}) text += std::string(name) + " [" + look.unit + "]" + separator;
  text += "phase [deg]\n";
  for (std::size_t r = 0; r < block.rows; ++r)
    for (std::size_t c = 0; c < block.columns; ++c) {
      const std::complex<double> v = block.at(r, c);
      if (rows) core::append_number(text, block.time_s[r]), text += separator;
      if (columns) core::append_number(text, block.range_m[c]), text += separator;
      for (const double value : {v.real(), v.imag(), std::abs(v)}) core::append_number(text, value), text += separator;
      core::append_number(text, std::arg(v) * 180.0 / core::pi);
      text += '\n';
    }
  return text;
}

}  // namespace sarsim::picture
