#pragma once

#include <QLabel>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <functional>
#include <vector>

#include "gui/image/image_plot.hpp"
#include "gui/image/image_viewer.hpp"
#include "raster/format/sinks.hpp"

/// Files of samples, and viewers that show them, for tests.
namespace sarsim::test {

namespace fs = std::filesystem;

/// A cache of its own for a test.
inline void keep_apart(const QTemporaryDir& cache) { qputenv("XDG_CACHE_HOME", cache.path().toUtf8()); }

inline constexpr int patience_ms = 20'000;
inline constexpr std::size_t rows = 120;
inline constexpr std::size_t columns = 100;
inline constexpr std::size_t point_row = 70;
inline constexpr std::size_t point_column = 40;

/// sin(pi x)/(pi x).
inline double sinc(double x) { return x == 0.0 ? 1.0 : std::sin(M_PI * x) / (M_PI * x); }

/// A point of 1000 counts in a plain of small ones.
inline std::complex<double> sample(std::size_t row, std::size_t column) {
  const double down = static_cast<double>(row) - static_cast<double>(point_row);
  const double across = static_cast<double>(column) - static_cast<double>(point_column);
  return {std::round(1000.0 * sinc(0.9 * down) * sinc(0.9 * across)), 2.0};
}

/// Writes `count` rows of `width` samples of whole numbers as a recording.
inline void write_samples(const fs::path& path, const raster::SinkOptions& options, std::size_t count,
                          std::size_t width,
                          const std::function<std::complex<double>(std::size_t row, std::size_t column)>& value) {
  raster::Product product;
  product.radar = "radar";
  product.rows = count;
  product.columns = width;
  product.bits = 12;
  product.lsb_v = 1.0;
  product.sample_rate_hz = 1e6;
  product.row_time_s = [](std::size_t row) { return 1e-3 * static_cast<double>(row); };
  product.row_carrier_hz = [](std::size_t) { return 1e10; };
  product.column_range_m = [](std::size_t column) { return 1000.0 + static_cast<double>(column); };
  const auto sink = raster::make_sink(path, product, options);
  std::vector<std::complex<double>> volts;
  std::vector<std::int64_t> counts;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < width; ++k) {
      volts.push_back(value(i, k));
      counts.push_back(std::llround(volts.back().real()));
      counts.push_back(std::llround(volts.back().imag()));
    }
  raster::Block block{0, count, width, {}, {}};
  if (sink->wants_counts())
    block.counts = counts;
  else
    block.volts = volts;
  sink->append(sink->encode(block), 0, count);
  raster::RunReport report;
  report.rows = count;
  report.columns = width;
  report.lsb_v = 1.0;
  sink->finish(report);
}

/// The point in its plain, as counts.
inline void write_samples(const fs::path& path, scene::FileFormat format, std::size_t count = rows) {
  raster::SinkOptions options;
  options.format = format;
  options.counts = true;
  write_samples(path, options, count, columns, sample);
}

/// Rows of a test's data: every format of samples, as an int in the column "format".
inline void add_formats() {
  QTest::addColumn<int>("format");
  for (const auto& [name, format] :
       {std::pair{"ascii", scene::FileFormat::ascii}, std::pair{"binary", scene::FileFormat::binary},
        std::pair{"bracket", scene::FileFormat::bracket}, std::pair{"hdf5", scene::FileFormat::hdf5},
        std::pair{"csv", scene::FileFormat::csv}, std::pair{"npy", scene::FileFormat::npy}})
    QTest::newRow(name) << static_cast<int>(format);
}

/// How a BINARY file of them is to be read.
inline raster::RasterHints binary_hints() {
  raster::RasterHints hints;
  hints.format = scene::FileFormat::binary;
  hints.columns = columns;
  hints.bits = 12;
  return hints;
}

/// How a file of pairs of floats is to be read.
inline raster::RasterHints float_layout(std::size_t width) {
  raster::RasterHints hints;
  hints.raw = raster::RawLayout{.width = width, .number = raster::RawNumber::float32};
  return hints;
}

/// Adds pairs of floats to a file: 1, 2 ... 7, 1, 2 ...
inline void append_floats(const fs::path& path, std::size_t count) {
  std::ofstream file(path, std::ios::binary | std::ios::app);
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const auto value = static_cast<float>(1 + i % 7);
    file.write(reinterpret_cast<const char*>(&value), sizeof value);
  }
}

/// Shows a viewer and lets it open a file.
inline void open_in(gui::ImageViewer& viewer, const fs::path& path, const raster::RasterHints& hints = {}) {
  viewer.resize(1000, 700);
  viewer.show();
  viewer.open(path, hints);
}

inline bool wait_until_open(gui::ImageViewer& viewer) {
  return QTest::qWaitFor([&] { return viewer.source() != nullptr && viewer.source()->indexed() >= 1.0; }, patience_ms);
}

inline bool wait_for_picture(gui::ImageViewer& viewer) {
  return QTest::qWaitFor([&] { return viewer.complete() && viewer.plot().part() != nullptr; }, patience_ms);
}

/// A folder with a file in it that a viewer shows.
struct Bench {
  explicit Bench(scene::FileFormat format = scene::FileFormat::npy) {
    path = folder.filePath("data.file").toStdString();
    write_samples(path, format);
    open_in(viewer, path, format == scene::FileFormat::binary ? binary_hints() : raster::RasterHints());
    shown = wait_until_open(viewer) && wait_for_picture(viewer);
  }
  QPoint at(double across, double down) {
    const QRect plot = viewer.plot().plot_rect();
    return {plot.left() + static_cast<int>(across * plot.width()), plot.top() + static_cast<int>(down * plot.height())};
  }
  QPoint at_sample(std::size_t row, std::size_t column) {
    return viewer.plot().pixel_of({static_cast<double>(column), static_cast<double>(row)}).toPoint();
  }
  void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {}) {
    gui::ImagePlot& plot = viewer.plot();
    QTest::mousePress(&plot, button, keys, from);
    for (int step = 1; step <= 4; ++step) {
      const QPoint place = from + (to - from) * step / 4;
      QMouseEvent move(QEvent::MouseMove, place, plot.mapToGlobal(place), Qt::NoButton, button, keys);
      QApplication::sendEvent(&plot, &move);
    }
    QTest::mouseRelease(&plot, button, keys, to);
  }
  QString words(const char* name) { return viewer.findChild<QLabel*>(name)->text(); }

  QTemporaryDir folder;
  fs::path path;
  gui::ImageViewer viewer;
  bool shown = false;
};

/// A folder with a file of floats, 64 to a row, that a viewer shows.
struct FloatBench {
  static constexpr std::size_t width = 64;

  explicit FloatBench(std::size_t count) {
    path = folder.filePath("floats.raw").toStdString();
    append_rows(count);
    open_in(viewer, path, float_layout(width));
    shown = wait_until_open(viewer) && wait_for_picture(viewer);
  }
  void append_rows(std::size_t count) const { append_floats(path, width * count); }
  void cut_off_after(std::size_t count) const { fs::resize_file(path, width * 8 * count); }
  bool wait_for_rows(std::size_t count) {
    return QTest::qWaitFor([&] { return viewer.source() && viewer.source()->rows() == count; }, patience_ms);
  }
  bool wait_for_words() {
    return QTest::qWaitFor([&] { return !viewer.problem_words().isEmpty(); }, patience_ms);
  }

  QTemporaryDir folder;
  fs::path path;
  gui::ImageViewer viewer;
  bool shown = false;
};

}  // namespace sarsim::test
