#include <QSignalSpy>
#include <QTest>

#include "gui/gui_test.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/script/script_coding.hpp"
#include "gui/script/script_editor.hpp"
#include "gui/script/script_text.hpp"
#include "gui/small_scene.hpp"
#include "gui/window_drags.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::drag_test {
namespace {

scene::Edit move_to(const gui::Session& session, double x, const char* key) {
  scene::Target moved = session.scene().targets[0];
  moved.position_m.x = x;
  return scene::replace_object(session.scene(), test::target(0), moved, "Move target", key);
}

scene::Edit set_rcs(const gui::Session& session, double rcs_m2, const char* key) {
  scene::Target faulty = session.scene().targets[0];
  faulty.rcs_m2 = rcs_m2;
  return scene::replace_object(session.scene(), test::target(0), faulty, "Change target", key);
}

bool about_rcs(const core::Problems& problems) {
  return std::ranges::any_of(problems, [](const core::Problem& problem) { return problem.subject.field == "rcs_m2"; });
}

// Ten times what a hand notices: a busy machine and a build with every check must not fail, a step that grows with the
// square of the scene must.
constexpr double far_too_long_ms = 330.0;

}  // namespace

class DragTest : public QObject {
  Q_OBJECT

 private slots:
  void the_window_follows_the_hand_with_ten_thousand_targets() {
    test::WindowDrags drags(10'000);
    drags.open_target_table();
    const std::pair<const char*, test::AnswerTimes> all[] = {{"turn the scene", drags.rotate(12)},
                                                             {"scrub the time", drags.scrub(12)},
                                                             {"drag a target", drags.move_target(12)},
                                                             {"step a coordinate", drags.step_coordinate(12)}};
    for (const auto& [what, times] : all) {
      qInfo("%s: %.1f ms, at worst %.1f ms", what, times.median(), times.worst());
      QVERIFY2(times.busy_median() < far_too_long_ms, what);
    }
  }

  void problems_of_a_run_are_looked_for_when_it_pauses() {
    gui::Session session;
    test::open(session, test::small_scene());
    QSignalSpy looked(&session, &gui::Session::problems_changed);
    session.perform(set_rcs(session, -1.0, "step"));
    QVERIFY(!about_rcs(session.problems()));
    QTRY_COMPARE(looked.size(), 1);
    QVERIFY(about_rcs(session.problems()));
  }

  void problems_of_a_run_are_looked_for_when_it_ends() {
    gui::Session session;
    test::open(session, test::small_scene());
    QSignalSpy looked(&session, &gui::Session::problems_changed);
    session.perform(set_rcs(session, -1.0, "step"));
    session.end_run();
    QCOMPARE(looked.size(), 1);
    QVERIFY(about_rcs(session.problems()));
    session.end_run();
    QCOMPARE(looked.size(), 1);
  }

  void problems_of_a_single_edit_are_known_at_once() {
    gui::Session session;
    test::open(session, test::small_scene());
    session.perform(set_rcs(session, -1.0, ""));
    QVERIFY(about_rcs(session.problems()));
    session.undo();
    QVERIFY(!about_rcs(session.problems()));
    session.redo();
    QVERIFY(about_rcs(session.problems()));
    session.take(scene::Document());
    QVERIFY(!about_rcs(session.problems()));
  }

  void an_edit_that_comes_to_nothing_leaves_the_selection_where_it_is() {
    gui::Session session;
    test::open(session, test::small_scene());
    session.select_only(test::target(2));
    session.perform(scene::remove_objects(session.scene(), {test::target(0)}));
    QVERIFY(session.current() == test::target(1));
    session.perform(move_to(session, session.scene().targets[0].position_m.x, ""));
    QVERIFY(session.current() == test::target(1));
  }

  void the_editor_follows_a_drag_in_any_coding_data() {
    QTest::addColumn<QByteArray>("comment");
    QTest::addColumn<QByteArray>("line_end");
    const QByteArray plain = "! plain";
    const QByteArray utf8 = "! \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x9B\xB0";
    const QByteArray latin1 = "! \xE4\xF6";
    QTest::newRow("plain, LF") << plain << QByteArray("\n");
    QTest::newRow("plain, CR LF") << plain << QByteArray("\r\n");
    QTest::newRow("plain, CR") << plain << QByteArray("\r");
    QTest::newRow("UTF-8, LF") << utf8 << QByteArray("\n");
    QTest::newRow("UTF-8, CR LF") << utf8 << QByteArray("\r\n");
    QTest::newRow("Latin-1, LF") << latin1 << QByteArray("\n");
    QTest::newRow("Latin-1, CR LF") << latin1 << QByteArray("\r\n");
    QTest::newRow("Latin-1, CR") << latin1 << QByteArray("\r");
  }
  void the_editor_follows_a_drag_in_any_coding() {
    QFETCH(QByteArray, comment);
    QFETCH(QByteArray, line_end);
    QByteArray script = QByteArray::fromStdString(scene::write_script(test::small_scene()));
    script = comment + "\n" + script + comment + "\n";
    script.replace("\n", line_end);
    gui::Session session;
    session.take(scene::Document::from_text(script.toStdString()));
    gui::ScriptEditor editor(session);
    editor.show();
    const auto agrees = [&] {
      const std::string& text = session.document().text();
      return editor.text().script() == gui::decoded(text, gui::coding_of(text));
    };
    QVERIFY(agrees());
    for (int i = 1; i <= 5; ++i) {
      session.perform(move_to(session, 1234.5 * i * i, "drag"));
      QVERIFY(agrees());
    }
    session.undo();
    QVERIFY(agrees());
    QVERIFY(QByteArray::fromStdString(session.document().text()) == script);
    session.redo();
    QVERIFY(agrees());
    session.perform(scene::remove_objects(session.scene(), {test::platform(1)}));
    QVERIFY(agrees());
    session.undo();
    QVERIFY(agrees());
  }

  void changes_of_bytes_are_told_in_characters() {
    const gui::ScriptCoding utf8;
    const std::string text = "\xC3\xA4\xF0\x9F\x9B\xB0 12\nxyz";  // two characters of 1 and 2 units
    const auto forwards = gui::decoded_changes({{7, "5", "12"}, {9, "ab", "xyz"}}, true, text, utf8);
    QVERIFY(forwards.has_value());
    QCOMPARE(forwards->size(), std::size_t{2});
    QCOMPARE((*forwards)[0].at, 4);
    QCOMPARE((*forwards)[0].removed, 1);
    QCOMPARE((*forwards)[0].put_in, QString("12"));
    QCOMPARE((*forwards)[1].at, 7);
    QCOMPARE((*forwards)[1].removed, 2);
    const auto backwards = gui::decoded_changes({{7, "12", "5"}}, false, text, utf8);
    QVERIFY(backwards.has_value());
    QCOMPARE((*backwards)[0].at, 4);
    QCOMPARE((*backwards)[0].put_in, QString("12"));
  }

  void changes_that_could_join_what_stood_apart_are_not_told() {
    const gui::ScriptCoding utf8;
    const gui::ScriptCoding latin1{true, gui::ScriptCoding::LineEnd::lf};
    const gui::ScriptCoding crlf{false, gui::ScriptCoding::LineEnd::crlf};
    QVERIFY(!gui::decoded_changes({{1, "x", ""}}, true, "\xC3\xA4", latin1));        // now one character
    QVERIFY(!gui::decoded_changes({{0, "x", "\xC3\xA4"}}, true, "\xC3\xA4", utf8));  // not of one byte
    QVERIFY(!gui::decoded_changes({{2, "x", ""}}, true, "a\r\nb", crlf));            // now one line end
    QVERIFY(!gui::decoded_changes({{1, "\n", "\r\n"}}, true, "a\r\nb", utf8));       // the text has other line ends
    QVERIFY(!gui::decoded_changes({{3, "x\r", "y"}}, true, "\r\nay\nb", crlf));  // was one line end with what follows
    QVERIFY(!gui::decoded_changes({{9, "x", "y"}}, true, "short", utf8));
  }
};

const test::AddTest added("drag_test", test::run_test<DragTest>);

}  // namespace sarsim::drag_test

#include "drag_test.moc"
