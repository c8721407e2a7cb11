#include <QAbstractItemModelTester>
#include <QAction>
#include <QApplication>
#include <QDrag>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

#include <functional>
#include <memory>

#include "gui/common/problem_line.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/objects/object_tree_model.hpp"
#include "gui/paint_count.hpp"
#include "small_scene.hpp"
#include "support/processor_time.hpp"

namespace sarsim::tree_test {
namespace {

struct Bench {
  Bench() { start(test::small_scene()); }
  explicit Bench(const scene::Scene& scene) { start(scene); }
  void start(const scene::Scene& scene) {
    test::open(session, scene);
    tree.resize(400, 600);
    tree.show();
    view = tree.findChild<QTreeView*>("object_tree");
    filter = tree.findChild<QLineEdit*>("object_filter");
    model = qobject_cast<gui::ObjectTreeModel*>(view->model());
    tester = std::make_unique<QAbstractItemModelTester>(model, QAbstractItemModelTester::FailureReportingMode::QtTest);
  }

  // The row whose text begins like this; below a row of the first level, or there.
  [[nodiscard]] QModelIndex row(const QString& text) const {
    for (int i = 0; i < model->rowCount(); ++i) {
      const QModelIndex top = model->index(i, 0);
      if (top.data().toString().startsWith(text)) return top;
      for (int j = 0; j < model->rowCount(top); ++j)
        if (model->index(j, 0, top).data().toString().startsWith(text)) return model->index(j, 0, top);
    }
    return {};
  }
  [[nodiscard]] QStringList below(const QString& top) const {
    QStringList texts;
    const QModelIndex index = row(top);
    for (int j = 0; j < model->rowCount(index); ++j) texts += model->index(j, 0, index).data().toString();
    return texts;
  }
  void click(const QString& text, Qt::KeyboardModifiers modifiers = {}) const {
    const QModelIndex index = row(text);
    view->scrollTo(index);
    QTest::mouseClick(view->viewport(), Qt::LeftButton, modifiers, view->visualRect(index).center());
  }
  void double_click(const QString& text) const {
    const QPoint at = view->visualRect(row(text)).center();
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(view->viewport(), Qt::LeftButton, {}, at);
  }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const { QTest::keyClick(view, key, modifiers); }
  // Drops what is selected onto a row, as the drag of a mouse would; false where the row does not take it.
  [[nodiscard]] bool drop_selection_on(const QString& text) const {
    const std::unique_ptr<QMimeData> data(model->mimeData(view->selectionModel()->selectedIndexes()));
    if (!data) return false;
    const QPoint at = view->visualRect(row(text)).center();
    QDragEnterEvent enter(at, Qt::MoveAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(view->viewport(), &enter);
    QDragMoveEvent move(at, Qt::MoveAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(view->viewport(), &move);
    if (!move.isAccepted()) return false;
    QDropEvent drop(at, Qt::MoveAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(view->viewport(), &drop);
    return drop.isAccepted();
  }
  void rename_in_editor(const QString& text) const {
    auto* editor = view->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor != nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
    QTest::qWait(1);  // The view takes the text in the next turn of the event loop.
  }
  void choose(const char* action) {
    const auto menu = tree.context_menu();
    auto* found = menu->findChild<QAction*>(action);
    QVERIFY2(found != nullptr && found->isEnabled(), action);
    found->trigger();
  }

  gui::Session session;
  gui::ObjectTree tree{session};
  QTreeView* view = nullptr;
  QLineEdit* filter = nullptr;
  gui::ObjectTreeModel* model = nullptr;
  std::unique_ptr<QAbstractItemModelTester> tester;
};

}  // namespace

class TreeTest : public QObject {
  Q_OBJECT

 private slots:
  void platforms_hold_what_stands_on_them_and_products_have_headings() {
    const Bench bench;
    QCOMPARE(bench.below("Earth"),
             QStringList({"Radar1", "Target 1 (1000, 0, 0) m", "Target 2 (2000, 0, 0) m", "Surface 1"}));
    QCOMPARE(bench.below("Ship"), QStringList({"Radar2", "Target 3 (3000, 0, 0) m"}));
    QCOMPARE(bench.below("Stored simulations"), QStringList({"sim1.bin"}));
    QCOMPARE(bench.below("Geometry tables"), QStringList({"geo1.txt"}));
    QVERIFY(!bench.view->accessibleName().isEmpty() && !bench.filter->accessibleName().isEmpty());
  }

  void what_stands_on_no_platform_is_shown() {
    scene::Scene scene = test::small_scene();
    scene.targets[0].platform = "Nowhere";
    const Bench bench(scene);
    QCOMPARE(bench.below("World"), QStringList({"Target 1 (1000, 0, 0) m"}));
    QVERIFY2(bench.row("Target 1").data(Qt::AccessibleTextRole).toString().contains("Error"), "told in words");
    QVERIFY(bench.row("Target 1").data(Qt::ToolTipRole).toString().contains("no platform has this name"));
  }

  void selection_is_the_sessions_both_ways() {
    Bench bench;
    bench.click("Target 2");
    QVERIFY(bench.session.selection() == std::set<scene::ObjectId>{test::target(1)});
    bench.click("Radar2", Qt::ControlModifier);
    QVERIFY(bench.session.selection() == (std::set<scene::ObjectId>{test::target(1), test::radar(1)}));
    QVERIFY(bench.session.current() == test::radar(1));
    bench.session.select({test::target(0), test::target(2)});
    const QModelIndexList rows = bench.view->selectionModel()->selectedRows();
    QCOMPARE(rows.size(), 2);
    QVERIFY(rows.contains(bench.row("Target 1")) && rows.contains(bench.row("Target 3")));
    bench.click("Target 1");
    bench.click("Surface 1", Qt::ShiftModifier);
    QCOMPARE(bench.session.selection().size(), std::size_t{3});
  }

  void headings_cannot_be_selected() {
    Bench bench;
    bench.click("Target 1");
    QVERIFY(!bench.model->flags(bench.row("Stored simulations")).testFlag(Qt::ItemIsSelectable));
    bench.click("Stored simulations");
    QVERIFY(bench.session.selection().empty());
  }

  void f2_renames_and_references_follow() {
    Bench bench;
    bench.click("Ship");
    bench.key(Qt::Key_F2);
    bench.rename_in_editor("Boat");
    QCOMPARE(bench.session.scene().platforms[1].name, std::string("Boat"));
    QCOMPARE(bench.session.scene().radars[1].platform, std::string("Boat"));
    QCOMPARE(bench.below("Boat").size(), 2);
    bench.session.undo();
    QCOMPARE(bench.below("Ship").size(), 2);
  }

  void a_double_click_renames_a_radar_and_asks_to_edit_a_target() {
    Bench bench;
    QSignalSpy wanted(&bench.tree, &gui::ObjectTree::edit_requested);
    bench.double_click("Radar1");
    bench.rename_in_editor("Eye");
    QCOMPARE(bench.session.scene().radars[0].name, std::string("Eye"));
    QCOMPARE(bench.session.scene().simulations[0].radar, std::string("Eye"));
    QCOMPARE(wanted.size(), 0);
    bench.double_click("Target 1");
    QCOMPARE(wanted.size(), 1);
    QVERIFY(wanted[0][0].value<scene::ObjectId>() == test::target(0));
  }

  void a_name_that_is_taken_is_refused_with_a_reason() {
    Bench bench;
    QSignalSpy logged(&bench.session, &gui::Session::logged);
    bench.click("Ship");
    bench.key(Qt::Key_F2);
    bench.rename_in_editor("EARTH");
    QCOMPARE(bench.session.scene().platforms[1].name, std::string("Ship"));
    QVERIFY(!bench.tree.findChild<gui::ProblemLine*>("object_message")->text().isEmpty());
    QCOMPARE(logged.size(), 1);
  }

  void delete_takes_all_that_is_selected_in_one_step() {
    Bench bench;
    const scene::Scene before = bench.session.scene();
    bench.click("Target 1");
    bench.click("Ship", Qt::ControlModifier);
    bench.key(Qt::Key_Delete);
    QCOMPARE(bench.session.scene().platforms.size(), std::size_t{1});
    QCOMPARE(bench.session.scene().targets.size(), std::size_t{1});
    QCOMPARE(bench.session.scene().radars.size(), std::size_t{1});
    QVERIFY(!bench.row("Ship").isValid());
    bench.session.undo();
    QVERIFY(bench.session.scene() == before);
    QVERIFY(bench.row("Ship").isValid());
    QVERIFY(!bench.session.document().history().can_undo());
  }

  void ctrl_d_duplicates_and_selects_the_copies() {
    Bench bench;
    bench.click("Ship");
    bench.key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(bench.session.scene().platforms.size(), std::size_t{3});
    QCOMPARE(bench.session.scene().targets.size(), std::size_t{4});
    QVERIFY(bench.session.selection() == std::set<scene::ObjectId>{test::platform(2)});
    bench.session.undo();
    bench.click("Target 2");
    bench.key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(bench.session.scene().targets.size(), std::size_t{4});
    QVERIFY(bench.session.scene().targets[3] == bench.session.scene().targets[1]);
    QVERIFY(bench.session.selection() == std::set<scene::ObjectId>{test::target(3)});
  }

  void keys_of_a_name_being_typed_are_not_the_trees() {
    Bench bench;
    bench.click("Ship");
    bench.key(Qt::Key_F2);
    auto* editor = bench.view->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor != nullptr);
    QTest::keyClick(editor, Qt::Key_D, Qt::ControlModifier);
    QTest::keyClick(editor, Qt::Key_Delete);
    QCOMPARE(bench.session.scene().platforms.size(), std::size_t{2});
  }

  void dragging_carries_to_another_platform() {
    Bench bench;
    bench.click("Target 1");
    bench.click("Surface 1", Qt::ControlModifier);
    bench.click("Radar1", Qt::ControlModifier);
    const scene::Scene before = bench.session.scene();
    QVERIFY(bench.drop_selection_on("Ship"));
    QCOMPARE(bench.session.scene().targets[0].platform, std::string("Ship"));
    QCOMPARE(bench.session.scene().targets[0].position_m.x, 1000.0);
    QCOMPARE(bench.session.scene().surfaces[0].platform, std::string("Ship"));
    QCOMPARE(bench.session.scene().radars[0].platform, std::string("Ship"));
    QCOMPARE(bench.below("Earth").size(), 1);
    QCOMPARE(bench.session.selection().size(), std::size_t{3});
    bench.session.undo();
    QVERIFY(bench.session.scene() == before);
  }

  void a_drop_on_a_child_goes_to_its_platform() {
    Bench bench;
    bench.click("Target 1");
    QVERIFY(bench.drop_selection_on("Target 3"));
    QCOMPARE(bench.session.scene().targets[0].platform, std::string("Ship"));
  }

  void platforms_are_not_carried_and_headings_take_nothing() {
    Bench bench;
    bench.click("Ship");
    QVERIFY(!bench.drop_selection_on("Earth"));
    bench.click("Target 1");
    QVERIFY(!bench.drop_selection_on("Stored simulations"));
    QVERIFY(!bench.session.document().history().can_undo());
  }

  void a_drop_with_numbers_of_another_scene_is_refused() {
    Bench bench;
    bench.click("Target 3");
    const std::unique_ptr<QMimeData> data(bench.model->mimeData(bench.view->selectionModel()->selectedIndexes()));
    bench.session.perform(scene::remove_objects(bench.session.scene(), {test::target(2)}));
    QVERIFY(!bench.model->dropMimeData(data.get(), Qt::MoveAction, -1, -1, bench.row("Earth")));
  }

  void only_what_stands_on_a_platform_can_be_dragged() {
    Bench bench;
    bench.click("Target 1");
    QVERIFY(bench.model->flags(bench.row("Target 1")).testFlag(Qt::ItemIsDragEnabled));
    QVERIFY(!bench.model->flags(bench.row("Ship")).testFlag(Qt::ItemIsDragEnabled));
    QVERIFY(!bench.model->flags(bench.row("sim1.bin")).testFlag(Qt::ItemIsDragEnabled));
    QVERIFY(bench.view->dragEnabled() && bench.view->acceptDrops());
  }

  void the_filter_keeps_what_holds_all_words() {
    Bench bench;
    QTest::keyClicks(bench.filter, "targ 2000");
    QCOMPARE(bench.below("Earth"), QStringList({"Target 2 (2000, 0, 0) m"}));
    QVERIFY(!bench.row("Ship").isValid());
    QVERIFY(bench.view->isExpanded(bench.row("Earth")));
    bench.filter->setText("ship");
    QCOMPARE(bench.below("Ship").size(), 2);
    QVERIFY(!bench.row("Earth").isValid());
    QTest::keyClick(bench.filter, Qt::Key_Escape);
    QCOMPARE(bench.model->rowCount(), 4);
  }

  void the_filter_leaves_the_selection_alone() {
    Bench bench;
    bench.click("Target 1");
    bench.filter->setText("radar");
    QVERIFY(bench.session.selection() == std::set<scene::ObjectId>{test::target(0)});
    bench.filter->clear();
    QVERIFY(bench.view->selectionModel()->isSelected(bench.row("Target 1")));
  }

  void the_box_hides_and_shows_and_a_platform_takes_everything_along() {
    Bench bench;
    const auto box = [&](const QString& text) { return bench.row(text).siblingAtColumn(1); };
    QVERIFY(bench.model->setData(box("Target 1"), Qt::Unchecked, Qt::CheckStateRole));
    QVERIFY(bench.session.hidden() == std::set<scene::ObjectId>{test::target(0)});
    QVERIFY(bench.row("Target 1").data(Qt::AccessibleTextRole).toString().contains("hidden"));
    QVERIFY(bench.model->setData(box("Ship"), Qt::Unchecked, Qt::CheckStateRole));
    QCOMPARE(box("Target 3").data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Unchecked));
    QVERIFY(bench.model->setData(box("Radar2"), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(box("Ship").data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::PartiallyChecked));
    QVERIFY(!bench.session.document().history().can_undo());
  }

  void a_click_on_the_box_hides() {
    Bench bench;
    const QRect cell = bench.view->visualRect(bench.row("Target 2").siblingAtColumn(1));
    QTest::mouseClick(bench.view->viewport(), Qt::LeftButton, {}, QPoint(cell.left() + 10, cell.center().y()));
    QVERIFY(bench.session.hidden().contains(test::target(1)));
  }

  void the_menu_begins_with_modify_and_delete() {
    Bench bench;
    bench.click("Target 1");
    const auto menu = bench.tree.context_menu();
    QStringList names;
    for (const QAction* action : menu->actions())
      if (!action->isSeparator()) names += action->text().remove('&');
    QCOMPARE(names, QStringList({"Modify", "Delete", "Duplicate", "Rename", "Hide"}));
    QVERIFY(!menu->findChild<QAction*>("tree_rename")->isEnabled());
  }

  void the_menu_does_what_it_says() {
    Bench bench;
    QSignalSpy wanted(&bench.tree, &gui::ObjectTree::edit_requested);
    bench.click("Target 1");
    bench.choose("tree_modify");
    QCOMPARE(wanted.size(), 1);
    bench.choose("tree_hide");
    QVERIFY(bench.session.hidden().contains(test::target(0)));
    bench.choose("tree_show");
    QVERIFY(bench.session.hidden().empty());
    bench.choose("tree_duplicate");
    QCOMPARE(bench.session.scene().targets.size(), std::size_t{4});
    bench.choose("tree_delete");
    QCOMPARE(bench.session.scene().targets.size(), std::size_t{3});
    bench.click("Radar1");
    bench.choose("tree_rename");
    bench.rename_in_editor("Eye");
    QCOMPARE(bench.session.scene().radars[0].name, std::string("Eye"));
  }

  void inverting_a_surface_turns_its_front() {
    Bench bench;
    const auto corners = bench.session.scene().surfaces[0].corner_m;
    bench.click("Surface 1");
    bench.choose("tree_invert");
    QVERIFY(bench.session.scene().surfaces[0].corner_m[0] == corners[1]);
    QVERIFY(bench.session.scene().surfaces[0].corner_m[1] == corners[0]);
    bench.session.undo();
    QVERIFY(bench.session.scene().surfaces[0].corner_m == corners);
  }

  void folds_and_scroll_outlive_changes() {
    Bench bench(test::many_targets(500));
    scene::Scene scene = bench.session.scene();
    bench.session.perform(scene::add_object(scene, scene::Platform{}));
    const QString added = QString::fromStdString(bench.session.scene().platforms[1].name);
    bench.view->collapse(bench.row(added));
    bench.view->verticalScrollBar()->setValue(200);
    bench.session.perform(scene::remove_objects(bench.session.scene(), {test::target(499)}));
    QCOMPARE(bench.view->verticalScrollBar()->value(), 200);
    QVERIFY(bench.view->isExpanded(bench.row("Earth")));
    QVERIFY(!bench.view->isExpanded(bench.row(added)));
    bench.session.perform(scene::rename_object(bench.session.scene(), test::platform(1), "Folded"));
    bench.session.perform(scene::remove_objects(bench.session.scene(), {test::target(498)}));
    QVERIFY(!bench.view->isExpanded(bench.row("Folded")));
  }

  void changes_of_many_are_painted_and_selected_once() {
    Bench bench(test::many_targets(500));
    std::set<scene::ObjectId> odd;
    for (std::size_t i = 1; i < 500; i += 2) odd.insert(test::target(i));
    bench.session.select(odd);
    QCoreApplication::processEvents();
    test::PaintCount paints(bench.view->viewport());
    bench.session.set_hidden(odd, true);
    QCoreApplication::processEvents();
    QVERIFY(paints.count > 0);
    // What is gone before them moves all of them; the row of each is found and shown once.
    paints.count = 0;
    QSignalSpy selections(bench.view->selectionModel(), &QItemSelectionModel::selectionChanged);
    bench.session.perform(scene::remove_objects(bench.session.scene(), {test::target(0)}));
    QCoreApplication::processEvents();
    QVERIFY(paints.count > 0);
    QCOMPARE(selections.size(), 1);
    QCOMPARE(bench.view->selectionModel()->selectedRows().size(), 250);
    const auto is_selected = [&](std::size_t index) {
      return bench.view->selectionModel()->isSelected(bench.model->index_of(test::target(index)));
    };
    QVERIFY(is_selected(0) && !is_selected(1));
    // Other objects of the same number are shown as well.
    std::set<scene::ObjectId> even;
    for (std::size_t i = 1; i < 499; i += 2) even.insert(test::target(i));
    paints.count = 0;
    bench.session.select(even);
    QCoreApplication::processEvents();
    QVERIFY(paints.count > 0);
    QVERIFY(is_selected(1) && !is_selected(0));
  }

  void ten_thousand_targets_stay_quick() {
    Bench bench(test::many_targets(10000));
    bench.tester.reset();
    const auto seconds_of = [](const std::function<void()>& work) {
      const test::ProcessorTime time;
      work();
      return time.seconds();
    };
    const double same_s = seconds_of([&] { bench.model->refresh(); });
    bench.view->verticalScrollBar()->setValue(5000);
    const double filtered_s = seconds_of([&] { bench.model->set_filter("target"); });
    const double reset_s = seconds_of([&] {
      bench.model->set_filter("");
      bench.view->viewport()->repaint();
    });
    std::set<scene::ObjectId> all;
    for (std::size_t i = 0; i < 10000; ++i) all.insert(test::target(i));
    const double selected_s = seconds_of([&] {
      bench.session.select(all);
      bench.view->viewport()->repaint();
    });
    qInfo() << "10000 targets [ms]: same shape" << 1e3 * same_s << "filter" << 1e3 * filtered_s << "reset"
            << 1e3 * reset_s << "select all" << 1e3 * selected_s;
    QCOMPARE(bench.view->selectionModel()->selectedRows().size(), 10000);
    // Far above what it takes, for slow machines.
    for (const double seconds : {same_s, reset_s, selected_s}) QVERIFY(seconds < 0.5);
    QVERIFY(filtered_s < 2.0);
  }
};

const test::AddTest added("tree_test", test::run_test<TreeTest>);

}  // namespace sarsim::tree_test

#include "tree_test.moc"
