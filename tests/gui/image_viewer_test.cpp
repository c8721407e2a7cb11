#include <QtTest>

#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QToolButton>

#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "data/sinks.hpp"
#include "data/sun_raster.hpp"
#include "gui/figure_plot.hpp"
#include "gui/image_controls.hpp"
#include "gui/image_plot.hpp"
#include "gui/image_thumbnail.hpp"
#include "gui/image_viewer.hpp"
#include "gui/image_viewers.hpp"
#include "gui/main_window.hpp"
#include "gui/open_image_dialog.hpp"

namespace sarsim {

namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 20'000;
constexpr std::size_t rows = 120;
constexpr std::size_t columns = 100;
constexpr std::size_t point_row = 70;
constexpr std::size_t point_column = 40;

double sinc(double x) { return x == 0.0 ? 1.0 : std::sin(M_PI * x) / (M_PI * x); }

// A point of 1000 counts in a plain of small ones.
std::complex<double> sample(std::size_t row, std::size_t column) {
  const double down = static_cast<double>(row) - static_cast<double>(point_row);
  const double across = static_cast<double>(column) - static_cast<double>(point_column);
  return {std::round(1000.0 * sinc(0.9 * down) * sinc(0.9 * across)), 2.0};
}

void write_samples(const fs::path& path, FileFormat format, std::size_t count = rows) {
  Product product;
  product.radar = "radar";
  product.rows = count;
  product.columns = columns;
  product.bits = 12;
  product.lsb_v = 1.0;
  product.sample_rate_hz = 1e6;
  product.row_time_s = [](std::size_t row) { return 1e-3 * static_cast<double>(row); };
  product.row_carrier_hz = [](std::size_t) { return 1e10; };
  product.column_range_m = [](std::size_t column) { return 1000.0 + static_cast<double>(column); };
  SinkOptions options;
  options.format = format;
  options.counts = true;
  const auto sink = make_sink(path, product, options);
  std::vector<std::complex<double>> volts;
  std::vector<std::int64_t> counts;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < columns; ++k) {
      volts.push_back(sample(i, k));
      counts.push_back(static_cast<std::int64_t>(volts.back().real()));
      counts.push_back(static_cast<std::int64_t>(volts.back().imag()));
    }
  Block block{0, count, columns, {}, {}};
  if (sink->wants_counts())
    block.counts = counts;
  else
    block.volts = volts;
  sink->append(sink->encode(block), 0, count);
  RunReport report;
  report.rows = count;
  report.columns = columns;
  report.lsb_v = 1.0;
  sink->finish(report);
}

ImageHints binary_hints() {
  ImageHints hints;
  hints.samples.format = FileFormat::binary;
  hints.samples.columns = columns;
  hints.samples.bits = 12;
  return hints;
}

ImageHints float_layout(std::size_t width) {
  ImageHints hints;
  hints.raw = RawLayout{.width = width, .number = RawNumber::float32};
  return hints;
}

void append_floats(const fs::path& path, std::size_t count) {
  std::ofstream file(path, std::ios::binary | std::ios::app);
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const auto value = static_cast<float>(1 + i % 7);
    file.write(reinterpret_cast<const char*>(&value), sizeof value);
  }
}

bool wait_until_open(ImageViewer& viewer) {
  return QTest::qWaitFor([&] { return viewer.source() != nullptr && viewer.source()->indexed() >= 1.0; }, patience_ms);
}

bool wait_for_picture(ImageViewer& viewer) {
  return QTest::qWaitFor([&] { return viewer.complete() && viewer.plot().part() != nullptr; }, patience_ms);
}

// A folder with a file in it that a viewer shows.
struct Bench {
  explicit Bench(FileFormat format = FileFormat::npy) {
    path = folder.filePath("data.file").toStdString();
    write_samples(path, format);
    viewer.resize(1000, 700);
    viewer.show();
    viewer.open(path, format == FileFormat::binary ? binary_hints() : ImageHints());
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
    ImagePlot& plot = viewer.plot();
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
  ImageViewer viewer;
  bool shown = false;
};

}  // namespace

class ImageViewerTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir cache_;

 private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QSettings().clear();
    qputenv("XDG_CACHE_HOME", cache_.path().toUtf8());
  }

  void every_format_of_samples_is_shown_data() {
    QTest::addColumn<int>("format");
    for (const auto& [name, format] : {std::pair{"ascii", FileFormat::ascii}, std::pair{"binary", FileFormat::binary},
                                       std::pair{"bracket", FileFormat::bracket}, std::pair{"hdf5", FileFormat::hdf5},
                                       std::pair{"csv", FileFormat::csv}, std::pair{"npy", FileFormat::npy}})
      QTest::newRow(name) << static_cast<int>(format);
  }

  void every_format_of_samples_is_shown() {
    QFETCH(int, format);
    QTemporaryDir folder;
    const fs::path path = folder.filePath("data.file").toStdString();
    write_samples(path, static_cast<FileFormat>(format));
    ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    ImageHints hints = binary_hints();
    hints.samples.format = static_cast<FileFormat>(format);
    viewer.open(path, hints);
    QVERIFY2(wait_until_open(viewer), qPrintable(viewer.problem_words()));
    QVERIFY(
        QTest::qWaitFor([&] { return viewer.complete() && viewer.plot().part()->window.rows == rows; }, patience_ms));
    const ImagePart& part = *viewer.plot().part();
    QCOMPARE(part.window.cols, columns);
    QCOMPARE(part.samples[*part.nearest(point_column, point_row)], sample(point_row, point_column));
    QVERIFY(viewer.findChild<QLabel*>("image_info")->text().contains("120 rows of 100 samples"));
  }

  void a_raster_is_shown_in_its_own_greys_and_colours() {
    QTemporaryDir folder;
    const fs::path grey = folder.filePath("grey.ras").toStdString();
    const fs::path colour = folder.filePath("colour.ras").toStdString();
    write_sun_raster(grey, 2, 2, std::vector<std::uint8_t>{0, 255, 100, 50});
    write_sun_raster(colour, 2, 2, std::vector<Rgb>{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {9, 8, 7}});
    ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    viewer.open(grey);
    QVERIFY(wait_until_open(viewer) && wait_for_picture(viewer));
    const QImage greys = viewer.plot().painted().image;
    QVERIFY(qRed(greys.pixel(0, 0)) < qRed(greys.pixel(1, 1)));
    QVERIFY(qRed(greys.pixel(1, 1)) < qRed(greys.pixel(0, 1)));
    QVERIFY(qRed(greys.pixel(0, 1)) < qRed(greys.pixel(1, 0)));
    ImageViewer other;
    other.resize(1000, 700);
    other.show();
    other.open(colour);
    QVERIFY(wait_until_open(other) && wait_for_picture(other));
    QCOMPARE(other.plot().painted().image.pixel(0, 1), qRgb(0, 0, 255));
    QVERIFY(!other.findChild<QComboBox*>("image_quantity")->isEnabled());
  }

  void a_file_that_is_described_by_hand_is_shown() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("floats.raw").toStdString();
    append_floats(path, 64 * 32);
    ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    viewer.open(path, float_layout(64));
    QVERIFY(wait_until_open(viewer) && wait_for_picture(viewer));
    QCOMPARE(viewer.source()->rows(), std::size_t{32});
    QCOMPARE(viewer.plot().part()->samples[1], std::complex<double>(3.0, 4.0));
  }

  void a_drawn_rectangle_is_zoomed_to_and_backspace_goes_back() {
    Bench bench;
    QVERIFY(bench.shown);
    const ImageView all = bench.viewer.plot().view();
    QCOMPARE(all, whole_view(rows, columns));
    bench.drag(bench.at(0.25, 0.5), bench.at(0.75, 1.0));
    const ImageView zoomed = bench.viewer.plot().view();
    QVERIFY(std::abs(zoomed.column_first - (0.25 * columns - 0.5)) < 1.0);
    QVERIFY(std::abs(zoomed.column_last - (0.75 * columns - 0.5)) < 1.0);
    QVERIFY(std::abs(zoomed.row_first - (0.5 * rows - 0.5)) < 1.0);
    QVERIFY(wait_for_picture(bench.viewer));
    QTest::keyClick(&bench.viewer.plot(), Qt::Key_Backspace);
    QCOMPARE(bench.viewer.plot().view(), all);
    bench.viewer.findChild<QToolButton*>("image_forward")->click();
    QCOMPARE(bench.viewer.plot().view(), zoomed);
    QTest::keyClick(&bench.viewer.plot(), Qt::Key_Home);
    QCOMPARE(bench.viewer.plot().view(), all);
  }

  void a_right_click_shows_twice_as_much() {
    Bench bench;
    bench.viewer.go_to({20.0, 40.0, 30.0, 50.0});
    QTest::mouseClick(&bench.viewer.plot(), Qt::RightButton, {}, bench.at(0.5, 0.5));
    const ImageView more = bench.viewer.plot().view();
    QVERIFY(std::abs(more.columns() - 40.0) < 1e-9);
    QVERIFY(std::abs(more.rows() - 40.0) < 1e-9);
  }

  void the_wheel_keeps_the_place_below_the_pointer() {
    Bench bench;
    const QPoint at = bench.at(0.3, 0.6);
    const ImagePlace before = bench.viewer.plot().place_at(at);
    QWheelEvent turn(at, bench.viewer.plot().mapToGlobal(at), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(&bench.viewer.plot(), &turn);
    const ImagePlace after = bench.viewer.plot().place_at(at);
    QVERIFY(bench.viewer.plot().view().columns() < 0.7 * columns);
    QVERIFY(std::abs(after.column - before.column) < 1e-6 && std::abs(after.row - before.row) < 1e-6);
  }

  void the_middle_button_moves_the_view_and_the_old_picture_at_once() {
    Bench bench;
    bench.viewer.go_to({20.0, 60.0, 20.0, 60.0});
    QVERIFY(wait_for_picture(bench.viewer));
    const auto part = bench.viewer.plot().part();
    bench.drag(bench.at(0.5, 0.5), bench.at(0.6, 0.5), Qt::MiddleButton);
    QVERIFY(std::abs(bench.viewer.plot().view().column_first - 16.0) < 0.5);
    QCOMPARE(bench.viewer.plot().part(), part);  // nothing has been read yet, but it is drawn elsewhere
    QVERIFY(!bench.viewer.plot().plot_image().isNull());
    QVERIFY(wait_for_picture(bench.viewer));
    QTest::keyClick(&bench.viewer.plot(), Qt::Key_Backspace);
    QCOMPARE(bench.viewer.plot().view().column_first, 20.0);
  }

  void colours_change_without_reading_anew() {
    Bench bench;
    const auto part = bench.viewer.plot().part();
    const QImage before = bench.viewer.plot().painted().image;
    ImageLook look = bench.viewer.look();
    look.inverted = true;
    bench.viewer.set_look(look);
    QVERIFY(wait_for_picture(bench.viewer));
    QCOMPARE(bench.viewer.plot().part(), part);
    QVERIFY(bench.viewer.plot().painted().image != before);
  }

  void limits_set_by_hand_begin_with_the_present_ones_and_refuse_nonsense() {
    Bench bench;
    auto* const limits = bench.viewer.findChild<QComboBox*>("image_limits");
    const ColourLimits present = bench.viewer.plot().painted().colours.limits;
    limits->setCurrentIndex(2);
    emit limits->activated(2);
    QCOMPARE(bench.viewer.look().limits.low, present.low);
    QCOMPARE(bench.viewer.look().limits.high, present.high);
    auto* const low = bench.viewer.findChild<QLineEdit*>("image_low");
    low->selectAll();
    QTest::keyClicks(low, "-20 dB");
    QTest::keyClick(low, Qt::Key_Return);
    QCOMPARE(bench.viewer.look().limits.low, -20.0);
    low->selectAll();
    QTest::keyClicks(low, "dark");
    QTest::keyClick(low, Qt::Key_Return);
    QCOMPARE(bench.viewer.look().limits.low, -20.0);
    QVERIFY(bench.viewer.findChild<QWidget*>("image_problem")->isVisibleTo(&bench.viewer));
  }

  void the_read_out_names_the_sample_below_the_pointer() {
    Bench bench(FileFormat::hdf5);
    QVERIFY(bench.shown);
    QTest::mouseMove(&bench.viewer.plot(), bench.at_sample(point_row, point_column));
    QMouseEvent move(QEvent::MouseMove, bench.at_sample(point_row, point_column), QPointF(), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QApplication::sendEvent(&bench.viewer.plot(), &move);
    const QString words = bench.words("image_read_out");
    for (const char* part : {"Row 70", "Sample 40", "I 1000", "Q 2", "Time 0.07 s", "Range 1040 m"})
      QVERIFY2(words.contains(part), qPrintable(words));
  }

  void cursors_tell_their_difference_and_cuts_go_through_the_first() {
    Bench bench;
    QTest::mouseClick(&bench.viewer.plot(), Qt::LeftButton, {}, bench.at_sample(point_row, point_column));
    QTest::mouseClick(&bench.viewer.plot(), Qt::LeftButton, Qt::ShiftModifier, bench.at_sample(80, 45));
    QVERIFY2(bench.words("image_difference").contains("5 samples   10 rows"),
             qPrintable(bench.words("image_difference")));
    bench.viewer.findChild<QToolButton*>("image_show_cuts")->click();
    auto* const row = bench.viewer.findChild<FigurePlot*>("image_row_cut");
    auto* const column = bench.viewer.findChild<FigurePlot*>("image_column_cut");
    QVERIFY(row->isVisibleTo(&bench.viewer) && column->isVisibleTo(&bench.viewer));
    QCOMPARE(row->figure().panels.at(0).title, std::string("Row 70"));
    QCOMPARE(column->figure().panels.at(0).title, std::string("Sample 40"));
    QCOMPARE(column->figure().panels.at(0).curves[0].y.size(), rows);
    QTest::keyClick(&bench.viewer.plot(), Qt::Key_Escape);
    QVERIFY(!bench.viewer.plot().cursor(0));
  }

  void a_selection_is_measured_whole() {
    Bench bench;
    bench.drag(bench.at_sample(65, 35), bench.at_sample(75, 45), Qt::LeftButton, Qt::ShiftModifier);
    QVERIFY(bench.viewer.plot().selection());
    QVERIFY(QTest::qWaitFor([&] { return bench.viewer.statistics().has_value(); }, patience_ms));
    const SelectionStatistics& measured = *bench.viewer.statistics();
    QCOMPARE(measured.samples, std::uint64_t{bench.viewer.plot().selection()->samples()});
    QVERIFY(measured.samples >= 100 && measured.samples <= 144);
    QCOMPARE(measured[SampleQuantity::real].maximum, 1000.0);
    QVERIFY(bench.viewer.findChild<QWidget*>("image_histogram")->isVisibleTo(&bench.viewer));
    QVERIFY(bench.words("image_statistics").contains("Selection:"));
    bench.viewer.plot().set_selection(std::nullopt);
    QVERIFY(QTest::qWaitFor([&] { return bench.viewer.statistics()->samples == rows * columns; }, patience_ms));
  }

  void a_click_with_the_reading_tool_measures_the_point() {
    Bench bench;
    bench.viewer.findChild<QToolButton*>("image_reading_tool")->click();
    QTest::mouseClick(&bench.viewer.plot(), Qt::LeftButton, {}, bench.at_sample(point_row + 1, point_column - 1));
    QVERIFY(QTest::qWaitFor([&] { return bench.viewer.reading().has_value(); }, patience_ms));
    const PointReading& reading = *bench.viewer.reading();
    QVERIFY(std::abs(reading.row - point_row) < 0.05);
    QVERIFY(std::abs(reading.column - point_column) < 0.05);
    // A sin(x)/x is 0.886 wide, here over 0.9; to the rounding of the counts.
    QVERIFY2(std::abs(reading.along_row.width - 0.886 / 0.9) < 0.03,
             qPrintable(QString::number(reading.along_row.width)));
    QVERIFY(std::abs(reading.along_row.pslr_db + 13.26) < 0.5);
    QVERIFY(bench.words("image_reading").contains("PSLR"));
  }

  void a_click_on_nothing_with_the_reading_tool_is_told_in_words() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("zeros.raw").toStdString();
    std::ofstream(path, std::ios::binary) << std::string(64 * 64 * 8, '\0');
    ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    viewer.open(path, float_layout(64));
    QVERIFY(wait_until_open(viewer) && wait_for_picture(viewer));
    viewer.read_point_at(10, 10);
    QVERIFY(
        QTest::qWaitFor([&] { return !viewer.findChild<QLabel*>("image_reading")->text().isEmpty(); }, patience_ms));
    QVERIFY(!viewer.reading());
  }

  void an_exported_selection_opens_again_with_the_same_samples_data() { every_format_of_samples_is_shown_data(); }

  void an_exported_selection_opens_again_with_the_same_samples() {
    QFETCH(int, format);
    Bench bench;
    bench.viewer.plot().set_selection(ImageWindow{60, 20, 30, 25, 1, 1});
    QSignalSpy done(&bench.viewer, &ImageViewer::exported);
    const QString copy = bench.folder.filePath("copy.file");
    bench.viewer.export_to(copy, static_cast<FileFormat>(format));
    QVERIFY(done.wait(patience_ms));
    QVERIFY2(done.front().front().toBool(), qPrintable(bench.viewer.problem_words()));
    ImageHints hints;
    hints.samples.format = static_cast<FileFormat>(format);
    hints.samples.columns = 25;
    hints.samples.bits = bench.viewer.source()->info().bits > 0 ? bench.viewer.source()->info().bits : 16;
    const OpenedImage opened = ImageSource::open(copy.toStdString(), hints);
    QVERIFY(opened.source != nullptr);
    opened.source->wait_until_indexed(nullptr);
    QCOMPARE(opened.source->rows(), std::size_t{20});
    std::vector<std::complex<float>> one(1);
    opened.source->read_window({point_row - 60, 1, point_column - 30, 1, 1, 1}, one);
    QVERIFY(std::abs(one[0] - std::complex<float>(1000.0F, 2.0F)) < 1e-3F);
  }

  void the_file_that_is_shown_is_not_overwritten() {
    Bench bench;
    const auto bytes = fs::file_size(bench.path);
    QSignalSpy done(&bench.viewer, &ImageViewer::exported);
    bench.viewer.export_to(QString::fromStdString(bench.path.string()), FileFormat::csv);
    QCOMPARE(done.size(), 1);
    QVERIFY(!done.front().front().toBool());
    QCOMPARE(fs::file_size(bench.path), bytes);
    QVERIFY(bench.viewer.problem_words().contains("another name"));
  }

  void the_figure_to_be_saved_shows_the_same_part() {
    Bench bench;
    bench.viewer.go_to({20.0, 60.0, 30.0, 90.0});
    QVERIFY(wait_for_picture(bench.viewer));
    const Figure figure = bench.viewer.figure();
    QCOMPARE(figure.panels.size(), std::size_t{1});
    QCOMPARE(figure.panels[0].x.first, 20.0);
    QCOMPARE(figure.panels[0].y.last, 30.0);
    QVERIFY(figure.panels[0].image->cells.size() == bench.viewer.plot().part()->samples.size());
    bench.viewer.copy_picture();
    QCOMPARE(QApplication::clipboard()->image().size(), bench.viewer.plot().device_size());
  }

  void the_thumbnail_shows_the_whole_and_leads_the_view() {
    Bench bench;
    auto* const thumbnail = bench.viewer.findChild<ImageThumbnail*>();
    QVERIFY(QTest::qWaitFor([&] { return !thumbnail->picture().isNull(); }, patience_ms));
    bench.viewer.go_to({20.0, 60.0, 30.0, 90.0});
    QVERIFY(thumbnail->mark().width() < 0.5 * thumbnail->width());
    QTest::mouseClick(thumbnail, Qt::LeftButton, {}, thumbnail->rect().center());
    const ImageView view = bench.viewer.plot().view();
    QVERIFY(std::abs((view.column_first + view.column_last) / 2.0 - (columns - 1) / 2.0) < 2.0);
    QVERIFY(std::abs(view.rows() - 60.0) < 1e-9);
  }

  void a_growing_file_is_followed() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("floats.raw").toStdString();
    append_floats(path, 64 * 32);
    ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    viewer.open(path, float_layout(64));
    QVERIFY(wait_until_open(viewer) && wait_for_picture(viewer));
    append_floats(path, 64 * 16);
    QVERIFY(QTest::qWaitFor([&] { return viewer.source()->rows() == 48 && viewer.complete(); }, patience_ms));
    QCOMPARE(viewer.plot().view(), whole_view(48, 64));
    QVERIFY(viewer.findChild<QLabel*>("image_info")->text().contains("48 rows"));
  }

  void a_shrinking_file_is_read_anew_or_told_in_words() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("floats.raw").toStdString();
    append_floats(path, 64 * 32);
    ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    viewer.open(path, float_layout(64));
    QVERIFY(wait_until_open(viewer) && wait_for_picture(viewer));
    fs::resize_file(path, 64 * 8 * 10);
    viewer.go_to({0.0, 10.0, 20.0, 30.0});  // what is gone
    QVERIFY(QTest::qWaitFor([&] { return viewer.source() && viewer.source()->rows() == 10; }, patience_ms));
    QVERIFY(wait_for_picture(viewer));
    fs::resize_file(path, 0);
    QVERIFY(QTest::qWaitFor([&] { return !viewer.problem_words().isEmpty(); }, patience_ms));
    append_floats(path, 64 * 4);
    QVERIFY(QTest::qWaitFor([&] { return viewer.source() && viewer.source()->rows() == 4; }, patience_ms));
  }

  void reading_what_was_cut_off_is_told_in_words() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("floats.raw").toStdString();
    append_floats(path, 64 * 3200);
    ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    viewer.open(path, float_layout(64));
    QVERIFY(wait_until_open(viewer) && wait_for_picture(viewer));
    viewer.findChild<QAbstractButton*>("image_follow")->setChecked(false);
    fs::resize_file(path, 64 * 8 * 10);
    viewer.go_to({0.0, 10.0, 2000.0, 2030.0});
    QVERIFY(QTest::qWaitFor([&] { return !viewer.problem_words().isEmpty(); }, patience_ms));
    QVERIFY2(viewer.problem_words().contains("floats.raw"), qPrintable(viewer.problem_words()));
  }

  void bad_files_are_told_in_words_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("one byte") << QByteArray("x");
    QTest::newRow("cut numpy") << QByteArray("\x93NUMPY\x01\x00\x76", 9);
    QTest::newRow("cut raster") << QByteArray("\x59\xa6\x6a\x95\x00\x00", 6);
    QTest::newRow("cut hdf5") << QByteArray("\x89HDF\r\n\x1a\n", 8);
    QTest::newRow("noise") << QByteArray(1000, '\xfe');
  }

  void bad_files_are_told_in_words() {
    QFETCH(QByteArray, content);
    QTemporaryDir folder;
    const fs::path path = folder.filePath("bad").toStdString();
    std::ofstream(path, std::ios::binary).write(content.data(), content.size());
    ImageViewer viewer;
    viewer.show();
    QSignalSpy failed(&viewer, &ImageViewer::open_failed);
    viewer.open(path);
    QVERIFY(failed.wait(patience_ms));
    QVERIFY(!viewer.problem_words().isEmpty());
    QVERIFY(viewer.findChild<QWidget*>("image_problems")->isVisible());
    viewer.go_to({0.0, 1.0, 0.0, 1.0});
    viewer.show_whole();
    viewer.read_point_at(0, 0);
    viewer.export_to(folder.filePath("copy"), FileFormat::csv);
    QTest::mouseClick(&viewer.plot(), Qt::RightButton, {}, viewer.plot().plot_rect().center());
  }

  void a_file_that_is_not_there_is_told_in_words() {
    ImageViewer viewer;
    QSignalSpy failed(&viewer, &ImageViewer::open_failed);
    viewer.open("/no/such/file.bin");
    QVERIFY(failed.wait(patience_ms));
    QVERIFY(!viewer.problem_words().isEmpty());
    QVERIFY(viewer.findChild<QLabel*>("image_info")->text().contains("file.bin"));
  }

  void forty_gigabytes_open_at_once_and_pan_smoothly() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("huge.raw").toStdString();
    std::ofstream(path).close();
    std::error_code refused;
    fs::resize_file(path, std::uintmax_t{40} << 30U, refused);
    if (refused) QSKIP("the disk holds no sparse file of 40 GB");
    ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    QElapsedTimer clock;
    clock.start();
    viewer.open(path, float_layout(16384));
    QVERIFY(QTest::qWaitFor([&] { return viewer.plot().part() != nullptr; }, patience_ms));
    QVERIFY2(clock.elapsed() < 1000, qPrintable(QString::number(clock.elapsed())));
    viewer.go_to({0.0, 2000.0, 0.0, 2000.0});
    ImagePlot& plot = viewer.plot();
    QPoint at = plot.plot_rect().center();
    QTest::mousePress(&plot, Qt::MiddleButton, {}, at);
    constexpr int frames = 60;
    qint64 longest = 0;
    clock.start();
    for (int i = 0; i < frames; ++i) {
      QElapsedTimer frame;
      frame.start();
      at += QPoint(-3, -2);
      QMouseEvent move(QEvent::MouseMove, at, plot.mapToGlobal(at), Qt::NoButton, Qt::MiddleButton, Qt::NoModifier);
      QApplication::sendEvent(&plot, &move);
      QApplication::processEvents();
      longest = std::max(longest, frame.elapsed());
    }
    const double each_ms = static_cast<double>(clock.elapsed()) / frames;
    QTest::mouseRelease(&plot, Qt::MiddleButton, {}, at);
    QVERIFY2(each_ms < 33.0, qPrintable(QString("%1 ms, longest %2").arg(each_ms).arg(longest)));
    QVERIFY(viewer.plot().view().row_first > 50.0);
  }

  void linked_viewers_move_together() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("a.npy").toStdString();
    write_samples(path, FileFormat::npy);
    MainWindow main;
    ImageViewer* const one = main.image_viewers().open_file(path);
    ImageViewer* const two = main.image_viewers().open_file(path);
    QVERIFY(wait_until_open(*one) && wait_until_open(*two));
    for (ImageViewer* viewer : {one, two}) viewer->findChild<QAbstractButton*>("image_link_columns")->click();
    one->go_to({20.0, 60.0, 30.0, 90.0});
    QCOMPARE(two->plot().view().column_first, 20.0);
    QCOMPARE(two->plot().view().column_last, 60.0);
    QCOMPARE(two->plot().view().rows(), static_cast<double>(rows));
  }

  void the_menu_asks_which_file_and_opens_it() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("a.npy").toStdString();
    write_samples(path, FileFormat::npy);
    MainWindow main;
    main.show();
    auto* const action = main.findChild<QAction*>("display_output");
    QVERIFY(action->isEnabled());
    action->trigger();
    auto* const dialog = main.findChild<OpenImageDialog*>();
    QVERIFY(dialog != nullptr);
    dialog->show_file(QString::fromStdString(path.string()), {});
    QVERIFY(QTest::qWaitFor([&] { return dialog->has_preview(); }, patience_ms));
    dialog->accept();
    QCOMPARE(main.image_viewers().viewers().size(), std::size_t{1});
    QVERIFY(wait_until_open(*main.image_viewers().viewers()[0]));
  }

  void a_file_that_does_not_describe_itself_is_guessed() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("strange").toStdString();
    std::ofstream file(path, std::ios::binary);
    for (std::size_t i = 0; i < 200; ++i)
      for (std::size_t k = 0; k < 256; ++k) {
        const float value = static_cast<float>(std::sin(0.05 * static_cast<double>(k)) *
                                               std::cos(0.03 * static_cast<double>(i)) * 100.0);
        file.write(reinterpret_cast<const char*>(&value), sizeof value);
      }
    file.close();
    OpenImageDialog dialog;
    dialog.show();
    dialog.show_file(QString::fromStdString(path.string()), {});
    QTRY_VERIFY_WITH_TIMEOUT(dialog.hints().raw.has_value(), patience_ms);
    QVERIFY(!dialog.guesses().empty());
    QCOMPARE(dialog.hints().raw->number, RawNumber::float32);
    QVERIFY(QTest::qWaitFor([&] { return dialog.has_preview(); }, patience_ms));
    auto* const width = dialog.findChild<QLineEdit*>("open_image_width");
    width->selectAll();
    QTest::keyClicks(width, "0");
    QCOMPARE(dialog.hints().raw->width, std::size_t{0});
    QVERIFY(QTest::qWaitFor([&] { return !dialog.has_preview(); }, patience_ms));
    QVERIFY(dialog.findChild<QWidget*>("open_image_problems")->isVisible());
  }

  void scripts_and_data_are_told_apart() {
    QTemporaryDir folder;
    const fs::path text = folder.filePath("no_ending").toStdString();
    std::ofstream(text) << "$PLATFORM\n";
    QVERIFY(!is_data_file(text));
    QVERIFY(!is_data_file("a.scr"));
    QVERIFY(is_data_file("a.H5"));
    const fs::path bytes = folder.filePath("bytes").toStdString();
    std::ofstream(bytes, std::ios::binary).write("ab\0cd", 5);
    QVERIFY(is_data_file(bytes));
    MainWindow main;
    write_samples(folder.filePath("a.npy").toStdString(), FileFormat::npy);
    QVERIFY(main.open_any(folder.filePath("a.npy")));
    QCOMPARE(main.image_viewers().viewers().size(), std::size_t{1});
  }

  void closing_while_everything_is_under_way_is_harmless() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("a.npy").toStdString();
    write_samples(path, FileFormat::npy);
    for (int i = 0; i < 10; ++i) {
      auto viewer = std::make_unique<ImageViewer>();
      viewer->show();
      viewer->open(path);
      QTest::qWait(7 * i);
      viewer->read_point_at(point_row, point_column);
      auto* const statistics = viewer->findChild<QToolButton*>("image_show_statistics");
      QVERIFY(statistics != nullptr);
      statistics->click();
    }
  }
};

}  // namespace sarsim

QTEST_MAIN(sarsim::ImageViewerTest)
#include "image_viewer_test.moc"
