#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextLayout>
#include <QWheelEvent>

#include "gui/common/palette_colours.hpp"
#include "gui/gui_test.hpp"
#include "gui/script/script_editor.hpp"
#include "gui/script/script_highlighter.hpp"
#include "gui/script/script_text.hpp"
#include "small_scene.hpp"
#include "support/processor_time.hpp"

namespace sarsim::script_editor_test {

namespace {

const std::string two_targets =
    "! my scene\n"
    "$PLATFORM Earth ! the ground\n"
    "STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
    "! the first one, north\n"
    "$TARGET Earth\n"
    "0 1000 0 ! (m) where it is\n"
    "0 0 0 1 0 ISOTROPIC\n"
    "! the second one, east\n"
    "$TARGET Earth\n"
    "2000 0 0\n"
    "0 0 0 1 0 ISOTROPIC\n";

// An editor on screen, with the keys of a keyboard.
struct Bench {
  explicit Bench(const std::string& script = two_targets) {
    session.take(scene::Document::from_text(script));
    editor.resize(700, 500);
    editor.show();
    text = &editor.text();
    text->complete();
    text->setFocus();
    problems = editor.findChild<QListWidget*>("script_problems");
  }
  void put_cursor_behind(const QString& words) const {
    QTextCursor cursor = text->document()->find(words);
    QVERIFY2(!cursor.isNull(), qPrintable(words));
    cursor.setPosition(cursor.selectionEnd());
    text->setTextCursor(cursor);
  }
  void replace(const QString& from, const QString& to) const {
    QTextCursor cursor = text->document()->find(from);
    QVERIFY2(!cursor.isNull(), qPrintable(from));
    text->setTextCursor(cursor);
    QTest::keyClicks(text, to);
  }
  void move_target(std::size_t index, const core::Vec3& position_m) {
    scene::Target moved = session.scene().targets[index];
    moved.position_m = position_m;
    session.perform(scene::replace_object(session.scene(), test::target(index), moved, "Move target"));
  }
  [[nodiscard]] QString marked(std::size_t mark) const {
    const auto [begin, end] = text->underlined().at(mark);
    return text->script().mid(begin, end - begin);
  }

  gui::Session session;
  gui::ScriptEditor editor{session};
  gui::ScriptText* text = nullptr;
  QListWidget* problems = nullptr;
};

constexpr int pause_ms = 300;

}  // namespace

class ScriptEditorTest : public QObject {
  Q_OBJECT

 private slots:
  void typing_becomes_the_scene_after_a_pause_and_not_before() {
    Bench bench;
    bench.replace("1000", "1500");
    QCOMPARE(bench.session.scene().targets[0].position_m.y, 1000.0);
    QTRY_COMPARE_WITH_TIMEOUT(bench.session.scene().targets[0].position_m.y, 1500.0, 10 * pause_ms);
    QCOMPARE(bench.text->script().toStdString(), bench.session.document().text());
    QVERIFY(bench.session.document().text().find("! (m) where it is") != std::string::npos);
  }

  void leaving_the_editor_applies_at_once() {
    Bench bench;
    bench.replace("1000", "1600");
    QFocusEvent out(QEvent::FocusOut);
    QApplication::sendEvent(bench.text, &out);
    QCOMPARE(bench.session.scene().targets[0].position_m.y, 1600.0);
  }

  void an_edit_of_the_scene_keeps_comments_cursor_and_selection() {
    Bench bench;
    bench.put_cursor_behind("second one");
    const QString before_cursor = bench.text->script().left(bench.text->textCursor().position()).right(10);
    bench.move_target(0, {123.0, 456.0, 7.0});
    QCOMPARE(bench.text->script().toStdString(), bench.session.document().text());
    for (const char* comment : {"! my scene", "! the ground", "! the first one, north", "! the second one, east"})
      QVERIFY2(bench.text->script().contains(comment), comment);
    QVERIFY(bench.text->script().contains("123"));
    QCOMPARE(bench.text->script().left(bench.text->textCursor().position()).right(10), before_cursor);
  }

  void an_edit_of_the_scene_keeps_what_is_on_screen() {
    scene::Scene scene = test::many_targets(300);
    Bench bench(scene::write_script(scene));
    QScrollBar* bar = bench.text->verticalScrollBar();
    bar->setValue(1000);
    const QString top = bench.text->cursorForPosition({1, 1}).block().text();
    const int shown = bar->value();
    bench.move_target(299, {1.0, 2.0, 3.0});
    QCOMPARE(bar->value(), shown);
    bench.session.perform(scene::remove_objects(bench.session.scene(), {test::target(0)}));
    QCOMPARE(bench.text->cursorForPosition({1, 1}).block().text(), top);
    QCOMPARE(bench.text->script().toStdString(), bench.session.document().text());
  }

  void typing_that_waits_survives_an_edit_elsewhere() {
    Bench bench;
    bench.replace("2000", "2500");
    bench.move_target(0, {11.0, 22.0, 33.0});
    QVERIFY(bench.text->script().contains("2500"));
    QTRY_COMPARE_WITH_TIMEOUT(bench.session.scene().targets[1].position_m.x, 2500.0, 10 * pause_ms);
    QCOMPARE(bench.session.scene().targets[0].position_m, (core::Vec3{11.0, 22.0, 33.0}));
    QCOMPARE(bench.text->script().toStdString(), bench.session.document().text());
  }

  void editor_and_session_do_not_answer_each_other_for_ever() {
    Bench bench;
    QSignalSpy changes(&bench.session, &gui::Session::scene_changed);
    bench.replace("1000", "1700");
    bench.editor.commit();
    bench.move_target(1, {1.0, 1.0, 1.0});
    QTest::qWait(3 * pause_ms);
    QCOMPARE(changes.size(), 2);
  }

  void undo_and_redo_are_those_of_the_document() {
    Bench bench;
    bench.move_target(0, {5.0, 5.0, 5.0});
    bench.replace("2000", "2100");
    QTest::keyClick(bench.text, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.session.scene().targets[1].position_m.x, 2000.0);
    QVERIFY(bench.text->script().contains("2000"));
    QTest::keyClick(bench.text, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.text->script().toStdString(), two_targets);
    QTest::keySequence(bench.text, QKeySequence::Redo);
    QCOMPARE(bench.session.scene().targets[0].position_m.x, 5.0);
  }

  void problems_are_underlined_where_they_are_and_listed() {
    Bench bench;
    QVERIFY(!bench.problems->isVisible());
    bench.replace("1000", "upwards");
    bench.editor.commit();
    QVERIFY(bench.problems->isVisible());
    QVERIFY(bench.problems->count() >= 1);
    QVERIFY(bench.problems->item(0)->text().startsWith("Line 6: Error"));
    QCOMPARE(bench.marked(0), QString("upwards"));
    const int at = bench.text->underlined()[0].first;
    QVERIFY(bench.text->problem_at(at + 2).contains("upwards"));
    QVERIFY(bench.text->problem_at(0).isEmpty());
    // The scene waits; the underline moves with the text.
    QCOMPARE(bench.session.scene().targets[0].position_m.y, 1000.0);
    QTextCursor top(bench.text->document());
    bench.text->setTextCursor(top);
    QTest::keyClicks(bench.text, "! one more");
    QTest::keyClick(bench.text, Qt::Key_Return);
    QCOMPARE(bench.marked(0), QString("upwards"));
    bench.editor.commit();
    QCOMPARE(bench.marked(0), QString("upwards"));
    QVERIFY(bench.problems->item(0)->text().startsWith("Line 7: Error"));
    bench.replace("upwards", "1000");
    bench.editor.commit();
    QVERIFY(bench.text->underlined().empty());
    QVERIFY(!bench.problems->isVisible());
  }

  void problems_behind_characters_of_several_bytes_are_underlined_rightly() {
    Bench bench("$PLATFORM \"Žižkov Ωµ\" STATIONARY 0 north 0\n");
    QVERIFY(!bench.text->underlined().empty());
    QCOMPARE(bench.marked(0), QString("north"));
  }

  void a_click_on_a_listed_problem_goes_there() {
    Bench bench;
    bench.replace("2000", "far");
    bench.editor.commit();
    bench.text->moveCursor(QTextCursor::Start);
    emit bench.problems->itemClicked(bench.problems->item(0));
    QCOMPARE(bench.text->textCursor().blockNumber(), 9);
    QCOMPARE(bench.text->textCursor().positionInBlock(), 0);
  }

  void old_scripts_keep_their_bytes() {
    const std::string latin1 = "! Sender f\xFCr Stra\xDF\x65n\r\n" + two_targets;
    std::string script;
    for (const char c : latin1) {
      if (c == '\n' && (script.empty() || script.back() != '\r')) script += '\r';
      script += c;
    }
    Bench bench(script);
    QVERIFY(bench.text->script().startsWith(QString::fromUtf8("! Sender für Straßen\n")));
    bench.replace("1000", "1800");
    bench.editor.commit();
    script.replace(script.find("1000"), 4, "1800");
    QCOMPARE(bench.session.document().text(), script);
  }

  void parts_of_a_line_are_told_apart() {
    const std::vector<gui::ScriptSpan> spans = gui::script_spans("$TARGET \"Big ship\", -1.5e3 ISOTROPIC ! 12 RECT");
    const std::vector<gui::ScriptSpan> expected{{0, 7, gui::ScriptPart::command},
                                                {8, 10, gui::ScriptPart::name},
                                                {20, 6, gui::ScriptPart::number},
                                                {27, 9, gui::ScriptPart::keyword},
                                                {37, 9, gui::ScriptPart::comment}};
    QVERIFY(spans == expected);
    QVERIFY(gui::script_spans("").empty());
    QVERIFY((gui::script_spans("!all") == std::vector<gui::ScriptSpan>{{0, 4, gui::ScriptPart::comment}}));
  }

  void parts_of_a_line_of_format_2_are_told_apart() {
    using Part = gui::ScriptPart;
    using Spans = std::vector<gui::ScriptSpan>;
    QVERIFY((gui::format_2_spans("carrier = \"9 # GHz\"  # X band") ==
             Spans{{0, 7, Part::keyword}, {10, 9, Part::name}, {21, 8, Part::comment}}));
    QVERIFY((gui::format_2_spans("[[radar.swath]] # [1]") == Spans{{0, 15, Part::command}, {16, 5, Part::comment}}));
    QVERIFY((gui::format_2_spans("  [1.5, -2, true],") ==
             Spans{{3, 3, Part::number}, {8, 2, Part::number}, {12, 4, Part::number}}));
    QVERIFY((gui::format_2_spans("a.b = { type = 'x' }") ==
             Spans{{0, 3, Part::keyword}, {8, 4, Part::keyword}, {15, 3, Part::name}}));
    QVERIFY((gui::format_2_spans("open = \"no end\\\"") == Spans{{0, 4, Part::keyword}, {7, 9, Part::name}}));
    QVERIFY(gui::format_2_spans("").empty());
  }

  void colours_follow_the_palette() {
    Bench bench;
    QApplication::processEvents();
    const auto colour_of_command = [&] {
      const QTextBlock block = bench.text->document()->findBlockByNumber(1);
      return block.layout()->formats().value(0).format.foreground().color();
    };
    QCOMPARE(colour_of_command(), gui::colour_of(picture::Role::curve, bench.text->palette()));
    QPalette dark = bench.text->palette();
    dark.setColor(QPalette::Window, QColor(20, 20, 20));
    dark.setColor(QPalette::WindowText, QColor(240, 240, 240));
    bench.text->setPalette(dark);
    QApplication::processEvents();
    QCOMPARE(colour_of_command(), gui::colour_of(picture::Role::curve, dark));
    const raster::Rgb light = picture::colour(picture::Role::curve, false);
    QVERIFY(colour_of_command() != QColor(light.red, light.green, light.blue));
  }

  void the_wheel_with_ctrl_zooms_the_text() {
    const Bench bench;
    const double before = bench.text->font().pointSizeF();
    QWheelEvent wheel({10.0, 10.0}, bench.text->mapToGlobal(QPointF(10.0, 10.0)), {}, {0, 120}, Qt::NoButton,
                      Qt::ControlModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(bench.text->viewport(), &wheel);
    QCOMPARE(bench.text->font().pointSizeF(), before + 1.0);
    QTest::keyClick(bench.text, Qt::Key_0, Qt::ControlModifier);
    QCOMPARE(bench.text->font().pointSizeF(), before);
  }

  void finding_goes_round_and_says_where_there_is_nothing() {
    const Bench bench;
    bench.editor.find_action()->trigger();
    auto* word = bench.editor.findChild<QLineEdit*>("find_text");
    auto* result = bench.editor.findChild<QLabel*>("find_result");
    QVERIFY(word->isVisible());
    QTest::keyClicks(word, "$target");
    QCOMPARE(bench.text->textCursor().blockNumber(), 4);
    QTest::keyClick(word, Qt::Key_Return);
    QCOMPARE(bench.text->textCursor().blockNumber(), 8);
    QTest::keyClick(word, Qt::Key_Return);
    QCOMPARE(bench.text->textCursor().blockNumber(), 4);
    QTest::keyClicks(word, "xyz");
    QCOMPARE(result->text(), QString("Not found"));
    QTest::keyClick(word, Qt::Key_Escape);
    QVERIFY(!word->isVisible());
  }

  void the_command_line_is_copied_with_the_file_name_quoted() {
    Bench bench;
    QVERIFY(!bench.editor.copy_command_action()->isEnabled());
    QVERIFY(bench.editor.command_line().isEmpty());
    const QTemporaryDir folder;
    const std::string path = folder.filePath("ship's echo.scr").toStdString();
    bench.session.save(path);
    bench.editor.copy_command_action()->trigger();
    QCOMPARE(QApplication::clipboard()->text(), "sarsim run '" + folder.filePath("ship'\\''s echo.scr") + "'");
  }

  void a_long_script_comes_in_pieces_and_takes_no_keys_until_it_is_there() {
    gui::Session session;
    session.take(scene::Document::from_text(scene::write_script(test::many_targets(5000))));
    gui::ScriptEditor editor(session);
    editor.show();
    gui::ScriptText& text = editor.text();
    QVERIFY(!text.is_complete() && text.isReadOnly());
    const QString beginning = text.script();
    QVERIFY(!beginning.isEmpty() && beginning.size() < static_cast<qsizetype>(session.document().text().size()));
    QTest::keyClicks(&text, "lost");
    QCOMPARE(text.script(), beginning);
    // What happens meanwhile is not lost.
    session.perform(scene::add_object(session.scene(), scene::Target()));
    const QString other = QString::fromStdString(session.document().text());
    QTRY_COMPARE_WITH_TIMEOUT(text.script(), other, 10'000);
    QTRY_VERIFY(text.is_complete() && !text.isReadOnly());
    editor.commit();
    QCOMPARE(QString::fromStdString(session.document().text()), other);
    // A problem at the end is gone to at once.
    session.take(scene::Document::from_text(other.toStdString() + "$TARGET nonsense\n"));
    core::Place place;
    place.line = static_cast<std::size_t>(other.count('\n')) + 1;
    editor.jump_to(place);
    QCOMPARE(text.textCursor().blockNumber() + 1, static_cast<int>(place.line));
  }

  void another_document_does_not_mix_with_a_text_that_is_still_put_in() {
    gui::Session session;
    session.take(scene::Document::from_text(scene::write_script(test::many_targets(5000))));
    gui::ScriptEditor editor(session);
    editor.show();
    QVERIFY(!editor.text().is_complete());
    session.add(scene::Document::from_text(two_targets));
    QTest::qWait(50);
    QCOMPARE(editor.text().script().toStdString(), two_targets);
    session.turn_to(0);
    QTRY_COMPARE_WITH_TIMEOUT(editor.text().script().toStdString(), session.document().text(), 10'000);
  }

  void a_long_script_is_shown_and_followed_quickly() {
    scene::Scene scene = test::many_targets(5000);
    const test::ProcessorTime showing;
    Bench bench(scene::write_script(scene));
    const double shown_s = showing.seconds();
    const test::ProcessorTime following;
    bench.move_target(2500, {1.0, 2.0, 3.0});
    const double followed_s = following.seconds();
    qInfo() << bench.text->blockCount() << "lines [ms]: shown in" << 1e3 * shown_s << "edit followed in"
            << 1e3 * followed_s;
    QCOMPARE(bench.text->script().toStdString(), bench.session.document().text());
    QVERIFY(followed_s < 2.0);
  }

  void an_editor_that_nobody_sees_catches_up_when_shown() {
    Bench bench;
    bench.editor.hide();
    bench.move_target(0, {9.0, 9.0, 9.0});
    bench.editor.show();
    QCOMPARE(bench.text->script().toStdString(), bench.session.document().text());
  }
};

const test::AddTest added("script_editor_test", test::run_test<ScriptEditorTest>);

}  // namespace sarsim::script_editor_test

#include "script_editor_test.moc"
