#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/property_panel.hpp"
#include "scene/script/reader.hpp"

// The worked example of thesis chapter 3 as its reader builds it: with menus, fields and dialogs only. What the
// workbench made of it is then judged by the command line program, which knows nothing of the workbench.

namespace sarsim::chapter3_test {

namespace {

constexpr int patience_ms = 60'000;
// Equation 3.5 with the wavelength of 1 GHz instead of 0.3 m: 4.09566e-5 mV, in the last digit that the thesis prints.
constexpr double magnitude_mv = 4.0957e-5;
constexpr double last_digit_mv = 0.0001e-5;

// The workbench in the hands of a reader of the thesis.
class Hands {
 public:
  explicit Hands(gui::MainWindow& window) : window_(window) {
    window_.show();
    if (!QTest::qWaitForWindowExposed(&window_)) qFatal("the window does not show");
    window_.activateWindow();
  }

  void choose(const char* action) const {
    auto* found = window_.findChild<QAction*>(action);
    if (found == nullptr || !found->isEnabled()) qFatal("no action %s", action);
    found->trigger();
    QCoreApplication::processEvents();
  }

  void type(const char* field, const QString& text) const {
    auto* line = of_panel<QLineEdit>(field);
    line->setFocus();
    QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    QCoreApplication::processEvents();
  }

  // Goes through the list with the arrow keys until the choice shows.
  void pick(const char* field, const QString& choice) const {
    auto* box = of_panel<QComboBox>(field);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Down);  // opens the list
    QTest::keyClick(box->view(), Qt::Key_Home);
    for (int i = 0; i < box->count() && box->view()->currentIndex().data().toString() != choice; ++i)
      QTest::keyClick(box->view(), Qt::Key_Down);
    QTest::keyClick(box->view(), Qt::Key_Return);
    if (box->currentText() != choice) qFatal("%s: no choice '%s'", field, qPrintable(choice));
    QCoreApplication::processEvents();
  }

  void click(const char* button) const {
    auto* found = window_.findChild<QPushButton*>(button);
    if (found == nullptr || !found->isVisible() || !found->isEnabled()) qFatal("no button %s to click", button);
    QTest::mouseClick(found, Qt::LeftButton);
    QCoreApplication::processEvents();
  }

  // Figure 3.5: the number below the picture of the raw return, in mV (the window says nV); negative until it is known.
  [[nodiscard]] double highest_magnitude_mv() const {
    const auto* label = window_.findChild<QLabel*>("echo_highest");
    static const QRegularExpression number(R"(([\d.]+) nV)");
    const QRegularExpressionMatch found = label == nullptr ? QRegularExpressionMatch() : number.match(label->text());
    return found.hasMatch() ? 1e-6 * found.captured(1).toDouble() : -1.0;
  }

  [[nodiscard]] QString shown(const char* field) const {
    const QWidget* widget = of_panel<QWidget>(field);
    if (const auto* box = qobject_cast<const QComboBox*>(widget)) return box->currentText();
    return qobject_cast<const QLineEdit*>(widget)->text();
  }

  // Save As, with the name typed into its dialog.
  void save_as(const QString& path) const {
    bool typed = false;
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !dialog->isVisible()) return;
      auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
      if (name == nullptr) qFatal("the dialog has no field for the name");
      name->setFocus();
      if (!name->hasFocus()) return;  // the dialog is still being brought up
      answer.stop();
      QTest::keyClick(name, Qt::Key_A, Qt::ControlModifier);
      QTest::keyClicks(name, path);
      typed = true;
      QTest::keyClick(name, Qt::Key_Return);
    });
    answer.start(20);
    choose("file_save_as");
    if (!typed) qFatal("no dialog asked for a name");
  }

 private:
  template <class Widget>
  [[nodiscard]] Widget* of_panel(const char* field) const {
    auto* panel = window_.findChild<gui::PropertyPanel*>();
    auto* found = panel->findChild<Widget*>(QString("field_%1").arg(field));
    if (found == nullptr || !found->isVisible() || !found->isEnabled()) qFatal("no field %s to type into", field);
    return found;
  }

  gui::MainWindow& window_;
};

struct Outcome {
  int status = -1;
  QString messages;
  QJsonObject product;
};

// What `sarsim run` says of the only product of a script.
Outcome run_script(const QString& script, const QString& folder) {
  QProcess sarsim;
  sarsim.start(SARSIM_PROGRAM, {"run", script, "--out", folder, "--json", "--strict"});
  Outcome outcome;
  if (!sarsim.waitForFinished(patience_ms)) return outcome;
  outcome.status = sarsim.exitStatus() == QProcess::NormalExit ? sarsim.exitCode() : -1;
  outcome.messages = QString::fromUtf8(sarsim.readAllStandardError());
  const QJsonArray products = QJsonDocument::fromJson(sarsim.readAllStandardOutput())["products"].toArray();
  if (products.size() == 1) outcome.product = products[0].toObject();
  return outcome;
}

// Table 3.1, as far as it differs from what new objects begin with.
void build_radar(const Hands& hands) {
  hands.choose("new_radar");
  hands.pick("pulse", "Chirp");
}

void build_target(const Hands& hands, const QString& x) {
  hands.choose("new_target");
  hands.type("position_m.x", x);
  hands.type("rcs_m2", "3");
}

void store_simulation(const Hands& hands) {
  hands.choose("simulation_stored");
  hands.click("stored_new");
  hands.type("range_start_m", "2.5 km");
  hands.type("range_end_m", "4500");
  hands.type("time_end_s", "3 ms");
  hands.type("sample_rate_hz", "100 MHz");
  hands.pick("format", "NumPy");
  hands.type("file", "chapter3.npy");
}

}  // namespace

class Chapter3Test : public QObject {
  Q_OBJECT

 private slots:
  void a_new_radar_begins_with_the_values_that_the_thesis_leaves_alone() {
    gui::MainWindow window;
    const Hands hands(window);
    hands.choose("file_new");
    build_radar(hands);
    QCOMPARE(hands.shown("name"), QString("Radar1"));
    QCOMPARE(hands.shown("platform"), QString("Earth"));
    QCOMPARE(hands.shown("bandwidth_hz"), QString("50 MHz"));
    QCOMPARE(hands.shown("pulse_width_s"), QString("5 µs"));
    QCOMPARE(hands.shown("prf_hz"), QString("1 kHz"));
    QCOMPARE(hands.shown("carrier_hz"), QString("1 GHz"));
    QCOMPARE(hands.shown("power_w"), QString("1 kW"));
    QCOMPARE(hands.shown("transmit_antenna.pattern"), QString("Isotropic"));
  }

  void the_example_built_with_widgets_gives_the_magnitude_of_the_thesis() {
    const QTemporaryDir folder;
    const QString script = folder.filePath("chapter3.toml");
    gui::MainWindow window;
    const Hands hands(window);
    hands.choose("file_new");
    build_radar(hands);
    build_target(hands, "3000");
    hands.choose("simulation_raw");
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(hands.highest_magnitude_mv() - magnitude_mv) < last_digit_mv, patience_ms);
    store_simulation(hands);
    QVERIFY(window.isWindowModified());
    hands.save_as(script);
    QVERIFY(!window.isWindowModified());
    QVERIFY2(window.windowTitle().contains(script), qPrintable(window.windowTitle()));
    QVERIFY(window.session().document().problems().empty());

    const Outcome outcome = run_script(script, folder.filePath("out"));
    QVERIFY2(outcome.status == 0, qPrintable(outcome.messages));
    QVERIFY(std::abs(1e3 * outcome.product["maximum_v"].toDouble() - magnitude_mv) < last_digit_mv);
    QCOMPARE(outcome.product["rows"].toInt(), 4);
    QCOMPARE(outcome.product["processing"].toString(), QString("raw"));
    QCOMPARE(QFileInfo(folder.filePath("out/chapter3.npy")).size(), outcome.product["bytes"].toInteger());
  }

  // 3000 m apart again: the platform 1 km out, the target 4 km, a radar that rides on the platform.
  void a_radar_on_a_new_platform_sees_the_same_at_the_same_distance() {
    const QTemporaryDir folder;
    gui::MainWindow window;
    const Hands hands(window);
    hands.choose("file_new");
    hands.choose("new_platform");
    hands.type("name", "Mast");
    hands.type("position_m.x", "1 km");
    build_radar(hands);
    QCOMPARE(hands.shown("platform"), QString("Mast"));
    build_target(hands, "4 km");
    hands.pick("platform", "Earth");
    store_simulation(hands);
    hands.save_as(folder.filePath("mast"));
    QVERIFY(QFileInfo::exists(folder.filePath("mast.toml")));
    const Outcome outcome = run_script(folder.filePath("mast.toml"), folder.filePath("out"));
    QVERIFY2(outcome.status == 0, qPrintable(outcome.messages));
    QVERIFY(std::abs(1e3 * outcome.product["maximum_v"].toDouble() - magnitude_mv) < last_digit_mv);
  }

  void undo_takes_the_whole_example_back_and_redo_builds_it_again() {
    gui::MainWindow window;
    const Hands hands(window);
    hands.choose("file_new");
    const std::string empty = window.session().document().text();
    build_radar(hands);
    build_target(hands, "3000");
    store_simulation(hands);
    const std::string built = window.session().document().text();
    const auto* undo = window.findChild<QAction*>("edit_undo");
    int steps = 0;
    for (; undo->isEnabled() && steps < 100; ++steps) hands.choose("edit_undo");
    QVERIFY(steps >= 5);
    QCOMPARE(window.session().document().text(), empty);
    QVERIFY(!window.isWindowModified());
    for (int i = 0; i < steps; ++i) hands.choose("edit_redo");
    QCOMPARE(window.session().document().text(), built);
  }
};

const test::AddTest added("chapter3_test", test::run_test<Chapter3Test>);

}  // namespace sarsim::chapter3_test

#include "chapter3_test.moc"
