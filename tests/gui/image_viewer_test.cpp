#include <QtTest>

#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QToolButton>

#include <string>

#include "gui/common/figure_plot.hpp"
#include "gui/gui_test.hpp"
#include "gui/image/image_thumbnail.hpp"
#include "image_viewer_bench.hpp"
#include "raster/format/sun_raster.hpp"

// What an image viewer shows, and what mouse and keys do in it.

namespace sarsim::image_viewer_test {

using namespace test;

class ImageViewerTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir cache_;

 private slots:
  void initTestCase() { keep_apart(cache_); }

  void every_format_of_samples_is_shown_data() { add_formats(); }

  void every_format_of_samples_is_shown() {
    QFETCH(int, format);
    QTemporaryDir folder;
    const fs::path path = folder.filePath("data.file").toStdString();
    write_samples(path, static_cast<scene::FileFormat>(format));
    gui::ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    raster::RasterHints hints = binary_hints();
    hints.format = static_cast<scene::FileFormat>(format);
    viewer.open(path, hints);
    QVERIFY2(wait_until_open(viewer), qPrintable(viewer.problem_words()));
    QVERIFY(
        QTest::qWaitFor([&] { return viewer.complete() && viewer.plot().part()->window.rows == rows; }, patience_ms));
    const gui::ImagePart& part = *viewer.plot().part();
    QCOMPARE(part.window.cols, columns);
    QCOMPARE(part.samples[*part.nearest(point_column, point_row)], sample(point_row, point_column));
    QVERIFY(viewer.findChild<QLabel*>("image_info")->text().contains("120 rows of 100 samples"));
  }

  void a_raster_is_shown_in_its_own_greys_and_colours() {
    QTemporaryDir folder;
    const fs::path grey = folder.filePath("grey.ras").toStdString();
    const fs::path colour = folder.filePath("colour.ras").toStdString();
    raster::write_sun_raster(grey, 2, 2, std::vector<std::uint8_t>{0, 255, 100, 50});
    raster::write_sun_raster(colour, 2, 2, std::vector<raster::Rgb>{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {9, 8, 7}});
    gui::ImageViewer viewer;
    open_in(viewer, grey);
    QVERIFY(wait_until_open(viewer) && wait_for_picture(viewer));
    const QImage greys = viewer.plot().painted().image;
    QVERIFY(qRed(greys.pixel(0, 0)) < qRed(greys.pixel(1, 1)));
    QVERIFY(qRed(greys.pixel(1, 1)) < qRed(greys.pixel(0, 1)));
    QVERIFY(qRed(greys.pixel(0, 1)) < qRed(greys.pixel(1, 0)));
    gui::ImageViewer other;
    open_in(other, colour);
    QVERIFY(wait_until_open(other) && wait_for_picture(other));
    QCOMPARE(other.plot().painted().image.pixel(0, 1), qRgb(0, 0, 255));
    QVERIFY(!other.findChild<QComboBox*>("image_quantity")->isEnabled());
  }

  void a_file_that_is_described_by_hand_is_shown() {
    FloatBench bench(32);
    QVERIFY(bench.shown);
    QCOMPARE(bench.viewer.source()->rows(), std::size_t{32});
    QCOMPARE(bench.viewer.plot().part()->samples[1], std::complex<double>(3.0, 4.0));
  }

  void a_drawn_rectangle_is_zoomed_to_and_backspace_goes_back() {
    Bench bench;
    QVERIFY(bench.shown);
    const gui::ImageView all = bench.viewer.plot().view();
    QCOMPARE(all, gui::whole_view(rows, columns));
    bench.drag(bench.at(0.25, 0.5), bench.at(0.75, 1.0));
    const gui::ImageView zoomed = bench.viewer.plot().view();
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
    const gui::ImageView more = bench.viewer.plot().view();
    QVERIFY(std::abs(more.columns() - 40.0) < 1e-9);
    QVERIFY(std::abs(more.rows() - 40.0) < 1e-9);
  }

  void the_wheel_keeps_the_place_below_the_pointer() {
    Bench bench;
    const QPoint at = bench.at(0.3, 0.6);
    const gui::SamplePlace before = bench.viewer.plot().place_at(at);
    QWheelEvent turn(at, bench.viewer.plot().mapToGlobal(at), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(&bench.viewer.plot(), &turn);
    const gui::SamplePlace after = bench.viewer.plot().place_at(at);
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
    gui::PartLook look = bench.viewer.look();
    look.inverted = true;
    bench.viewer.set_look(look);
    QVERIFY(wait_for_picture(bench.viewer));
    QCOMPARE(bench.viewer.plot().part(), part);
    QVERIFY(bench.viewer.plot().painted().image != before);
  }

  void limits_set_by_hand_begin_with_the_present_ones_and_refuse_nonsense() {
    Bench bench;
    auto* const limits = bench.viewer.findChild<QComboBox*>("image_limits");
    const picture::ColourLimits present = bench.viewer.plot().painted().colours.limits;
    limits->setCurrentIndex(2);
    emit limits->activated(2);
    // To six digits, as they are shown.
    QVERIFY(std::abs(bench.viewer.look().limits.low - present.low) <= 1e-5 * std::abs(present.low));
    QVERIFY(std::abs(bench.viewer.look().limits.high - present.high) <= 1e-5 * std::abs(present.high));
    QVERIFY(bench.viewer.findChild<QLineEdit*>("image_low")->text().size() <= qsizetype{10});
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
    Bench bench(scene::FileFormat::hdf5);
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
    auto* const row = bench.viewer.findChild<gui::FigurePlot*>("image_row_cut");
    auto* const column = bench.viewer.findChild<gui::FigurePlot*>("image_column_cut");
    QVERIFY(row->isVisibleTo(&bench.viewer) && column->isVisibleTo(&bench.viewer));
    QCOMPARE(row->figure().panels.at(0).title, std::string("Row 70"));
    QCOMPARE(column->figure().panels.at(0).title, std::string("Sample 40"));
    QCOMPARE(column->figure().panels.at(0).curves[0].y.size(), rows);
    QTest::keyClick(&bench.viewer.plot(), Qt::Key_Escape);
    QVERIFY(!bench.viewer.plot().cursor(0));
  }

  // By hand: curves at least 20 pixels apart, the largest value as 3/8 of that, decibels as nine tenths.
  void slices_are_curves_through_the_samples() {
    gui::ImagePart part;
    part.window = {0, 12, 0, 5, 1, 1};
    part.value = raster::ImageValue::real;
    part.samples.assign(60, 0.0);
    part.samples[4 * 5 + 2] = 2.0;
    part.samples[4 * 5 + 3] = -1.0;
    gui::PartColours colours;
    colours.quantity = picture::DisplayQuantity::real;
    colours.limits = {-1.0, 2.0};
    colours.reference_v = 2.0;
    const gui::ImageView view = gui::whole_view(12, 5);
    const QSize plot_px(50, 120);  // 10 pixels a sample
    const auto rows = gui::slices_of(part, colours, picture::DrawAs::curves_per_pulse, view, plot_px);
    QCOMPARE(rows.size(), std::size_t{6});
    QCOMPARE(rows[2].base, 4.0);
    QCOMPARE(rows[2].points.size(), std::size_t{5});
    QCOMPARE(rows[2].points[2], QPointF(2.0, 4.0 - 0.375 * 2.0));
    QCOMPARE(rows[2].points[3], QPointF(3.0, 4.0 + 0.375));
    QCOMPARE(rows[1].points[2], QPointF(2.0, 2.0));
    const auto columns = gui::slices_of(part, colours, picture::DrawAs::curves_per_range, view, plot_px);
    QCOMPARE(columns.size(), std::size_t{3});
    QCOMPARE(columns[1].points[4], QPointF(2.0 + 0.375 * 2.0, 4.0));
    // A view that moves meets the same rows.
    part.window.row0 = 1;
    QCOMPARE(gui::slices_of(part, colours, picture::DrawAs::curves_per_pulse, view, plot_px)[0].base, 2.0);
    part.window.row0 = 0;
    colours.quantity = picture::DisplayQuantity::decibels;
    colours.limits = {-40.0, 0.0};
    const auto decibels = gui::slices_of(part, colours, picture::DrawAs::curves_per_pulse, view, plot_px);
    QCOMPARE(decibels[2].points[2], QPointF(2.0, 4.0 - 0.9 * 2.0));
    QCOMPARE(decibels[2].points[0], QPointF(0.0, 4.0));
    QVERIFY(gui::slices_of(part, colours, picture::DrawAs::pixels, view, plot_px).empty());
  }

  void slices_are_chosen_drawn_and_saved() {
    Bench bench;
    gui::ImagePlot& plot = bench.viewer.plot();
    auto* const choice = bench.viewer.findChild<QComboBox*>("image_draw_as");
    auto* const peak = bench.viewer.findChild<QWidget*>("image_peak");
    QVERIFY(peak->isVisibleTo(&bench.viewer));
    const QImage pixels = plot.grab().toImage();
    for (const int index : {1, 2}) {
      choice->setCurrentIndex(index);
      emit choice->activated(index);
      QVERIFY(wait_for_picture(bench.viewer));
      QVERIFY(!peak->isVisibleTo(&bench.viewer));
      QVERIFY(plot.slices().size() > 3);
      QCOMPARE(plot.slices()[0].points.size(), index == 1 ? plot.part()->window.cols : plot.part()->window.rows);
      QVERIFY(!plot.part()->peaks);
      QVERIFY(plot.grab().toImage() != pixels);
      const picture::Figure figure = bench.viewer.figure();
      QVERIFY(!figure.panels.at(0).image);
      QCOMPARE(figure.panels[0].curves.size(), plot.slices().size());
    }
    choice->setCurrentIndex(0);
    emit choice->activated(0);
    QVERIFY(wait_for_picture(bench.viewer));
    QVERIFY(plot.slices().empty());
    QVERIFY(bench.viewer.figure().panels.at(0).image.has_value());
    QVERIFY(plot.grab().toImage() == pixels);
  }

  void a_cursor_is_dragged_and_the_cuts_follow() {
    Bench bench;
    gui::ImagePlot& plot = bench.viewer.plot();
    bench.viewer.findChild<QToolButton*>("image_show_cuts")->click();
    auto* const row = bench.viewer.findChild<gui::FigurePlot*>("image_row_cut");
    auto* const column = bench.viewer.findChild<gui::FigurePlot*>("image_column_cut");
    QTest::mouseClick(&plot, Qt::LeftButton, {}, bench.at_sample(50, 20));
    const gui::ImageView view = plot.view();
    QTest::mousePress(&plot, Qt::LeftButton, {}, bench.at_sample(50, 20));
    QTest::mouseMove(&plot, bench.at_sample(60, 30));
    QTest::mouseMove(&plot, bench.at_sample(point_row, point_column));
    QCOMPARE(row->figure().panels.at(0).title, std::string("Row 70"));  // Already on the way.
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, bench.at_sample(point_row, point_column));
    QCOMPARE(column->figure().panels.at(0).title, std::string("Sample 40"));
    QVERIFY(plot.view() == view);  // It was no zoom.
    QCOMPARE(plot.cursor(0)->row, static_cast<double>(point_row));
    // The mark of a cut is the sample below the cursor.
    const picture::FigureMark mark = row->figure().panels.at(0).marks.at(0);
    QCOMPARE(mark.y, row->figure().panels.at(0).curves[0].y[point_column]);
    // Beyond the rim is the rim; Escape puts it back.
    QTest::mousePress(&plot, Qt::LeftButton, {}, bench.at_sample(point_row, point_column));
    QTest::mouseMove(&plot, QPoint(plot.plot_rect().left() + 3, plot.plot_rect().top() - 30));
    QCOMPARE(plot.cursor(0)->row, 0.0);
    QTest::keyClick(&plot, Qt::Key_Escape);
    QCOMPARE(plot.cursor(0)->row, static_cast<double>(point_row));
    QCOMPARE(plot.cursor(0)->column, static_cast<double>(point_column));
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, bench.at_sample(0, 0));
    QVERIFY(plot.view() == view);
  }

  void a_click_into_a_cut_moves_the_cursor_along_it() {
    Bench bench;
    gui::ImagePlot& plot = bench.viewer.plot();
    QTest::mouseClick(&plot, Qt::LeftButton, {}, bench.at_sample(point_row, point_column));
    bench.viewer.findChild<QToolButton*>("image_show_cuts")->click();
    auto* const row = bench.viewer.findChild<gui::FigurePlot*>("image_row_cut");
    auto* const column = bench.viewer.findChild<gui::FigurePlot*>("image_column_cut");
    QTRY_VERIFY(row->panel(0) != nullptr && row->panel(0)->width() > 50);
    const auto press = [](gui::FigurePlot* cut, double place) {
      const auto x = static_cast<int>(std::round(cut->panel(0)->axis(QCPAxis::atBottom)->coordToPixel(place)));
      QTest::mousePress(cut, Qt::LeftButton, {}, QPoint(x, cut->panel(0)->center().y()));
      QTest::mouseRelease(cut, Qt::LeftButton, {}, QPoint(x, cut->panel(0)->center().y()));
      return cut->panel(0)->axis(QCPAxis::atBottom)->pixelToCoord(x);
    };
    const double across = press(row, row->figure().panels.at(0).curves[0].x[20]);
    QVERIFY(std::abs(plot.cursor(0)->column - 20.0) <= 1.0);
    QCOMPARE(plot.cursor(0)->row, static_cast<double>(point_row));
    QVERIFY(std::abs(row->figure().panels.at(0).marks.at(0).x - across) < 1.0);
    press(column, column->figure().panels.at(0).curves[0].x[110]);
    QVERIFY(std::abs(plot.cursor(0)->row - 110.0) <= 1.0);
    QVERIFY(std::abs(plot.cursor(0)->column - 20.0) <= 1.0);
  }

  void a_selection_is_measured_whole() {
    Bench bench;
    bench.drag(bench.at_sample(65, 35), bench.at_sample(75, 45), Qt::LeftButton, Qt::ShiftModifier);
    QVERIFY(bench.viewer.plot().selection());
    QVERIFY(QTest::qWaitFor([&] { return bench.viewer.statistics().has_value(); }, patience_ms));
    const picture::SelectionStatistics& measured = *bench.viewer.statistics();
    QCOMPARE(measured.samples, std::uint64_t{bench.viewer.plot().selection()->samples()});
    QVERIFY(measured.samples >= 81 && measured.samples <= 144);  // 10 x 10, and what pixels round
    QCOMPARE(measured[picture::SampleQuantity::real].maximum, 1000.0);
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
    const picture::PointReading& reading = *bench.viewer.reading();
    QVERIFY(std::abs(reading.row - point_row) < 0.05);
    QVERIFY(std::abs(reading.column - point_column) < 0.05);
    // A sin(x)/x is 0.886 wide, here over 0.9; to the rounding of the counts.
    QVERIFY2(std::abs(reading.along_row.width - 0.886 / 0.9) < 0.03,
             qPrintable(QString::number(reading.along_row.width)));
    QVERIFY(std::abs(reading.along_row.pslr_db + 13.26) < 0.5);
    QVERIFY(bench.words("image_reading").contains("PSLR"));
  }

  // Finding B7: what is below the pointer stays there.
  void the_picture_stays_where_it_is_whatever_is_said_of_it() {
    Bench bench;
    gui::ImagePlot& plot = bench.viewer.plot();
    const QRect before(plot.mapTo(&bench.viewer, plot.plot_rect().topLeft()), plot.plot_rect().size());
    const auto now = [&] {
      QCoreApplication::sendPostedEvents();
      QCoreApplication::processEvents();
      return QRect(plot.mapTo(&bench.viewer, plot.plot_rect().topLeft()), plot.plot_rect().size());
    };
    QTest::mouseMove(&plot, bench.at(0.5, 0.5));
    QCOMPARE(now(), before);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, bench.at(0.4, 0.4));
    QTest::mouseClick(&plot, Qt::LeftButton, Qt::ShiftModifier, bench.at(0.6, 0.6));
    QVERIFY(!bench.words("image_difference").isEmpty());
    QCOMPARE(now(), before);
    bench.viewer.findChild<QToolButton*>("image_reading_tool")->click();
    const QRect with_tool = now();
    QTest::mouseClick(&plot, Qt::LeftButton, {}, bench.at_sample(point_row + 1, point_column - 1));
    QVERIFY(QTest::qWaitFor([&] { return bench.viewer.reading().has_value(); }, patience_ms));
    QCOMPARE(now(), with_tool);
  }

  void a_click_on_nothing_with_the_reading_tool_is_told_in_words() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("zeros.raw").toStdString();
    std::ofstream(path, std::ios::binary) << std::string(64 * 64 * 8, '\0');
    gui::ImageViewer viewer;
    open_in(viewer, path, float_layout(64));
    QVERIFY(wait_until_open(viewer) && wait_for_picture(viewer));
    viewer.read_point_at(10, 10);
    QVERIFY(
        QTest::qWaitFor([&] { return !viewer.findChild<QLabel*>("image_reading")->text().isEmpty(); }, patience_ms));
    QVERIFY(!viewer.reading());
  }

  void the_figure_to_be_saved_shows_the_same_part() {
    Bench bench;
    bench.viewer.go_to({20.0, 60.0, 30.0, 90.0});
    QVERIFY(wait_for_picture(bench.viewer));
    const picture::Figure figure = bench.viewer.figure();
    QCOMPARE(figure.panels.size(), std::size_t{1});
    QCOMPARE(figure.panels[0].x.first, 20.0);
    QCOMPARE(figure.panels[0].y.last, 30.0);
    QVERIFY(figure.panels[0].image->cells.size() == bench.viewer.plot().part()->samples.size());
    bench.viewer.copy_picture();
    QCOMPARE(QApplication::clipboard()->image().size(), bench.viewer.plot().device_size());
  }

  void the_thumbnail_shows_the_whole_and_leads_the_view() {
    Bench bench;
    auto* const thumbnail = bench.viewer.findChild<gui::ImageThumbnail*>();
    QVERIFY(QTest::qWaitFor([&] { return !thumbnail->picture().isNull(); }, patience_ms));
    bench.viewer.go_to({20.0, 60.0, 30.0, 90.0});
    QVERIFY(thumbnail->mark().width() < 0.5 * thumbnail->width());
    QTest::mouseClick(thumbnail, Qt::LeftButton, {}, thumbnail->rect().center());
    const gui::ImageView view = bench.viewer.plot().view();
    QVERIFY(std::abs((view.column_first + view.column_last) / 2.0 - (columns - 1) / 2.0) < 2.0);
    QVERIFY(std::abs(view.rows() - 60.0) < 1e-9);
  }
};

const test::AddTest added("image_viewer_test", test::run_test<ImageViewerTest>);

}  // namespace sarsim::image_viewer_test

#include "image_viewer_test.moc"
