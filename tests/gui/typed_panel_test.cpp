#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "gui/common/appearance.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/property_panel.hpp"
#include "small_scene.hpp"

// What a form shows of the text of format 2: defaults in grey, expressions as they were typed.

namespace sarsim::typed_panel_test {
namespace {

constexpr const char* scene_text = R"toml(format = "sarsim 2"
[let]
a = "30 deg"

[[target]]
position = ["15 km * sin(a)", 20, 0]

[[target]]
position = ["15 km * sin(a)", 30, 0]
rcs = "2 m2"

[[radar]]
pulse = "800 ns"
power = "2 W"
)toml";

struct Bench {
  explicit Bench(const std::string& text = scene_text) {
    QObject::connect(&session, &gui::Session::logged, &session, [this](int, const QString& line) { log += line; });
    session.take(scene::Document::from_text(text));
    panel.resize(420, 900);
    panel.show();
    session.select_only(test::target(0));
  }
  template <class Widget = QLineEdit>
  [[nodiscard]] Widget* field(const char* id) const {
    return panel.findChild<Widget*>(QString("field_%1").arg(id));
  }
  [[nodiscard]] QLabel* result(const char* id) const { return panel.findChild<QLabel*>(QString("result_%1").arg(id)); }
  [[nodiscard]] QAction* reset(const char* id) const { return panel.findChild<QAction*>(QString("reset_%1").arg(id)); }
  [[nodiscard]] QString problem(const char* id) const {
    return panel.findChild<gui::ProblemLine*>(QString("problem_%1").arg(id))->text();
  }
  [[nodiscard]] bool says(const char* words) const {
    return session.document().text().find(words) != std::string::npos;
  }
  void type(const char* id, const char* text) const {
    QLineEdit* edit = field(id);
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
  }

  gui::Session session;
  gui::PropertyPanel panel{session};
  QStringList log;
};

bool is_grey(const QWidget* widget, QPalette::ColorRole role) {
  return widget->palette().color(role) == widget->palette().color(QPalette::PlaceholderText);
}

}  // namespace

class TypedPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { gui::set_appearance(*qApp, gui::Appearance::light); }

  void what_the_text_does_not_say_is_grey() {
    const Bench bench;
    QVERIFY(is_grey(bench.field("rcs_m2"), QPalette::Text));
    QVERIFY(bench.field("rcs_m2")->toolTip().contains("Default"));
    QVERIFY(is_grey(bench.field<QComboBox>("platform"), QPalette::ButtonText));
    QVERIFY(!is_grey(bench.field("position_m.y"), QPalette::Text));
    QVERIFY(!bench.field("position_m.y")->toolTip().contains("Default"));
    bench.type("rcs_m2", "3 m2");
    QVERIFY(!is_grey(bench.field("rcs_m2"), QPalette::Text));
    QVERIFY(!bench.field("rcs_m2")->toolTip().contains("Default"));
  }

  void grey_follows_the_theme() {
    const Bench bench;
    gui::set_appearance(*qApp, gui::Appearance::dark);
    QTRY_COMPARE(bench.field("rcs_m2")->palette().color(QPalette::Text),
                 gui::palette_of(true).color(QPalette::PlaceholderText));
    QCOMPARE(bench.field("position_m.y")->palette().color(QPalette::Text), gui::palette_of(true).color(QPalette::Text));
    gui::set_appearance(*qApp, gui::Appearance::light);
    QTRY_COMPARE(bench.field("rcs_m2")->palette().color(QPalette::Text),
                 gui::palette_of(false).color(QPalette::PlaceholderText));
  }

  void a_script_of_1998_says_all_of_its_fields() {
    Bench bench;
    test::open(bench.session, test::small_scene());
    bench.session.select_only(test::target(0));
    QVERIFY(!is_grey(bench.field("rcs_m2"), QPalette::Text));
    QVERIFY(!bench.reset("rcs_m2")->isVisible());
    bench.type("rcs_m2", "2 * 3 m2");
    QVERIFY(!bench.problem("rcs_m2").isEmpty());
  }

  void the_atmosphere_is_edited_where_nothing_is_selected() {
    Bench bench;
    bench.session.select({});
    QVERIFY(!bench.field("scale_height_m")->isVisible());
    bench.type("rain_mm_per_h", "20");
    QVERIFY(bench.says("[atmosphere]\nrain = { rate = 20 }\n"));
    QCOMPARE(bench.session.scene().atmosphere.rain_mm_per_h, 20.0);
    QCOMPARE(QString::fromStdString(bench.session.document().history().undo_label()), QString("Change rain rate"));
    QTest::keyClicks(bench.field<QComboBox>("refraction"), "E");
    QTRY_COMPARE(bench.session.scene().atmosphere.refraction, scene::Atmosphere::Refraction::exponential);
    QVERIFY(bench.field("scale_height_m")->isVisible());
    bench.type("rain_mm_per_h", "-3");
    QVERIFY(!bench.problem("rain_mm_per_h").isEmpty());
    bench.session.undo();
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
  }

  void a_script_of_1998_has_no_atmosphere() {
    Bench bench;
    test::open(bench.session, test::small_scene());
    bench.session.select({});
    QVERIFY(bench.field("seed")->isVisible());
    QVERIFY(!bench.field("rain_mm_per_h")->isVisible());
  }

  void a_field_goes_back_to_its_default() {
    Bench bench;
    QVERIFY(!bench.reset("rcs_m2")->isVisible());
    bench.session.select_only(test::target(1));
    QVERIFY(bench.reset("rcs_m2")->isVisible());
    bench.reset("rcs_m2")->trigger();
    QVERIFY(!bench.says("rcs"));
    QCOMPARE(bench.field("rcs_m2")->text(), QString("1 m²"));
    QVERIFY(is_grey(bench.field("rcs_m2"), QPalette::Text));
    QVERIFY(!bench.reset("rcs_m2")->isVisible());
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
    QVERIFY(!is_grey(bench.field("rcs_m2"), QPalette::Text));
  }

  void a_default_that_is_said_can_be_taken_out() {
    Bench bench;
    bench.session.select_only(test::target(1));
    bench.type("rcs_m2", "1 m2");
    QVERIFY(bench.says("rcs = \"1 m2\""));
    QVERIFY(!is_grey(bench.field("rcs_m2"), QPalette::Text));
    bench.reset("rcs_m2")->trigger();
    QVERIFY(!bench.says("rcs"));
  }

  void an_expression_stands_with_its_value() {
    const Bench bench;
    QCOMPARE(bench.field("position_m.x")->text(), QString("15 km * sin(a)"));
    QVERIFY(bench.result("position_m.x")->isVisible());
    QCOMPARE(bench.result("position_m.x")->text(), QString("= 7.5 km"));
    QVERIFY(!bench.result("position_m.y")->isVisible());
    QTest::keyClicks(bench.field("position_m.x"), "1");
    QCOMPARE(bench.result("position_m.x")->text(), QString("= …"));
    QTest::keyClick(bench.field("position_m.x"), Qt::Key_Escape);
    QCOMPARE(bench.result("position_m.x")->text(), QString("= 7.5 km"));
  }

  void leaving_a_field_with_an_expression_changes_nothing() {
    const Bench bench;
    bench.field("position_m.x")->setFocus();
    bench.field("position_m.y")->setFocus();
    QTest::keyClick(bench.field("position_m.x"), Qt::Key_Return);
    QVERIFY(!bench.session.document().changed());
  }

  void an_expression_that_is_typed_stands_in_the_text() {
    Bench bench;
    bench.type("position_m.y", "2 km * sin(a)");
    QVERIFY(bench.says("position = [\"15 km * sin(a)\", \"2 km * sin(a)\", 0]"));
    QVERIFY(std::abs(bench.session.scene().targets[0].position_m.y - 1000.0) < 1e-9);
    QCOMPARE(bench.field("position_m.y")->text(), QString("2 km * sin(a)"));
    QCOMPARE(bench.result("position_m.y")->text(), QString("= 1 km"));
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
    QCOMPARE(bench.field("position_m.y")->text(), QString("20 m"));
  }

  void an_expression_of_another_dimension_is_refused() {
    const Bench bench;
    bench.type("position_m.y", "a * 2");
    QVERIFY2(bench.problem("position_m.y").contains("angle"), qPrintable(bench.problem("position_m.y")));
    QCOMPARE(bench.field("position_m.y")->text(), QString("a * 2"));
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
  }

  void a_step_replaces_an_expression_and_tells() {
    Bench bench;
    bench.field("position_m.x")->setFocus();
    bench.log.clear();
    QTest::keyClick(bench.field("position_m.x"), Qt::Key_Up);
    QTest::keyClick(bench.field("position_m.x"), Qt::Key_Up);
    QCOMPARE(bench.field("position_m.x")->text(), QString("7.7 km"));
    QVERIFY(bench.says("[7700, 20, 0]"));
    QCOMPARE(bench.log.size(), 1);
    QVERIFY2(bench.log[0].contains("15 km * sin(a)"), qPrintable(bench.log[0]));
    QVERIFY2(bench.log[0].contains("7.6 km"), qPrintable(bench.log[0]));
    QVERIFY(!bench.result("position_m.x")->isVisible());
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
    QCOMPARE(bench.field("position_m.x")->text(), QString("15 km * sin(a)"));
  }

  void a_number_that_is_typed_over_an_expression_needs_no_note() {
    Bench bench;
    bench.log.clear();
    bench.type("position_m.x", "7500");
    QVERIFY(bench.says("position = [7500, 20, 0]"));
    QVERIFY2(bench.log.isEmpty(), qPrintable(bench.log.join('\n')));
  }

  void several_objects_show_what_they_have_in_common() {
    Bench bench;
    bench.session.select({test::target(0), test::target(1)});
    QCOMPARE(bench.field("position_m.x")->text(), QString("15 km * sin(a)"));
    QVERIFY(is_grey(bench.field("rcs_stddev_m2"), QPalette::Text));
    bench.type("position_m.x", "1 km * cos(a)");
    QCOMPARE(QString::fromStdString(bench.session.document().text()).count("1 km * cos(a)"), 2);
    QVERIFY(bench.reset("rcs_m2")->isVisible());
    bench.reset("rcs_m2")->trigger();
    QVERIFY(!bench.says("rcs"));
    bench.session.undo();
    bench.session.undo();
    QCOMPARE(bench.session.document().text(), std::string(scene_text));
  }

  void the_form_follows_what_is_typed_into_the_text() {
    Bench bench;
    QVERIFY(is_grey(bench.field("rcs_m2"), QPalette::Text));
    std::string text = scene_text;
    bench.session.type_text(text.insert(text.find("[[target]]") + 11, "rcs = \"1 m2\"\n"));
    QVERIFY(!is_grey(bench.field("rcs_m2"), QPalette::Text));
  }
};

const test::AddTest added("typed_panel_test", test::run_test<TypedPanelTest>);

}  // namespace sarsim::typed_panel_test

#include "typed_panel_test.moc"
