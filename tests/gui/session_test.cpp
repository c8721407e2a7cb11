#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>

#include "gui/gui_test.hpp"
#include "gui/objects/object_tree_model.hpp"
#include "gui/objects/target_table_model.hpp"
#include "gui/small_scene.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::session_test {
namespace {

// A session of the small scene and what it says of its changes.
struct Announced {
  gui::Session session;
  std::vector<scene::SceneChange> changes;
  int others = 0;  // of the signals that tell of anything else than the selection

  Announced() {
    test::open(session, test::small_scene());
    QObject::connect(&session, &gui::Session::scene_changed,
                     [this](const scene::SceneChange& change) { changes.push_back(change); });
    QObject::connect(&session, &gui::Session::document_changed, [this] { ++others; });
    QObject::connect(&session, &gui::Session::problems_changed, [this] { ++others; });
  }

  [[nodiscard]] scene::Edit move_target(std::size_t index, double x) const {
    scene::Target target = session.scene().targets[index];
    target.position_m.x = x;
    return scene::replace_object(session.scene(), test::target(index), target, "Move target");
  }

  [[nodiscard]] std::vector<scene::ObjectId> changed() const {
    std::vector<scene::ObjectId> ids;
    for (const scene::ChangedObject& object : changes.back().changed) ids.push_back(object.id);
    return ids;
  }
};

std::vector<std::string> words_of(const core::Problems& problems) {
  std::vector<std::string> words;
  for (const core::Problem& problem : problems) words.push_back(core::to_string(problem));
  return words;
}

using Ids = std::vector<scene::ObjectId>;

}  // namespace

class SessionTest : public QObject {
  Q_OBJECT

 private slots:
  void every_change_is_announced_once_with_what_it_changed() {
    Announced told;
    told.session.perform(told.move_target(1, 55.0));
    QCOMPARE(told.changes.size(), std::size_t{1});
    QVERIFY(told.changed() == Ids{test::target(1)});
    told.session.undo();
    QCOMPARE(told.changes.size(), std::size_t{2});
    QVERIFY(told.changed() == Ids{test::target(1)});
    told.session.redo();
    QCOMPARE(told.changes.size(), std::size_t{3});
    told.session.perform(scene::remove_objects(told.session.scene(), {test::target(0)}));
    QCOMPARE(told.changes.size(), std::size_t{4});
    QVERIFY(told.changes.back().removed == Ids{test::target(0)});
    told.session.undo();
    QVERIFY(told.changes.back().inserted == Ids{test::target(0)});
    QCOMPARE(told.others, 0);
  }

  void another_document_is_everything() {
    Announced told;
    told.session.take(scene::Document());
    QCOMPARE(told.changes.size(), std::size_t{1});
    QVERIFY(told.changes.back().everything);
  }

  void an_edit_that_comes_to_nothing_names_what_it_was_to_change() {
    Announced told;
    told.session.perform(told.move_target(1, told.session.scene().targets[1].position_m.x));
    QCOMPARE(told.changes.size(), std::size_t{1});
    QVERIFY(told.changed() == Ids{test::target(1)});
  }

  void a_comment_leaves_the_scene_as_it_is() {
    Announced told;
    const auto shared = told.session.shared_scene();
    told.session.type_text(told.session.document().text() + "! a comment\n");
    QCOMPARE(told.changes.size(), std::size_t{1});
    QVERIFY(told.changes.back().empty());
    QVERIFY(told.session.shared_scene() == shared);
  }

  void a_document_that_was_saved_is_no_change_of_the_scene() {
    Announced told;
    QTemporaryDir folder;
    told.session.save((folder.path() + "/scene.scr").toStdString());
    QCOMPARE(told.changes.size(), std::size_t{0});
    QCOMPARE(told.others, 2);  // the path, and problems that name it
  }

  void the_scene_is_shared_until_it_changes() {
    Announced told;
    const auto before = told.session.shared_scene();
    QVERIFY(told.session.shared_scene() == before);
    QVERIFY(*before == told.session.scene());
    told.session.perform(told.move_target(0, 77.0));
    QVERIFY(told.session.shared_scene() != before);
    QVERIFY(*told.session.shared_scene() == told.session.scene());
    QVERIFY(before->targets[0].position_m.x != 77.0);
    told.session.take(scene::Document());
    QVERIFY(*told.session.shared_scene() == told.session.scene());
  }

  // Reading a text of a megabyte again would hold a hand up.
  void problems_of_a_long_text_are_looked_for_in_the_background() {
    Announced told;
    scene::Scene scene = test::many_targets(6000);
    scene.radars[0].prf_hz = 0.0;
    told.session.take(scene::Document::from_text(scene::write_script(scene)));
    QVERIFY(told.session.document().text().size() > 300'000);
    const std::vector<std::string> found = words_of(told.session.problems());
    QVERIFY(!found.empty());
    told.others = 0;
    told.session.perform(told.move_target(1, 55.0));
    told.session.end_run();
    QVERIFY(words_of(told.session.problems()) == found);  // about the same objects
    QTRY_COMPARE(told.others, 1);
    QVERIFY(!told.session.problems().empty());
    QVERIFY(words_of(told.session.problems()) == words_of(told.session.document().problems()));
    // What is gone is not told of.
    told.session.perform(scene::remove_objects(told.session.scene(), {test::radar(0)}));
    QVERIFY(told.session.problems().empty());
    told.session.undo();
    QTRY_VERIFY(!told.session.problems().empty());
    // Nor is what another document has.
    told.session.undo();
    told.session.add(scene::Document());
    QVERIFY(told.session.problems().empty());
    QTest::qWait(300);
    QVERIFY(told.session.problems().empty());
    told.session.turn_to(0);
    QTRY_VERIFY(!told.session.problems().empty());
  }

  void an_edit_of_many_objects_leaves_the_windows_time() {
    constexpr std::size_t many = 20'000;
    const std::vector<scene::Target> targets = test::many_targets(many).targets;
    Announced told;
    scene::Document alone = told.session.document();
    alone.perform(scene::add_targets(alone.scene(), targets));
    int turns = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, [&] { ++turns; });
    timer.start(1);
    told.session.perform(scene::add_targets(told.session.scene(), targets));
    QVERIFY2(turns > 0, "no event was handled meanwhile");
    QCOMPARE(told.changes.size(), std::size_t{1});
    QCOMPARE(told.changes.back().inserted.size(), many);
    QVERIFY(told.session.document().text() == alone.text());
    QVERIFY(told.session.scene() == alone.scene());
    QVERIFY(words_of(told.session.problems()) == words_of(alone.problems()));
    const auto undone = [&] {
      QCOMPARE(told.session.scene().targets.size(), std::size_t{3});
      QVERIFY(!told.session.document().changed());
    };
    for (const auto step : {&gui::Session::undo, &gui::Session::redo, &gui::Session::take_back}) {
      turns = 0;
      (told.session.*step)();
      QVERIFY2(turns > 0, "no event was handled meanwhile");
      if (step != &gui::Session::redo) undone();
      if (step == &gui::Session::redo) QVERIFY(told.session.document().text() == alone.text());
      if (step == &gui::Session::redo) QCOMPARE(told.changes.back().inserted.size(), many);
    }
    QVERIFY(!told.session.document().history().can_redo());
    // Where somebody else changes the document meanwhile, the edit is made on what is there.
    QTimer::singleShot(0, [&] { told.session.perform(told.move_target(1, 55.0)); });
    told.session.perform(scene::add_targets(told.session.scene(), targets));
    QCOMPARE(told.session.scene().targets.size(), many + 3);
    QCOMPARE(told.session.scene().targets[1].position_m.x, 55.0);
  }

  void an_edit_of_many_objects_is_made_on_another_thread() {
    Announced told;
    const auto make = [](std::thread::id* at) {
      return [at](const scene::Document& document, scene::Edit& edit) {
        *at = std::this_thread::get_id();
        edit = scene::remove_objects(document.scene(), {test::target(0)});
        return std::string();
      };
    };
    std::thread::id few;
    QCOMPARE(told.session.make_and_perform("Remove", 3, make(&few)), std::string());
    QCOMPARE(few, std::this_thread::get_id());
    std::thread::id many;
    QCOMPARE(told.session.make_and_perform("Remove", 1'000'000, make(&many)), std::string());
    QVERIFY(many != std::thread::id() && many != few);
    QCOMPARE(told.session.scene().targets.size(), std::size_t{1});
    QCOMPARE(told.changes.size(), std::size_t{2});
  }

  void an_edit_that_cannot_be_made_changes_nothing_and_says_why() {
    Announced told;
    for (const std::size_t objects : {std::size_t{1}, std::size_t{1'000'000}}) {
      const std::string why = told.session.make_and_perform(
          "Fill", objects, [](const scene::Document&, scene::Edit&) { return std::string("the RCS is negative"); });
      QCOMPARE(why, std::string("the RCS is negative"));
    }
    const std::string failed = told.session.make_and_perform(
        "Fill", 1'000'000,
        [](const scene::Document&, scene::Edit&) -> std::string { throw std::out_of_range("there is no target 7"); });
    QCOMPARE(failed, std::string("there is no target 7"));
    // It was made for a scene that is no longer there.
    QTimer::singleShot(0, [&] { told.session.perform(told.move_target(1, 55.0)); });
    const std::string late =
        told.session.make_and_perform("Remove", 1'000'000, [](const scene::Document& document, scene::Edit& edit) {
          std::this_thread::sleep_for(std::chrono::milliseconds(100));
          edit = scene::remove_objects(document.scene(), {test::target(0)});
          return std::string();
        });
    QCOMPARE(late, std::string("the scene was changed meanwhile"));
    QCOMPARE(told.session.scene().targets.size(), std::size_t{3});
    QCOMPARE(told.changes.size(), std::size_t{1});
  }

  void a_selection_is_told_when_the_scene_is_known() {
    Announced told;
    told.session.select({test::target(1), test::target(2)});
    const std::uint64_t number = told.session.selection_number();
    QStringList order;
    connect(&told.session, &gui::Session::scene_changed, [&] { order += "scene"; });
    connect(&told.session, &gui::Session::selection_changed, [&] { order += "selection"; });
    told.session.perform(scene::remove_objects(told.session.scene(), {test::target(0)}));
    QCOMPARE(order, QStringList({"scene", "selection"}));
    QVERIFY(told.session.selection() == (std::set{test::target(0), test::target(1)}));
    QVERIFY(told.session.selection_number() != number);
    // The one that is gone was not selected, and none of the others moves.
    order.clear();
    told.session.select_only(test::target(0));
    order.clear();
    told.session.perform(scene::remove_objects(told.session.scene(), {test::target(1)}));
    QCOMPARE(order, QStringList({"scene"}));
  }

  void a_moved_target_refreshes_its_rows_alone() {
    Announced told;
    gui::ObjectTreeModel tree(told.session);
    gui::TargetTableModel table(told.session);
    QSignalSpy of_tree(&tree, &QAbstractItemModel::dataChanged);
    QSignalSpy of_table(&table, &QAbstractItemModel::dataChanged);
    told.session.perform(told.move_target(1, 55.0));
    QCOMPARE(of_tree.size(), 1);
    QCOMPARE(of_tree[0][0].toModelIndex(), tree.index_of(test::target(1)));
    QCOMPARE(of_tree[0][1].toModelIndex().row(), tree.index_of(test::target(1)).row());
    QCOMPARE(of_table.size(), 1);
    QCOMPARE(of_table[0][0].toModelIndex().row(), 1);
    QCOMPARE(of_table[0][1].toModelIndex().row(), 1);
  }
};

const test::AddTest added("session_test", test::run_test<SessionTest>);

}  // namespace sarsim::session_test

#include "session_test.moc"
