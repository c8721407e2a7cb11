#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/property_panel.hpp"
#include "scene/edit/edit.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::documents_test {

namespace {

namespace fs = std::filesystem;

constexpr const char* gain_points = "2\n0 0\n90 -10\n";
constexpr const char* script_text = R"(! with data beside it
$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0
$TARGET Earth 1 2 3 0 0 0 1 0 DIRECTIONAL 0 0 0 0 OTHER_GAIN LINEAR FILE gain.dat
)";
constexpr scene::ObjectId first{scene::ObjectKind::target, 0};

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string text_in(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

double gain_in(const fs::path& path) {
  return scene::read_script_file(path).scene.targets.at(0).traits->gain_db.part[0].knots.at(1).y;
}

// A window on a script with a data file, in a folder of its own.
struct Bench {
  Bench() {
    fs::create_directories(folder / "other");
    write(folder / "gain.dat", gain_points);
    write(folder / "a.scr", script_text);
    window.documents().ask_data = [this](const std::vector<scene::DataFileWrite>& files) {
      asked.push_back(files);
      return answer;
    };
    window.documents().ask_unsaved = [this] { return ++asked_unsaved, gui::DocumentKeeper::Answer::cancel; };
    if (!window.documents().open_file(QString::fromStdString((folder / "a.scr").string()))) qFatal("not opened");
    window.show();
  }
  void trigger(const char* name) { window.findChild<QAction*>(name)->trigger(); }
  void set_gain(double y) {
    scene::Target target = window.session().scene().targets.at(0);
    target.traits.edit().gain_db.part[0].knots.at(1).y = y;
    window.session().perform(scene::replace_object(window.session().scene(), first, target, "Change function"));
    window.session().end_run();
  }
  [[nodiscard]] QLineEdit* field(const char* id) {
    return window.findChild<gui::PropertyPanel*>()->findChild<QLineEdit*>(QString("field_%1").arg(id));
  }

  QTemporaryDir temporary;
  fs::path folder = temporary.path().toStdString();
  gui::MainWindow window;
  std::vector<std::vector<scene::DataFileWrite>> asked;
  gui::DocumentKeeper::DataAnswer answer = gui::DocumentKeeper::DataAnswer::write;
  int asked_unsaved = 0;
};

// Answers the next dialog of a kind once it is up.
template <class Dialog, class Answer>
void answer_next(QTimer& timer, Answer answer) {
  QObject::connect(&timer, &QTimer::timeout, &timer, [&timer, answer] {
    auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
    if (dialog != nullptr && dialog->isVisible() && answer(*dialog)) timer.stop();
  });
  timer.start(20);
}

QAbstractButton* button_with(const QMessageBox& box, const QString& word) {
  for (QAbstractButton* button : box.buttons())
    if (button->text().remove('&').contains(word)) return button;
  return nullptr;
}

}  // namespace

class DocumentsTest : public QObject {
  Q_OBJECT

 private slots:
  void saving_asks_nothing_where_the_data_files_say_what_is_shown() {
    Bench bench;
    bench.trigger("file_save");
    QVERIFY(bench.asked.empty());
    QCOMPARE(text_in(bench.folder / "gain.dat"), std::string(gain_points));
    QCOMPARE(text_in(bench.folder / "a.scr"), std::string(script_text));
  }

  void saving_writes_the_data_of_edited_functions_where_that_is_wanted() {
    Bench bench;
    bench.set_gain(-20.0);
    bench.trigger("file_save");
    QCOMPARE(bench.asked.size(), std::size_t{1});
    QCOMPARE(bench.asked[0].at(0).name, std::string("gain.dat"));
    QVERIFY(bench.asked[0][0].replaces);
    QVERIFY(!bench.window.isWindowModified());
    QCOMPARE(gain_in(bench.folder / "a.scr"), -20.0);
    bench.trigger("file_save");
    QCOMPARE(bench.asked.size(), std::size_t{1});
  }

  void saving_the_script_alone_leaves_the_data_and_says_so() {
    Bench bench;
    bench.answer = gui::DocumentKeeper::DataAnswer::leave;
    bench.set_gain(-20.0);
    bench.trigger("file_save");
    QCOMPARE(text_in(bench.folder / "gain.dat"), std::string(gain_points));
    QVERIFY(bench.window.isWindowModified());
    QVERIFY(!bench.window.close());
    QCOMPARE(bench.asked_unsaved, 1);
  }

  void cancelling_saves_nothing() {
    Bench bench;
    bench.answer = gui::DocumentKeeper::DataAnswer::cancel;
    bench.set_gain(-20.0);
    bench.window.session().perform(scene::remove_objects(bench.window.session().scene(), {}));
    QVERIFY(!bench.window.documents().save_to(QString::fromStdString((bench.folder / "b.scr").string())));
    QVERIFY(!fs::exists(bench.folder / "b.scr"));
    QCOMPARE(text_in(bench.folder / "gain.dat"), std::string(gain_points));
    QVERIFY(bench.window.isWindowModified());
  }

  // The data were written with the function; the script never changed, and yet the scene is not what is on disk.
  void undo_after_the_data_were_written_counts_as_unsaved() {
    Bench bench;
    bench.set_gain(-20.0);
    bench.trigger("file_save");
    bench.trigger("edit_undo");
    QVERIFY(bench.window.isWindowModified());
    bench.trigger("file_save");
    QCOMPARE(bench.asked.size(), std::size_t{2});
    QCOMPARE(gain_in(bench.folder / "a.scr"), -10.0);
    QVERIFY(!bench.window.isWindowModified());
    QVERIFY(bench.window.close());
  }

  void data_files_go_along_to_another_folder() {
    Bench bench;
    QVERIFY(bench.window.documents().save_to(QString::fromStdString((bench.folder / "other/b.scr").string())));
    QCOMPARE(bench.asked.size(), std::size_t{1});
    QCOMPARE(text_in(bench.folder / "other/gain.dat"), std::string(gain_points));
    QCOMPARE(gain_in(bench.folder / "other/b.scr"), -10.0);
    QVERIFY(bench.window.session().document().problems().empty());
  }

  void data_that_cannot_be_written_leave_the_script_as_it_was() {
    Bench bench;
    bench.set_gain(-20.0);
    fs::remove(bench.folder / "gain.dat");
    fs::create_directories(bench.folder / "gain.dat/in the way");
    bench.window.session().perform(scene::add_object(bench.window.session().scene(), scene::Target()));
    QTimer timer;
    QString told;
    answer_next<QMessageBox>(timer, [&told](QMessageBox& box) {
      told = box.informativeText();
      box.defaultButton() != nullptr ? box.defaultButton()->click() : box.accept();
      return true;
    });
    bench.trigger("file_save");
    QVERIFY2(told.contains("gain.dat"), qPrintable(told));
    QCOMPARE(text_in(bench.folder / "a.scr"), std::string(script_text));
    QVERIFY(bench.window.isWindowModified());
  }

  void the_question_about_data_names_the_files_and_takes_three_answers() {
    Bench bench;
    gui::MainWindow other;
    const std::vector<scene::DataFileWrite> files{{"a.dat", "/x/a.dat", "", true}, {"b.dat", "/x/b.dat", "", false}};
    const std::pair<const char*, gui::DocumentKeeper::DataAnswer> answers[] = {
        {"Write", gui::DocumentKeeper::DataAnswer::write},
        {"Only", gui::DocumentKeeper::DataAnswer::leave},
        {"Cancel", gui::DocumentKeeper::DataAnswer::cancel}};
    for (const auto& [word, expected] : answers) {
      QTimer timer;
      QString text;
      answer_next<QMessageBox>(timer, [&text, word = word](QMessageBox& box) {
        text = box.informativeText();
        button_with(box, word)->click();
        return true;
      });
      QCOMPARE(other.documents().ask_data(files), expected);
      QCOMPARE(text, QString("/x/a.dat (is replaced)\n/x/b.dat (new)"));
    }
  }

  void what_is_typed_but_not_entered_is_saved() {
    Bench bench;
    bench.window.session().select_only(first);
    bench.field("position_m.x")->setFocus();
    bench.field("position_m.x")->selectAll();
    QTest::keyClicks(bench.field("position_m.x"), "2 km");
    QCOMPARE(bench.window.session().scene().targets[0].position_m.x, 1.0);
    bench.trigger("file_save");
    QCOMPARE(scene::read_script_file(bench.folder / "a.scr").scene.targets.at(0).position_m.x, 2000.0);
  }

  void what_is_typed_but_not_entered_keeps_the_window_from_closing_unasked() {
    Bench bench;
    bench.window.session().select_only(first);
    bench.field("position_m.x")->setFocus();
    bench.field("position_m.x")->selectAll();
    QTest::keyClicks(bench.field("position_m.x"), "2 km");
    QVERIFY(!bench.window.close());
    QCOMPARE(bench.asked_unsaved, 1);
  }

  void what_cannot_be_read_stays_in_its_field_and_the_rest_is_saved() {
    Bench bench;
    bench.window.session().select_only(first);
    bench.field("position_m.x")->setFocus();
    bench.field("position_m.x")->selectAll();
    QTest::keyClicks(bench.field("position_m.x"), "two");
    bench.trigger("file_save");
    QCOMPARE(bench.field("position_m.x")->text(), QString("two"));
    QCOMPARE(text_in(bench.folder / "a.scr"), std::string(script_text));
  }

  void save_as_asks_before_the_file_with_the_added_ending_is_replaced() {
    Bench bench;
    write(bench.folder / "taken.scr", "precious");
    const QString typed = QString::fromStdString((bench.folder / "taken").string());
    bool asked = false;
    QTimer name_timer;
    answer_next<QFileDialog>(name_timer, [&](QFileDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
      name->setFocus();
      if (!name->hasFocus()) return false;
      QTimer question_timer;
      answer_next<QMessageBox>(question_timer, [&](QMessageBox& box) {
        asked = box.text().contains("taken.scr");
        box.button(QMessageBox::No)->click();
        return true;
      });
      name_timer.stop();
      QTest::keyClick(name, Qt::Key_A, Qt::ControlModifier);
      QTest::keyClicks(name, typed);
      QTest::keyClick(name, Qt::Key_Return);
      dialog.reject();
      return true;
    });
    bench.trigger("file_save_as");
    QVERIFY(asked);
    QCOMPARE(text_in(bench.folder / "taken.scr"), std::string("precious"));
  }

  void an_example_from_the_menu_is_a_copy_without_a_file() {
    gui::MainWindow window;
    const QString path = QStringLiteral(SARSIM_SOURCE_DIR "/examples/thesis_chapter3.scr");
    QVERIFY(window.documents().open_example(path));
    QVERIFY(window.session().document().path().empty());
    QCOMPARE(window.session().document().text(), text_in(path.toStdString()));
    QVERIFY(!window.isWindowModified());
    // Finding B15.
    QVERIFY2(window.windowTitle().contains("thesis_chapter3.scr (copy of the example)"),
             qPrintable(window.windowTitle()));
    window.documents().ask_save_name = [] { return QString(); };
    QVERIFY(!window.documents().save());
    QVERIFY(window.documents().make_new());
    QVERIFY2(window.windowTitle().contains("New scene"), qPrintable(window.windowTitle()));
  }

  void examples_are_offered_in_format_2_and_below_in_the_language_of_1998() {
    gui::MainWindow window;
    const auto* examples = window.findChild<QMenu*>("file_examples");
    QVERIFY(examples != nullptr);
    QStringList names;
    const QMenu* scripts = nullptr;
    for (const QAction* action : examples->actions()) {
      if (action->menu() != nullptr)
        scripts = action->menu();
      else if (!action->isSeparator())
        names += action->text();
    }
    QVERIFY(names.contains("sar_r.toml"));
    QVERIFY(!names.contains("sar_r.scr"));
    QVERIFY(scripts != nullptr);
    const auto is_script = [](const QAction* action) { return action->text() == "sar_r_1998.scr"; };
    QVERIFY(std::ranges::any_of(scripts->actions(), is_script));
  }

  void a_new_scene_is_in_format_2_and_is_saved_with_its_ending() {
    QTemporaryDir folder;
    gui::MainWindow window;
    QVERIFY(window.documents().make_new());
    QVERIFY(window.session().document().text().find("format = \"sarsim 2\"") != std::string::npos);
    window.session().perform(scene::add_object(window.session().scene(), scene::Target()));
    QVERIFY(window.session().document().text().find("[[target]]") != std::string::npos);
    window.documents().ask_save_name = [&] { return folder.filePath("new"); };
    QVERIFY(window.documents().save());
    QCOMPARE(window.session().document().path().filename().string(), std::string("new.toml"));
  }

  void the_ending_of_the_other_language_is_asked_about_and_changes_nothing() {
    Bench bench;
    QString asked;
    bool answer = false;
    bench.window.documents().ask_ending = [&](const QString& path) { return asked = path, answer; };
    const QString other = bench.temporary.filePath("b.toml");
    bench.window.documents().ask_save_name = [&] { return other; };
    QVERIFY(!bench.window.documents().save_as());
    QCOMPARE(asked, other);
    QVERIFY(!QFileInfo::exists(other));
    answer = true;
    QVERIFY(bench.window.documents().save_as());
    QCOMPARE(text_in(other.toStdString()), std::string(script_text));
    asked.clear();
    bench.window.documents().ask_save_name = [&] { return bench.temporary.filePath("c.scr"); };
    QVERIFY(bench.window.documents().save_as());
    QVERIFY(asked.isEmpty());
  }

  void an_example_that_needs_its_data_files_is_opened_where_it_stands() {
    Bench bench;
    gui::MainWindow window;
    QVERIFY(window.documents().open_example(QString::fromStdString((bench.folder / "a.scr").string())));
    QCOMPARE(window.session().document().path(), bench.folder / "a.scr");
  }

  void a_scene_in_json_is_opened_as_a_new_one_in_toml() {
    Bench bench;
    QStringList failures;
    bench.window.documents().show_failure = [&](const QString& what, const QString&) { failures << what; };
    write(bench.folder / "a.json", R"({"format": "sarsim 2", "target": [{"position": [7, 0, 0]}]})");
    QVERIFY(bench.window.open_any(bench.temporary.filePath("a.json")));
    QVERIFY(bench.window.session().document().path().empty());
    QCOMPARE(bench.window.session().scene().targets.at(0).position_m.x, 7.0);
    QVERIFY(failures.isEmpty());
    write(bench.folder / "b.json", R"({"format": "sarsim 2", "target": [{"postion": [7, 0, 0]}]})");
    QVERIFY(!bench.window.open_any(bench.temporary.filePath("b.json")));
    QCOMPARE(failures.size(), 1);
  }

  void the_path_of_a_document_does_not_depend_on_the_folder_of_the_program() {
    Bench bench;
    const fs::path before = fs::current_path();
    fs::current_path(bench.folder);
    const bool opened = bench.window.documents().open_file("a.scr");
    fs::current_path(before);
    QVERIFY(opened);
    QCOMPARE(bench.window.session().document().path(), bench.folder / "a.scr");
    QVERIFY(bench.window.windowTitle().contains(bench.temporary.path()));
  }
};

const test::AddTest added("documents_test", test::run_test<DocumentsTest>);

}  // namespace sarsim::documents_test

#include "documents_test.moc"
