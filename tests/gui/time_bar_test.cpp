#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <limits>

#include "gui/gui_test.hpp"
#include "gui/scene/time_bar.hpp"

namespace sarsim::time_bar_test {
namespace {

struct Bench {
  Bench() {
    bar.resize(900, 40);
    bar.show();
  }
  template <class Widget>
  [[nodiscard]] Widget* get(const char* name) const {
    return bar.findChild<Widget*>(QLatin1String(name));
  }
  void type(const char* name, const QString& text) const {
    auto* field = get<QLineEdit>(name);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  }

  gui::TimeBar bar;
};

}  // namespace

class TimeBarTest : public QObject {
  Q_OBJECT

 private slots:
  void its_buttons_can_be_seen_on_any_ground_data() {
    QTest::addColumn<QColor>("ink");
    QTest::newRow("light") << QColor(20, 20, 20);
    QTest::newRow("dark") << QColor(235, 235, 235);
  }
  void its_buttons_can_be_seen_on_any_ground() {
    QFETCH(QColor, ink);
    Bench bench;
    QPalette palette = bench.bar.palette();
    palette.setColor(QPalette::ButtonText, ink);
    bench.bar.setPalette(palette);
    QApplication::processEvents();
    for (const char* name : {"earlier_button", "play_button", "later_button"}) {
      const QImage picture = bench.get<QToolButton>(name)->icon().pixmap(16, 16).toImage();
      int drawn = 0;
      for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
          const QColor pixel = picture.pixelColor(x, y);
          if (pixel.alpha() < 255) continue;
          ++drawn;
          QVERIFY2(std::abs(pixel.lightness() - ink.lightness()) < 8, name);
        }
      QVERIFY2(drawn > 0, name);
    }
  }

  void every_part_has_its_name_and_is_spoken() {
    const Bench bench;
    QCOMPARE(bench.bar.objectName(), QString("time_bar"));
    for (const char* name :
         {"time_field", "earlier_button", "later_button", "play_button", "step_field", "speed_box", "scrubber"}) {
      const auto* part = bench.get<QWidget>(name);
      QVERIFY2(part != nullptr, name);
      QVERIFY2(!part->accessibleName().isEmpty(), name);
    }
    QCOMPARE(bench.get<QToolButton>("earlier_button")->text(), QString("Earlier"));
    QCOMPARE(bench.get<QToolButton>("later_button")->text(), QString("Later"));
  }

  void time_takes_any_unit() {
    Bench bench;
    QSignalSpy changed(&bench.bar, &gui::TimeBar::time_changed);
    bench.type("time_field", "5 ms");
    QCOMPARE(bench.bar.time_s(), 0.005);
    bench.type("time_field", "-2");
    QCOMPARE(bench.bar.time_s(), -2.0);
    QCOMPARE(changed.size(), 2);
    QCOMPARE(changed[0][0].toDouble(), 0.005);
  }

  void time_can_be_typed_as_utc_where_there_is_an_epoch() {
    Bench bench;
    const auto epoch = radar::parse_instant("2026-05-01T12:00:00Z", radar::TimeScale::utc);
    bench.bar.set_epoch(epoch.instant);
    bench.type("time_field", "2026-05-01T12:00:12.5Z");
    QCOMPARE(bench.bar.time_s(), 12.5);
    QCOMPARE(bench.get<QLabel>("utc_label")->text(), QString("12:00:12.500 UTC"));
    QVERIFY(bench.get<QLabel>("utc_label")->toolTip().endsWith("2026-05-01T12:00:12.5Z"));
    bench.type("time_field", "2026-05-01 11:59:59");
    QCOMPARE(bench.bar.time_s(), -1.0);
    bench.type("time_field", "2026-13-01T12:00:00Z");
    QCOMPARE(bench.bar.time_s(), -1.0);
    QVERIFY(bench.get<QLineEdit>("time_field")->property("refused").toBool());
    bench.type("time_field", "2 s");
    QCOMPARE(bench.bar.time_s(), 2.0);
    bench.bar.set_epoch(std::nullopt);
    bench.type("time_field", "2026-05-01T12:00:12.5Z");
    QCOMPARE(bench.bar.time_s(), 2.0);
  }

  void text_that_is_no_time_is_refused_and_kept() {
    Bench bench;
    bench.bar.set_time(0.25);
    bench.type("time_field", "soon");
    QCOMPARE(bench.bar.time_s(), 0.25);
    auto* field = bench.get<QLineEdit>("time_field");
    QCOMPARE(field->text(), QString("soon"));
    QVERIFY(field->property("refused").toBool());
    QVERIFY(!field->accessibleDescription().isEmpty());
    bench.type("time_field", "0.5 s");
    QVERIFY(!field->property("refused").toBool());
    QCOMPARE(bench.bar.time_s(), 0.5);
  }

  void earlier_and_later_go_one_step_without_gathering_digits() {
    Bench bench;
    for (int i = 0; i < 3; ++i) bench.get<QToolButton>("later_button")->click();
    QCOMPARE(bench.bar.time_s(), 0.3);  // exactly, where 0.1 + 0.1 + 0.1 is not
    QVERIFY(bench.bar.time_s() == 0.3);
    for (int i = 0; i < 3; ++i) bench.get<QToolButton>("earlier_button")->click();
    QVERIFY(bench.bar.time_s() == 0.0);
    bench.type("step_field", "2 ms");
    QCOMPARE(bench.bar.step_s(), 0.002);
    bench.get<QToolButton>("earlier_button")->click();
    QVERIFY(bench.bar.time_s() == -0.002);
  }

  void negative_step_is_refused() {
    Bench bench;
    bench.type("step_field", "-1 s");
    QCOMPARE(bench.bar.step_s(), 0.1);
    QVERIFY(bench.get<QLineEdit>("step_field")->property("refused").toBool());
    bench.type("step_field", "0");
    QCOMPARE(bench.bar.step_s(), 0.0);
    bench.bar.later();
    QCOMPARE(bench.bar.time_s(), 0.0);
  }

  void held_buttons_step_ten_times_a_second() {
    Bench bench;
    auto* later = bench.get<QToolButton>("later_button");
    QVERIFY(later->autoRepeat());
    QCOMPARE(later->autoRepeatInterval(), 100);
    QTest::mousePress(later, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(bench.bar.time_s() > 0.25, 5000);
    QTest::mouseRelease(later, Qt::LeftButton);
  }

  void scrubber_runs_over_the_span() {
    Bench bench;
    bench.bar.set_span(-10.0, 30.0);
    auto* scrubber = bench.get<QSlider>("scrubber");
    scrubber->setValue(scrubber->maximum());
    QCOMPARE(bench.bar.time_s(), 30.0);
    scrubber->setValue(scrubber->maximum() / 4);
    QVERIFY(std::abs(bench.bar.time_s()) < 1e-9);
    bench.bar.set_time(10.0);
    QCOMPARE(scrubber->value(), scrubber->maximum() / 2);
  }

  void times_beyond_the_span_are_kept() {
    Bench bench;
    bench.bar.set_span(0.0, 1.0);
    bench.bar.set_time(7.0);
    QCOMPARE(bench.bar.time_s(), 7.0);
    auto* scrubber = bench.get<QSlider>("scrubber");
    QCOMPARE(scrubber->value(), scrubber->maximum());
  }

  void what_is_no_number_is_passed_over() {
    Bench bench;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QSignalSpy changed(&bench.bar, &gui::TimeBar::time_changed);
    bench.bar.set_time(nan);
    bench.bar.set_span(2.0, 1.0);
    bench.bar.set_span(nan, 1.0);
    bench.bar.set_step(-1.0);
    QCOMPARE(changed.size(), 0);
    QCOMPARE(bench.bar.span_s()[1], 1.0);
    QCOMPARE(bench.bar.step_s(), 0.1);
  }

  void the_same_time_is_not_announced_again() {
    Bench bench;
    QSignalSpy changed(&bench.bar, &gui::TimeBar::time_changed);
    bench.bar.set_time(0.5);
    bench.bar.set_time(0.5);
    QCOMPARE(changed.size(), 1);
  }

  void playing_runs_to_the_end_and_stops() {
    Bench bench;
    bench.bar.set_span(0.0, 0.2);
    QSignalSpy playing(&bench.bar, &gui::TimeBar::playing_changed);
    QSignalSpy changed(&bench.bar, &gui::TimeBar::time_changed);
    QElapsedTimer clock;
    clock.start();
    bench.get<QToolButton>("play_button")->click();
    QVERIFY(bench.bar.playing());
    QCOMPARE(bench.get<QToolButton>("play_button")->text(), QString("Stop"));
    QTRY_VERIFY_WITH_TIMEOUT(!bench.bar.playing(), 10000);
    QVERIFY(clock.elapsed() >= 200);
    QCOMPARE(bench.bar.time_s(), 0.2);
    QCOMPARE(playing.size(), 2);
    for (qsizetype i = 1; i < changed.size(); ++i) QVERIFY(changed[i][0].toDouble() > changed[i - 1][0].toDouble());
    bench.get<QToolButton>("play_button")->click();
    QVERIFY(bench.bar.time_s() < 0.2);  // again from the beginning
    bench.bar.set_playing(false);
  }

  void playing_in_a_loop_stays_within_the_span() {
    Bench bench;
    bench.bar.set_span(1.0, 2.0);
    bench.bar.set_time(1.0);
    bench.get<QComboBox>("speed_box")->setCurrentText("x20");
    QCOMPARE(bench.bar.speed(), 20.0);
    bench.get<QCheckBox>("loop_box")->setChecked(true);
    QSignalSpy changed(&bench.bar, &gui::TimeBar::time_changed);
    bench.bar.set_playing(true);
    QTRY_VERIFY_WITH_TIMEOUT(changed.size() >= 8, 10000);
    QVERIFY(bench.bar.playing());
    bench.bar.set_playing(false);
    for (const auto& arguments : changed) {
      QVERIFY(arguments[0].toDouble() >= 1.0);
      QVERIFY(arguments[0].toDouble() <= 2.0);
    }
  }

  void moving_the_time_while_it_runs_runs_on_from_there() {
    Bench bench;
    bench.bar.set_span(0.0, 1000.0);
    bench.bar.set_playing(true);
    QTest::qWait(60);
    bench.bar.set_time(500.0);
    QTest::qWait(120);
    QVERIFY(bench.bar.time_s() > 500.0);
    QVERIFY(bench.bar.time_s() < 600.0);
    bench.bar.set_playing(false);
  }

  void what_is_being_typed_stays_while_the_time_runs() {
    Bench bench;
    bench.bar.activateWindow();
    auto* field = bench.get<QLineEdit>("time_field");
    field->setFocus();
    QTRY_VERIFY(field->hasFocus());
    field->selectAll();
    QTest::keyClicks(field, "0.7");
    bench.bar.set_time(0.1);
    QCOMPARE(field->text(), QString("0.7"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(bench.bar.time_s(), 0.7);
  }
};

const test::AddTest added("time_bar_test", test::run_test<TimeBarTest>);

}  // namespace sarsim::time_bar_test

#include "time_bar_test.moc"
