#include "gui/image/image_words.hpp"

#include <QStringList>

#include <algorithm>
#include <cmath>

#include "gui/common/text.hpp"
#include "gui/image/image_plot.hpp"

namespace sarsim::gui {

QString number_text(double value, const QString& unit) {
  const QString text = QString::number(value, 'g', 6);
  return unit.isEmpty() ? text : text + " " + unit;
}

QString ImageWords::value_unit() const {
  if (!source) return {};
  const raster::RasterInfo& info = source->info();
  // A file that is described by hand does not say what its numbers are.
  const bool volts = info.value == raster::ImageValue::complex && !info.counts && (!info.format->by_hand || focused);
  return volts ? QStringLiteral("V") : QString();
}

QString ImageWords::unit() const {
  const bool of_values =
      look.quantity != picture::DisplayQuantity::phase && look.quantity != picture::DisplayQuantity::decibels;
  return of_values ? value_unit() : text_of(picture::unit_of(look.quantity));
}

// What is measured counts from 1 V, not from the strongest sample in view.
QString ImageWords::decibel_unit() const { return value_unit() == "V" ? QStringLiteral("dBV") : QStringLiteral("dB"); }

QString ImageWords::at(const ImagePlot& plot, SamplePlace place) const {
  const auto& part = plot.part();
  const auto index = part ? part->nearest(place.column, place.row) : std::nullopt;
  if (!index) return {};
  const std::size_t row = part->window.row(*index / part->window.cols);
  const std::size_t column = part->window.column(*index % part->window.cols);
  const std::complex<double> s = part->samples[*index];
  QStringList words{tr("Row %1").arg(row), tr("Sample %1").arg(column)};
  if (axes) {  // exact, also where pulses are not evenly spaced
    if (row < axes->row_time_s.size() && std::isfinite(axes->row_time_s[row]))
      words << tr("Time %1").arg(number_text(axes->row_time_s[row], "s"));
    if (column < axes->column_range_m.size() && std::isfinite(axes->column_range_m[column]))
      words << tr("Range %1").arg(number_text(axes->column_range_m[column], "m"));
  } else if (const auto& places = plot.places()) {
    const auto say = [&](const raster::ImagePlaces& axis, std::size_t number) {
      if (axis.unit.empty()) return;
      words << QString::fromStdString(axis.label) + " " +
                   number_text(axis.first + axis.step * static_cast<double>(number), axis.unit.c_str());
    };
    say(places->azimuth, row);
    say(places->range, column);
  }
  if (!part->colours.empty()) {
    const raster::Rgb& c = part->colours[*index];
    words << tr("Red %1  green %2  blue %3").arg(c.red).arg(c.green).arg(c.blue);
    return words.join("   ");
  }
  if (part->peaks) {
    words << tr("Largest magnitude here %1").arg(number_text(s.real(), value_unit()));
    return words.join("   ");
  }
  const double db = shown_value(part->value, picture::DisplayQuantity::decibels, s, 1.0);
  if (part->value == raster::ImageValue::complex)
    words << "I " + number_text(s.real(), value_unit()) << "Q " + number_text(s.imag(), value_unit())
          << tr("Magnitude %1").arg(number_text(std::abs(s), value_unit()))
          << tr("Phase %1 deg").arg(picture::value_of(picture::DisplayQuantity::phase, s), 0, 'f', 2);
  else
    words << tr("Value %1").arg(number_text(s.real(), value_unit()));
  words << (db <= picture::lowest_db ? tr("no power") : QStringLiteral("%1 %2").arg(db, 0, 'f', 2).arg(decibel_unit()));
  return words.join("   ");
}

QString ImageWords::difference(const ImagePlot& plot) const {
  const auto& first = plot.cursor(0);
  const auto& second = plot.cursor(1);
  if (!first || !second) return {};
  QString words =
      tr("From 1 to 2:   %1 samples   %2 rows").arg(second->column - first->column).arg(second->row - first->row);
  const auto& part = plot.part();
  const auto a = part ? part->nearest(first->column, first->row) : std::nullopt;
  const auto b = part ? part->nearest(second->column, second->row) : std::nullopt;
  if (a && b) {
    const double db = shown_value(part->value, picture::DisplayQuantity::decibels, part->samples[*b], 1.0) -
                      shown_value(part->value, picture::DisplayQuantity::decibels, part->samples[*a], 1.0);
    words += tr("   Level %1 dB").arg(db, 0, 'f', 2);
  }
  return words;
}

picture::SampleQuantity ImageWords::measured_quantity() const {
  switch (look.quantity) {
    case picture::DisplayQuantity::real: return picture::SampleQuantity::real;
    case picture::DisplayQuantity::imaginary: return picture::SampleQuantity::imaginary;
    case picture::DisplayQuantity::phase: return picture::SampleQuantity::phase;
    case picture::DisplayQuantity::decibels: return picture::SampleQuantity::decibels;
    default: return picture::SampleQuantity::magnitude;
  }
}

double ImageWords::measured_scale() const {
  const bool decibels = look.quantity == picture::DisplayQuantity::decibels;
  const bool powers = source && source->info().value == raster::ImageValue::power;
  // Measured are radians, and 20 log10 of whatever the values are.
  return look.quantity == picture::DisplayQuantity::phase ? 180.0 / M_PI : decibels && powers ? 0.5 : 1.0;
}

QString ImageWords::measured_unit() const {
  return look.quantity == picture::DisplayQuantity::decibels ? decibel_unit() : unit();
}

QString ImageWords::of_selection(const picture::SelectionStatistics& statistics, bool selected) const {
  const picture::QuantityStatistics& of = statistics[measured_quantity()];
  const bool decibels = look.quantity == picture::DisplayQuantity::decibels;
  QStringList words{tr("%1 %2 samples").arg(selected ? tr("Selection:") : tr("In view:")).arg(statistics.samples)};
  const QString name = text_of(picture::title_of(look.quantity));
  const auto add = [&](const QString& what, double value) {
    words << what + " " + number_text(value * measured_scale(), measured_unit());
  };
  if (of.count > 0) {
    words << name + ":";
    add(tr("from"), of.minimum);
    add(tr("to"), of.maximum);
    add(tr("mean"), of.mean);
    add(tr("deviation"), of.deviation);
    if (!decibels) add(tr("RMS"), of.rms);
  }
  if (statistics.zeros > 0) words << tr("%1 zero").arg(statistics.zeros);
  if (statistics.not_finite > 0) words << tr("%1 no number").arg(statistics.not_finite);
  return words.join("   ");
}

QString ImageWords::of_point(const picture::PointReading& r) const {
  const auto cut = [](const picture::CutReading& c, const QString& unit) {
    return tr("width %1 %2, PSLR %3 dB, ISLR %4 dB")
        .arg(c.width, 0, 'f', 3)
        .arg(unit)
        .arg(c.pslr_db, 0, 'f', 2)
        .arg(c.islr_db, 0, 'f', 2);
  };
  QString text = tr("Point at row %1, sample %2: peak %3, phase %4 deg\nAlong samples: %5\nAlong rows: %6")
                     .arg(r.row, 0, 'f', 2)
                     .arg(r.column, 0, 'f', 2)
                     .arg(number_text(std::abs(r.value), value_unit()))
                     .arg(picture::value_of(picture::DisplayQuantity::phase, r.value), 0, 'f', 2)
                     .arg(cut(r.along_row, tr("samples")), cut(r.along_column, tr("rows")));
  if (std::max(r.along_row.pslr_db, r.along_column.pslr_db) > 0.0)
    text += "\n" + tr("This may be a sidelobe of a stronger response nearby: click on that one.");
  return text;
}

}  // namespace sarsim::gui
