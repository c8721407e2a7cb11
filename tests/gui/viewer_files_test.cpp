#include <QtTest>

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>

#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/image/image_controls.hpp"
#include "gui/image/image_plot.hpp"
#include "gui/image/image_thumbnail.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/image/open_image_dialog.hpp"
#include "gui/small_scene.hpp"
#include "image_viewer_bench.hpp"

/// Viewers of files and what they do with files: replaced ones, exports, looks, descriptions.
namespace sarsim::viewer_files_test {

namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 20'000;

using Values = std::function<std::complex<double>(std::size_t row, std::size_t column)>;

void write_samples(const fs::path& path, scene::FileFormat format, std::size_t rows, std::size_t columns,
                   const Values& value) {
  raster::SinkOptions options;
  options.format = format;
  options.replace = true;
  test::write_samples(path, options, rows, columns, value);
}

std::complex<double> some_value(std::size_t row, std::size_t column) {
  return {static_cast<double>(row % 7), static_cast<double>(column % 5)};
}

bool wait_until_open(gui::ImageViewer& viewer) {
  return QTest::qWaitFor([&] { return viewer.source() != nullptr && viewer.source()->indexed() >= 1.0; }, patience_ms);
}

bool wait_for_picture(gui::ImageViewer& viewer) {
  return QTest::qWaitFor([&] { return viewer.complete() && viewer.plot().part() != nullptr; }, patience_ms);
}

// A folder with a file in it that a viewer shows.
struct Bench {
  explicit Bench(std::size_t rows = 60, std::size_t columns = 80, const Values& value = some_value) {
    path = in_folder("data.npy");
    write_samples(path, scene::FileFormat::npy, rows, columns, value);
    viewer.resize(1000, 700);
    viewer.show();
    viewer.open(path);
    shown = wait_until_open(viewer) && wait_for_picture(viewer);
  }
  [[nodiscard]] fs::path in_folder(const char* name) const { return folder.filePath(name).toStdString(); }
  [[nodiscard]] QString words(const char* name) const { return viewer.findChild<QLabel*>(name)->text(); }

  QTemporaryDir folder;
  fs::path path;
  gui::ImageViewer viewer;
  bool shown = false;
};

// Answers the dialog that asks where to export to: types a name, and yes or no where a file is to be replaced.
class ExportAnswers : public QObject {
 public:
  ExportAnswers(const QString& filter, const QString& name, QMessageBox::StandardButton replace)
      : filter_(filter), name_(name), replace_(replace) {
    connect(&look_, &QTimer::timeout, this, &ExportAnswers::look);
    look_.start(20);
  }
  [[nodiscard]] int questions() const { return questions_; }

 private:
  void look() {
    if (auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      ++questions_;
      box->button(replace_)->click();
      return;
    }
    auto* const dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    if (std::exchange(typed_, true)) return dialog->reject();
    dialog->selectNameFilter(filter_);
    emit dialog->filterSelected(filter_);
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(name_);
    QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
  }

  QString filter_;
  QString name_;
  QMessageBox::StandardButton replace_;
  QTimer look_;
  bool typed_ = false;
  int questions_ = 0;
};

std::string begin_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(6, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

}  // namespace

class ViewerFilesTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir cache_;

 private slots:
  void initTestCase() {
    qputenv("XDG_CACHE_HOME", cache_.path().toUtf8());
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  }

  void export_asks_before_it_replaces_the_file_that_it_writes() {
    Bench bench;
    QVERIFY(bench.shown);
    std::ofstream(bench.in_folder("out.h5")) << "precious";
    ExportAnswers answers("HDF5 (*.h5)", bench.folder.filePath("out"), QMessageBox::No);
    bench.viewer.export_chosen();
    QVERIFY(!bench.viewer.exporting());
    QCOMPARE(answers.questions(), 1);
    QCOMPARE(begin_of(bench.in_folder("out.h5")), std::string("precio"));
  }

  void export_takes_the_format_from_a_typed_ending() {
    Bench bench;
    QVERIFY(bench.shown);
    QSignalSpy exported(&bench.viewer, &gui::ImageViewer::exported);
    ExportAnswers answers("HDF5 (*.h5)", bench.folder.filePath("out.npy"), QMessageBox::Yes);
    bench.viewer.export_chosen();
    QVERIFY(!exported.isEmpty() || exported.wait(patience_ms));
    QCOMPARE(answers.questions(), 0);
    QCOMPARE(begin_of(bench.in_folder("out.npy")), std::string("\x93NUMPY"));
  }

  void export_adds_the_ending_of_the_chosen_format() {
    Bench bench;
    QVERIFY(bench.shown);
    QSignalSpy exported(&bench.viewer, &gui::ImageViewer::exported);
    ExportAnswers answers("CSV (*.csv)", bench.folder.filePath("out"), QMessageBox::Yes);
    bench.viewer.export_chosen();
    QVERIFY(!exported.isEmpty() || exported.wait(patience_ms));
    QVERIFY(fs::exists(bench.in_folder("out.csv")));
  }

  void a_larger_file_that_takes_the_name_is_read_anew() {
    Bench bench(60);
    QVERIFY(bench.shown);
    write_samples(bench.in_folder("other.npy"), scene::FileFormat::npy, 90, 80,
                  [](std::size_t, std::size_t) { return std::complex<double>(9.0, 0.0); });
    fs::rename(bench.in_folder("other.npy"), bench.path);
    QVERIFY(QTest::qWaitFor([&] { return bench.viewer.source()->rows() == 90; }, patience_ms));
    QVERIFY(QTest::qWaitFor(
        [&] {
          const auto& part = bench.viewer.plot().part();
          return bench.viewer.complete() && part && part->samples.front() == std::complex<double>(9.0, 0.0);
        },
        patience_ms));
  }

  void every_peak_is_drawn_where_samples_are_a_little_closer_than_pixels() {
    // Bright samples far enough from each other to be told apart.
    constexpr std::size_t columns = 800;
    constexpr std::size_t rows = 700;
    const auto is_bright = [](std::size_t row, std::size_t column) { return row % 45 == 22 && column % 55 == 27; };
    Bench bench(rows, columns, [&](std::size_t row, std::size_t column) {
      return std::complex<double>(is_bright(row, column) ? 1000.0 : 0.001, 0.0);
    });
    QVERIFY(bench.shown);
    const QSize size = bench.viewer.plot().device_size();
    QVERIFY(columns > static_cast<std::size_t>(size.width()) && columns < static_cast<std::size_t>(2 * size.width()));
    gui::PartLook look = bench.viewer.look();
    look.peak = true;
    look.quantity = picture::DisplayQuantity::magnitude;
    look.map = picture::ColourMap::grey;
    look.limits = {};
    bench.viewer.set_look(look);
    QVERIFY(QTest::qWaitFor([&] { return bench.viewer.complete() && bench.viewer.plot().part()->peaks; }, patience_ms));
    const QImage picture = bench.viewer.plot().plot_image();
    const QPoint corner = bench.viewer.plot().plot_rect().topLeft();
    int missing = 0;
    for (std::size_t row = 22; row < rows; row += 45)
      for (std::size_t column = 27; column < columns; column += 55) {
        const QPoint at =
            bench.viewer.plot().pixel_of({static_cast<double>(column), static_cast<double>(row)}).toPoint() - corner;
        bool found = false;
        for (int dy = -3; dy <= 3; ++dy)
          for (int dx = -3; dx <= 3; ++dx)
            found = found || (picture.valid(at + QPoint(dx, dy)) && qGray(picture.pixel(at + QPoint(dx, dy))) > 200);
        if (!found) ++missing;
      }
    QCOMPARE(missing, 0);
  }

  void statistics_follow_the_quantity_that_is_shown() {
    Bench bench;
    QVERIFY(bench.shown);
    gui::PartLook look = bench.viewer.look();
    look.quantity = picture::DisplayQuantity::magnitude;
    bench.viewer.set_look(look);
    bench.viewer.findChild<QToolButton*>("image_show_statistics")->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(bench.words("image_statistics").contains("from"), patience_ms);
    const QString before = bench.words("image_statistics");
    look.quantity = picture::DisplayQuantity::phase;
    bench.viewer.set_look(look);
    QVERIFY2(bench.words("image_statistics") != before, qPrintable(before));
    QVERIFY2(bench.words("image_statistics").contains("deg"), qPrintable(bench.words("image_statistics")));
  }

  void viewers_of_different_sizes_do_not_throw_each_other_about() {
    const QTemporaryDir folder;
    const fs::path large = folder.filePath("large.npy").toStdString();
    const fs::path small = folder.filePath("small.npy").toStdString();
    write_samples(large, scene::FileFormat::npy, 50, 400, some_value);
    write_samples(small, scene::FileFormat::npy, 50, 20, some_value);
    gui::MainWindow main;
    gui::ImageViewer* const one = main.image_viewers().open_file(large);
    gui::ImageViewer* const two = main.image_viewers().open_file(small);
    QVERIFY(wait_until_open(*one) && wait_until_open(*two));
    for (gui::ImageViewer* viewer : {one, two}) viewer->findChild<QAbstractButton*>("image_link_columns")->click();
    one->go_to({200.0, 300.0, 10.0, 40.0});
    QCOMPARE(one->plot().view().column_first, 200.0);
    QCOMPARE(one->plot().view().column_last, 300.0);
  }

  void what_was_said_of_a_file_goes_with_it() {
    Bench bench;
    QVERIFY(bench.shown);
    bench.viewer.findChild<QToolButton*>("image_show_statistics")->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(bench.viewer.statistics().has_value(), patience_ms);
    bench.viewer.plot().set_cursor(0, gui::SamplePlace{10.0, 10.0});
    QTRY_VERIFY(!bench.words("image_read_out").isEmpty());
    bench.viewer.read_point_at(3, 4);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.words("image_reading").isEmpty(), patience_ms);
    QSignalSpy failed(&bench.viewer, &gui::ImageViewer::open_failed);
    bench.viewer.open(bench.in_folder("none.npy"));
    QVERIFY(!failed.isEmpty() || failed.wait(patience_ms));
    for (const char* name : {"image_read_out", "image_statistics", "image_reading"})
      QVERIFY2(bench.words(name).isEmpty(), name);
    QVERIFY(!bench.viewer.statistics() && !bench.viewer.reading());
  }

  void numbers_described_by_hand_have_no_unit() {
    const QTemporaryDir folder;
    const fs::path path = folder.filePath("floats.raw").toStdString();
    std::ofstream file(path, std::ios::binary);
    for (int i = 0; i < 2 * 32 * 32; ++i) {
      const auto value = static_cast<float>(1 + i % 7);
      file.write(reinterpret_cast<const char*>(&value), sizeof value);
    }
    file.close();
    gui::ImageViewer viewer;
    viewer.resize(1000, 700);
    viewer.show();
    raster::RasterHints hints;
    hints.raw = raster::RawLayout{.width = 32, .number = raster::RawNumber::float32};
    viewer.open(path, hints);
    QVERIFY(wait_until_open(viewer) && wait_for_picture(viewer));
    viewer.plot().set_cursor(0, gui::SamplePlace{10.0, 10.0});
    auto* const words = viewer.findChild<QLabel*>("image_read_out");
    QTRY_VERIFY(words->text().contains("Magnitude"));
    QVERIFY2(!words->text().contains(" V ") && !words->text().contains("dBV"), qPrintable(words->text()));
  }

  void a_drag_in_the_overview_is_one_step_of_the_history() {
    Bench bench;
    QVERIFY(bench.shown);
    bench.viewer.go_to({10.0, 30.0, 10.0, 30.0});
    const gui::ImageView before = bench.viewer.plot().view();
    auto* const overview = bench.viewer.findChild<gui::ImageThumbnail*>();
    const QPoint middle = overview->rect().center();
    QTest::mousePress(overview, Qt::LeftButton, {}, middle);
    for (int step = 1; step <= 5; ++step) {
      const QPoint at = middle + QPoint(2 * step, 0);
      QMouseEvent move(QEvent::MouseMove, at, overview->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(overview, &move);
    }
    QTest::mouseRelease(overview, Qt::LeftButton, {}, middle + QPoint(10, 0));
    QVERIFY(bench.viewer.plot().view() != before);
    bench.viewer.go_back();
    QCOMPARE(bench.viewer.plot().view(), before);
  }

  void there_is_nothing_to_go_back_to_without_a_file() {
    const gui::ImageViewer viewer;
    QVERIFY(!viewer.findChild<QToolButton*>("image_back")->isEnabled());
    QVERIFY(!viewer.findChild<QToolButton*>("image_forward")->isEnabled());
  }

  // --- Describing a file ----------------------------------------------------------------------------------------

  void what_the_scene_knows_of_one_file_is_not_held_against_the_next() {
    const QTemporaryDir folder;
    scene::Scene scene = test::small_scene();
    scene.simulations[0].file = "known.bin";
    scene.simulations[0].bits = 8;
    for (const char* name : {"known.bin", "other.bin"})
      std::ofstream(folder.filePath(name).toStdString(), std::ios::binary) << std::string(4000, '\x80');
    gui::OpenImageDialog dialog;
    dialog.set_scene(scene);
    dialog.show();
    auto* const columns = dialog.findChild<QLineEdit*>("open_image_columns");
    dialog.show_file(folder.filePath("known.bin"), {});
    QTRY_VERIFY_WITH_TIMEOUT(!columns->text().isEmpty(), patience_ms);
    dialog.show_file(folder.filePath("other.bin"), {});
    QTRY_VERIFY_WITH_TIMEOUT(!dialog.guesses().empty(), patience_ms);
    QCOMPARE(columns->text(), QString());
    QCOMPARE(dialog.findChild<QLineEdit*>("open_image_bits")->text(), QString());
  }

  void typed_nonsense_is_told_and_not_opened() {
    Bench bench;
    gui::OpenImageDialog dialog;
    dialog.show();
    dialog.show_file(QString::fromStdString(bench.path.string()), {});
    QTRY_VERIFY_WITH_TIMEOUT(dialog.has_preview(), patience_ms);
    QTest::keyClicks(dialog.findChild<QLineEdit*>("open_image_columns"), "1e3");
    auto* const open = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
    QTRY_VERIFY(!open->isEnabled());
    auto* const problems = dialog.findChild<QWidget*>("open_image_problems");
    QVERIFY(problems->isVisible());
    QTest::keyClick(dialog.findChild<QLineEdit*>("open_image_columns"), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(dialog.findChild<QLineEdit*>("open_image_columns"), Qt::Key_Delete);
    QTRY_VERIFY_WITH_TIMEOUT(open->isEnabled(), patience_ms);
    QVERIFY(!problems->isVisible());
  }

  void a_chosen_format_is_kept() {
    const QTemporaryDir folder;
    const fs::path path = folder.filePath("a.dat").toStdString();
    write_samples(path, scene::FileFormat::binary, 20, 30, some_value);
    gui::OpenImageDialog dialog;
    dialog.show();
    raster::RasterHints hints;
    hints.format = scene::FileFormat::binary;
    hints.columns = 30;
    hints.bits = 12;
    dialog.show_file(QString::fromStdString(path.string()), hints);
    QTRY_VERIFY_WITH_TIMEOUT(dialog.has_preview(), patience_ms);
    QVERIFY(dialog.hints().format == scene::FileFormat::binary);
    QCOMPARE(dialog.hints().columns, std::size_t{30});
    QCOMPARE(dialog.hints().bits, 12);
  }

  void a_text_is_previewed_when_it_has_been_looked_through() {
    const QTemporaryDir folder;
    const fs::path path = folder.filePath("a.asc").toStdString();
    write_samples(path, scene::FileFormat::ascii, 2000, 200, some_value);
    gui::OpenImageDialog dialog;
    dialog.show();
    dialog.show_file(QString::fromStdString(path.string()), {});
    QTRY_VERIFY_WITH_TIMEOUT(dialog.has_preview(), patience_ms);
  }
};

const test::AddTest added("viewer_files_test", test::run_test<ViewerFilesTest>);

}  // namespace sarsim::viewer_files_test

#include "viewer_files_test.moc"
