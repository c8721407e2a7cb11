#include <QtTest>

#include <QComboBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <signal.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>

#include "gui/common/problem_line.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/runs/product_window.hpp"
#include "scene/schema/function_block.hpp"
#include "scene/script/data_file.hpp"
#include "scene/script/writer.hpp"

namespace sarsim {

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
    if (ended.isEmpty() && !ended.wait(patience_ms)) qFatal("the command did not end");
    return ended.front().front().toBool();
  }
  [[nodiscard]] QString problems() const { return window->findChild<gui::ProblemLine*>("products_problems")->text(); }

  gui::MainWindow main;
  gui::ProductWindow* window = nullptr;
};

}  // namespace

class ProductWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("sarsim");
    QCoreApplication::setApplicationName("product_window_test");
    qputenv("PATH", QFileInfo(SARSIM_PROGRAM).absolutePath().toUtf8() + ":" + qgetenv("PATH"));
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

  void makes_products_and_opens_them_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<QString>("kind");
    QTest::newRow("focused") << "sar_r.scr"
                             << "Focused";
    QTest::newRow("profiles") << "stepped_srp.scr"
                              << "profiles";
    QTest::newRow("turning") << "turning_ship.scr"
                             << "turning";
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
    QVERIFY(!bench.window->findChild<QPlainTextEdit*>("products_report")->toPlainText().isEmpty());
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

  void stops_at_once() {
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
  }

  void ends_its_command_when_the_workbench_closes() {
    Bench bench("sar_r.scr");
    bench.choose("products_choice", "back-projection");
    bench.window->make();
    auto* const process = bench.window->findChild<QProcess*>();
    QVERIFY(process->waitForStarted(patience_ms));
    const auto number = static_cast<pid_t>(process->processId());
    QVERIFY(number > 0 && ::kill(number, 0) == 0);
    delete bench.window;
    QVERIFY2(::kill(number, 0) != 0 && errno == ESRCH, "the command still runs");
  }
};

}  // namespace sarsim

QTEST_MAIN(sarsim::ProductWindowTest)
#include "product_window_test.moc"
