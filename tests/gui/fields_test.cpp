#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/property_panel.hpp"
#include "scene/edit/edit.hpp"
#include "scene/language/recorded_text.hpp"
#include "scene/schema/fields.hpp"
#include "scene/script/reader.hpp"
#include "small_scene.hpp"

// Every field of every panel, from the widget to the script and back.

namespace sarsim::fields_test {
namespace {

constexpr scene::ObjectKind kinds[] = {scene::ObjectKind::platform,   scene::ObjectKind::target,
                                       scene::ObjectKind::surface,    scene::ObjectKind::radar,
                                       scene::ObjectKind::simulation, scene::ObjectKind::geometry};

// What a hand types and the number that it means, in the unit that the quantity is held in. The figures are worked out
// by hand: 3 nmi are 3 x 1 852 m, 30 dBm are 1 W, 10 dBsm are 10 m2.
struct Typed {
  const char* text;
  double held;
};

const std::vector<Typed>& typed_values(scene::Quantity quantity) {
  static const std::map<scene::Quantity, std::vector<Typed>> values{
      {scene::Quantity::number, {{"0.25", 0.25}, {"2", 2.0}, {"1e-3", 1e-3}}},
      {scene::Quantity::length, {{"10 km", 1e4}, {"3 nmi", 5556.0}, {"25 cm", 0.25}, {"12.5", 12.5}}},
      {scene::Quantity::time, {{"3 us", 3e-6}, {"250ns", 250e-9}, {"2 min", 120.0}, {"0.5", 0.5}}},
      {scene::Quantity::frequency, {{"50 MHz", 5e7}, {"9.5 GHz", 9.5e9}, {"750 Hz", 750.0}}},
      {scene::Quantity::angle, {{"12.5 deg", 12.5}, {"30'", 0.5}, {"7", 7.0}}},
      {scene::Quantity::angle_rate, {{"2 rpm", 12.0}, {"1.5 deg/s", 1.5}}},
      {scene::Quantity::area, {{"10 dBsm", 10.0}, {"50 cm2", 5e-3}, {"2.5", 2.5}}},
      {scene::Quantity::power, {{"30 dBm", 1.0}, {"2 kW", 2e3}, {"5 mW", 5e-3}, {"3 MW", 3e6}}},
      {scene::Quantity::ratio_db, {{"3 dB", 3.0}, {"x100", 20.0}, {"1.5", 1.5}}},
      {scene::Quantity::temperature, {{"290 K", 290.0}, {"310", 310.0}}},
      {scene::Quantity::voltage, {{"2 mV", 2e-3}, {"40 uV", 40e-6}}},
      {scene::Quantity::count, {{"5", 5.0}, {"3", 3.0}}}};
  return values.at(quantity);
}

// A text that is no value of the quantity, in a unit that belongs to another.
QString foreign_text(scene::Quantity quantity) {
  return quantity == scene::Quantity::length ? QStringLiteral("5 kg") : QStringLiteral("5 parsec");
}

// One place where a field means something: the object and the field.
struct Case {
  scene::AnyObject object;
  scene::Field field;
};

// Of each field of a kind a first object for which it means something, reached from the plain one by choices.
std::vector<Case> cases_of(const scene::AnyObject& plain) {
  const std::vector<scene::Field>& fields = scene::fields_of(scene::kind_of(plain));
  std::vector<scene::AnyObject> reached{plain};
  std::set<std::string> found;
  std::vector<Case> cases;  // those of one object in a row
  for (std::size_t i = 0; i < reached.size() && reached.size() < 500; ++i)
    for (const scene::Field& field : fields) {
      if (field.spec->since_2 || !scene::field_applies(reached[i], field.id)) continue;
      if (!found.insert(field.id).second) continue;
      cases.push_back({reached[i], field});
      std::vector<std::string> values = field.choices;
      if (field.kind == scene::FieldKind::check) values = {"yes", "no"};
      for (const std::string& value : values) {
        scene::AnyObject other = reached[i];
        if (scene::set_field(other, field.id, value).empty() && other != reached[i] && scene::fits_script(other))
          reached.push_back(other);
      }
    }
  return cases;
}

// A text to enter, the object that it makes, and what is held by then where it is a number.
struct Entry {
  QString text;
  scene::AnyObject after;
  double held = 0.0;
};

std::vector<Entry> entries_for(const Case& one) {
  std::vector<Typed> candidates;
  if (one.field.kind == scene::FieldKind::quantity) candidates = typed_values(one.field.quantity);
  for (const std::string& choice : one.field.choices) candidates.push_back({choice.c_str(), 0.0});
  if (one.field.kind == scene::FieldKind::check) candidates = {{"yes", 0.0}, {"no", 0.0}};
  if (one.field.kind == scene::FieldKind::text) candidates = {{"Another1", 0.0}};
  if (one.field.kind == scene::FieldKind::platform) candidates = {{"Ship", 0.0}, {"Earth", 0.0}};
  if (one.field.kind == scene::FieldKind::radar) candidates = {{"Radar2", 0.0}, {"Radar1", 0.0}};
  std::vector<Entry> entries;
  for (const Typed& typed : candidates) {
    scene::AnyObject after = one.object;
    if (scene::set_field(after, one.field.id, typed.text).empty() && after != one.object && scene::fits_script(after))
      entries.push_back({QString::fromUtf8(typed.text), after, typed.held});
  }
  return entries;
}

struct Bench {
  Bench() {
    panel.resize(420, 900);
    panel.show();
  }

  // The small scene with this object in the place of the first of its kind, selected; as it is where it stands there.
  void open(const scene::AnyObject& object) {
    const scene::Scene plain = test::small_scene();
    if (!opened.empty() && session.document().text() == opened && id.kind == scene::kind_of(object) &&
        this->object() == object)
      return;
    id = {scene::kind_of(object), 0};
    test::open(session, plain);
    scene::AnyObject named = object;
    session.perform(scene::replace_object(session.scene(), id, std::move(named), "Begin"));
    // A text that was read, so that undoing has nothing before it.
    const std::string script = session.document().text();
    session.take(scene::Document::from_text(script));
    session.select_only(id);
    opened = session.document().text();
  }
  gui::Session& open_options() {
    test::open(session, test::small_scene());
    session.select({});
    return session;
  }

  [[nodiscard]] QWidget* widget(const scene::Field& field) const {
    return panel.findChild<QWidget*>(QString::fromStdString("field_" + field.id));
  }
  [[nodiscard]] QString words_at(const scene::Field& field) const {
    return panel.findChild<gui::ProblemLine*>(QString::fromStdString("problem_" + field.id))->text();
  }
  // What the widget of a field shows, in the words of the field.
  [[nodiscard]] QString shown(const scene::Field& field) const {
    QWidget* const any = widget(field);
    if (auto* edit = qobject_cast<QLineEdit*>(any)) return edit->text();
    if (auto* box = qobject_cast<QComboBox*>(any)) return box->currentText();
    if (auto* check = qobject_cast<QCheckBox*>(any)) return check->isChecked() ? "yes" : "no";
    if (auto* button = qobject_cast<QPushButton*>(any)) {
      QString text = button->text();
      return text.chopped(text.endsWith(" ...") ? 4 : 0);
    }
    return {};
  }
  // As a hand does, with the keyboard.
  void enter(const scene::Field& field, const QString& text) const {
    panel_focus(field);
    QWidget* const any = widget(field);
    if (auto* edit = qobject_cast<QLineEdit*>(any)) {
      edit->selectAll();
      QTest::keyClicks(edit, text);
      QTest::keyClick(edit, Qt::Key_Return);
    } else if (auto* box = qobject_cast<QComboBox*>(any)) {
      box->setCurrentIndex(box->findText(text));  // With the keyboard every choice on the way would be a step.
    } else if (auto* check = qobject_cast<QCheckBox*>(any)) {
      if (check->isChecked() != (text == "yes")) QTest::keyClick(check, Qt::Key_Space);
    }
  }
  void panel_focus(const scene::Field& field) const {
    const_cast<gui::PropertyPanel&>(panel).focus_field(QString::fromStdString(field.id));
  }
  [[nodiscard]] scene::AnyObject object() const { return scene::object_of(session.scene(), id); }

  gui::Session session;
  gui::PropertyPanel panel{session};
  scene::ObjectId id;
  std::string opened;
};

scene::Scene scene_of(const std::string& text) { return scene::read_script(text, "", {}).scene; }

std::string where(const Case& one, const QString& text) {
  return std::string(scene::name_of(scene::kind_of(one.object))) + " " + one.field.id + " = " + text.toStdString();
}

}  // namespace

class FieldsTest : public QObject {
  Q_OBJECT

 private:
  static void every_field(const std::function<void(Bench&, const Case&)>& test) {
    Bench bench;
    for (const scene::ObjectKind kind : kinds) {
      const std::vector<Case> cases = cases_of(scene::object_of(test::small_scene(), {kind, 0}));
      const auto in_scripts =
          std::ranges::count_if(scene::fields_of(kind), [](const scene::Field& field) { return !field.spec->since_2; });
      QCOMPARE(static_cast<std::ptrdiff_t>(cases.size()), in_scripts);
      for (const Case& one : cases) {
        bench.open(one.object);
        QVERIFY2(bench.object() == one.object, where(one, "").c_str());
        QVERIFY2(bench.widget(one.field) != nullptr, where(one, "").c_str());
        test(bench, one);
        if (QTest::currentTestFailed()) return;
        QCoreApplication::processEvents();  // Qt looks through all that waits for each that is posted.
      }
    }
  }

 private slots:
  void what_is_entered_stands_in_the_script() {
    int entered = 0;
    every_field([&](Bench& bench, const Case& one) {
      if (one.field.kind == scene::FieldKind::function) return;
      const std::vector<Entry> entries = entries_for(one);
      QVERIFY2(!entries.empty(), where(one, "?").c_str());
      for (const Entry& entry : entries) {
        const std::string place = where(one, entry.text);
        const std::string before = bench.session.document().text();
        bench.enter(one.field, entry.text);
        const std::string after = bench.session.document().text();
        QVERIFY2(after != before, place.c_str());
        const scene::Scene read = scene_of(after);
        QVERIFY2(read == bench.session.scene(), place.c_str());
        QVERIFY2(scene::object_of(read, bench.id) == entry.after, place.c_str());
        if (one.field.kind == scene::FieldKind::quantity) {
          const auto held = scene::read_quantity(scene::field_text(scene::object_of(read, bench.id), one.field.id),
                                                 one.field.quantity);
          QVERIFY2(held.value && std::abs(*held.value - entry.held) <= 1e-12 * std::abs(entry.held), place.c_str());
        }
        QVERIFY2(bench.session.document().history().can_undo(), place.c_str());
        bench.session.undo();
        QVERIFY2(bench.session.document().text() == before, place.c_str());
        QVERIFY2(!bench.session.document().history().can_undo(), place.c_str());
        ++entered;
      }
    });
    QVERIFY2(entered > 200, qPrintable(QString::number(entered)));
  }

  void what_stands_in_the_script_is_shown() {
    every_field([&](Bench& bench, const Case& one) {
      const std::string before = bench.session.document().text();
      QCOMPARE(bench.shown(one.field), gui::display_of(scene::field_text(one.object, one.field.id)));
      for (const Entry& entry : entries_for(one)) {
        // The text as the edit would write it, typed by hand.
        scene::Document other = scene::Document::from_text(before);
        other.perform(scene::replace_object(other.scene(), bench.id, entry.after, ""));
        bench.session.type_text(other.text());
        QVERIFY2(bench.shown(one.field) == gui::display_of(scene::field_text(entry.after, one.field.id)),
                 where(one, entry.text + ": " + bench.shown(one.field)).c_str());
        bench.session.type_text(before);
        QVERIFY2(bench.shown(one.field) == gui::display_of(scene::field_text(one.object, one.field.id)),
                 where(one, entry.text).c_str());
      }
    });
  }

  void functions_show_what_the_script_says_and_ask_for_their_editor() {
    int functions = 0;
    every_field([&](Bench& bench, const Case& one) {
      if (one.field.kind != scene::FieldKind::function) return;
      ++functions;
      QSignalSpy asked(&bench.panel, &gui::PropertyPanel::function_requested);
      bench.panel_focus(one.field);
      QTest::keyClick(bench.widget(one.field), Qt::Key_Space);
      QCOMPARE(asked.size(), 1);
      QCOMPARE(asked[0][1].toString(), QString::fromStdString(one.field.id));
    });
    QVERIFY(functions >= 10);
  }

  void what_cannot_be_read_changes_nothing_and_is_answered_at_the_field() {
    int refused = 0;
    every_field([&](Bench& bench, const Case& one) {
      if (one.field.kind != scene::FieldKind::quantity) return;
      const scene::Scene scene = bench.session.scene();
      const std::string text = bench.session.document().text();
      for (const QString& typed : {QStringLiteral("nonsense"), foreign_text(one.field.quantity), QStringLiteral("1,5"),
                                   QStringLiteral("1e999")}) {
        const std::string place = where(one, typed);
        bench.enter(one.field, typed);
        QVERIFY2(bench.session.scene() == scene, place.c_str());
        QVERIFY2(bench.session.document().text() == text, place.c_str());
        QVERIFY2(!bench.session.document().history().can_undo(), place.c_str());
        QVERIFY2(bench.shown(one.field) == typed, place.c_str());
        QVERIFY2(bench.words_at(one.field).startsWith("Error: "), place.c_str());
        QVERIFY2(bench.widget(one.field)->accessibleDescription().startsWith("Error: "), place.c_str());
        ++refused;
        QTest::keyClick(bench.widget(one.field), Qt::Key_Escape);
        QVERIFY2(bench.shown(one.field) == gui::display_of(scene::field_text(one.object, one.field.id)), place.c_str());
        QVERIFY2(!bench.words_at(one.field).contains(typed), place.c_str());
      }
    });
    QVERIFY2(refused > 200, qPrintable(QString::number(refused)));
  }

  void values_outside_their_limits_change_nothing_and_are_answered_at_the_field() {
    int refused = 0;
    every_field([&](Bench& bench, const Case& one) {
      if (one.field.kind != scene::FieldKind::quantity && one.field.kind != scene::FieldKind::text) return;
      std::vector<QString> typed{"-7", "99999999999", "0.5", ""};
      for (const QString& text : typed) {
        scene::AnyObject changed = one.object;
        const std::string why = scene::set_field(changed, one.field.id, text.toStdString());
        const bool named = one.field.id == "name" && text.isEmpty();
        if (why.empty() && !named) continue;
        const scene::Scene scene = bench.session.scene();
        bench.panel_focus(one.field);
        auto* edit = qobject_cast<QLineEdit*>(bench.widget(one.field));
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
        QVERIFY2(bench.session.scene() == scene, where(one, text).c_str());
        QVERIFY2(!named ? bench.words_at(one.field).contains(QString::fromStdString(why))
                        : bench.words_at(one.field).startsWith("Error: "),
                 where(one, text).c_str());
        QTest::keyClick(edit, Qt::Key_Escape);
        ++refused;
      }
    });
    QVERIFY2(refused > 20, qPrintable(QString::number(refused)));
  }

  void options_go_to_the_script_and_back() {
    Bench bench;
    const std::map<std::string, std::vector<QString>> values{
        {"profile", {"Classic", "Physical"}},     {"seed", {"18446744073709551615", "42", "0"}},
        {"pulse", {"Band-limited", "Ideal"}},     {"tolerance", {"1e-3", "0.1", "1e-9"}},
        {"cubic_ends", {"Not a knot", "Chords"}}, {"ambiguous_echoes", {"All", "None", "Strong"}},
        {"eclipsing", {"Blanked", "None"}}};
    QCOMPARE(values.size(), scene::option_fields().size());
    for (const scene::Field& field : scene::option_fields()) {
      QVERIFY2(values.contains(field.id), field.id.c_str());
      for (const QString& text : values.at(field.id)) {
        bench.open_options();
        scene::RunOptions wanted = bench.session.scene().options;
        QCOMPARE(scene::set_field(wanted, field.id, text.toStdString()), std::string());
        const std::string before = bench.session.document().text();
        bench.enter(field, text);
        QVERIFY2(bench.session.scene().options == wanted, field.id.c_str());
        QVERIFY2(scene_of(bench.session.document().text()) == bench.session.scene(), field.id.c_str());
        const std::string after = bench.session.document().text();
        bench.session.type_text(before);
        QCOMPARE(bench.shown(field), gui::display_of(scene::field_text(scene::RunOptions{}, field.id)));
        bench.session.type_text(after);
        QCOMPARE(bench.shown(field), gui::display_of(scene::field_text(wanted, field.id)));
      }
    }
    for (const char* text : {"-1", "18446744073709551616", "1.5", "much"}) {
      bench.open_options();
      const scene::Field& seed = *std::ranges::find(scene::option_fields(), std::string("seed"), &scene::Field::id);
      bench.enter(seed, text);
      QVERIFY2(bench.session.scene().options == scene::RunOptions{}, text);
      QVERIFY2(bench.words_at(seed).startsWith("Error: "), text);
    }
  }
};

const test::AddTest added("fields_test", test::run_test<FieldsTest>);

}  // namespace sarsim::fields_test

#include "fields_test.moc"
