#include <QtTest>

#include <QAbstractButton>
#include <QToolButton>

#include <memory>

#include "gui/gui_test.hpp"
#include "image_viewer_bench.hpp"
#include "support/processor_time.hpp"

// Files that an image viewer writes, and those that change, are damaged, huge or not there.

namespace sarsim::image_files_test {

using namespace test;

class ImageFilesTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir cache_;

 private slots:
  void initTestCase() { keep_apart(cache_); }

  void an_exported_selection_opens_again_with_the_same_samples_data() { add_formats(); }

  void an_exported_selection_opens_again_with_the_same_samples() {
    QFETCH(int, format);
    Bench bench;
    bench.viewer.plot().set_selection(raster::ImageWindow{60, 20, 30, 25, 1, 1});
    QSignalSpy done(&bench.viewer, &gui::ImageViewer::exported);
    const QString copy = bench.folder.filePath("copy.file");
    bench.viewer.export_to(copy, static_cast<scene::FileFormat>(format));
    QVERIFY(done.wait(patience_ms));
    QVERIFY2(done.front().front().toBool(), qPrintable(bench.viewer.problem_words()));
    raster::RasterHints hints;
    hints.format = static_cast<scene::FileFormat>(format);
    hints.columns = 25;
    hints.bits = bench.viewer.source()->info().bits > 0 ? bench.viewer.source()->info().bits : 16;
    const raster::OpenedRaster opened = raster::open_raster(raster::Integrity::partial, copy.toStdString(), hints);
    QVERIFY(opened.raster != nullptr);
    opened.raster->wait_until_indexed(nullptr);
    QCOMPARE(opened.raster->rows(), std::size_t{20});
    std::vector<std::complex<float>> one(1);
    opened.raster->read_window({point_row - 60, 1, point_column - 30, 1, 1, 1}, one);
    QVERIFY(std::abs(one[0] - std::complex<float>(1000.0F, 2.0F)) < 1e-3F);
  }

  void the_file_that_is_shown_is_not_overwritten() {
    Bench bench;
    const auto bytes = fs::file_size(bench.path);
    QSignalSpy done(&bench.viewer, &gui::ImageViewer::exported);
    bench.viewer.export_to(QString::fromStdString(bench.path.string()), scene::FileFormat::csv);
    QCOMPARE(done.size(), 1);
    QVERIFY(!done.front().front().toBool());
    QCOMPARE(fs::file_size(bench.path), bytes);
    QVERIFY(bench.viewer.problem_words().contains("another name"));
  }

  void a_growing_file_is_followed() {
    FloatBench bench(32);
    QVERIFY(bench.shown);
    bench.append_rows(16);
    QVERIFY(
        QTest::qWaitFor([&] { return bench.viewer.source()->rows() == 48 && bench.viewer.complete(); }, patience_ms));
    QCOMPARE(bench.viewer.plot().view(), gui::whole_view(48, 64));
    QVERIFY(bench.viewer.findChild<QLabel*>("image_info")->text().contains("48 rows"));
  }

  void a_shrinking_file_is_read_anew_or_told_in_words() {
    FloatBench bench(32);
    QVERIFY(bench.shown);
    bench.cut_off_after(10);
    bench.viewer.go_to({0.0, 10.0, 20.0, 30.0});  // what is gone
    QVERIFY(bench.wait_for_rows(10));
    QVERIFY(wait_for_picture(bench.viewer));
    bench.cut_off_after(0);
    QVERIFY(bench.wait_for_words());
    bench.append_rows(4);
    QVERIFY(bench.wait_for_rows(4));
  }

  void reading_what_was_cut_off_is_told_in_words() {
    FloatBench bench(3200);
    QVERIFY(bench.shown);
    bench.viewer.findChild<QAbstractButton*>("image_follow")->setChecked(false);
    bench.cut_off_after(10);
    bench.viewer.go_to({0.0, 10.0, 2000.0, 2030.0});
    QVERIFY(bench.wait_for_words());
    QVERIFY2(bench.viewer.problem_words().contains("floats.raw"), qPrintable(bench.viewer.problem_words()));
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
    gui::ImageViewer viewer;
    viewer.show();
    QSignalSpy failed(&viewer, &gui::ImageViewer::open_failed);
    viewer.open(path);
    QVERIFY(failed.wait(patience_ms));
    QVERIFY(!viewer.problem_words().isEmpty());
    QVERIFY(viewer.findChild<QWidget*>("image_problems")->isVisible());
    viewer.go_to({0.0, 1.0, 0.0, 1.0});
    viewer.show_whole();
    viewer.read_point_at(0, 0);
    viewer.export_to(folder.filePath("copy"), scene::FileFormat::csv);
    QTest::mouseClick(&viewer.plot(), Qt::RightButton, {}, viewer.plot().plot_rect().center());
  }

  void a_file_that_is_not_there_is_told_in_words() {
    gui::ImageViewer viewer;
    QSignalSpy failed(&viewer, &gui::ImageViewer::open_failed);
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
    gui::ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    const test::ProcessorTime opening;
    viewer.open(path, float_layout(16384));
    QVERIFY(QTest::qWaitFor([&] { return viewer.plot().part() != nullptr; }, patience_ms));
    const double opened_s = opening.seconds();
    QVERIFY2(opened_s < 1.0, qPrintable(QString::number(opened_s)));
    viewer.go_to({0.0, 2000.0, 0.0, 2000.0});
    gui::ImagePlot& plot = viewer.plot();
    QPoint at = plot.plot_rect().center();
    QTest::mousePress(&plot, Qt::MiddleButton, {}, at);
    constexpr int frames = 60;
    double longest_ms = 0.0;
    const auto panning = test::ProcessorTime::of_this_thread();
    for (int i = 0; i < frames; ++i) {
      const auto frame = test::ProcessorTime::of_this_thread();
      at += QPoint(-3, -2);
      QMouseEvent move(QEvent::MouseMove, at, plot.mapToGlobal(at), Qt::NoButton, Qt::MiddleButton, Qt::NoModifier);
      QApplication::sendEvent(&plot, &move);
      QApplication::processEvents();
      longest_ms = std::max(longest_ms, 1e3 * frame.seconds());
    }
    const double each_ms = 1e3 * panning.seconds() / frames;
    QTest::mouseRelease(&plot, Qt::MiddleButton, {}, at);
    QVERIFY2(each_ms < 33.0, qPrintable(QString("%1 ms, longest %2").arg(each_ms).arg(longest_ms)));
    QVERIFY(viewer.plot().view().row_first > 50.0);
  }

  void closing_while_everything_is_under_way_is_harmless() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("a.npy").toStdString();
    write_samples(path, scene::FileFormat::npy);
    for (int i = 0; i < 10; ++i) {
      auto viewer = std::make_unique<gui::ImageViewer>();
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

const test::AddTest added("image_files_test", test::run_test<ImageFilesTest>);

}  // namespace sarsim::image_files_test

#include "image_files_test.moc"
