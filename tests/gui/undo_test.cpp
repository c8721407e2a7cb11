#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "gui/echo/data_saver.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/function_editor.hpp"
#include "gui/objects/import_dialog.hpp"
#include "gui/objects/object_tree.hpp"
#include "gui/objects/object_tree_model.hpp"
#include "gui/objects/property_panel.hpp"
#include "gui/objects/target_table.hpp"
#include "gui/objects/target_table_model.hpp"
#include "gui/runs/run_panel.hpp"
#include "gui/runs/save_data_dialog.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/script/script_coding.hpp"
#include "gui/script/script_editor.hpp"
#include "gui/script/script_text.hpp"
#include "gui/start/tour_panel.hpp"
#include "scene/edit/edit_test_support.hpp"
#include "scene/script/reader.hpp"
#include "small_scene.hpp"
#include "text_files.hpp"

// Every way to change a scene, undone and done again: scene and text come back, byte by byte.

namespace sarsim::undo_test {
namespace {

using test::file_text;
using test::platform;
using test::radar;
using test::target;

constexpr scene::ObjectId first_simulation{scene::ObjectKind::simulation, 0};
constexpr scene::ObjectId first_surface{scene::ObjectKind::surface, 0};

// The small scene with a path for the ship, and with comments above, beside and behind its commands.
std::string commented_script() {
  scene::Scene scene = test::small_scene();
  scene::Platform& ship = scene.platforms[1];
  ship.path = scene::Platform::Path::trajectory;
  for (core::SampledFunction& part : ship.trajectory_m.part) part.knots = {{0.0, 10.0}, {1.0, 150.0}};
  std::istringstream lines(scene::write_script(scene));
  std::string script = "! A scene for tests\n\n";
  int number = 0;
  for (std::string line; std::getline(lines, line); ++number) {
    if (line.starts_with("$")) script += "! about the next command\n";
    script += line;
    if (number % 3 == 0 && !line.empty() && line.find('!') == std::string::npos) script += "   ! beside";
    script += '\n';
  }
  return script + "\n! the end";
}

// --- Makers of edits ------------------------------------------------------------------------------------------------

using Maker = std::function<scene::Edit(const scene::Scene&)>;

// By the names of the functions in scene/edit/edit.hpp that make edits; one entry for each or more.
const std::multimap<std::string, Maker>& makers() {
  static const std::multimap<std::string, Maker> all{
      {"replace_object",
       [](const scene::Scene& scene) {
         scene::Target moved = scene.targets[1];
         moved.position_m = {1.25, -3e6, 0.1};
         return scene::replace_object(scene, target(1), moved, "Move target");
       }},
      {"replace_object",
       [](const scene::Scene& scene) {
         scene::Radar other = scene.radars[0];
         other.pulse = scene::Radar::Pulse::barker;
         other.bandwidth_hz = scene::Radar{}.bandwidth_hz;
         other.carrier = scene::Radar::Carrier::stepped;
         return scene::replace_object(scene, radar(0), other, "Change radar");
       }},
      {"add_object", [](const scene::Scene& scene) { return scene::add_object(scene, scene::Platform{}); }},
      {"add_object", [](const scene::Scene& scene) { return scene::add_object(scene, scene::Target{}); }},
      {"add_object", [](const scene::Scene& scene) { return scene::add_object(scene, scene::Surface{}); }},
      {"add_object", [](const scene::Scene& scene) { return scene::add_object(scene, scene::Radar{}); }},
      {"add_object", [](const scene::Scene& scene) { return scene::add_object(scene, scene.simulations[0]); }},
      {"add_object", [](const scene::Scene& scene) { return scene::add_object(scene, scene.geometries[0]); }},
      {"remove_objects",
       [](const scene::Scene& scene) {
         return scene::remove_objects(scene, {target(0), target(2)});
       }},
      {"remove_objects", [](const scene::Scene& scene) { return scene::remove_objects(scene, {platform(0)}); }},
      {"remove_objects",
       [](const scene::Scene& scene) {
         return scene::remove_objects(scene, {radar(0), first_surface});
       }},
      {"duplicate_objects",
       [](const scene::Scene& scene) {
         return scene::duplicate_objects(scene, {platform(1), target(0)});
       }},
      {"rename_object",
       [](const scene::Scene& scene) { return scene::rename_object(scene, platform(1), "Great ship"); }},
      {"rename_object", [](const scene::Scene& scene) { return scene::rename_object(scene, radar(0), "X"); }},
      {"carry_objects",
       [](const scene::Scene& scene) {
         return scene::carry_objects(scene, {target(0), radar(0)}, "Ship");
       }},
      {"add_targets",
       [](const scene::Scene& scene) { return scene::add_targets(scene, std::vector<scene::Target>(3)); }},
      {"change_options",
       [](const scene::Scene& scene) {
         scene::RunOptions options = scene.options;
         options.seed = 7;
         options.profile = scene::Profile::classic;
         return scene::change_options(scene, options);
       }},
      {"difference", [](const scene::Scene& scene) {
         scene::Scene to = scene;
         to.targets.erase(to.targets.begin());
         to.surfaces.emplace_back();
         to.radars[1].power_w = 5.0;
         to.options.tolerance = 1e-3;
         return scene::difference(scene, to, "Difference");
       }}};
  return all;
}

// --- Commands of the windows ----------------------------------------------------------------------------------------

struct Command {
  std::string file;  // of src/gui, where it changes the document
  std::string name;
  std::set<scene::ObjectId> selected;  // before
  std::function<void(gui::MainWindow&)> work;
};

void trigger(gui::MainWindow& window, const char* action) {
  auto* found = window.findChild<QAction*>(action);
  QVERIFY2(found != nullptr, action);
  found->trigger();
}
void press(QWidget* in, const char* button) {
  auto* found = in->findChild<QPushButton*>(button);
  QVERIFY2(found != nullptr && found->isEnabled(), button);
  found->click();
}
gui::ObjectTree& tree(gui::MainWindow& window) { return *window.findChild<gui::ObjectTree*>(); }
gui::ObjectTreeModel& tree_model(gui::MainWindow& window) {
  return *qobject_cast<gui::ObjectTreeModel*>(window.findChild<QTreeView*>("object_tree")->model());
}
gui::TargetTable& table(gui::MainWindow& window) {
  return *window.window_named("targets")->findChild<gui::TargetTable*>();
}
void type_into(gui::MainWindow& window, const char* field, const QString& text) {
  auto* edit = window.findChild<QLineEdit*>(field);
  QVERIFY2(edit != nullptr, field);
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, text);
  QTest::keyClick(edit, Qt::Key_Return);
}
void select_cells(gui::MainWindow& window, const char* field) {
  auto* view = table(window).findChild<QTableView*>("target_cells");
  const int column = qobject_cast<gui::TargetTableModel*>(view->model())->column_of(field);
  view->setCurrentIndex(view->model()->index(0, column));
  view->selectionModel()->select(QItemSelection(view->model()->index(0, column), view->model()->index(1, column)),
                                 QItemSelectionModel::ClearAndSelect);
}
void import(gui::MainWindow& window) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("targets.csv");
  std::ofstream(path.toStdString()) << "x,y,z\n1,2,3\n4,5,6\n";
  gui::ImportDialog dialog(window.session());
  dialog.set_file(path);
  dialog.set_platform("Ship");
  dialog.accept();
}
void bend_path(gui::MainWindow& window) {
  gui::FunctionEditor editor(window.session(), platform(1), "trajectory_m");
  auto* points = editor.findChild<QTableView*>("function_table")->model();
  QVERIFY(points->setData(points->index(1, 1), "175"));
  editor.accept();
}
void drag(gui::MainWindow& window, scene::ObjectId id) {
  gui::SceneWidget& view = window.scene().scene();
  emit view.drag_started(id);
  for (int i = 1; i <= 5; ++i) emit view.dragged_to(id, {1.5 * i, 0.0, -2.0 * i});
  emit view.drag_ended();
}
void type_in_script(gui::MainWindow& window) {
  auto& editor = *window.findChild<gui::ScriptEditor*>();
  trigger(window, "display_script");
  QTRY_VERIFY(!editor.text().script().isEmpty());
  editor.text().moveCursor(QTextCursor::End);
  editor.text().insertPlainText("\n$TARGET Earth 1 2 3 0 0 0 1 0 ISO ! typed\n");
  editor.commit();
}

void save_settings_only(gui::MainWindow& window) {
  gui::SimulationWindow& from = *window.simulation_windows().open_new(scene::Processing::raw);
  gui::SaveDataDialog* const dialog = window.saver().ask(window.session().scene().simulations[0], from);
  auto* const target = dialog->findChild<QComboBox*>("save_target");
  QVERIFY(target != nullptr);
  target->setCurrentIndex(1);
  dialog->accept();
}
void rename_in_tree(gui::MainWindow& window) {
  gui::ObjectTreeModel& model = tree_model(window);
  QVERIFY(model.setData(model.index_of(radar(0)), "C-band", Qt::EditRole));
}
void carry_in_tree(gui::MainWindow& window) {
  gui::ObjectTreeModel& model = tree_model(window);
  const std::unique_ptr<QMimeData> data(model.mimeData({model.index_of(target(0)), model.index_of(radar(0))}));
  QVERIFY(model.dropMimeData(data.get(), Qt::MoveAction, -1, -1, model.index_of(platform(1))));
}
void choose_next(gui::MainWindow& window, const char* field) {
  auto* box = window.findChild<QComboBox*>(field);
  box->setCurrentIndex((box->currentIndex() + 1) % box->count());
}
void delete_from_table(gui::MainWindow& window) {
  select_cells(window, "rcs_m2");
  table(window).delete_targets();
}
void paste_targets(gui::MainWindow& window) {
  QApplication::clipboard()->setText("1\t2\t3\n4\t5\t6\n");
  table(window).paste();
}
void fill_table(gui::MainWindow& window) {
  select_cells(window, "rcs_m2");
  table(window).fill_selection("3 m2");
}
void take_best_lsb(gui::MainWindow& window) {
  const QTemporaryDir folder;
  auto* const stored = window.findChild<gui::StoredSimulations*>();
  stored->run_panel().set_patience_s(0.0);
  stored->run_into(first_simulation, folder.filePath("a.bin").toStdString(), false);
  stored->run_panel().cancel();
  while (stored->run_panel().running()) QCoreApplication::processEvents();
  emit stored->run_panel().lsb_wanted(window.session().scene().simulations[0], 1.5e-3);
}

const std::set<scene::ObjectId> some{platform(1), target(0)};

// "Show Me" of the step that types the cross-section of the newest target.
void take_tour_step(gui::MainWindow& window) {
  auto* tour = qobject_cast<gui::TourPanel*>(window.window_named("tour"));
  tour->begin();
  tour->show();
  for (int step = 0; step < 4; ++step) tour->findChild<QPushButton*>("tour_next")->click();
  tour->findChild<QPushButton*>("tour_show")->click();
  tour->close();
}

const Command all_commands[] = {
    {"main_window.cpp", "new target", {}, [](gui::MainWindow& w) { trigger(w, "new_target"); }},
    {"main_window.cpp", "new platform", {}, [](gui::MainWindow& w) { trigger(w, "new_platform"); }},
    {"main_window.cpp", "new radar", {}, [](gui::MainWindow& w) { trigger(w, "new_radar"); }},
    {"main_window.cpp", "new surface", {}, [](gui::MainWindow& w) { trigger(w, "new_surface"); }},
    {"start_guide.cpp", "a step of the tour", {}, take_tour_step},
    {"data_saver.cpp", "settings to the script only", {}, save_settings_only},
    {"simulation_window.cpp",
     "store a simulation",
     {},
     [](gui::MainWindow& w) { w.simulation_windows().open_new(scene::Processing::raw)->store_simulation(); }},
    {"object_tree.cpp", "delete", some, [](gui::MainWindow& w) { tree(w).delete_selection(); }},
    {"object_tree.cpp", "duplicate", some, [](gui::MainWindow& w) { tree(w).duplicate_selection(); }},
    {"object_tree.cpp", "invert surface", {first_surface}, [](gui::MainWindow& w) { tree(w).invert_surfaces(); }},
    {"object_tree_model.cpp", "rename", {}, rename_in_tree},
    {"object_tree_model.cpp", "carry", {}, carry_in_tree},
    {"property_panel.cpp",
     "type a number",
     {target(1)},
     [](gui::MainWindow& w) { type_into(w, "field_position_m.x", "5 km"); }},
    {"property_panel.cpp",
     "type a number for several",
     {target(0), target(1)},
     [](gui::MainWindow& w) { type_into(w, "field_rcs_m2", "10 dBsm"); }},
    {"property_panel.cpp", "choose", {radar(0)}, [](gui::MainWindow& w) { choose_next(w, "field_pulse"); }},
    {"property_panel.cpp", "rename", {platform(1)}, [](gui::MainWindow& w) { type_into(w, "field_name", "Boat"); }},
    {"property_panel.cpp", "options", {}, [](gui::MainWindow& w) { type_into(w, "field_seed", "11"); }},
    {"scene_panel.cpp", "drag a target", {}, [](gui::MainWindow& w) { drag(w, target(2)); }},
    {"scene_panel.cpp", "drag a platform", {}, [](gui::MainWindow& w) { drag(w, platform(0)); }},
    {"stored_simulations.cpp",
     "delete a simulation",
     {first_simulation},
     [](gui::MainWindow& w) { press(&w, "stored_delete"); }},
    {"stored_simulations.cpp", "new simulation", {}, [](gui::MainWindow& w) { press(&w, "stored_new"); }},
    {"stored_simulations.cpp", "best LSB", {}, take_best_lsb},
    {"target_table.cpp", "add a target", {}, [](gui::MainWindow& w) { table(w).add_target(); }},
    {"target_table.cpp", "delete targets", {}, delete_from_table},
    {"target_table.cpp", "paste targets", {}, paste_targets},
    {"target_table_model.cpp", "fill", {}, fill_table},
    {"import_dialog.cpp", "import", {}, import},
    {"function_editor.cpp", "change a function", {}, bend_path},
    {"geometry_window.cpp",
     "delete a table",
     {},
     [](gui::MainWindow& w) { press(w.window_named("geometry"), "geometry_delete_stored"); }},
    {"geometry_window.cpp",
     "store a table",
     {},
     [](gui::MainWindow& w) { press(w.window_named("geometry"), "geometry_to_script"); }},
    {"script_editor.cpp", "type", {}, type_in_script}};

// How many places in a file of src/gui change the document.
std::map<std::string, int> places_that_edit() {
  std::map<std::string, int> places;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SARSIM_SOURCE_DIR "/src/gui")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".cpp") || name == "session.cpp") continue;
    const std::string text = file_text(entry.path());
    const std::regex call(R"(session_?(\(\))?\.(perform|make_and_perform|type_text)\()");
    const auto found = std::distance(std::sregex_iterator(text.begin(), text.end(), call), std::sregex_iterator());
    if (found > 0) places[name] = static_cast<int>(found);
  }
  return places;
}

bool shows_its_text(gui::MainWindow& window) {
  const std::string& text = window.session().document().text();
  return window.findChild<gui::ScriptEditor*>()->text().script() == gui::decoded(text, gui::coding_of(text));
}

// A state of a document, and whether another is the same.
struct State {
  scene::Scene scene;
  std::string text;

  explicit State(const scene::Document& document) : scene(document.scene()), text(document.text()) {}
  [[nodiscard]] bool is(const scene::Document& document) const {
    return text == document.text() && scene == document.scene();
  }
};

}  // namespace

class UndoTest : public QObject {
  Q_OBJECT

 private slots:
  void every_maker_of_edits_is_tested() {
    const std::string header = file_text(SARSIM_SOURCE_DIR "/src/scene/edit/edit.hpp");
    const std::regex declaration(R"(\[\[nodiscard\]\] Edit (\w+)\()");
    std::set<std::string> declared;
    for (std::sregex_iterator at(header.begin(), header.end(), declaration); at != std::sregex_iterator(); ++at)
      declared.insert((*at)[1]);
    declared.erase("composed");           // joins edits, makes none
    declared.erase("change_atmosphere");  // of texts of format 2 alone: typed_panel_test
    declared.erase("change_world");       // the same: list_field_test
    QVERIFY(declared.size() >= 9);
    for (const std::string& name : declared) QVERIFY2(makers().contains(name), (name + " is not in makers()").c_str());
  }

  void every_maker_undoes_and_redoes_scene_and_text() {
    for (const auto& [name, make] : makers()) {
      scene::Document document = scene::Document::from_text(commented_script());
      const State before(document);
      document.perform(make(document.scene()));
      const State after(document);
      QVERIFY2(after.text != before.text, name.c_str());
      QVERIFY2(scene::read_script(after.text, "", {}).scene == after.scene, name.c_str());
      QVERIFY2(after.text.find("! A scene for tests") == 0, name.c_str());
      document.undo();
      QVERIFY2(before.is(document), name.c_str());
      QVERIFY2(!document.history().can_undo() && !document.changed(), name.c_str());
      document.redo();
      QVERIFY2(after.is(document), name.c_str());
      QVERIFY2(!document.history().can_redo(), name.c_str());
    }
  }

  void every_place_in_the_windows_that_edits_is_tested() {
    std::set<std::string> tested;
    std::map<std::string, int> known;
    for (const Command& command : all_commands) known[command.file] += 1;
    for (const auto& [file, places] : places_that_edit()) {
      if (file == "document_keeper.cpp") continue;  // takes a text up after a crash; recovery is tested on its own
      QVERIFY2(
          known.contains(file) && known[file] >= places,
          (file + " changes the document in " + std::to_string(places) + " places; add them to all_commands").c_str());
      tested.insert(file);
    }
    for (const auto& [file, count] : known)
      QVERIFY2(tested.contains(file), (file + " changes nothing any more").c_str());
  }

  void every_command_undoes_and_redoes_scene_and_text() {
    for (const Command& command : all_commands) {
      gui::MainWindow window;
      window.session().take(scene::Document::from_text(commented_script()));
      window.show();
      const scene::Document& document = window.session().document();
      const State before(document);
      window.session().select(command.selected);
      command.work(window);
      if (QTest::currentTestFailed()) return;
      const State after(document);
      QVERIFY2(after.text != before.text, command.name.c_str());
      QVERIFY2(scene::read_script(after.text, "", {}).scene == after.scene, command.name.c_str());
      QVERIFY2(!document.history().undo_label().empty(), command.name.c_str());
      trigger(window, "edit_undo");
      QVERIFY2(before.is(document), command.name.c_str());
      QVERIFY2(!document.history().can_undo(), (command.name + " is more than one step").c_str());
      trigger(window, "edit_redo");
      QVERIFY2(after.is(document), command.name.c_str());
      window.findChild<QDockWidget*>("script_dock")->raise();
      QTRY_VERIFY2(shows_its_text(window), command.name.c_str());
    }
  }

  void a_dragged_coordinate_has_no_digits_that_only_the_sum_made() {
    gui::MainWindow window;
    scene::Scene scene = test::small_scene();
    scene.targets[0].position_m = {9860.1, 1.0 / 3.0, 0.0};
    test::open(window.session(), scene);
    gui::SceneWidget& view = window.scene().scene();
    emit view.drag_started(target(0));
    emit view.dragged_to(target(0), {0.066, 0.0, -0.2});
    emit view.drag_ended();
    const core::Vec3 moved = window.session().scene().targets[0].position_m;
    QVERIFY(9860.1 + 0.066 != 9860.166);
    QCOMPARE(moved.x, 9860.166);
    QCOMPARE(moved.y, 1.0 / 3.0);
    QCOMPARE(moved.z, -0.2);
  }

  void drags_and_runs_of_steps_are_one_step_each() {
    gui::MainWindow window;
    window.session().take(scene::Document::from_text(commented_script()));
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));  // Only then do fields hear that the keyboard leaves them.
    const scene::Document& document = window.session().document();
    std::vector<State> states{State(document)};
    const auto note = [&] { states.emplace_back(document); };
    drag(window, target(0));
    note();
    drag(window, target(0));
    note();
    drag(window, target(1));
    note();
    const auto run_up = [&](const char* field, int steps) {
      auto* edit = window.findChild<QLineEdit*>(field);
      edit->setFocus();
      for (int i = 0; i < steps; ++i) QTest::keyClick(edit, Qt::Key_Up);
      QTest::keyClick(edit, Qt::Key_Tab);
      note();
    };
    window.session().select_only(target(1));
    run_up("field_position_m.x", 20);
    run_up("field_position_m.x", 7);
    run_up("field_position_m.y", 3);
    window.session().select_only(target(2));
    run_up("field_position_m.y", 4);
    for (std::size_t i = 1; i < states.size(); ++i) QVERIFY(states[i].text != states[i - 1].text);
    for (std::size_t i = states.size() - 1; i > 0; --i) {
      QVERIFY2(states[i].is(document), std::to_string(i).c_str());
      window.session().undo();
    }
    QVERIFY(states[0].is(document));
    QVERIFY(!document.history().can_undo());
    for (std::size_t i = 1; i < states.size(); ++i) {
      window.session().redo();
      QVERIFY2(states[i].is(document), std::to_string(i).c_str());
    }
  }

  void a_drag_that_comes_back_is_no_step() {
    gui::MainWindow window;
    window.session().take(scene::Document::from_text(commented_script()));
    const State before(window.session().document());
    gui::SceneWidget& view = window.scene().scene();
    emit view.drag_started(target(0));
    emit view.dragged_to(target(0), {5.0, 0.0, 0.0});
    emit view.dragged_to(target(0), {0.0, 0.0, 0.0});
    emit view.drag_ended();
    QVERIFY(before.is(window.session().document()));
    QVERIFY(!window.session().document().history().can_undo());
    QVERIFY(!window.session().document().changed());
  }

  // Edits of every maker, runs of merged edits and typed texts in any order, now and then some steps back and on.
  void random_steps_go_back_to_the_beginning_and_forward_again() {
    constexpr std::uint64_t seed = 20;
    scene::test::RandomEdits edits(seed);
    gui::Session session;
    session.take(scene::Document::from_text(commented_script()));
    gui::ScriptEditor editor(session);
    editor.show();
    gui::ObjectTreeModel model(session);
    const scene::Document& document = session.document();
    const auto shown = [&] {
      editor.text().complete();
      return editor.text().script() == gui::decoded(document.text(), gui::coding_of(document.text()));
    };
    std::vector<State> states{State(document)};
    std::size_t at = 0;
    for (int step = 0; step < 500; ++step) {
      const std::uint64_t kind = edits.below(10);
      if (kind == 0) {
        for (std::uint64_t back = edits.below(4); back > 0 && at > 0; --back, --at) session.undo();
        for (std::uint64_t on = edits.below(3); on > 0 && at + 1 < states.size(); --on, ++at) session.redo();
      } else {
        take_step(session, edits, kind);
        session.end_run();
        if (!states[at].is(document)) {
          states.erase(states.begin() + static_cast<std::ptrdiff_t>(++at), states.end());
          states.emplace_back(document);
        }
      }
      QVERIFY2(states[at].is(document), std::to_string(step).c_str());
      QVERIFY2(shown(), std::to_string(step).c_str());
    }
    QVERIFY(states.size() > 200);
    while (at > 0) {
      session.undo();
      QVERIFY2(states[--at].is(document), std::to_string(at).c_str());
    }
    QVERIFY(!document.history().can_undo());
    QVERIFY(shown());
    QCOMPARE(document.text(), commented_script());
    for (++at; at < states.size(); ++at) {
      session.redo();
      QVERIFY2(states[at].is(document), std::to_string(at).c_str());
    }
    QVERIFY(!document.history().can_redo());
    QVERIFY(shown());
  }

 private:
  static void take_step(gui::Session& session, scene::test::RandomEdits& edits, std::uint64_t kind) {
    if (kind == 1 && !session.scene().targets.empty()) {  // a drag
      for (int i = 0; i < 5; ++i) {
        scene::Target moved = session.scene().targets[0];
        moved.position_m.x += 1.25;
        session.perform(scene::replace_object(session.scene(), target(0), moved, "Move target", "drag"));
      }
    } else if (kind == 2) {  // typing, which may leave the text broken on the way
      const std::string text = session.document().text();
      session.type_text(text + "$TARGET Earth 1 2");
      session.type_text(text + "$TARGET Earth 1 2 3 0 0 0 1 0 ISO ! typed\n");
    } else if (kind == 3) {
      session.type_text(session.document().text() + "! a remark\n");
    } else {
      session.perform(edits.edit(session.scene()));
    }
  }
};

const test::AddTest added("undo_test", test::run_test<UndoTest>);

}  // namespace sarsim::undo_test

#include "undo_test.moc"
