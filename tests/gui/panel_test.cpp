#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>

#include "gui/common/field_editor.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/property_panel.hpp"
#include "picture/facts/display_text.hpp"
#include "scene/language/recorded_text.hpp"
#include "scene/script/reader.hpp"
#include "small_scene.hpp"
#include "support/processor_time.hpp"

namespace sarsim::panel_test {
namespace {

const std::vector<scene::ObjectKind> all_kinds{scene::ObjectKind::platform,   scene::ObjectKind::target,
                                               scene::ObjectKind::surface,    scene::ObjectKind::radar,
                                               scene::ObjectKind::simulation, scene::ObjectKind::geometry};

// A session with the small scene and a panel that shows it.
struct Bench {
  Bench() { start(test::small_scene()); }
  explicit Bench(const scene::Scene& scene) { start(scene); }
  void start(const scene::Scene& scene) {
    test::open(session, scene);
    panel.resize(400, 900);
    panel.show();
  }

  [[nodiscard]] QWidget* field(const std::string& id) const {
    return panel.findChild<QWidget*>(QString::fromStdString("field_" + id));
  }
  [[nodiscard]] QLineEdit* line(const std::string& id) const { return qobject_cast<QLineEdit*>(field(id)); }
  [[nodiscard]] QString problem(const std::string& id) const {
    return panel.findChild<gui::ProblemLine*>(QString::fromStdString("problem_" + id))->text();
  }
  [[nodiscard]] QString title() const { return panel.findChild<QLabel*>("panel_title")->text(); }
  // As a user does: marks everything, types, presses Enter.
  void type(const std::string& id, const QString& text, bool enter = true) const {
    QLineEdit* edit = line(id);
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    if (enter) QTest::keyClick(edit, Qt::Key_Return);
  }
  [[nodiscard]] const scene::Radar& radar() const { return session.scene().radars.front(); }

  gui::Session session;
  gui::PropertyPanel panel{session};
};

// Objects of a kind among which every field means something: the first one and all that its choices lead to.
std::vector<scene::AnyObject> variants(const scene::AnyObject& first) {
  std::vector<scene::AnyObject> found{first};
  for (std::size_t i = 0; i < found.size() && found.size() < 200; ++i)
    for (const scene::Field& field : scene::fields_of(scene::kind_of(first))) {
      std::vector<std::string> values = field.choices;
      if (field.kind == scene::FieldKind::check) values = {"yes", "no"};
      for (const std::string& value : values) {
        scene::AnyObject other = found[i];
        if (!scene::field_applies(other, field.id) || !scene::set_field(other, field.id, value).empty()) continue;
        // One choice away from the first is enough, but what a choice opens may hold another one.
        const bool opens = std::ranges::any_of(scene::fields_of(scene::kind_of(first)), [&](const scene::Field& f) {
          return std::ranges::none_of(found,
                                      [&](const scene::AnyObject& o) { return scene::field_applies(o, f.id); }) &&
                 scene::field_applies(other, f.id);
        });
        if (opens) found.push_back(other);
      }
    }
  return found;
}

const std::vector<std::string>& typed_values(scene::Quantity quantity) {
  static const std::map<scene::Quantity, std::vector<std::string>> values{
      {scene::Quantity::number, {"0.25", "2"}}, {scene::Quantity::length, {"3.25 km"}},
      {scene::Quantity::time, {"0.3 us"}},      {scene::Quantity::frequency, {"75 MHz"}},
      {scene::Quantity::angle, {"12.5 deg"}},   {scene::Quantity::angle_rate, {"3 rpm"}},
      {scene::Quantity::area, {"2.5 m2"}},      {scene::Quantity::power, {"2 kW"}},
      {scene::Quantity::ratio_db, {"3 dB"}},    {scene::Quantity::temperature, {"290 K"}},
      {scene::Quantity::voltage, {"2 mV"}},     {scene::Quantity::count, {"5", "3"}}};
  return values.at(quantity);
}

// What to enter into a field to give it another value.
template <class Object>
std::string another_value(const Object& object, const scene::Field& field) {
  std::vector<std::string> candidates = field.choices;
  if (field.kind == scene::FieldKind::quantity) candidates = typed_values(field.quantity);
  if (field.kind == scene::FieldKind::check) candidates = {"yes", "no"};
  if (field.kind == scene::FieldKind::text) candidates = {"Another1"};
  if (field.kind == scene::FieldKind::platform) candidates = {"Ship", "Earth"};
  if (field.kind == scene::FieldKind::radar) candidates = {"Radar2", "Radar1"};
  for (const std::string& text : candidates) {
    Object changed = object;
    if (scene::set_field(changed, field.id, text).empty() && changed != object) return text;
  }
  return {};
}

void enter(QWidget* widget, const std::string& text) {
  const QString value = QString::fromStdString(text);
  if (auto* edit = qobject_cast<QLineEdit*>(widget)) {
    edit->selectAll();
    QTest::keyClicks(edit, value);
    QTest::keyClick(edit, Qt::Key_Return);
  } else if (auto* box = qobject_cast<QComboBox*>(widget)) {
    box->setCurrentIndex(box->findText(value));
  } else if (auto* check = qobject_cast<QCheckBox*>(widget)) {
    check->click();
  }
}

std::string shown_in(const QWidget* widget) {
  if (const auto* edit = qobject_cast<const QLineEdit*>(widget)) return edit->text().toStdString();
  if (const auto* box = qobject_cast<const QComboBox*>(widget)) return box->currentText().toStdString();
  if (const auto* check = qobject_cast<const QCheckBox*>(widget)) return check->isChecked() ? "yes" : "no";
  return {};
}

scene::Scene scene_with(const scene::AnyObject& object) {
  scene::Scene scene = test::small_scene();
  switch (scene::kind_of(object)) {
    case scene::ObjectKind::platform: scene.platforms[1] = std::get<scene::Platform>(object); break;
    case scene::ObjectKind::target: scene.targets[0] = std::get<scene::Target>(object); break;
    case scene::ObjectKind::cloud: scene.clouds.assign(1, std::get<scene::Cloud>(object)); break;
    case scene::ObjectKind::surface: scene.surfaces[0] = std::get<scene::Surface>(object); break;
    case scene::ObjectKind::radar: scene.radars[1] = std::get<scene::Radar>(object); break;
    case scene::ObjectKind::simulation: scene.simulations[0] = std::get<scene::Simulation>(object); break;
    case scene::ObjectKind::geometry: scene.geometries[0] = std::get<scene::GeometryTable>(object); break;
  }
  return scene;
}

scene::ObjectId place_of(scene::ObjectKind kind) {
  return {kind,
          kind == scene::ObjectKind::platform || kind == scene::ObjectKind::radar ? std::size_t{1} : std::size_t{0}};
}

// Gives a field of the object another value through its widget; the scene, the script and undo must agree.
void round_trip(const scene::AnyObject& object, const scene::Field& field) {
  const std::string where = std::string(scene::name_of(scene::kind_of(object))) + " " + field.id;
  const Bench bench_object(scene_with(object));
  auto& bench = const_cast<Bench&>(bench_object);
  const scene::ObjectId id = place_of(scene::kind_of(object));
  QVERIFY2(scene::object_of(bench.session.scene(), id) == object, where.c_str());
  bench.session.select_only(id);
  QWidget* widget = bench.field(field.id);
  QVERIFY2(widget != nullptr, where.c_str());
  QVERIFY2(bench.panel.focus_field(QString::fromStdString(field.id)), where.c_str());
  QVERIFY2(widget->isVisible(), where.c_str());
  QVERIFY2(!widget->accessibleName().isEmpty() && !widget->toolTip().isEmpty(), where.c_str());
  if (field.kind == scene::FieldKind::function) {
    QSignalSpy wanted(&bench.panel, &gui::PropertyPanel::function_requested);
    QTest::qWait(1);
    QTest::mouseClick(widget, Qt::LeftButton);
    QCOMPARE(wanted.size(), 1);
    QCOMPARE(wanted[0][1].toString().toStdString(), field.id);
    return;
  }
  QCOMPARE(shown_in(widget), picture::display_text(scene::field_text(object, field.id)));
  const std::string value = another_value(object, field);
  QVERIFY2(!value.empty(), where.c_str());
  const scene::Scene before = bench.session.scene();
  const std::string text_before = bench.session.document().text();
  scene::AnyObject expected = object;
  QCOMPARE(scene::set_field(expected, field.id, value), std::string());

  enter(widget, value);
  QVERIFY2(scene::object_of(bench.session.scene(), id) == expected, where.c_str());
  QCOMPARE(shown_in(widget), picture::display_text(scene::field_text(expected, field.id)));
  const scene::ScriptReading reading = scene::read_script(bench.session.document().text(), "test.scr", {});
  QVERIFY2(reading.scene == bench.session.scene(), where.c_str());
  bench.session.undo();
  QVERIFY2(bench.session.scene() == before, where.c_str());
  QCOMPARE(bench.session.document().text(), text_before);
  QCOMPARE(shown_in(widget), picture::display_text(scene::field_text(object, field.id)));
}

}  // namespace

class PanelTest : public QObject {
  Q_OBJECT

 private slots:
  void every_field_of_every_kind_goes_to_the_script_and_back() {
    for (const scene::ObjectKind kind : all_kinds) {
      const std::vector<scene::AnyObject> objects = variants(scene::object_of(test::small_scene(), place_of(kind)));
      for (const scene::Field& field : scene::fields_of(kind)) {
        if (field.spec->since_2) continue;  // no script says it
        const auto holder = std::ranges::find_if(objects, [&](const scene::AnyObject& object) {
          return scene::field_applies(object, field.id) && scene::fits_script(object);
        });
        QVERIFY2(holder != objects.end(), field.id.c_str());
        round_trip(*holder, field);
        if (QTest::currentTestFailed()) return;
      }
    }
  }

  void options_go_to_the_script_and_back() {
    Bench bench;
    QCOMPARE(bench.title(), QString("World, options and atmosphere"));
    for (const scene::Field& field : scene::option_fields()) {
      const scene::RunOptions before = bench.session.scene().options;
      scene::RunOptions expected = before;
      const std::string value = field.id == "tolerance" ? "1e-5" : another_value(before, field);
      QCOMPARE(scene::set_field(expected, field.id, value), std::string());
      enter(bench.field(field.id), value);
      QVERIFY2(bench.session.scene().options == expected, field.id.c_str());
      QVERIFY(scene::read_script(bench.session.document().text(), "test.scr", {}).scene == bench.session.scene());
      bench.session.undo();
      QVERIFY2(bench.session.scene().options == before, field.id.c_str());
    }
  }

  void a_number_may_be_typed_with_any_unit() {
    Bench bench;
    bench.session.select_only(test::radar(0));
    bench.type("carrier_hz", "5300 MHz");
    QCOMPARE(bench.radar().carrier_hz, 5.3e9);
    QCOMPARE(bench.line("carrier_hz")->text(), QString("5.3 GHz"));
    bench.type("pulse_width_s", "3000ns");
    QCOMPARE(bench.radar().pulse_width_s, 3e-6);
    QCOMPARE(QString::fromStdString(bench.session.document().history().undo_label()), QString("Change pulse width"));
  }

  void a_bad_text_stays_and_is_explained() {
    Bench bench;
    bench.session.select_only(test::radar(0));
    const scene::Scene before = bench.session.scene();
    bench.type("pulse_width_s", "5 kg");
    QVERIFY(bench.session.scene() == before);
    QVERIFY(!bench.session.document().history().can_undo());
    QLineEdit* edit = bench.line("pulse_width_s");
    QCOMPARE(edit->text(), QString("5 kg"));
    QVERIFY2(bench.problem("pulse_width_s").startsWith("Error: '5 kg' is not a valid time"),
             qPrintable(bench.problem("pulse_width_s")));
    QVERIFY(edit->accessibleDescription().contains("5 kg"));
    QVERIFY(edit->palette().color(QPalette::Text) != bench.panel.palette().color(QPalette::Text));

    // Other changes of the scene leave it alone.
    bench.session.set_time(1.0);
    bench.type("prf_hz", "2 kHz");
    QCOMPARE(edit->text(), QString("5 kg"));

    // While it is mended, the sentence goes as soon as the text is good.
    edit->setFocus();
    QTest::keyClick(edit, Qt::Key_Backspace);
    QTest::keyClick(edit, Qt::Key_Backspace);
    QVERIFY(bench.problem("pulse_width_s").isEmpty());
    QTest::keyClicks(edit, "us");
    QTest::keyClick(edit, Qt::Key_Return);
    QCOMPARE(bench.radar().pulse_width_s, 5e-6);
    QCOMPARE(edit->palette().color(QPalette::Text), bench.panel.palette().color(QPalette::Text));
  }

  void escape_restores() {
    Bench bench;
    bench.session.select_only(test::radar(0));
    bench.type("prf_hz", "nonsense");
    QVERIFY(!bench.problem("prf_hz").isEmpty());
    QTest::keyClick(bench.line("prf_hz"), Qt::Key_Escape);
    QCOMPARE(bench.line("prf_hz")->text(), QString("1 kHz"));
    QVERIFY(bench.problem("prf_hz").isEmpty());
    bench.type("prf_hz", "3 kHz", false);
    QTest::keyClick(bench.line("prf_hz"), Qt::Key_Escape);
    QCOMPARE(bench.line("prf_hz")->text(), QString("1 kHz"));
    QVERIFY(!bench.session.document().history().can_undo());
  }

  void leaving_a_field_applies_it() {
    Bench bench;
    bench.session.select_only(test::radar(0));
    QVERIFY(QTest::qWaitForWindowActive(&bench.panel));
    bench.type("prf_hz", "3 kHz", false);
    QTest::keyClick(bench.line("prf_hz"), Qt::Key_Tab);
    QCOMPARE(bench.radar().prf_hz, 3000.0);
  }

  void selecting_something_else_applies_what_was_typed_to_the_old_object() {
    Bench bench;
    bench.session.select_only(test::target(0));
    bench.type("rcs_m2", "7 m2", false);
    bench.session.select_only(test::target(1));
    QCOMPARE(bench.session.scene().targets[0].rcs_m2, 7.0);
    QCOMPARE(bench.session.scene().targets[1].rcs_m2, 1.0);
    QCOMPARE(bench.line("rcs_m2")->text(), QString("1 m²"));
    bench.type("rcs_m2", "8 m2", false);
    bench.session.select_only(test::radar(0));
    QCOMPARE(bench.session.scene().targets[1].rcs_m2, 8.0);
  }

  void an_object_that_goes_while_its_field_is_typed_in_changes_nothing_else() {
    Bench bench;
    QVERIFY(QTest::qWaitForWindowActive(&bench.panel));
    bench.session.select_only(test::target(0));
    bench.type("rcs_m2", "7 m2", false);
    bench.session.perform(scene::remove_objects(bench.session.scene(), {test::target(0)}));
    for (const scene::Target& target : bench.session.scene().targets) QCOMPARE(target.rcs_m2, 1.0);
    QCOMPARE(bench.title(), QString("World, options and atmosphere"));
  }

  void steps_move_the_last_shown_digit() {
    QCOMPARE(gui::stepped_text("50 MHz", 1), QString("51 MHz"));
    QCOMPARE(gui::stepped_text("5.66 cm", -1), QString("5.65 cm"));
    QCOMPARE(gui::stepped_text("0.1", -2), QString("-0.1"));
    QCOMPARE(gui::stepped_text("-0.05 m", 5), QString("0.00 m"));
    QCOMPARE(gui::stepped_text("9.9e-7", 1), QString("10.0e-7"));
    QCOMPARE(gui::stepped_text("123456789012345678", 1), QString("123456789012345679"));
    QCOMPARE(gui::stepped_text(".5 m", 1), QString("0.6 m"));
    QCOMPARE(gui::stepped_text("", 1), QString());
    QCOMPARE(gui::stepped_text("(different)", 1), QString());
    QCOMPARE(gui::upsampled_text("1 m2"), QString("1.0 m2"));
    QCOMPARE(gui::upsampled_text("-2.5e3 m"), QString("-2.50e3 m"));
    QCOMPARE(gui::upsampled_text("(different)"), QString());
  }

  void a_run_of_steps_is_one_undo_step_and_keeps_its_unit() {
    Bench bench;
    bench.session.select_only(test::radar(0));
    QVERIFY(QTest::qWaitForWindowActive(&bench.panel));
    QLineEdit* edit = bench.line("bandwidth_hz");
    bench.panel.findChild<QComboBox*>("field_pulse")->setCurrentIndex(1);
    bench.type("bandwidth_hz", "998 MHz");
    edit->setFocus();
    for (int i = 0; i < 4; ++i) QTest::keyClick(edit, Qt::Key_Up);
    QCOMPARE(edit->text(), QString("1002 MHz"));
    QCOMPARE(bench.radar().bandwidth_hz, 1.002e9);
    QTest::keyClick(edit, Qt::Key_PageDown);
    QCOMPARE(bench.radar().bandwidth_hz, 0.992e9);
    QTest::keyClick(edit, Qt::Key_PageUp);
    bench.line("pulse_width_s")->setFocus();
    QCOMPARE(edit->text(), QString("1.002 GHz"));
    edit->setFocus();
    QTest::keyClick(edit, Qt::Key_Down);
    QCOMPARE(bench.radar().bandwidth_hz, 1.001e9);
    bench.session.undo();
    QCOMPARE(bench.radar().bandwidth_hz, 1.002e9);
    bench.session.undo();
    QCOMPARE(bench.radar().bandwidth_hz, 998e6);
  }

  void the_wheel_steps_only_with_control_and_focus() {
    Bench bench;
    bench.session.select_only(test::radar(0));
    QVERIFY(QTest::qWaitForWindowActive(&bench.panel));
    QLineEdit* edit = bench.line("prf_hz");
    const auto turn = [&](QWidget* widget, Qt::KeyboardModifiers modifiers) {
      QWheelEvent event(QPointF(5, 5), widget->mapToGlobal(QPointF(5, 5)), {}, QPoint(0, 120), Qt::NoButton, modifiers,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(widget, &event);
    };
    edit->setFocus();
    turn(edit, Qt::NoModifier);
    QCOMPARE(bench.radar().prf_hz, 1000.0);
    turn(edit, Qt::ControlModifier);
    QCOMPARE(bench.radar().prf_hz, 2000.0);
    // A list that the pointer happens to be over is not changed by scrolling, nor is the one that was used last.
    turn(bench.field("pulse"), Qt::NoModifier);
    bench.field("pulse")->setFocus();
    turn(bench.field("pulse"), Qt::NoModifier);
    QVERIFY(bench.radar().pulse == scene::Radar::Pulse::mono);
  }

  void arrow_keys_open_the_list_of_a_choice_and_change_nothing_yet() {
    Bench bench;
    bench.session.select_only(test::radar(0));
    QVERIFY(QTest::qWaitForWindowActive(&bench.panel));
    auto* box = qobject_cast<QComboBox*>(bench.field("pulse"));
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Down);
    QVERIFY(box->view()->isVisible());
    QVERIFY(bench.radar().pulse == scene::Radar::Pulse::mono);
    QTest::keyClick(box->view(), Qt::Key_Down);
    QTest::keyClick(box->view(), Qt::Key_Return);
    QVERIFY(bench.radar().pulse != scene::Radar::Pulse::mono);
  }

  void an_arrow_key_that_meets_a_marked_text_changes_nothing() {
    Bench bench;
    bench.session.select_only(test::target(0));
    QLineEdit* edit = bench.line("rcs_m2");
    edit->setFocus();
    edit->selectAll();  // as the Tab key does
    QTest::keyClick(edit, Qt::Key_Up);
    QCOMPARE(bench.session.scene().targets[0].rcs_m2, 1.0);
    QTest::keyClick(edit, Qt::Key_Up);
    QCOMPARE(bench.session.scene().targets[0].rcs_m2, 2.0);
  }

  void steps_stay_above_what_is_impossible() {
    Bench bench;
    bench.session.select_only(test::target(0));
    QLineEdit* edit = bench.line("rcs_m2");
    edit->setFocus();
    QTest::keyClick(edit, Qt::Key_Down);
    QCOMPARE(edit->text(), QString("0.9 m\u00B2"));
    for (int i = 0; i < 10; ++i) QTest::keyClick(edit, Qt::Key_Down);
    QVERIFY(bench.session.scene().targets[0].rcs_m2 > 0.0);
    bench.session.select_only({scene::ObjectKind::simulation, 0});
    edit = bench.line("time_end_s");
    bench.type("time_end_s", "1 s");
    QTest::keyClick(edit, Qt::Key_Down);
    QTest::keyClick(edit, Qt::Key_Down);
    QCOMPARE(bench.session.scene().simulations[0].time_end_s, 0.0);
    bench.type("time_end_s", "-2 s");  // typed values know no such limit
    QTest::keyClick(edit, Qt::Key_Down);
    QCOMPARE(bench.session.scene().simulations[0].time_end_s, -3.0);
  }

  void a_step_beyond_the_limits_is_not_taken() {
    Bench bench;
    bench.session.select_only({scene::ObjectKind::simulation, 0});
    bench.type("bits", "64");
    QTest::keyClick(bench.line("bits"), Qt::Key_Up);
    QCOMPARE(bench.session.scene().simulations[0].bits, 64);
    QCOMPARE(bench.line("bits")->text(), QString("64"));
    QVERIFY(!bench.problem("bits").isEmpty());
    QTest::keyClick(bench.line("bits"), Qt::Key_Down);
    QCOMPARE(bench.session.scene().simulations[0].bits, 63);
    QVERIFY2(!bench.problem("bits").contains("Error"), qPrintable(bench.problem("bits")));
  }

  void several_objects_show_what_they_share_and_change_together() {
    Bench bench;
    bench.session.select({test::target(0), test::target(1), test::target(2)});
    QCOMPARE(bench.title(), QString("3 targets"));
    QCOMPARE(bench.line("rcs_m2")->text(), QString("1 m²"));
    QCOMPARE(bench.line("position_m.x")->text(), QString());
    QCOMPARE(bench.line("position_m.x")->placeholderText(), QString("(different)"));
    QCOMPARE(qobject_cast<QComboBox*>(bench.field("platform"))->currentIndex(), -1);
    const scene::Scene before = bench.session.scene();
    bench.type("position_m.x", "4 km");
    for (const scene::Target& target : bench.session.scene().targets) QCOMPARE(target.position_m.x, 4000.0);
    QCOMPARE(bench.line("position_m.x")->text(), QString("4 km"));
    bench.session.undo();
    QVERIFY(bench.session.scene() == before);
    QCOMPARE(bench.line("position_m.x")->placeholderText(), QString("(different)"));
    enter(bench.field("platform"), "Ship");
    for (const scene::Target& target : bench.session.scene().targets) QCOMPARE(target.platform, std::string("Ship"));
  }

  void a_bad_text_for_several_objects_changes_none() {
    Bench bench;
    bench.session.select({test::target(0), test::target(1)});
    const scene::Scene before = bench.session.scene();
    bench.type("position_m.x", "4 kg");
    QVERIFY(bench.session.scene() == before);
    QCOMPARE(bench.line("position_m.x")->text(), QString("4 kg"));
    QVERIFY(!bench.problem("position_m.x").isEmpty());
  }

  void an_unsettled_check_box_is_settled_by_a_click() {
    Bench bench;
    bench.session.perform([&] {
      scene::Radar radar = bench.session.scene().radars[1];
      radar.same_antenna = false;
      return scene::replace_object(bench.session.scene(), test::radar(1), radar, "Separate antennas");
    }());
    bench.session.select({test::radar(0), test::radar(1)});
    auto* box = qobject_cast<QCheckBox*>(bench.field("same_antenna"));
    QCOMPARE(box->checkState(), Qt::PartiallyChecked);
    box->click();
    QVERIFY(bench.session.scene().radars[0].same_antenna && bench.session.scene().radars[1].same_antenna);
    QCOMPARE(box->checkState(), Qt::Checked);
    QVERIFY(!box->isTristate());
  }

  void fields_without_meaning_are_hidden() {
    Bench bench;
    bench.session.select_only(test::radar(0));
    QVERIFY(!bench.field("bandwidth_hz")->isVisible());
    enter(bench.field("pulse"), "Chirp");
    QVERIFY(bench.field("bandwidth_hz")->isVisible());
    QVERIFY(bench.radar().pulse == scene::Radar::Pulse::chirp);
  }

  void rare_fields_are_a_level_down_and_stay_unfolded() {
    Bench bench;
    bench.session.select_only(test::target(0));
    QVERIFY(!bench.field("position_stddev_m.x")->isVisible());
    bench.panel.findChild<QToolButton*>("more_Position")->click();
    QVERIFY(bench.field("position_stddev_m.x")->isVisible());
    bench.session.select_only(test::radar(0));
    bench.session.select_only(test::target(1));
    QVERIFY(bench.field("position_stddev_m.x")->isVisible());
  }

  void a_problem_stands_at_its_field_even_if_that_is_folded_away() {
    Bench bench;
    bench.session.select_only(test::target(0));
    scene::Target target = bench.session.scene().targets[0];
    target.traits.edit().rcs_stddev_m2 = -1.0;
    bench.session.perform(scene::replace_object(bench.session.scene(), test::target(0), target, "Spoil"));
    QVERIFY2(bench.problem("rcs_stddev_m2").startsWith("Error:"), qPrintable(bench.problem("rcs_stddev_m2")));
    QVERIFY(bench.field("rcs_stddev_m2")->isVisible());
    bench.session.undo();
    QVERIFY(bench.problem("rcs_stddev_m2").isEmpty());
    QVERIFY(!bench.field("rcs_stddev_m2")->isVisible());
  }

  void a_platform_that_does_not_exist_is_shown_and_explained() {
    scene::Scene scene = test::small_scene();
    scene.targets[0].platform = "Nowhere";
    Bench bench(scene);
    bench.session.select_only(test::target(0));
    QVERIFY2(bench.problem("platform").contains("no platform has this name"), qPrintable(bench.problem("platform")));
    QCOMPARE(qobject_cast<QComboBox*>(bench.field("platform"))->currentText(), QString("Nowhere"));
    enter(bench.field("platform"), "Ship");
    QVERIFY(bench.problem("platform").isEmpty());
    QCOMPARE(qobject_cast<QComboBox*>(bench.field("platform"))->findText("Nowhere"), -1);
  }

  void derived_values_follow_fields_and_time() {
    Bench bench;
    bench.session.select_only(test::radar(0));
    auto* table = bench.panel.findChild<QTableWidget*>("derived_figures");
    QTRY_VERIFY(table->isVisible() && table->rowCount() > 3);
    const auto text_of = [&](const QString& label) {
      const QList<QTableWidgetItem*> found = table->findItems(label, Qt::MatchStartsWith);
      return found.isEmpty() ? QString() : table->item(found[0]->row(), 1)->text();
    };
    const QString before = text_of("Wavelength");
    QVERIFY(!before.isEmpty());
    QVERIFY(!table->item(0, 0)->toolTip().isEmpty());
    bench.type("carrier_hz", "10 GHz");
    QTRY_VERIFY(text_of("Wavelength") != before);
    bench.session.select({});
    QTRY_VERIFY(!table->isVisible());
  }

  void a_panel_may_go_while_something_is_typed() {
    gui::Session session;
    test::open(session, test::small_scene());
    {
      gui::PropertyPanel panel(session);
      panel.show();
      QVERIFY(QTest::qWaitForWindowActive(&panel));
      auto* edit = panel.findChild<QLineEdit*>("field_seed");
      edit->setFocus();
      QTest::keyClicks(edit, "7");
    }
    QCOMPARE(session.scene().options.seed, std::uint64_t{1});
  }

  void the_field_in_hand_survives_changes_of_the_scene() {
    Bench bench;
    bench.session.select_only(test::target(0));
    QLineEdit* edit = bench.line("rcs_m2");
    QVERIFY(QTest::qWaitForWindowActive(&bench.panel));
    bench.type("rcs_m2", "12", false);
    scene::Target other = bench.session.scene().targets[1];
    other.rcs_m2 = 4.0;
    bench.session.perform(scene::replace_object(bench.session.scene(), test::target(1), other, "Elsewhere"));
    QCOMPARE(bench.line("rcs_m2"), edit);
    QCOMPARE(edit->text(), QString("12"));
    QVERIFY(edit->hasFocus());
    bench.session.select_only(test::target(2));
    QCOMPARE(bench.line("rcs_m2"), edit);
  }

  void names_stay_unique_and_references_follow() {
    Bench bench;
    bench.session.select_only(test::platform(1));
    bench.type("name", "earth");
    QCOMPARE(bench.session.scene().platforms[1].name, std::string("Ship"));
    QVERIFY(!bench.problem("name").isEmpty());
    bench.type("name", "Boat");
    QCOMPARE(bench.session.scene().platforms[1].name, std::string("Boat"));
    QCOMPARE(bench.session.scene().targets[2].platform, std::string("Boat"));
    QCOMPARE(bench.title(), QString("Platform Boat"));
    bench.session.select({test::platform(0), test::platform(1)});
    QVERIFY(!bench.field("name")->isEnabled());
  }

  void labels_are_buddies_of_their_fields() {
    Bench bench;
    bench.session.select_only(test::target(0));
    int buddies = 0;
    for (const QLabel* label : bench.panel.findChildren<QLabel*>())
      if (label->buddy() != nullptr && label->buddy()->objectName().startsWith("field_")) ++buddies;
    const auto& fields = scene::fields_of(scene::ObjectKind::target);
    const auto checks = std::ranges::count(fields, scene::FieldKind::check, &scene::Field::kind);
    QCOMPARE(static_cast<std::ptrdiff_t>(buddies), static_cast<std::ptrdiff_t>(fields.size()) - checks);
  }

  void thousands_of_targets_can_be_shown_together() {
    Bench bench(test::many_targets(10000));
    std::set<scene::ObjectId> all;
    for (std::size_t i = 0; i < 10000; ++i) all.insert(test::target(i));
    const test::ProcessorTime time;
    bench.session.select(all);
    const double taken_s = time.seconds();
    qInfo() << "10000 targets in the panel:" << 1e3 * taken_s << "ms";
    QCOMPARE(bench.line("rcs_m2")->text(), QString("1 m²"));
    QVERIFY(taken_s < 5.0);
    const auto rcs_of = [&](std::size_t index) { return bench.session.scene().targets[index].rcs_m2; };
    bench.type("rcs_m2", "3");
    QCOMPARE(rcs_of(0) + rcs_of(9999), 6.0);
    bench.type("rcs_m2", "3 s");
    QVERIFY2(bench.problem("rcs_m2").contains("3 s"), qPrintable(bench.problem("rcs_m2")));
    QCOMPARE(rcs_of(9999), 3.0);
    bench.session.undo();
    QCOMPARE(rcs_of(0) + rcs_of(9999), 2.0);
  }
};

const test::AddTest added("panel_test", test::run_test<PanelTest>);

}  // namespace sarsim::panel_test

#include "panel_test.moc"
