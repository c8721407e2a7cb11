#include <QtTest>

#include <QClipboard>
#include <QComboBox>
#include <QMenu>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <cmath>

#include "gui/common/figure_plot.hpp"
#include "gui/echo/radar_view_window.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::radar_views_window_test {

namespace {

constexpr int patience_ms = 20'000;

// The example of chapter 3: a target at 3 km; raw echoes, computed.
struct Bench {
  Bench() {
    main.documents().open_file(SARSIM_SOURCE_DIR "/examples/thesis_chapter3.scr");
    window = main.simulation_windows().open_new(scene::Processing::raw);
    window->resize(900, 600);
    QTest::qWait(50);
    shown = QTest::qWaitFor([&] { return window->complete(); }, patience_ms);
  }
  gui::RadarViewWindow& open(picture::RadarView kind) const {
    gui::RadarViewWindow& view = *window->open_radar_view(kind);
    if (!wait_for(view)) qFatal("the view was not computed");
    return view;
  }
  static bool wait_for(gui::RadarViewWindow& view) {
    return QTest::qWaitFor([&] { return view.complete(); }, patience_ms);
  }

  gui::MainWindow main;
  gui::SimulationWindow* window = nullptr;
  bool shown = false;
};

double highest(const picture::FigureCurve& curve) { return *std::ranges::max_element(curve.y); }

}  // namespace

class RadarViewsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void the_views_button_opens_each_view() {
    Bench bench;
    QVERIFY(bench.shown);
    QMenu* const menu = bench.window->findChild<QToolButton*>("echo_views")->menu();
    QCOMPARE(menu->actions().size(), 5);
    for (QAction* action : menu->actions()) action->trigger();
    const auto views = bench.window->findChildren<gui::RadarViewWindow*>();
    QCOMPARE(views.size(), 5);
    for (gui::RadarViewWindow* view : views) {
      QVERIFY(Bench::wait_for(*view));
      QVERIFY2(!view->plot().figure().panels.empty(), qPrintable(view->windowTitle()));
      QVERIFY(view->windowTitle().contains("Radar"));
    }
  }

  void a_range_profile_begins_at_the_range_of_the_target() {
    Bench bench;
    gui::RadarViewWindow& view = bench.open(picture::RadarView::range_profile);
    picture::RadarViewChoice choice = view.choice();
    choice.decibels = false;
    view.set_choice(choice);
    QVERIFY(Bench::wait_for(view));
    const picture::FigureCurve& curve = view.plot().figure().panels.at(0).curves.at(0);
    const double half = 0.5 * highest(curve);
    const auto first = std::ranges::find_if(curve.y, [&](double y) { return y > half; });
    const double range_m = curve.x[static_cast<std::size_t>(first - curve.y.begin())];
    QVERIFY2(std::abs(range_m - 3000.0) < 5.0, qPrintable(QString::number(range_m)));
    QVERIFY(std::abs(highest(curve) - 4.0957e-8) < 1e-11);
  }

  void a_view_follows_the_scene() {
    Bench bench;
    gui::RadarViewWindow& view = bench.open(picture::RadarView::range_profile);
    const double before_db = highest(view.plot().figure().panels.at(0).curves.at(0));
    gui::Session& session = bench.main.session();
    scene::Target target = session.scene().targets.at(0);
    target.rcs_m2 *= 4.0;
    session.perform(scene::replace_object(session.scene(), {scene::ObjectKind::target, 0}, target, "Change"));
    QVERIFY(!view.complete());
    QVERIFY(Bench::wait_for(view));
    const double after_db = highest(view.plot().figure().panels.at(0).curves.at(0));
    QVERIFY(std::abs(after_db - before_db - 20.0 * std::log10(2.0)) < 1e-6);
  }

  void a_view_follows_the_cursor() {
    Bench bench;
    gui::RadarViewWindow& view = bench.open(picture::RadarView::phase_history);
    bench.window->plot().set_cursor(0, gui::EchoPlot::Cursor{3100.0, 0.004});
    QVERIFY(!view.complete());
    QVERIFY(Bench::wait_for(view));
    QCOMPARE(view.choice().range_m, 3100.0);
    QVERIFY2(view.plot().figure().note.find("Range 3.1") != std::string::npos ||
                 view.plot().figure().note.find("Range 3.09") != std::string::npos,
             view.plot().figure().note.c_str());
  }

  void each_view_offers_its_own_choices() {
    Bench bench;
    gui::RadarViewWindow& view = bench.open(picture::RadarView::range_profile);
    QVERIFY(view.findChild<QWidget*>("radar_view_mean")->isVisibleTo(&view));
    QVERIFY(!view.findChild<QWidget*>("radar_view_unwrapped")->isVisibleTo(&view));
    auto* const kind = view.findChild<QComboBox*>("radar_view_kind");
    kind->setCurrentIndex(2);
    emit kind->activated(2);
    QCOMPARE(view.choice().view, picture::RadarView::doppler_time);
    QCOMPARE(view.choice().pulses, std::size_t{1024});
    QVERIFY(view.findChild<QWidget*>("radar_view_interval")->isVisibleTo(&view));
    view.findChild<QSpinBox*>("radar_view_interval")->setValue(4);
    QVERIFY(Bench::wait_for(view));
    QVERIFY(view.plot().figure().panels.at(0).image);
    QVERIFY2(view.plot().figure().note.find("spectra of 4 of ") != std::string::npos,
             view.plot().figure().note.c_str());
    kind->setCurrentIndex(4);
    emit kind->activated(4);
    QVERIFY(!view.findChild<QWidget*>("radar_view_interval")->isVisibleTo(&view));
    QCOMPARE(view.choice().view, picture::RadarView::phase_history);
    QVERIFY(!view.findChild<QWidget*>("radar_view_mean")->isVisibleTo(&view));
    QVERIFY(view.findChild<QWidget*>("radar_view_unwrapped")->isVisibleTo(&view));
    view.findChild<QSpinBox*>("radar_view_pulses")->setValue(3);
    QVERIFY(Bench::wait_for(view));
    QCOMPARE(view.plot().figure().panels.at(0).curves.at(0).x.size(), std::size_t{3});
  }

  void values_go_to_the_clipboard_and_to_a_file() {
    Bench bench;
    gui::RadarViewWindow& view = bench.open(picture::RadarView::spectrum);
    view.copy_values();
    const QStringList lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    QCOMPARE(static_cast<std::size_t>(lines.size()), view.plot().figure().panels.at(0).curves.at(0).x.size() + 1);
    QVERIFY(lines[0].contains("Frequency from the carrier [Hz]\t"));
    const QTemporaryDir folder;
    view.save_values(folder.filePath("spectrum.csv"));
    QFile file(folder.filePath("spectrum.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(QString(file.readAll()), QApplication::clipboard()->text().replace('\t', ','));
    view.save_picture(folder.filePath("spectrum.png"));
    QVERIFY(!QImage(folder.filePath("spectrum.png")).isNull());
    view.copy_picture();
    QVERIFY(!QApplication::clipboard()->image().isNull());
  }

  void what_stands_in_the_way_is_told_in_words() {
    Bench bench;
    gui::RadarViewWindow& view = bench.open(picture::RadarView::range_doppler);
    gui::Session& session = bench.main.session();
    session.perform(scene::remove_objects(session.scene(), {{scene::ObjectKind::radar, 0}}));
    QVERIFY(Bench::wait_for(view));
    QVERIFY(view.findChild<QWidget*>("radar_view_problems")->isVisibleTo(&view));
    QVERIFY(view.plot().figure().panels.empty());
  }

  void a_view_ends_with_its_window() {
    Bench bench;
    const QPointer<gui::RadarViewWindow> view = &bench.open(picture::RadarView::spectrum);
    bench.window->close();
    QTRY_VERIFY(view.isNull());
  }
};

const test::AddTest added("radar_views_window_test", test::run_test<RadarViewsWindowTest>);

}  // namespace sarsim::radar_views_window_test

#include "radar_views_window_test.moc"
