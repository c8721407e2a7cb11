#include <QtTest>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <memory>

#include "gui/common/figure_plot.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/live/live_panel.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::live_panel_test {

namespace {

constexpr int patience_ms = 20'000;
using Compare = gui::LivePanel::Compare;

// The R on a window with the image beside the scene.
struct Bench {
  explicit Bench(const char* example = "sar_r") {
    main.resize(1366, 768);
    main.show();
    main.documents().open_file(QString(SARSIM_SOURCE_DIR "/examples/%1.toml").arg(example));
    static_cast<void>(main.window_named("image"));
    panel = main.findChild<gui::LivePanel*>();
    wait();
  }
  // Until the image of the scene as it is is there.
  void wait() const {
    QVERIFY(panel != nullptr);
    QTest::qWait(0);
    QVERIFY(QTest::qWaitFor([&] { return panel->complete(); }, patience_ms));
  }
  void move_target(std::size_t number, double x_m) {
    scene::Target target = main.session().scene().targets.at(number);
    target.position_m.x = x_m;
    main.session().perform(
        scene::replace_object(main.session().scene(), {scene::ObjectKind::target, number}, target, "Move target"));
  }
  void set_prf(double prf_hz) {
    scene::Radar radar = main.session().scene().radars.at(0);
    radar.prf_hz = prf_hz;
    main.session().perform(
        scene::replace_object(main.session().scene(), {scene::ObjectKind::radar, 0}, radar, "Change radar"));
  }
  template <class Widget>
  [[nodiscard]] Widget& part(const char* name) const {
    auto* const found = panel->findChild<Widget*>(name);
    if (found == nullptr) qFatal("no %s", name);
    return *found;
  }

  gui::MainWindow main;
  gui::LivePanel* panel = nullptr;
};

// The share of an image's pixels above a tenth of the largest.
double strong_share(const picture::LiveImage& image) {
  const auto strong = std::ranges::count_if(image.magnitude_v, [&](float v) { return v > 0.1F * image.largest_v; });
  return static_cast<double>(strong) / static_cast<double>(image.magnitude_v.size());
}

}  // namespace

class LivePanelTest : public QObject {
  Q_OBJECT

 private slots:
  void followsADraggedTarget() {
    Bench bench;
    const auto before = bench.panel->image();
    QVERIFY(before != nullptr);
    QCOMPARE(before->product, picture::LiveProduct::focused);
    for (int step = 1; step <= 5; ++step) bench.move_target(0, -190.0 + 10.0 * step);
    bench.wait();
    QVERIFY(bench.panel->image()->magnitude_v != before->magnitude_v);
    // Of one target alone, though five places were passed.
    QVERIFY(bench.panel->image()->cost.echoes <= 10U * 1240U);
    QVERIFY(bench.part<QLabel>("live_state").text().contains("1240 pulses"));
  }

  void showsImagesWhileTheHandGoesOn() {
    Bench bench;
    int images = 0;
    auto last = bench.panel->image();
    // Faster than any image is made.
    for (int step = 0; step < 1000 && images < 3; ++step) {
      bench.move_target(0, -190.0 + 0.1 * step);
      QTest::qWait(3);
      if (bench.panel->image() != last) ++images;
      last = bench.panel->image();
    }
    QCOMPARE(images, 3);
    QVERIFY(!bench.panel->complete());
    bench.wait();
    QVERIFY(!bench.panel->image()->coarse);
  }

  void showsGhostsOfALowPrfAndSaysSo() {
    Bench bench;
    const double alone = strong_share(*bench.panel->image());
    bench.set_prf(150.0);
    bench.wait();
    QVERIFY(strong_share(*bench.panel->image()) > 1.5 * alone);
    QVERIFY(!bench.part<QLabel>("live_problems").text().isEmpty());
    bench.set_prf(620.0);
    bench.wait();
    QCOMPARE(strong_share(*bench.panel->image()), alone);
  }

  void comparesWithTheImageThatWasKept() {
    Bench bench;
    auto& how = bench.part<QComboBox>("live_compare");
    QVERIFY(!how.isEnabled());
    bench.part<QToolButton>("live_keep").click();
    QVERIFY(how.isEnabled());
    bench.move_target(4, 60.0);
    bench.wait();
    auto& before = bench.part<gui::FigurePlot>("live_before");
    bench.panel->compare(Compare::side_by_side);
    QVERIFY(before.isVisible());
    QVERIFY(before.figure() != bench.panel->plot().figure());
    bench.wait();
    bench.panel->compare(Compare::difference);
    QVERIFY(!before.isVisible());
    const auto& bar = bench.panel->plot().figure().panels.at(0).colour_bar;
    QVERIFY(bar && bar->first == -bar->last);
    bench.wait();
    bench.panel->compare(Compare::blink);
    const picture::Figure now = bench.panel->plot().figure();
    QVERIFY(QTest::qWaitFor([&] { return bench.panel->plot().figure() != now; }, patience_ms));
    QVERIFY(bench.part<QLabel>("live_state").text().startsWith("Pinned"));
    bench.panel->compare(Compare::off);
    QVERIFY(bench.panel->plot().figure() == now);
  }

  void eachSceneHasAnImageOfItsOwnToCompareWith() {
    Bench bench;
    bench.panel->keep();
    const auto kept = bench.panel->kept();
    QVERIFY(kept != nullptr);
    bench.main.documents().open_file(QStringLiteral(SARSIM_SOURCE_DIR "/examples/thesis_chapter3.toml"));
    QVERIFY(bench.panel->kept() == nullptr);
    QVERIFY(!bench.part<QComboBox>("live_compare").isEnabled());
    bench.main.session().turn_to(0);
    QVERIFY(bench.panel->kept() == kept);
    bench.wait();
    QVERIFY(bench.part<QComboBox>("live_compare").isEnabled());
    bench.main.session().turn_to(1);
    bench.main.session().close(0);
    QVERIFY(bench.panel->kept() == nullptr);
  }

  void ringsMarkWhereTargetsShouldBe() {
    Bench bench;
    const auto rings = [&] { return bench.panel->plot().figure().panels.at(0).marks; };
    QVERIFY(rings().empty());
    auto& wanted = bench.part<QCheckBox>("live_targets");
    wanted.click();
    bench.wait();
    QCOMPARE(rings().size(), std::size_t{24});
    QVERIFY(rings()[4].ring);
    const double before_m = rings()[4].y;
    bench.move_target(4, 60.0);
    bench.wait();
    QCOMPARE(rings().size(), std::size_t{24});
    QVERIFY2(std::abs(rings()[4].y - before_m) > 20.0, qPrintable(QString::number(rings()[4].y - before_m)));
    wanted.click();
    bench.wait();
    QVERIFY(rings().empty());
  }

  void choicesTakeEffectAtOnce() {
    Bench bench;
    const auto sharp = bench.panel->image();
    auto& window = bench.part<QComboBox>("live_window");
    window.setCurrentText("hamming");
    emit window.activated(window.currentIndex());
    bench.wait();
    QVERIFY(bench.panel->image()->magnitude_v != sharp->magnitude_v);
    QCOMPARE(bench.panel->image()->cost.echoes, std::size_t{0});
    auto& product = bench.part<QComboBox>("live_product");
    product.setCurrentIndex(4);
    emit product.activated(4);
    bench.wait();
    QCOMPARE(bench.panel->image()->product, picture::LiveProduct::doppler);
    QVERIFY(!bench.part<QComboBox>("live_algorithm").isEnabled());
  }

  void saysWhyThereIsNoImageAndComesBack() {
    Bench bench;
    bench.main.session().perform(scene::remove_objects(bench.main.session().scene(), {{scene::ObjectKind::radar, 0}}));
    bench.wait();
    QVERIFY(bench.panel->image() == nullptr);
    QVERIFY(bench.part<QLabel>("live_problems").text().contains("Radar1") ||
            bench.part<QLabel>("live_problems").text().contains("No recording"));
    bench.main.session().undo();
    bench.wait();
    QVERIFY(bench.panel->image() != nullptr);
  }

  void opensAllSamplesInAViewerAndCopiesTheCommand() {
    Bench bench;
    QSignalSpy opened(bench.panel, &gui::LivePanel::opened);
    bench.panel->findChild<QAction*>("live_open")->trigger();
    QVERIFY(opened.wait(patience_ms));
    QCOMPARE(bench.main.image_viewers().viewers().size(), std::size_t{1});
    bench.panel->copy_command();
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("sarsim focus sar_r.toml"));
  }

  void isNarrowAndKeepsItsHeights() {
    Bench bench("thesis_chapter3");
    QVERIFY(bench.panel->minimumSizeHint().width() <= 300);
    const int state = bench.part<QLabel>("live_state").height();
    const int problems = bench.part<QLabel>("live_problems").height();
    bench.part<QLabel>("live_state").setText(QString(300, 'x'));
    bench.part<QLabel>("live_problems").setText(QString(300, 'x') + QString(300, ' '));
    QTest::qWait(20);
    QCOMPARE(bench.part<QLabel>("live_state").height(), state);
    QCOMPARE(bench.part<QLabel>("live_problems").height(), problems);
    QVERIFY(bench.panel->minimumSizeHint().width() <= 300);
  }
};

const test::AddTest added("live_panel_test", test::run_test<LivePanelTest>);

}  // namespace sarsim::live_panel_test

#include "live_panel_test.moc"
