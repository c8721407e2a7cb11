#include <QtTest>

#include <QAbstractButton>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QToolButton>

#include <algorithm>
#include <complex>
#include <vector>

#include "gui/common/problem_line.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/image/open_image_dialog.hpp"
#include "image_viewer_bench.hpp"
#include "raster/format/envi.hpp"
#include "raster/sicd/sicd_test_value.hpp"
#include "raster/sicd/sicd_writer.hpp"

// Several image viewers, and how files come to them.

namespace sarsim::image_viewers_test {

using namespace test;

class ImageViewersTest : public QObject {
  Q_OBJECT

 private:
  // The letter R as `sarsim focus` makes it, open in a viewer.
  struct FocusedR {
    FocusedR() {
      const QString file = folder.filePath("r.img");
      QProcess::execute(SARSIM_PROGRAM, {"focus", SARSIM_SOURCE_DIR "/examples/sar_r.toml", "--out", file, "--quiet"});
      if (!main.open_any(file)) return;
      viewer = main.image_viewers().viewers()[0];
      shown = wait_until_open(*viewer) && wait_for_picture(*viewer);
    }

    QTemporaryDir folder;
    gui::MainWindow main;
    gui::ImageViewer* viewer = nullptr;
    bool shown = false;
  };

  QTemporaryDir cache_;

 private slots:
  void initTestCase() { keep_apart(cache_); }

  void linked_viewers_move_together() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("a.npy").toStdString();
    write_samples(path, scene::FileFormat::npy);
    gui::MainWindow main;
    gui::ImageViewer* const one = main.image_viewers().open_file(path);
    gui::ImageViewer* const two = main.image_viewers().open_file(path);
    QVERIFY(wait_until_open(*one) && wait_until_open(*two));
    for (gui::ImageViewer* viewer : {one, two}) viewer->findChild<QAbstractButton*>("image_link_columns")->click();
    one->go_to({20.0, 60.0, 30.0, 90.0});
    QCOMPARE(two->plot().view().column_first, 20.0);
    QCOMPARE(two->plot().view().column_last, 60.0);
    QCOMPARE(two->plot().view().rows(), static_cast<double>(rows));
  }

  void the_menu_asks_which_file_and_opens_it() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("a.npy").toStdString();
    write_samples(path, scene::FileFormat::npy);
    gui::MainWindow main;
    main.show();
    auto* const action = main.findChild<QAction*>("display_output");
    QVERIFY(action->isEnabled());
    action->trigger();
    auto* const dialog = main.findChild<gui::OpenImageDialog*>();
    QVERIFY(dialog != nullptr);
    dialog->show_file(QString::fromStdString(path.string()), {});
    QVERIFY(QTest::qWaitFor([&] { return dialog->has_preview(); }, patience_ms));
    dialog->accept();
    QCOMPARE(main.image_viewers().viewers().size(), std::size_t{1});
    QVERIFY(wait_until_open(*main.image_viewers().viewers()[0]));
  }

  // What `sarsim focus` writes unless told otherwise: samples in one file, what they are in another.
  void an_image_with_its_header_beside_it_is_opened() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("focused.img").toStdString();
    raster::EnviHeader header;
    header.samples = 30;
    header.lines = 20;
    raster::EnviWriter writer(path, header, false);
    for (float row = 0.0F; row < 20.0F; row += 1.0F) writer.append(std::vector<std::complex<float>>(30, {row, 1.0F}));
    writer.finish();
    gui::MainWindow main;
    QVERIFY(main.open_any(QString::fromStdString(path.string())));
    QCOMPARE(main.image_viewers().viewers().size(), std::size_t{1});
    gui::ImageViewer& viewer = *main.image_viewers().viewers()[0];
    QVERIFY(wait_until_open(viewer));
    QCOMPARE(viewer.plot().view().rows(), 20.0);
    QCOMPARE(viewer.plot().view().columns(), 30.0);
    gui::OpenImageDialog dialog;
    dialog.show_file(QString::fromStdString(path.string()), {});
    QVERIFY(QTest::qWaitFor([&] { return dialog.has_preview(); }, patience_ms));
    QVERIFY(dialog.hints().raw.has_value());
    QCOMPARE(dialog.hints().raw->width, std::size_t{30});
  }

  void a_sicd_file_is_opened_with_its_places() {
    QTemporaryDir folder;
    const fs::path path = folder.filePath("focused.nitf").toStdString();
    raster::SicdWriter writer(path, raster::sicd_test_value(20, 30), false, false);
    for (int column = 0; column < 30; ++column) writer.append(std::vector<std::complex<float>>(20, {1.0F, 2.0F}));
    writer.finish();
    gui::MainWindow main;
    QVERIFY(main.open_any(QString::fromStdString(path.string())));
    QCOMPARE(main.image_viewers().viewers().size(), std::size_t{1});
    gui::ImageViewer& viewer = *main.image_viewers().viewers()[0];
    QVERIFY(wait_until_open(viewer));
    // Scales are equal: one direction shows the image, the other has room to spare.
    const gui::ImageView view = viewer.plot().view();
    QVERIFY(view.rows() >= 20.0 && view.columns() >= 30.0 &&
            std::min(view.rows() - 20.0, view.columns() - 30.0) < 1e-6);
    gui::OpenImageDialog dialog;
    dialog.show_file(QString::fromStdString(path.string()), {});
    QVERIFY(QTest::qWaitFor([&] { return dialog.has_preview(); }, patience_ms));
    QVERIFY(!dialog.hints().raw.has_value());
  }

  void a_focused_image_is_seen_in_metres_as_long_across_as_downwards() {
    const FocusedR r;
    QVERIFY(r.shown);
    gui::ImageViewer& viewer = *r.viewer;
    gui::ImagePlot& plot = viewer.plot();
    QVERIFY(plot.places().has_value());
    QCOMPARE(plot.shown_places().range.label, std::string("Slant range"));
    QCOMPARE(plot.shown_places().azimuth.unit, std::string("m"));
    const auto m_per_px = [&] {
      const QSize size = plot.plot_rect().size();
      return std::pair(plot.view().rows() * plot.places()->azimuth.step / size.height(),
                       plot.view().columns() * plot.places()->range.step / size.width());
    };
    QVERIFY(std::abs(m_per_px().first / m_per_px().second - 1.0) < 1e-9);
    viewer.resize(viewer.width() + 300, viewer.height() - 100);
    QTRY_VERIFY(std::abs(m_per_px().first / m_per_px().second - 1.0) < 1e-9);
    QVERIFY(wait_for_picture(viewer));
    QCOMPARE(viewer.figure().panels.at(0).x.unit, std::string("m"));
    QCOMPARE(viewer.figure().panels.at(0).y_per_x, 1.0);
    viewer.findChild<QCheckBox*>("image_numbers")->click();
    QCOMPARE(plot.shown_places().range.label, std::string("Sample"));
    viewer.findChild<QCheckBox*>("image_equal_scale")->click();
    QCOMPARE(plot.view().columns(), static_cast<double>(viewer.source()->columns()));
  }

  void the_ends_of_the_axes_can_be_typed() {
    const FocusedR r;
    QVERIFY(r.shown);
    gui::ImageViewer& viewer = *r.viewer;
    gui::ImagePlot& plot = viewer.plot();
    const auto type = [&](const char* name, const char* text) {
      auto* const field = viewer.findChild<QLineEdit*>(name);
      field->selectAll();
      QTest::keyClicks(field, text);
      QTest::keyClick(field, Qt::Key_Return);
    };
    const auto range_m = [&](double column) { return plot.places()->range.first + plot.places()->range.step * column; };
    const auto azimuth_m = [&](double row) { return plot.places()->azimuth.first + plot.places()->azimuth.step * row; };
    const auto m_per_px = [&] {
      const QSize size = plot.plot_rect().size();
      return std::pair(plot.view().rows() * plot.places()->azimuth.step / size.height(),
                       plot.view().columns() * plot.places()->range.step / size.width());
    };
    type("image_column_from", "10.15 km");
    type("image_column_to", "10250");
    QVERIFY(std::abs(range_m(plot.view().column_first) - 10150.0) < 1e-6);
    QVERIFY(std::abs(range_m(plot.view().column_last) - 10250.0) < 1e-6);
    QVERIFY(std::abs(m_per_px().first / m_per_px().second - 1.0) < 1e-9);
    QCOMPARE(viewer.findChild<QLineEdit*>("image_column_from")->text(), QString("10.15 km"));
    // Without equal scales each axis is its own, and the fields follow what the mouse does.
    viewer.findChild<QCheckBox*>("image_equal_scale")->click();
    const gui::ImageView before = plot.view();
    type("image_row_from", "-50");
    QVERIFY(std::abs(azimuth_m(plot.view().row_first) + 50.0) < 1e-6);
    QCOMPARE(plot.view().row_last, before.row_last);
    QCOMPARE(plot.view().columns(), before.columns());
    viewer.go_back();
    QVERIFY(viewer.findChild<QLineEdit*>("image_row_from")->text() != "-50 m");
    QVERIFY(plot.view() == before);
    // Ends typed in the wrong order are swapped; text that is not a number changes nothing.
    type("image_column_from", "10.3 km");
    QVERIFY(std::abs(range_m(plot.view().column_first) - 10250.0) < 1e-6);
    QVERIFY(std::abs(range_m(plot.view().column_last) - 10300.0) < 1e-6);
    const gui::ImageView right = plot.view();
    type("image_column_to", "far");
    QVERIFY(plot.view() == right);
    QVERIFY(!viewer.findChild<gui::ProblemLine*>("image_problem")->isHidden());
    // Rows and samples have no unit.
    viewer.findChild<QCheckBox*>("image_numbers")->click();
    type("image_row_from", "3");
    QCOMPARE(plot.view().row_first, 3.0);
  }

  // Finding B6: full view, five pixels beside the peak.
  void a_point_is_found_beside_the_click_whatever_the_zoom() {
    const FocusedR r;
    QVERIFY(r.shown);
    gui::ImageViewer& viewer = *r.viewer;
    viewer.findChild<QToolButton*>("image_reading_tool")->click();
    const gui::ImagePart& part = *viewer.plot().part();
    const auto strongest = std::ranges::max_element(part.samples, {}, [](const auto& z) { return std::norm(z); });
    const auto index = static_cast<std::size_t>(strongest - part.samples.begin());
    const QPointF peak = viewer.plot().pixel_of({static_cast<double>(part.window.column(index % part.window.cols)),
                                                 static_cast<double>(part.window.row(index / part.window.cols))});
    QTest::mouseClick(&viewer.plot(), Qt::LeftButton, {}, (peak + QPointF(4.0, 3.0)).toPoint());
    QTRY_VERIFY_WITH_TIMEOUT(viewer.reading().has_value(), patience_ms);
    QVERIFY2(viewer.reading()->along_row.pslr_db < -10.0,
             qPrintable(viewer.findChild<QLabel*>("image_reading")->text()));
    QVERIFY(viewer.reading()->along_column.pslr_db < -10.0);
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
    gui::OpenImageDialog dialog;
    dialog.show();
    dialog.show_file(QString::fromStdString(path.string()), {});
    QTRY_VERIFY_WITH_TIMEOUT(dialog.hints().raw.has_value(), patience_ms);
    QVERIFY(!dialog.guesses().empty());
    QCOMPARE(dialog.hints().raw->number, raster::RawNumber::float32);
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
    QVERIFY(!gui::is_data_file(text));
    QVERIFY(!gui::is_data_file("a.scr"));
    QVERIFY(gui::is_data_file("a.H5"));
    const fs::path bytes = folder.filePath("bytes").toStdString();
    std::ofstream(bytes, std::ios::binary).write("ab\0cd", 5);
    QVERIFY(gui::is_data_file(bytes));
    gui::MainWindow main;
    write_samples(folder.filePath("a.npy").toStdString(), scene::FileFormat::npy);
    QVERIFY(main.open_any(folder.filePath("a.npy")));
    QCOMPARE(main.image_viewers().viewers().size(), std::size_t{1});
  }
};

const test::AddTest added("image_viewers_test", test::run_test<ImageViewersTest>);

}  // namespace sarsim::image_viewers_test

#include "image_viewers_test.moc"
