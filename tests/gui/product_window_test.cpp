#include <QtTest>

#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/report/invalid_request.hpp"
#include "gui/common/figure_plot.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/runs/product_window.hpp"
#include "gui/runs/report_view.hpp"
#include "scene/schema/function_block.hpp"
#include "scene/script/data_file.hpp"
#include "scene/script/writer.hpp"
#include "workflow/search/search_options.hpp"
#include "workflow/stepped/profiles_options.hpp"

namespace sarsim::product_window_test {

namespace {

constexpr int patience_ms = 60'000;

struct Bench {
  explicit Bench(const char* example) {
    main.documents().open_file(QString(SARSIM_SOURCE_DIR "/examples/") + example);
    window = qobject_cast<gui::ProductWindow*>(main.window_named("products"));
  }
  void choose(const char* box, const QString& words) const {
    auto* const found = window->findChild<QComboBox*>(box);
    for (int i = 0; i < found->count(); ++i)
      if (found->itemText(i).contains(words)) return found->setCurrentIndex(i);
    qFatal("no %s", qPrintable(words));
  }
  [[nodiscard]] bool make() const {
    QSignalSpy ended(window, &gui::ProductWindow::ended);
    window->findChild<QPushButton*>("products_make")->click();
    if (ended.isEmpty() && !ended.wait(patience_ms)) qFatal("the work did not end");
    return ended.front().front().toBool();
  }
  // Waits for the end of work that was begun.
  [[nodiscard]] bool end_of_work() const {
    return QTest::qWaitFor([&] { return !window->busy(); }, patience_ms);
  }
  void type_more(const char* words) const { window->findChild<QLineEdit*>("products_more")->setText(words); }
  [[nodiscard]] QString problems() const { return window->findChild<gui::ProblemLine*>("products_problems")->text(); }
  [[nodiscard]] QString state() const { return window->findChild<QLabel*>("products_state")->text(); }
  [[nodiscard]] gui::ReportView* report() const { return window->findChild<gui::ReportView*>("products_report"); }
  [[nodiscard]] const QTableWidget* table(const QString& title) const {
    for (const QTableWidget* table : report()->findChildren<QTableWidget*>())
      if (table->accessibleName() == title) return table;
    return nullptr;
  }
  // "value unit" of a name in the table of results.
  [[nodiscard]] QString result(const QString& name) const {
    const QTableWidget* const results = table("Result");
    for (int row = 0; results != nullptr && row < results->rowCount(); ++row)
      if (results->item(row, 0)->text() == name)
        return (results->item(row, 1)->text() + " " + results->item(row, 2)->text()).trimmed();
    return {};
  }

  gui::MainWindow main;
  gui::ProductWindow* window = nullptr;
};

// A folder for temporary files of its own, so that it is seen what is left there.
class OwnTemporaryFolder {
 public:
  OwnTemporaryFolder() : before_(qgetenv("TMPDIR")) { qputenv("TMPDIR", folder_.path().toUtf8()); }
  ~OwnTemporaryFolder() { before_.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before_); }
  [[nodiscard]] QStringList entries() const {
    return QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
  }

 private:
  QTemporaryDir folder_;
  QByteArray before_;
};

std::filesystem::path example(const char* name) { return std::filesystem::path(SARSIM_SOURCE_DIR "/examples") / name; }

}  // namespace

class ProductWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    qputenv("PATH", "");  // No program can be found: all work is done here.
  }

  void begins_with_the_product_that_suits_the_scene() {
    for (const auto& [example, command] :
         {std::pair("sar_r.toml", "sarsim focus"), std::pair("search_radar.toml", "sarsim search"),
          std::pair("turning_ship.toml", "sarsim isar"), std::pair("stepped_aircraft.toml", "sarsim profiles")}) {
      Bench bench(example);
      QVERIFY2(bench.window->command().startsWith(command), qPrintable(bench.window->command()));
    }
    // Another scene in the same window.
    Bench bench("sar_r.toml");
    bench.main.documents().open_file(SARSIM_SOURCE_DIR "/examples/search_radar.toml");
    QVERIFY(bench.window->command().startsWith("sarsim search"));
  }

  void shows_the_command_that_does_the_same() {
    Bench bench("sar_r.scr");
    QCOMPARE(bench.window->command(),
             QString("sarsim focus sar_r.scr --algorithm omega-k --window rectangular --out sar_r_focus.npy"));
    bench.choose("products_kind", "Doppler");
    bench.choose("products_choice", "two");
    bench.choose("products_window", "hann");
    bench.window->findChild<QLineEdit*>("products_more")->setText("--pfa 1e-4 --detections \"my hits.csv\"");
    QCOMPARE(bench.window->command(),
             QString("sarsim doppler sar_r.scr --canceller two --window hann --pfa 1e-4 --detections 'my hits.csv' "
                     "--out sar_r_doppler.npy"));
    QCOMPARE(bench.window->findChild<QLineEdit*>("products_command")->text(), bench.window->command());
  }

  void words_that_are_typed_take_the_place_of_what_is_chosen() {
    Bench bench("sar_r.scr");
    bench.type_more("--window=taylor:35:5 --algorithm range-doppler");
    QCOMPARE(bench.window->command(),
             QString("sarsim focus sar_r.scr --window=taylor:35:5 --algorithm range-doppler --out sar_r_focus.npy"));
    QVERIFY2(bench.make(), qPrintable(bench.problems()));
    QCOMPARE(bench.result("Window over azimuth"), QString("taylor:35:5"));
    QCOMPARE(bench.result("Algorithm"), QString("range-doppler"));
  }

  void makes_products_and_opens_them_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<QString>("kind");
    QTest::newRow("focused") << "sar_r.scr"
                             << "Focused";
    QTest::newRow("profiles") << "stepped_srp.scr"
                              << "profiles";
    QTest::newRow("turning") << "turning_ship.scr"
                             << "ISAR";
    QTest::newRow("maps") << "mti.scr"
                          << "Doppler";
    QTest::newRow("search") << "search_radar.scr"
                            << "PPI";
  }

  void makes_products_and_opens_them() {
    QFETCH(QString, example);
    QFETCH(QString, kind);
    Bench bench(qPrintable(example));
    bench.choose("products_kind", kind);
    QVERIFY2(bench.make(), qPrintable(bench.problems()));
    QCOMPARE(bench.problems(), QString());
    QVERIFY(bench.window->findChild<QPlainTextEdit*>() == nullptr);
    QVERIFY(!bench.report()->empty());
    QVERIFY(bench.table("Result")->rowCount() > 5);
    QVERIFY(!bench.result("Time taken").isEmpty());
    QVERIFY(bench.window->findChild<QProcess*>() == nullptr);
    const auto viewers = bench.main.image_viewers().viewers();
    QCOMPARE(viewers.size(), std::size_t{1});
    gui::ImageViewer& viewer = *viewers.front();
    QVERIFY(QTest::qWaitFor([&] { return viewer.source() != nullptr; }, patience_ms));
    QVERIFY(viewer.source()->rows() > 0 && viewer.source()->columns() > 10);
    const QString file = QString::fromStdString(viewer.path().string());
    QVERIFY(QFileInfo::exists(file));
    delete &viewer;
    QVERIFY2(!QFileInfo::exists(file), "the file goes with its viewer");
  }

  void the_same_image_made_again_takes_the_place_of_the_one_before_unless_that_is_kept() {
    Bench bench("sar_r.scr");
    QVERIFY(bench.make());
    gui::ImageViewer& first = *bench.main.image_viewers().viewers().front();
    QVERIFY(QTest::qWaitFor([&] { return first.complete(); }, patience_ms));
    QVERIFY2(first.windowTitle().startsWith("sar_r, Radar1, PRF 620 Hz, omega-k"), qPrintable(first.windowTitle()));
    const std::filesystem::path before = first.path();
    const gui::ImageView part{100.0, 200.0, 100.0, 400.0};
    first.go_to(part);
    const gui::ImageView seen = first.plot().view();
    QVERIFY(bench.make());
    QCOMPARE(bench.main.image_viewers().viewers().size(), std::size_t{1});
    QVERIFY(first.path() != before);
    QVERIFY(QTest::qWaitFor([&] { return first.complete(); }, patience_ms));
    QCOMPARE(first.plot().view(), seen);
    QVERIFY(!std::filesystem::exists(before));
    first.findChild<QAbstractButton*>("image_keep")->click();
    QVERIFY(bench.make());
    QCOMPARE(bench.main.image_viewers().viewers().size(), std::size_t{2});
  }

  // Finding B17.
  void another_scene_takes_the_report_away() {
    Bench bench("sar_r.scr");
    QVERIFY(bench.make());
    QVERIFY(!bench.report()->empty());
    bench.main.session().take(scene::Document::open(SARSIM_SOURCE_DIR "/examples/spotlight.scr"));
    QVERIFY(bench.report()->empty());
  }

  // Finding B3: the last line of the report widened the window beyond the screen.
  void no_words_change_the_size_of_the_window() {
    Bench bench("turning_ship.scr");
    const QSize size = bench.window->size();
    bench.choose("products_kind", "ISAR");
    QVERIFY(bench.make());
    QCOMPARE(bench.window->size(), size);
    QVERIFY(bench.window->minimumSizeHint().width() < 1000);
  }

  // What is on screen counts, not what is on disk.
  void takes_the_scene_as_it_is_now() {
    Bench bench("sar_r.scr");
    std::string text = bench.main.session().document().text();
    bench.main.session().type_text(text + "\n$TARGET Earth nonsense\n");
    QVERIFY(!bench.make());
    QVERIFY2(bench.problems().contains("nonsense"), qPrintable(bench.problems()));
    QVERIFY(bench.main.image_viewers().viewers().empty());
  }

  // A name like ../gain.dat means another file from the folder that the command works in.
  void writes_no_data_files() {
    const QTemporaryDir folder;
    const std::filesystem::path root = folder.path().toStdString();
    for (const char* name : {"scenes", "tmp"}) std::filesystem::create_directory(root / name);
    scene::Document document = scene::Document::open(SARSIM_SOURCE_DIR "/examples/sar_r.scr");
    scene::Scene scene = document.scene();
    scene.radars[0].stc = scene::Radar::Stc::user;
    scene.radars[0].stc_gain.part[0].knots = {{0.0, 1.0}, {1e6, 1.0}};
    scene.radars[0].stc_gain.file = "../gain.dat";
    std::ofstream(root / "gain.dat") << scene::write_data_file(scene.radars[0].stc_gain.part,
                                                               scene::function_blocks::stc_gain);
    std::ofstream(root / "scenes" / "a.scr") << scene::write_script(scene);
    std::ofstream(root / "tmp" / "gain.dat") << "precious";
    const QByteArray before = qgetenv("TMPDIR");
    qputenv("TMPDIR", QByteArray::fromStdString((root / "tmp").string()));
    {
      Bench bench("sar_r.scr");
      QVERIFY(bench.main.documents().open_file(QString::fromStdString((root / "scenes" / "a.scr").string())));
      QVERIFY2(bench.make(), qPrintable(bench.problems()));
    }
    before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
    std::string kept;
    std::getline(std::ifstream(root / "tmp" / "gain.dat"), kept);
    QCOMPARE(kept, std::string("precious"));
  }

  void says_what_the_scene_lacks() {
    Bench bench("sar_r.scr");
    bench.choose("products_kind", "profiles");
    QVERIFY(!bench.make());
    QVERIFY2(bench.problems().contains("step", Qt::CaseInsensitive), qPrintable(bench.problems()));
    QVERIFY(bench.window->findChild<QPushButton*>("products_make")->isEnabled());
  }

  void shows_the_report_of_profiles_as_tables_and_a_figure() {
    Bench bench("stepped_srp.scr");
    bench.choose("products_kind", "profiles");
    QVERIFY2(bench.make(), qPrintable(bench.problems()));
    const QTemporaryDir folder;
    const workflow::ProfilesReport made = workflow::profiles(
        workflow::profiles_request(example("stepped_srp.scr").string(),
                                   {{"--window", "rectangular"}, {"--out", folder.filePath("p.npy").toStdString()}}),
        {});
    QVERIFY(!made.targets.empty() && !made.peaks.empty());
    QCOMPARE(bench.result("Bins"), QString::number(made.series.axis.count));
    QCOMPARE(bench.result("Bursts illuminated"), QString::number(made.series.rows.size()));
    const std::size_t burst = made.series.rows[made.held_row].burst + 1;
    const QTableWidget* const targets = bench.table(QString("Targets in burst %1").arg(burst));
    QVERIFY(targets != nullptr);
    QCOMPARE(targets->rowCount(), static_cast<int>(made.targets.size()));
    for (int row = 0; row < targets->rowCount(); ++row) {
      const workflow::HeldTarget& target = made.targets[static_cast<std::size_t>(row)];
      QCOMPARE(targets->item(row, 0)->text(), QString::number(target.truth.target + 1));
      QCOMPARE(targets->item(row, 3)->text(), QString::number(target.expected_m, 'f', 3));
      if (target.found) QCOMPARE(targets->item(row, 5)->text(), QString::number(target.found->range_m, 'f', 3));
    }
    QCOMPARE(bench.table("Scans")->rowCount(), static_cast<int>(made.series.scans.size()));
    const auto* const plot = bench.report()->findChild<gui::FigurePlot*>();
    QVERIFY(plot != nullptr);
    QCOMPARE(plot->figure().panels.at(0).curves.at(0).y.size(), made.series.axis.count);
    QCOMPARE(plot->figure().title, "Profile of burst " + std::to_string(burst));
  }

  void lists_detections_and_targets() {
    Bench bench("mti.scr");
    bench.choose("products_kind", "Doppler");
    bench.choose("products_choice", "two");
    QVERIFY2(bench.make(), qPrintable(bench.problems()));
    const QTemporaryDir folder;
    const workflow::DopplerReport made = workflow::doppler(
        workflow::doppler_request(example("mti.scr").string(),
                                  {{"--canceller", "two"}, {"--out", folder.filePath("m.npy").toStdString()}}),
        {});
    QVERIFY(made.detections > 0 && !made.findings.empty());
    QCOMPARE(bench.result("Detections"), QString::number(made.detections));
    QCOMPARE(bench.table("Detections")->rowCount(), static_cast<int>(made.detections));
    const QTableWidget* const targets = bench.table("Targets");
    QCOMPARE(targets->rowCount(), static_cast<int>(made.findings.size()));
    QCOMPARE(targets->item(0, 2)->text(), QString::number(made.findings[0].sight.range_m, 'f', 1));
  }

  void copies_what_is_selected() {
    Bench bench("sar_r.scr");
    QVERIFY2(bench.make(), qPrintable(bench.problems()));
    auto* const results = const_cast<QTableWidget*>(bench.table("Result"));
    results->clearSelection();
    results->setRangeSelected(QTableWidgetSelectionRange(1, 0, 2, 1), true);
    QTest::keyClick(results, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QGuiApplication::clipboard()->text(),
             QString("Algorithm\tomega-k\nRows, along azimuth\t") + results->item(2, 1)->text());
    for (QAction* const action : results->actions())
      if (action->text().contains("Table")) action->trigger();
    const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
    QCOMPARE(lines.size(), results->rowCount() + 1);
    QCOMPARE(lines.front(), QString("Name\tValue\tUnit"));
  }

  void opens_every_image_of_a_series() {
    Bench bench("turning_ship.scr");
    bench.choose("products_kind", "ISAR");
    bench.type_more("--bursts 32 --step 32");
    QVERIFY2(bench.make(), qPrintable(bench.problems()));
    const int images = bench.result("Images").toInt();
    QVERIFY(images > 1);
    QCOMPARE(bench.table("Images")->rowCount(), images);
    QCOMPARE(bench.main.image_viewers().viewers().size(), static_cast<std::size_t>(std::min(images, 8)));
  }

  void needs_no_image() {
    Bench bench("mti.scr");
    bench.choose("products_kind", "Doppler");
    bench.type_more("--no-map");
    QVERIFY2(bench.make(), qPrintable(bench.problems()));
    QVERIFY(bench.main.image_viewers().viewers().empty());
    QVERIFY(!bench.report()->empty());
  }

  void refuses_options_that_there_are_not_before_it_begins_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("told");
    QTest::newRow("unknown") << "--algoritm omega-k"
                             << "Error: unknown option '--algoritm'. Did you mean '--algorithm'?";
    QTest::newRow("of another product") << "--pfa 1e-4"
                                        << "Error: unknown option '--pfa'.";
    QTest::newRow("word") << "--grid grund"
                          << "Did you mean 'ground'?";
    QTest::newRow("number") << "--threads many"
                            << "--threads: 'many' is not a whole number from 0 to 4096";
    QTest::newRow("missing") << "--memory"
                             << "--memory: SIZE is missing after it";
    QTest::newRow("size") << "--memory lots"
                          << "--memory: 'lots' is not a valid size";
    QTest::newRow("quote") << "--scratch 'my disk"
                           << "a quote ' is not closed";
    QTest::newRow("name") << "--out a.npy"
                          << "--out: the image goes to a viewer";
  }

  void refuses_options_that_there_are_not_before_it_begins() {
    QFETCH(QString, words);
    QFETCH(QString, told);
    const OwnTemporaryFolder temporary;
    Bench bench("sar_r.scr");
    bench.type_more(qPrintable(words));
    QSignalSpy ended(bench.window, &gui::ProductWindow::ended);
    bench.window->make();
    QCOMPARE(ended.size(), 1);
    QCOMPARE(ended.front().front().toBool(), false);
    QVERIFY(!bench.window->busy());
    QVERIFY2(bench.problems().contains(told), qPrintable(bench.problems()));
    QCOMPARE(temporary.entries(), QStringList());
    QVERIFY(bench.window->findChild<QPushButton*>("products_make")->isEnabled());
  }

  void tells_how_far_it_is() {
    Bench bench("sar_r.scr");
    bench.choose("products_choice", "back-projection");
    auto* const bar = bench.window->findChild<QProgressBar*>("products_progress");
    QVERIFY(bar->isHidden());
    bench.window->make();
    QVERIFY(!bar->isHidden());
    QSet<QString> told;
    int farthest = 0;
    QVERIFY(QTest::qWaitFor(
        [&] {
          told << bench.state();
          farthest = std::max(farthest, bar->value());
          return !bench.window->busy();
        },
        patience_ms));
    QVERIFY(farthest > 0);
    QVERIFY2(told.size() > 2, qPrintable(QStringList(told.values()).join('|')));
    for (const QString& words : std::as_const(told)) QVERIFY2(!words.contains(QDir::tempPath()), qPrintable(words));
    QVERIFY(bar->isHidden());
    QCOMPARE(bench.state(), QString("Done"));
  }

  void stops_at_once() {
    const OwnTemporaryFolder temporary;
    Bench bench("sar_r.scr");
    bench.choose("products_choice", "back-projection");
    QSignalSpy ended(bench.window, &gui::ProductWindow::ended);
    bench.window->make();
    QVERIFY(bench.window->busy());
    bench.window->findChild<QPushButton*>("products_stop")->click();
    QVERIFY(ended.wait(patience_ms));
    QCOMPARE(ended.front().front().toBool(), false);
    QVERIFY(!bench.window->busy() && bench.problems().isEmpty());
    QVERIFY(bench.main.image_viewers().viewers().empty());
    QCOMPARE(temporary.entries(), QStringList());
  }

  void stops_in_the_middle_and_leaves_nothing() {
    const OwnTemporaryFolder temporary;
    Bench bench("sar_r.scr");
    bench.choose("products_choice", "back-projection");
    auto* const bar = bench.window->findChild<QProgressBar*>("products_progress");
    bench.window->make();
    QVERIFY(QTest::qWaitFor([&] { return bar->value() > 0 || !bench.window->busy(); }, patience_ms));
    QVERIFY2(bench.window->busy(), "it was done before it could be stopped");
    bench.window->stop();
    QVERIFY(bench.end_of_work());
    QCOMPARE(bench.state(), QString("Stopped; nothing was kept"));
    QVERIFY(bench.report()->empty() && bench.problems().isEmpty());
    QVERIFY(bench.main.image_viewers().viewers().empty());
    QCOMPARE(temporary.entries(), QStringList());
    QVERIFY2(bench.make(), "it can begin anew");
  }

  void stops_when_its_window_is_closed() {
    const OwnTemporaryFolder temporary;
    Bench bench("sar_r.scr");
    bench.choose("products_choice", "back-projection");
    QSignalSpy ended(bench.window, &gui::ProductWindow::ended);
    bench.window->make();
    bench.window->close();
    QVERIFY(!ended.isEmpty() || ended.wait(patience_ms));
    QCOMPARE(ended.front().front().toBool(), false);
    QCOMPARE(temporary.entries(), QStringList());
  }

  void ends_its_work_when_the_workbench_closes_data() {
    QTest::addColumn<bool>("in_the_middle");
    QTest::newRow("at once") << false;
    QTest::newRow("in the middle") << true;
  }

  void ends_its_work_when_the_workbench_closes() {
    QFETCH(bool, in_the_middle);
    const OwnTemporaryFolder temporary;
    {
      Bench bench("sar_r.scr");
      bench.choose("products_choice", "back-projection");
      auto* const bar = bench.window->findChild<QProgressBar*>("products_progress");
      bench.window->make();
      if (in_the_middle)
        QVERIFY(QTest::qWaitFor([&] { return bar->value() > 0 || !bench.window->busy(); }, patience_ms));
      QVERIFY2(bench.window->busy(), "it was done before the workbench could close");
      delete bench.window;
      QVERIFY2(temporary.entries().isEmpty(), "the work still has its files");
    }
    QCoreApplication::processEvents();
    QCOMPARE(temporary.entries(), QStringList());
  }
};

const test::AddTest added("product_window_test", test::run_test<ProductWindowTest>);

}  // namespace sarsim::product_window_test

#include "product_window_test.moc"
