#include <QHelpEvent>
#include <QTest>
#include <QTextBlock>
#include <QToolTip>

#include <algorithm>
#include <vector>

#include "gui/common/palette_colours.hpp"
#include "gui/common/session.hpp"
#include "gui/gui_test.hpp"
#include "gui/script/completion_list.hpp"
#include "gui/script/script_completer.hpp"
#include "gui/script/script_editor.hpp"
#include "gui/script/script_text.hpp"
#include "support/processor_time.hpp"

namespace sarsim::script_completion_test {

namespace {

const std::string one_radar =
    "format = \"sarsim 2\"\n"
    "\n"
    "[let]\n"
    "speed = \"200 m/s\"   # over ground\n"
    "\n"
    "[[platform]]\n"
    "name = \"Plane\"\n"
    "\n"
    "[[radar]]\n"
    "name = \"Radar1\"\n"
    "platform = \"Plane\"\n"
    "carrier = \"9 GHz\"\n"
    "power = \"1 kW\"\n"
    "\n"
    "[radar.pulse]\n"
    "type = \"chirp\"\n"
    "width = \"5 us\"\n";

// An editor on screen, with keyboard and mouse.
struct Bench {
  explicit Bench(const std::string& script = one_radar) {
    session.take(scene::Document::from_text(script));
    editor.resize(700, 500);
    editor.show();
    editor.activateWindow();
    if (!QTest::qWaitForWindowActive(&editor)) qFatal("not active");
    text = &editor.text();
    text->complete();
    text->setFocus();
    list = editor.findChild<gui::CompletionList*>("script_completions");
  }
  [[nodiscard]] int position_of(const QString& words) const {
    const QTextCursor found = text->document()->find(words, 0, QTextDocument::FindCaseSensitively);
    if (found.isNull()) qFatal("no '%s'", qPrintable(words));
    return found.selectionStart();
  }
  void put_cursor_behind(const QString& words) const {
    QTextCursor cursor = text->textCursor();
    cursor.setPosition(position_of(words) + static_cast<int>(words.size()));
    text->setTextCursor(cursor);
  }
  void type(const QString& keys) const { QTest::keyClicks(text, keys); }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::keyClick(text, key, modifiers);
  }
  // An empty line of the radar, with the keyboard.
  void begin_line_of_radar() const {
    put_cursor_behind("power = \"1 kW\"");
    press(Qt::Key_Return);
  }
  [[nodiscard]] QStringList offered() const {
    QStringList words;
    if (!list->isVisible()) return words;
    for (int i = 0; i < list->topLevelItemCount(); ++i) words += list->topLevelItem(i)->text(0);
    return words;
  }
  [[nodiscard]] QString line() const { return text->textCursor().block().text(); }
  // The tooltip that a mouse gets that rests on the middle of a character.
  [[nodiscard]] QString tip_at(int position) const {
    QTextCursor cursor(text->document());
    cursor.setPosition(position);
    text->ensureCursorVisible();
    const QRect left = text->cursorRect(cursor);
    const QPoint middle = left.center() + QPoint(text->fontMetrics().horizontalAdvance('n') / 2, 0);
    QHelpEvent event(QEvent::ToolTip, middle, text->viewport()->mapToGlobal(middle));
    for (QWidget* tip : QApplication::topLevelWidgets())  // One that is hidden stays for a while.
      if (tip->inherits("QTipLabel")) tip->close();
    QApplication::sendEvent(text->viewport(), &event);
    return QToolTip::isVisible() ? QToolTip::text() : QString();
  }
  [[nodiscard]] QStringList marked() const {
    QStringList words;
    for (const auto& [begin, end] : text->underlined()) words += text->script().mid(begin, end - begin);
    return words;
  }

  gui::Session session;
  gui::ScriptEditor editor{session};
  gui::ScriptText* text = nullptr;
  gui::CompletionList* list = nullptr;
};

}  // namespace

class ScriptCompletionTest : public QObject {
  Q_OBJECT

 private slots:
  void a_key_that_is_typed_is_completed_and_then_its_value() {
    const Bench bench;
    bench.begin_line_of_radar();
    QVERIFY(bench.offered().isEmpty());
    bench.type("wi");
    QCOMPARE(bench.offered(), QStringList({"window"}));
    bench.press(Qt::Key_Return);
    QCOMPARE(bench.line(), QString("window = "));
    QVERIFY(bench.offered().contains("hamming"));
    bench.press(Qt::Key_Down);
    bench.press(Qt::Key_Down);
    bench.press(Qt::Key_Down);
    bench.press(Qt::Key_Tab);
    QCOMPARE(bench.line(), QString("window = \"hamming\""));
    QVERIFY(bench.offered().isEmpty());
  }

  void what_is_completed_becomes_the_scene() {
    Bench bench;
    bench.begin_line_of_radar();
    bench.type("wi");
    bench.press(Qt::Key_Return);
    bench.type("\"ha");
    QCOMPARE(bench.offered(), QStringList({"hann", "hamming"}));
    bench.press(Qt::Key_Down);
    bench.press(Qt::Key_Return);
    bench.editor.commit();
    QCOMPARE(bench.session.scene().radars[0].window, scene::Radar::Window::hamming);
    QVERIFY(bench.text->underlined().empty());
  }

  void ctrl_and_space_show_all_and_escape_hides_them() {
    const Bench bench;
    bench.begin_line_of_radar();
    const QString before = bench.text->script();
    bench.press(Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(bench.offered().contains("antenna"));
    QVERIFY(bench.offered().contains("[radar.beam]") == false);
    QVERIFY(bench.offered().contains("[[recording]]"));
    QVERIFY2(!bench.offered().contains("power"), "is there already");
    bench.press(Qt::Key_Escape);
    QVERIFY(bench.offered().isEmpty());
    QCOMPARE(bench.text->script(), before);
    QVERIFY(bench.text->hasFocus());
  }

  void typing_narrows_the_list_and_letters_stay_typed() {
    const Bench bench;
    bench.begin_line_of_radar();
    bench.type("r");
    QVERIFY(bench.offered().contains("repetition"));
    QVERIFY(bench.offered().contains("[[radar]]"));
    bench.type("ece");
    QCOMPARE(bench.offered(), QStringList({"receive_gain", "receive_antenna"}));
    bench.type("x");
    QVERIFY(bench.offered().isEmpty());
    bench.press(Qt::Key_Backspace);
    QCOMPARE(bench.line(), QString("rece"));
  }

  void names_of_the_scene_and_of_let_are_offered() {
    Bench bench;
    bench.begin_line_of_radar();
    bench.press(Qt::Key_Return);
    bench.type("[[tar");
    bench.press(Qt::Key_Return);
    bench.press(Qt::Key_Return);
    bench.type("platform = \"");
    QCOMPARE(bench.offered(), QStringList({"Earth", "Plane"}));
    bench.type("Pl");
    bench.press(Qt::Key_Return);
    QCOMPARE(bench.line(), QString("platform = \"Plane\""));
    bench.press(Qt::Key_Return);
    bench.type("position = [\"2 s * sp");
    QCOMPARE(bench.offered(), QStringList({"speed"}));
    // A name that has just come into the scene.
    bench.put_cursor_behind("name = \"Plane");
    bench.type("2");
    bench.editor.commit();
    bench.put_cursor_behind("platform = \"");
    bench.press(Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(bench.offered().contains("Plane"));
  }

  void units_follow_a_number_and_a_blank() {
    const Bench bench;
    bench.put_cursor_behind("width = \"5");
    bench.type("0");
    QVERIFY(bench.offered().isEmpty());
    bench.press(Qt::Key_Delete);
    bench.press(Qt::Key_Delete);
    bench.press(Qt::Key_Delete);
    bench.type(" ");
    QCOMPARE(bench.offered(), QStringList({"s", "ns", "us", "ms", "min", "h"}));
    bench.type("n");
    bench.press(Qt::Key_Return);
    QCOMPARE(bench.line(), QString("width = \"50 ns\""));
  }

  void the_list_goes_where_the_cursor_leaves() {
    const Bench bench;
    const auto show = [&] {
      bench.put_cursor_behind("power");
      bench.press(Qt::Key_Space, Qt::ControlModifier);
      QVERIFY(bench.list->isVisible());
    };
    show();
    bench.press(Qt::Key_Home);
    QVERIFY(!bench.list->isVisible());
    show();
    QTest::mouseClick(bench.text->viewport(), Qt::LeftButton, {}, QPoint(5, 5));
    QVERIFY(!bench.list->isVisible());
    show();
    QFocusEvent out(QEvent::FocusOut);
    QApplication::sendEvent(bench.text, &out);
    QVERIFY(!bench.list->isVisible());
  }

  void a_click_in_the_list_puts_the_word_in() {
    const Bench bench;
    bench.begin_line_of_radar();
    bench.type("rece");
    const QRect second = bench.list->visualItemRect(bench.list->topLevelItem(1));
    QTest::mouseClick(bench.list->viewport(), Qt::LeftButton, {}, second.center());
    QCOMPARE(bench.line(), QString("receive_antenna = "));
    QVERIFY(bench.text->hasFocus());
  }

  void scripts_of_1998_are_typed_as_before() {
    const Bench bench("$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n");
    bench.text->moveCursor(QTextCursor::End);
    bench.type("$ra");
    bench.press(Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(!bench.list->isVisible());
  }

  void the_mouse_explains_keys_headers_and_words() {
    const Bench bench;
    const QString width = bench.tip_at(bench.position_of("width") + 2);
    for (const char* const part : {"radar.pulse.width", "From edge to edge", "a time", "ns, us", "0.1 ns to 1 s"})
      QVERIFY2(width.contains(part), qPrintable(width));
    QVERIFY(bench.tip_at(bench.position_of("chirp") + 1).contains("linearly swept frequency"));
    QVERIFY(bench.tip_at(bench.position_of("[[radar]]") + 4).contains("A transmitter and receiver."));
    QVERIFY(bench.tip_at(bench.position_of("radar.pulse") + 8).contains("Modulation within the pulse"));
    QVERIFY(bench.tip_at(bench.position_of("[let]") + 2).contains("Names for values"));
    QVERIFY(bench.tip_at(bench.position_of("# over") + 3).isEmpty());
    QVERIFY(bench.tip_at(bench.position_of("Radar1") + 1).isEmpty());
    QVERIFY2(bench.tip_at(bench.position_of("name = \"Plane\"") + 15).isEmpty(), "behind the end of a line");
  }

  void the_mouse_explains_commands_of_1998() {
    const Bench bench("! a scene\n$RADAR Radar1 Earth CHIRP\n");
    const QString tip = bench.tip_at(bench.position_of("RADAR"));
    QVERIFY2(tip.contains("$RADAR") && tip.contains("A transmitter and receiver."), qPrintable(tip));
    QVERIFY(bench.text->explanation_at(bench.position_of("a scene")).isEmpty());
    QVERIFY(bench.text->explanation_at(bench.position_of("Earth")).isEmpty());
  }

  void mistakes_are_marked_where_they_are_in_their_colours() {
    Bench bench;
    bench.put_cursor_behind("width = \"5");
    bench.type("0 parsec + 1");
    bench.put_cursor_behind("speed = \"200 m/s\"");
    bench.press(Qt::Key_Return);
    bench.type("fast = \"3 * sped\"");
    bench.put_cursor_behind("power");
    bench.type("s");
    bench.editor.commit();
    QStringList marked = bench.marked();
    marked.sort();
    QCOMPARE(marked, QStringList({"parsec", "powers", "sped"}));
    const QString tip = bench.tip_at(bench.position_of("powers") + 1);
    QVERIFY2(tip.contains("powers") && tip.contains("Did you mean"), qPrintable(tip));
    const QTextCharFormat format = bench.text->extraSelections().last().format;
    QCOMPARE(format.underlineStyle(), QTextCharFormat::WaveUnderline);
    QCOMPARE(format.underlineColor(), gui::colour_of(picture::Role::error, bench.text->palette()));
  }

  void warnings_have_another_colour_and_their_explanation_below() {
    Bench bench;
    bench.put_cursor_behind("carrier = ");
    for (int i = 0; i < 7; ++i) bench.press(Qt::Key_Delete);
    bench.type("5.3");
    bench.editor.commit();
    QVERIFY(bench.marked().contains("5.3"));
    QCOMPARE(bench.session.problems().front().severity, core::Severity::warning);
    const QTextCharFormat format = bench.text->extraSelections().last().format;
    QCOMPARE(format.underlineColor(), gui::colour_of(picture::Role::warning, bench.text->palette()));
  }

  // What a key costs must not grow with the text: a pause of 300 ms decides when all of it is read.
  void typing_stays_fluid_in_a_long_text() {
    std::string script = one_radar;
    for (int i = 0; i < 10'000; ++i)
      script += "[[target]]\nposition = [" + std::to_string(i) + ", 0, 0]\nplatform = \"Plane\"\n\n";
    Bench bench(script);
    bench.put_cursor_behind("position = [5000, 0, 0]");
    bench.press(Qt::Key_Return);
    type_and_measure(bench, "rcs = \"3 * sqrt(2) m2\"");
    QCOMPARE(bench.line(), QString("rcs = \"3 * sqrt(2) m2\""));
  }

  void typing_stays_fluid_in_a_long_table_of_positions() {
    std::string script = one_radar + "[[target]]\npositions = [\n";
    for (int i = 0; i < 10'000; ++i) script += "  [" + std::to_string(i) + ", 0, 0],\n";
    Bench bench(script + "]\n");
    bench.put_cursor_behind("  [9000, 0, 0],");
    bench.press(Qt::Key_Return);
    type_and_measure(bench, "  [\"3 km\", 0, \"2 * speed * 1 s\"],");
  }

 private:
  static void type_and_measure(const Bench& bench, const QString& words) {
    std::vector<double> taken_ms;
    for (const QChar key : words) {
      const auto time = test::ProcessorTime::of_this_thread();
      bench.type(key);
      taken_ms.push_back(1e3 * time.seconds());
    }
    std::ranges::sort(taken_ms);
    const double usual_ms = taken_ms[taken_ms.size() / 2];
    qInfo() << bench.text->blockCount() << "lines; a key takes" << usual_ms << "ms, at most" << taken_ms.back();
    QVERIFY2(usual_ms < 20.0, "a key is felt");
  }
};

const test::AddTest added("script_completion_test", test::run_test<ScriptCompletionTest>);

}  // namespace sarsim::script_completion_test

#include "script_completion_test.moc"
