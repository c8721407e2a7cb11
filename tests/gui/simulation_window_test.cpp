#include <QtTest>

#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QToolButton>

#include <cmath>

#include "gui/echo/echo_controls.hpp"
#include "gui/echo/echo_plot.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::simulation_window_test {

namespace {

constexpr int patience_ms = 20'000;

bool wait_for_picture(gui::SimulationWindow& window) {
  return QTest::qWaitFor([&] { return window.complete() && window.plot().matrix() != nullptr; }, patience_ms);
}

// A workbench with the example of chapter 3 and a window of raw echoes, computed.
struct Bench {
  Bench() {
    main.documents().open_file(SARSIM_SOURCE_DIR "/examples/thesis_chapter3.scr");
    window = main.simulation_windows().open_new(scene::Processing::raw);
    window->resize(900, 600);
    QTest::qWait(50);  // The resize counts before the picture does.
    computed = wait_for_picture(*window);
  }

  QPoint at(double across, double up) const {
    const QRect plot = window->plot().plot_rect();
    return {plot.left() + static_cast<int>(across * plot.width()),
            plot.bottom() - static_cast<int>(up * plot.height())};
  }
  void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) const {
    gui::EchoPlot& plot = window->plot();
    QTest::mousePress(&plot, button, {}, from);
    for (int step = 1; step <= 4; ++step) {
      QMouseEvent move(QEvent::MouseMove, from + (to - from) * step / 4,
                       plot.mapToGlobal(from + (to - from) * step / 4), Qt::NoButton, button, Qt::NoModifier);
      QApplication::sendEvent(&plot, &move);
    }
    QTest::mouseRelease(&plot, button, {}, to);
  }
  QString highest() const { return window->findChild<QLabel*>("echo_highest")->text(); }

  gui::MainWindow main;
  gui::SimulationWindow* window = nullptr;
  bool computed = false;
};

}  // namespace

class SimulationWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void the_menu_opens_a_window_that_shows_all_targets() {
    gui::MainWindow main;
    main.documents().open_file(SARSIM_SOURCE_DIR "/examples/thesis_chapter3.scr");
    main.findChild<QAction*>("simulation_raw")->trigger();
    QCOMPARE(main.simulation_windows().windows().size(), std::size_t{1});
    gui::SimulationWindow& window = *main.simulation_windows().windows()[0];
    QVERIFY(wait_for_picture(window));
    // The target stands at 3 km; two pulse lengths of c Tp/2 = 749.48 m around it.
    const picture::EchoView view = picture::view_of(window.window_state());
    QVERIFY(std::abs(view.range_start_m - (3000.0 - 2 * 749.481145)) < 0.5);
    QVERIFY(std::abs(view.range_end_m - (3000.0 + 2 * 749.481145)) < 0.5);
  }

  void the_highest_magnitude_is_that_of_the_thesis() {
    Bench bench;
    QVERIFY(bench.computed);
    QVERIFY2(bench.highest().contains("40.95"), qPrintable(bench.highest()));
    QVERIFY(bench.highest().endsWith(" nV"));
  }

  void a_change_of_the_scene_changes_the_echoes() {
    Bench bench;
    const QString before = bench.highest();
    gui::Session& session = bench.main.session();
    scene::Target target = session.scene().targets.at(0);
    target.rcs_m2 *= 4.0;  // twice the amplitude
    session.perform(scene::replace_object(session.scene(), {scene::ObjectKind::target, 0}, target, "Change"));
    QVERIFY(QTest::qWaitFor([&] { return bench.highest() != before && bench.window->complete(); }, patience_ms));
    QVERIFY2(bench.highest().contains("81.9"), qPrintable(bench.highest()));
  }

  void limits_that_a_mouse_has_drawn_have_few_digits() {
    Bench bench;
    for (const double from : {0.137, 0.211, 0.346, 0.459}) {
      bench.drag(bench.at(from, 0.2), bench.at(from + 0.31, 0.9));
      for (const char* name : {"echo_range_from", "echo_range_to"}) {
        const QString text = bench.window->findChild<QLineEdit*>(name)->text();
        // Kilometres to the millimetre, or metres.
        const QRegularExpression few("^\\d+(\\.\\d{1,6})? (km|m)$");
        QVERIFY2(few.match(text).hasMatch(), qPrintable(text));
      }
      for (const char* name : {"echo_time_from", "echo_time_to"}) {
        const QString text = bench.window->findChild<QLineEdit*>(name)->text();
        const QRegularExpression few("^-?\\d+(\\.\\d{1,9})? (s|ms|us|ns)$");
        QVERIFY2(few.match(text).hasMatch(), qPrintable(text));
      }
      QTest::keyClick(&bench.window->plot(), Qt::Key_Backspace);
    }
  }

  void a_drawn_rectangle_is_zoomed_to_and_backspace_goes_back() {
    Bench bench;
    const picture::EchoView all = picture::view_of(bench.window->window_state());
    bench.drag(bench.at(0.25, 0.5), bench.at(0.75, 1.0));
    const picture::EchoView zoomed = picture::view_of(bench.window->window_state());
    const double width = all.range_end_m - all.range_start_m;
    QVERIFY(std::abs(zoomed.range_start_m - (all.range_start_m + 0.25 * width)) < 0.01 * width);
    QVERIFY(std::abs(zoomed.range_end_m - (all.range_start_m + 0.75 * width)) < 0.01 * width);
    QVERIFY(zoomed.time_start_s > all.time_start_s);
    QVERIFY(wait_for_picture(*bench.window));
    QTest::keyClick(&bench.window->plot(), Qt::Key_Backspace);
    QCOMPARE(picture::view_of(bench.window->window_state()), all);
    bench.window->findChild<QToolButton*>("echo_forward")->click();
    QCOMPARE(picture::view_of(bench.window->window_state()), zoomed);
  }

  void a_right_click_shows_twice_as_much() {
    Bench bench;
    const picture::EchoView all = picture::view_of(bench.window->window_state());
    QTest::mouseClick(&bench.window->plot(), Qt::RightButton, {}, bench.at(0.5, 0.5));
    const picture::EchoView more = picture::view_of(bench.window->window_state());
    const double ratio = (more.range_end_m - more.range_start_m) / (all.range_end_m - all.range_start_m);
    QVERIFY2(std::abs(ratio - 2.0) < 1e-6, qPrintable(QString::number(ratio)));
  }

  void the_wheel_keeps_the_place_below_the_pointer() {
    Bench bench;
    const QPoint at = bench.at(0.3, 0.5);
    const picture::EchoView all = picture::view_of(bench.window->window_state());
    const double before = all.range_start_m + 0.3 * (all.range_end_m - all.range_start_m);
    QWheelEvent turn(at, bench.window->plot().mapToGlobal(at), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(&bench.window->plot(), &turn);
    const picture::EchoView zoomed = picture::view_of(bench.window->window_state());
    const double after = zoomed.range_start_m + 0.3 * (zoomed.range_end_m - zoomed.range_start_m);
    QVERIFY(zoomed.range_end_m - zoomed.range_start_m < 0.7 * (all.range_end_m - all.range_start_m));
    QVERIFY(std::abs(after - before) < 0.005 * (all.range_end_m - all.range_start_m));
  }

  void the_middle_button_moves_the_view() {
    Bench bench;
    const picture::EchoView all = picture::view_of(bench.window->window_state());
    bench.drag(bench.at(0.5, 0.5), bench.at(0.6, 0.5), Qt::MiddleButton);
    const picture::EchoView moved = picture::view_of(bench.window->window_state());
    const double width = all.range_end_m - all.range_start_m;
    QVERIFY(std::abs(all.range_start_m - moved.range_start_m - 0.1 * width) < 0.01 * width);
  }

  void what_is_only_drawn_otherwise_is_not_computed_again() {
    Bench bench;
    const auto matrix = bench.window->plot().matrix();
    auto* const quantity = bench.window->findChild<QComboBox*>("echo_quantity");
    quantity->setCurrentIndex(4);
    emit quantity->activated(4);
    QTest::qWait(50);
    QVERIFY(bench.window->plot().matrix() == matrix);
    QCOMPARE(bench.window->window_state().quantity, picture::DisplayQuantity::decibels);
    QCOMPARE(picture::info_of(bench.window->window_state().map).kind, picture::ColourMapKind::sequential);
  }

  void typed_limits_take_units_and_refuse_nonsense() {
    Bench bench;
    auto* const from = bench.window->findChild<QLineEdit*>("echo_range_from");
    from->setFocus();
    from->selectAll();
    QTest::keyClicks(from, "2.9 km");
    QTest::keyClick(from, Qt::Key_Return);
    QCOMPARE(picture::view_of(bench.window->window_state()).range_start_m, 2900.0);
    const picture::EchoView before = picture::view_of(bench.window->window_state());
    from->selectAll();
    QTest::keyClicks(from, "far");
    QTest::keyClick(from, Qt::Key_Return);
    QCOMPARE(picture::view_of(bench.window->window_state()), before);
    QVERIFY(bench.window->findChild<QWidget*>("echo_problem")->isVisibleTo(bench.window));
  }

  void linked_windows_move_together() {
    Bench bench;
    gui::SimulationWindow* const other = bench.main.simulation_windows().open_new(scene::Processing::matched_filter);
    QVERIFY(wait_for_picture(*other));
    for (gui::SimulationWindow* window : {bench.window, other})
      window->findChild<QAbstractButton*>("echo_link_range")->click();
    const double time_before = picture::view_of(other->window_state()).time_end_s;
    bench.window->go_to({2950.0, 3050.0, 0.0, 0.001});
    QCOMPARE(picture::view_of(other->window_state()).range_start_m, 2950.0);
    QCOMPARE(picture::view_of(other->window_state()).range_end_m, 3050.0);
    QCOMPARE(picture::view_of(other->window_state()).time_end_s, time_before);
  }

  void cursors_tell_their_difference() {
    Bench bench;
    QTest::mouseClick(&bench.window->plot(), Qt::LeftButton, {}, bench.at(0.5, 0.5));
    QTest::mouseClick(&bench.window->plot(), Qt::LeftButton, Qt::ShiftModifier, bench.at(0.6, 0.5));
    auto* const text = bench.window->findChild<QLabel*>("echo_difference");
    const QRect with_words = bench.window->plot().geometry();
    QVERIFY2(text->text().contains("Range") && text->text().contains(" m"), qPrintable(text->text()));
    QTest::keyClick(&bench.window->plot(), Qt::Key_Escape);
    QVERIFY(text->text().isEmpty());
    QCoreApplication::processEvents();
    QCOMPARE(bench.window->plot().geometry(), with_words);  // Finding B7: words move nothing.
  }

  void a_cursor_is_dragged() {
    Bench bench;
    gui::EchoPlot& plot = bench.window->plot();
    QTest::mouseClick(&plot, Qt::LeftButton, {}, bench.at(0.5, 0.5));
    const gui::EchoPlot::Cursor before = *plot.cursor(0);
    QTest::mousePress(&plot, Qt::LeftButton, {}, bench.at(0.5, 0.5));
    QTest::mouseMove(&plot, bench.at(0.6, 0.7));
    QTest::mouseMove(&plot, bench.at(0.7, 0.7));
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, bench.at(0.7, 0.7));
    QVERIFY(plot.cursor(0)->range_m > before.range_m);
    QVERIFY(plot.cursor(0)->time_s != before.time_s);
    // There it is taken hold of again, and put back.
    const gui::EchoPlot::Cursor moved = *plot.cursor(0);
    QTest::mousePress(&plot, Qt::LeftButton, {}, bench.at(0.7, 0.7));
    QTest::mouseMove(&plot, bench.at(0.2, 0.2));
    QVERIFY(plot.cursor(0)->range_m < before.range_m);
    QTest::keyClick(&plot, Qt::Key_Escape);
    QVERIFY(std::abs(plot.cursor(0)->range_m - moved.range_m) < 1e-6 * moved.range_m);
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, bench.at(0.2, 0.2));
  }

  void stored_settings_open_again_exactly() {
    Bench bench;
    bench.window->go_to({2900.0, 3900.0, 0.0, 0.01});
    bench.window->store_simulation();
    const std::size_t last = bench.main.session().scene().simulations.size() - 1;
    gui::SimulationWindow* const again =
        bench.main.simulation_windows().open_stored({scene::ObjectKind::simulation, last});
    QVERIFY(again != nullptr);
    QCOMPARE(again->simulation(), bench.main.session().scene().simulations[last]);
    QCOMPARE(picture::view_of(again->window_state()), picture::view_of(bench.window->window_state()));
  }

  void copied_values_are_the_samples_below_the_cursor() {
    Bench bench;
    bench.window->copy_values();
    const QStringList lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    QCOMPARE(static_cast<std::size_t>(lines.size()), bench.window->plot().matrix()->columns() + 1);
    double largest = 0.0;
    for (const QString& line : lines.mid(1)) largest = std::max(largest, line.split('\t').at(3).toDouble());
    QVERIFY2(std::abs(largest - 4.0957e-8) < 1e-11, qPrintable(QString::number(largest)));
  }

  void the_figure_to_be_saved_shows_the_same_part() {
    Bench bench;
    const picture::Figure figure = bench.window->figure();
    QCOMPARE(figure.panels.size(), std::size_t{1});
    const picture::EchoView view = picture::view_of(bench.window->window_state());
    const double pixel =
        (view.range_end_m - view.range_start_m) / static_cast<double>(bench.window->plot().plot_size().width_px);
    QVERIFY(std::abs(figure.panels[0].x.first - view.range_start_m) < pixel);
    QVERIFY(figure.note.find("40.95") != std::string::npos);
  }

  void a_scene_that_loses_its_radar_is_told_in_words() {
    Bench bench;
    gui::Session& session = bench.main.session();
    session.perform(scene::remove_objects(session.scene(), {{scene::ObjectKind::radar, 0}}));
    QVERIFY(QTest::qWaitFor([&] { return bench.window->plot().matrix() == nullptr; }, patience_ms));
    QVERIFY(bench.window->findChild<QWidget*>("echo_problems")->isVisibleTo(bench.window));
  }
};

const test::AddTest added("simulation_window_test", test::run_test<SimulationWindowTest>);

}  // namespace sarsim::simulation_window_test

#include "simulation_window_test.moc"
