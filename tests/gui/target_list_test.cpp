// The targets of a focused image: rings, and a table of what `sarsim measure` says of them.

#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include "gui/common/problem_line.hpp"
#include "gui/gui_test.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/target_list.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/focus_options.hpp"
#include "workflow/focus/measure.hpp"

namespace sarsim::target_list_test {

constexpr int patience_ms = 30'000;

class TargetListTest : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  std::filesystem::path image_;

 private slots:
  void initTestCase() {
    QVERIFY(QFile::copy(SARSIM_SOURCE_DIR "/examples/sar_r.toml", folder_.filePath("r.toml")));
    image_ = folder_.filePath("r.npy").toStdString();
    workflow::FocusRequest request = workflow::focus_request(folder_.filePath("r.toml").toStdString(), {});
    request.output = image_;
    static_cast<void>(workflow::focus(request, {}));
    QVERIFY(std::filesystem::exists(image_));
  }

  void rings_stand_where_the_targets_are_and_the_table_has_the_numbers_of_measure() {
    gui::ImageViewer viewer;
    viewer.resize(900, 800);
    QSignalSpy opened(&viewer, &gui::ImageViewer::opened);
    viewer.open(image_);
    viewer.show();
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience_ms);
    auto* tool = viewer.findChild<QToolButton*>("image_show_targets");
    QSignalSpy measured(&viewer.targets(), &gui::TargetList::measured);
    tool->click();
    QVERIFY(measured.wait(patience_ms));
    const picture::TargetTable& table = viewer.targets().table();
    QCOMPARE(table.rows.size(), 24U);
    workflow::MeasureRequest request;
    request.image = image_;
    const workflow::MeasureReport report = workflow::measure(request, {});
    QCOMPARE(picture::text_of(table), picture::text_of(picture::target_table(report)));
    QCOMPARE(viewer.plot().rings().size(), 24U);
    // Where a ring stands the image is bright: all targets reflect alike.
    QTRY_VERIFY_WITH_TIMEOUT(viewer.complete(), patience_ms);
    const auto part = viewer.plot().part();
    double most = 0.0;
    for (const std::complex<double>& sample : part->samples) most = std::max(most, std::abs(sample));
    for (const gui::ImagePlot::Ring& ring : viewer.plot().rings()) {
      QVERIFY(ring.found);
      double brightest = 0.0;
      for (const double down : {-2.0, 0.0, 2.0})
        for (const double across : {-1.0, 0.0, 1.0})
          if (const auto at = part->nearest(ring.at.column + across, ring.at.row + down))
            brightest = std::max(brightest, std::abs(part->samples.at(*at)));
      QVERIFY2(brightest > 0.5 * most, qPrintable(QString::number(brightest / most)));
    }
    // A click on a ring chooses its row, and a row brings its target into sight.
    viewer.plot().ring_clicked(5);
    QCOMPARE(viewer.targets().chosen(), std::optional<std::size_t>(5));
    QCOMPARE(viewer.plot().chosen_ring(), std::optional<std::size_t>(5));
    const auto& ring = viewer.plot().rings().at(11).at;
    viewer.go_to({ring.column - 200.0, ring.column - 100.0, ring.row - 200.0, ring.row - 100.0});
    viewer.targets().choose(11);
    const gui::ImageView& view = viewer.plot().view();
    QVERIFY(view.column_first < ring.column && ring.column < view.column_last);
    QVERIFY(view.row_first < ring.row && ring.row < view.row_last);
    viewer.findChild<QPushButton*>("target_list_copy")->click();
    QVERIFY(QApplication::clipboard()->text().startsWith("Target\tState\tAzimuth (m)"));
    // A file of the same numbers as the command's.
    const QTemporaryDir folder;
    const QString csv = folder.filePath("targets.csv");
    auto* const save = viewer.findChild<QPushButton*>("target_list_save");
    viewer.targets().ask_name = [] { return QString(); };
    save->click();
    QVERIFY(QDir(folder.path()).isEmpty());
    viewer.targets().ask_name = [&] { return csv; };
    save->click();
    QFile file(csv);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray lines = file.readAll();
    QCOMPARE(lines.count('\n'), static_cast<qsizetype>(viewer.targets().table().rows.size()) + 1);
    QProcess measure;
    measure.start(SARSIM_PROGRAM, {"measure", QString::fromStdString(image_.string()), "--csv"});
    QVERIFY(measure.waitForFinished(patience_ms));
    QCOMPARE(lines, measure.readAllStandardOutput());
    viewer.targets().ask_name = [&] { return folder.filePath("none/targets.csv"); };
    save->click();
    QVERIFY(viewer.findChild<gui::ProblemLine*>("target_list_problems")->text().contains("none/targets.csv"));
    tool->click();
    QVERIFY(viewer.plot().rings().empty() && !viewer.targets().isVisible());
  }

  void columns_sort_by_their_numbers() {
    gui::TargetList list;
    list.show();
    QSignalSpy measured(&list, &gui::TargetList::measured);
    list.measure(image_);
    QVERIFY(measured.wait(patience_ms));
    auto* table = list.findChild<QTableWidget*>("target_list_table");
    table->sortByColumn(2, Qt::DescendingOrder);
    const auto azimuth = [&](int line) { return table->item(line, 2)->text().replace(QChar(0x2212), '-').toDouble(); };
    QVERIFY(azimuth(0) > 100.0 && azimuth(table->rowCount() - 1) < -100.0);
    for (int line = 1; line < table->rowCount(); ++line) QVERIFY(azimuth(line - 1) >= azimuth(line));
    list.choose(0);
    QCOMPARE(list.chosen(), std::optional<std::size_t>(0));
  }

  void what_is_cancelled_says_so_and_can_be_measured_again() {
    gui::TargetList list;
    list.show();
    auto* cancel = list.findChild<QPushButton*>("target_list_cancel");
    QSignalSpy measured(&list, &gui::TargetList::measured);
    list.measure(image_);
    QVERIFY(list.table().rows.empty());
    cancel->click();
    QVERIFY(measured.wait(patience_ms));
    // It may have been quicker than the hand.
    if (list.table().rows.empty()) {
      QCOMPARE(cancel->text(), QString("Measure Again"));
      QVERIFY(list.findChild<QLabel*>("target_list_summary")->text().contains("cancelled"));
      cancel->click();
      QVERIFY(measured.wait(patience_ms));
    }
    QVERIFY2(list.table().rows.size() == 24U,
             qPrintable(list.findChild<gui::ProblemLine*>("target_list_problems")->text()));
    // Nothing of one image is left while the next is measured.
    list.measure(image_);
    QVERIFY(list.table().rows.empty() && !list.chosen());
    QTRY_COMPARE_WITH_TIMEOUT(list.table().rows.size(), 24U, patience_ms);
  }

  void an_image_of_unknown_origin_says_why_there_are_no_targets() {
    const QString alone = folder_.filePath("alone.npy");
    QVERIFY(QFile::copy(QString::fromStdString(image_.string()), alone));
    gui::TargetList list;
    list.show();
    QSignalSpy measured(&list, &gui::TargetList::measured);
    list.measure(alone.toStdString());
    QVERIFY(measured.wait(patience_ms));
    QVERIFY(list.table().rows.empty());
    QVERIFY(list.findChild<QWidget*>("target_list_problems")->isVisible());
    QVERIFY(!list.findChild<QPushButton*>("target_list_copy")->isEnabled());
  }
};

const test::AddTest added("target_list_test", test::run_test<TargetListTest>);

}  // namespace sarsim::target_list_test

#include "target_list_test.moc"
