#include <QApplication>
#include <QCheckBox>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <fstream>
#include <memory>

#include "gui/common/problem_line.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/function_editor.hpp"
#include "gui/objects/function_plot.hpp"
#include "gui/objects/function_table.hpp"
#include "small_scene.hpp"
#include "text_files.hpp"

namespace sarsim::function_editor_test {

namespace {

using test::file_text;

constexpr scene::ObjectId ship{scene::ObjectKind::platform, 1};
constexpr scene::ObjectId radar1{scene::ObjectKind::radar, 0};

scene::Scene scene_with_functions() {
  scene::Scene scene = test::small_scene();
  scene::Platform& platform = scene.platforms[1];
  platform.path = scene::Platform::Path::trajectory;
  platform.trajectory_m.part[0] = {core::Interpolation::linear, {{0.0, 0.0}, {1.0, 150.0}, {2.0, 0.0}, {3.0, -500.0}}};
  platform.trajectory_m.part[1] = {core::Interpolation::linear, {{0.0, 10.0}}};
  platform.trajectory_m.part[2] = {core::Interpolation::cubic, {{0.0, 20.0}}};
  scene.radars[0].repetition = scene::Radar::Repetition::user;
  scene.radars[0].pri_s.part[0].knots = {{0.0, 1e-3}, {1.0, 2e-3}, {2.0, 1.5e-3}};
  return scene;
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

// An editor on screen, with the gestures of a mouse.
struct Bench {
  explicit Bench(scene::ObjectId object = ship, const std::string& field = "trajectory_m") {
    test::open(session, scene_with_functions());
    script = std::filesystem::path(folder.path().toStdString()) / "scene.scr";
    session.save(script);
    editor = std::make_unique<gui::FunctionEditor>(session, object, field);
    editor->resize(1000, 700);
    editor->show();
    plot = &editor->plot();
    view = editor->findChild<QTableView*>("function_table");
    QApplication::processEvents();
  }

  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons buttons) const {
    QMouseEvent event(type, at, plot->mapToGlobal(at), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(plot, &event);
  }
  void press(QPointF at) const { mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton); }
  void move(QPointF at) const { mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton); }
  void release(QPointF at) const { mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton); }
  void right_click(QPointF at) const {
    mouse(QEvent::MouseButtonPress, at, Qt::RightButton, Qt::RightButton);
    mouse(QEvent::MouseButtonRelease, at, Qt::RightButton, Qt::NoButton);
  }
  void drag(QPointF from, QPointF to) const {
    press(from);
    move(0.5 * (from + to));
    move(to);
    release(to);
  }
  void click(const char* name) const { editor->findChild<QAbstractButton*>(name)->click(); }
  bool type(int row, int column, const QString& text) const {
    return view->model()->setData(view->model()->index(row, column), text);
  }
  [[nodiscard]] const std::vector<core::Knot>& knots() const { return editor->draft().parts[editor->part()].knots; }
  [[nodiscard]] QString problems() const {
    const auto* line = editor->findChild<gui::ProblemLine*>("function_problems");
    return line->isVisible() ? line->text() : QString();
  }
  [[nodiscard]] const scene::UserFunction<3>& stored() const { return session.scene().platforms[1].trajectory_m; }
  [[nodiscard]] QPointF pixel(double x, double y) const {
    return {plot->xAxis->coordToPixel(x), plot->yAxis->coordToPixel(y)};
  }

  QTemporaryDir folder;
  std::filesystem::path script;
  gui::Session session;
  std::unique_ptr<gui::FunctionEditor> editor;
  gui::FunctionPlot* plot = nullptr;
  QTableView* view = nullptr;
};

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

}  // namespace

class FunctionEditorTest : public QObject {
  Q_OBJECT

 private slots:
  void a_dragged_point_moves_in_the_draft_and_is_rounded_on_release() {
    const Bench bench;
    const QPointF from = bench.plot->knot_pixel(1);
    const QPointF to = bench.pixel(1.4321, 77.777);
    bench.press(from + QPointF(5.0, 3.0));
    bench.move(to);
    QVERIFY(near(bench.knots()[1].x, 1.4321, 0.02));
    bench.release(to);
    // The window spans 3.3 s and 715 m: a hundredth of the decade is 0.01 s and 1 m.
    QCOMPARE(bench.knots()[1].x, 1.43);
    QCOMPARE(bench.knots()[1].y, 78.0);
    QCOMPARE(bench.view->model()->index(1, 1).data().toString(), QString("78"));
    QCOMPARE(bench.stored().part[0].knots[1], (core::Knot{1.0, 150.0}));
  }

  void undo_in_a_drag_takes_the_drag_back() {
    const Bench bench;
    bench.press(bench.plot->knot_pixel(1));
    bench.move(bench.pixel(1.4, 77.0));
    bench.editor->undo();
    QCOMPARE(bench.knots()[1], (core::Knot{1.0, 150.0}));
    bench.move(bench.pixel(1.5, 70.0));
    bench.release(bench.pixel(1.5, 70.0));
    QCOMPARE(bench.knots()[1], (core::Knot{1.0, 150.0}));
  }

  void undoing_an_inserted_last_sample_while_it_is_dragged_is_harmless() {
    const Bench bench;
    const std::size_t count = bench.knots().size();
    bench.editor->table().set_current(count - 1);
    bench.click("function_insert");
    QCOMPARE(bench.knots().size(), count + 1);
    bench.plot->fit();
    const QPointF at = bench.plot->knot_pixel(count);
    bench.press(at);
    bench.move(at + QPointF(-20.0, 10.0));
    bench.editor->undo();
    bench.editor->undo();
    QCOMPARE(bench.knots().size(), count);
    bench.move(at + QPointF(-30.0, 20.0));
    bench.release(at + QPointF(-30.0, 20.0));
    QCOMPARE(bench.knots().size(), count);
  }

  void a_dragged_point_stays_between_its_neighbours() {
    const Bench bench;
    bench.drag(bench.plot->knot_pixel(1), bench.pixel(2.9, 50.0));
    QVERIFY(bench.knots()[1].x > 1.0 && bench.knots()[1].x < 2.0);
    QCOMPARE(bench.knots().size(), std::size_t{4});
    QCOMPARE(bench.knots()[2], (core::Knot{2.0, 0.0}));
  }

  void escape_takes_a_drag_back() {
    const Bench bench;
    const scene::FunctionDraft before = bench.editor->draft();
    bench.press(bench.plot->knot_pixel(1));
    bench.move(bench.pixel(1.2, 20.0));
    QVERIFY(!(bench.editor->draft() == before));
    QTest::keyClick(bench.plot, Qt::Key_Escape);
    bench.release(bench.pixel(1.2, 20.0));
    QVERIFY(bench.editor->draft() == before);
    QVERIFY(bench.editor->isVisible());
  }

  void a_drag_is_one_step_that_undo_takes_back() {
    const Bench bench;
    const scene::FunctionDraft before = bench.editor->draft();
    bench.drag(bench.plot->knot_pixel(1), bench.pixel(1.5, 20.0));
    const scene::FunctionDraft after = bench.editor->draft();
    QVERIFY(!(after == before));
    QTest::keyClick(bench.editor.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(bench.editor->draft() == before);
    bench.editor->redo();
    QVERIFY(bench.editor->draft() == after);
  }

  void a_rectangle_zooms_in_and_a_right_click_zooms_out_by_two_about_it() {
    const Bench bench;
    bench.drag(bench.pixel(0.5, -400.0), bench.pixel(1.7, -100.0));
    gui::FunctionPlot::Window window = bench.plot->window();
    QVERIFY(near(window.x[0], 0.5, 0.02) && near(window.x[1], 1.7, 0.02));
    QVERIFY(near(window.y[0], -400.0, 4.0) && near(window.y[1], -100.0, 4.0));
    QCOMPARE(bench.knots(), bench.stored().part[0].knots);
    bench.right_click(bench.pixel(1.0, -200.0));
    window = bench.plot->window();
    QVERIFY(near(window.x[0], 1.0 - 1.2, 0.03) && near(window.x[1], 1.0 + 1.2, 0.03));
    QVERIFY(near(window.y[0], -200.0 - 300.0, 6.0) && near(window.y[1], -200.0 + 300.0, 6.0));
  }

  void the_wheel_keeps_what_is_under_the_pointer_and_buttons_halve_and_double() {
    const Bench bench;
    const QPointF at = bench.pixel(2.0, -300.0);
    QWheelEvent wheel(at, bench.plot->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    const double before = bench.plot->window().x[1] - bench.plot->window().x[0];
    QApplication::sendEvent(bench.plot, &wheel);
    const double after = bench.plot->window().x[1] - bench.plot->window().x[0];
    QVERIFY(near(before / after, 1.25 * 1.25, 1e-6));
    QVERIFY(near(bench.pixel(2.0, -300.0).x(), at.x(), 0.5) && near(bench.pixel(2.0, -300.0).y(), at.y(), 0.5));
    bench.click("function_x_in");
    QVERIFY(near(bench.plot->window().x[1] - bench.plot->window().x[0], 0.5 * after, 1e-9));
    bench.click("function_fit");
    QVERIFY(near(bench.plot->window().x[1] - bench.plot->window().x[0], before, 1e-9));
  }

  void typed_limits_set_the_window_and_bad_ones_are_refused() {
    const Bench bench;
    auto* from = bench.editor->findChild<QLineEdit*>("field_x_from");
    from->setFocus();
    from->selectAll();
    QTest::keyClicks(from, "500 ms");
    QTest::keyClick(from, Qt::Key_Return);
    QCOMPARE(bench.plot->window().x[0], 0.5);
    QVERIFY(bench.editor->isVisible());
    from->selectAll();
    QTest::keyClicks(from, "5 kg");
    QTest::keyClick(from, Qt::Key_Return);
    QCOMPARE(bench.plot->window().x[0], 0.5);
    QVERIFY(bench.editor->findChild<gui::ProblemLine*>("problem_x_from")->text().contains("5 kg"));
  }

  void samples_are_inserted_halfway_and_deleted_down_to_one() {
    const Bench bench;
    bench.editor->table().set_current(1);
    bench.click("function_insert");
    QCOMPARE(bench.knots().size(), std::size_t{5});
    QCOMPARE(bench.knots()[2], (core::Knot{1.5, 75.0}));
    QCOMPARE(bench.editor->table().current(), std::optional<std::size_t>(2));
    for (int i = 0; i < 9; ++i) bench.click("function_delete");
    QCOMPARE(bench.knots().size(), std::size_t{1});
    QVERIFY(!bench.editor->findChild<QPushButton*>("function_delete")->isEnabled());
  }

  void the_number_of_samples_appends_and_cuts() {
    const Bench bench;
    auto* count = bench.editor->findChild<QSpinBox*>("function_count");
    count->setValue(6);
    QCOMPARE(bench.knots().size(), std::size_t{6});
    QCOMPARE(bench.knots()[5], (core::Knot{5.0, 0.0}));
    count->setValue(2);
    QCOMPARE(bench.knots().size(), std::size_t{2});
  }

  void typed_points_take_any_unit_and_are_sorted() {
    const Bench bench;
    QVERIFY(bench.type(0, 0, "2500 ms"));
    QCOMPARE(bench.knots()[2].x, 2.5);
    QCOMPARE(bench.editor->table().current(), std::optional<std::size_t>(2));
    QVERIFY(bench.type(0, 1, "2 km"));
    QCOMPARE(bench.knots()[0], (core::Knot{1.0, 2000.0}));
    QVERIFY(!bench.type(0, 1, "far"));
    QVERIFY(bench.problems().contains("far"));
    QCOMPARE(bench.knots()[0].y, 2000.0);
    bench.type(0, 0, "3");
    QVERIFY(bench.problems().contains("Another sample"));
    QCOMPARE(bench.knots()[0].x, 1.0);
  }

  void tab_goes_on_to_the_next_number_and_loses_nothing() {
    const Bench bench;
    const std::vector<core::Knot> before = bench.knots();
    bench.editor->activateWindow();
    bench.view->setFocus();
    bench.view->setCurrentIndex(bench.view->model()->index(0, 0));
    bench.view->edit(bench.view->currentIndex());
    const auto keys = [&](const QString& text, Qt::Key end) {
      QWidget* cell = bench.view->indexWidget(bench.view->currentIndex());
      QVERIFY2(cell != nullptr, qPrintable(text));
      QTest::keyClicks(cell, text);
      QTest::keyClick(cell, end);
      QApplication::processEvents();  // Return is taken at the next turn.
    };
    // The first point goes behind the second by its new x; what is typed next is its y all the same.
    const double x = before[1].x + 0.25 * (before[2].x - before[1].x);
    keys(QString::number(x), Qt::Key_Tab);
    keys("10", Qt::Key_Tab);
    QCOMPARE(bench.knots().size(), before.size());
    QCOMPARE(bench.knots()[0], before[1]);
    QCOMPARE(bench.knots()[1].x, x);
    QCOMPARE(bench.knots()[1].y, 10.0);
    QCOMPARE(bench.view->currentIndex().row(), 2);
    keys(QString::number(before[2].x), Qt::Key_Tab);
    keys("-10", Qt::Key_Return);
    QCOMPARE(bench.knots().size(), before.size());
    QCOMPARE(bench.knots()[2].y, -10.0);
    QCOMPARE(bench.editor->findChild<QSpinBox*>("function_count")->value(), static_cast<int>(before.size()));
  }

  void tab_passes_the_numbers_of_pulses_by() {
    const Bench bench(radar1, "pri_s");
    bench.view->setCurrentIndex(bench.view->model()->index(0, 1));
    bench.view->edit(bench.view->currentIndex());
    QTest::keyClick(bench.view->indexWidget(bench.view->currentIndex()), Qt::Key_Tab);
    QCOMPARE(bench.view->currentIndex(), bench.view->model()->index(1, 1));
    QTest::keyClick(bench.view->indexWidget(bench.view->currentIndex()), Qt::Key_Backtab);
    QCOMPARE(bench.view->currentIndex(), bench.view->model()->index(0, 1));
  }

  void interpolation_is_chosen_for_each_variable_and_compared() {
    const Bench bench;
    const auto visible_curves = [&] {
      int count = 0;
      for (int i = 0; i < 3; ++i)
        if (bench.plot->graph(i)->visible() && !bench.plot->graph(i)->data()->isEmpty()) ++count;
      return count;
    };
    QCOMPARE(visible_curves(), 1);
    bench.editor->findChild<QCheckBox*>("function_compare")->setChecked(true);
    QCOMPARE(visible_curves(), 3);
    QCOMPARE(bench.plot->graph(0)->pen().style(), Qt::SolidLine);
    bench.click("function_cubic");
    QCOMPARE(bench.editor->draft().parts[0].method, core::Interpolation::cubic);
    QCOMPARE(bench.editor->draft().parts[1].method, core::Interpolation::linear);
    QCOMPARE(bench.plot->graph(1)->pen().style(), Qt::SolidLine);
    QVERIFY(bench.plot->graph(0)->pen().style() != Qt::SolidLine);
    // The spline through (1, 150) and (2, 0) is not the straight line between them.
    const double straight = bench.plot->graph(0)->data()->findBegin(1.5)->value;
    const double spline = bench.plot->graph(1)->data()->findBegin(1.5)->value;
    QVERIFY(near(straight, 75.0, 1.0) && !near(spline, 75.0, 5.0));
    bench.click("function_part_2");
    QCOMPARE(bench.knots(), (std::vector<core::Knot>{{0.0, 20.0}}));
    QVERIFY(bench.editor->findChild<QRadioButton*>("function_cubic")->isChecked());
  }

  void functions_of_the_pulse_number_are_bars_whose_points_move_up_and_down() {
    const Bench bench(radar1, "pri_s");
    int bars = 0;
    for (int i = 0; i < bench.plot->plottableCount(); ++i)
      if (auto* plottable = qobject_cast<QCPBars*>(bench.plot->plottable(i)); plottable && plottable->visible())
        bars += plottable->data()->size();
    QCOMPARE(bars, 3);
    bench.drag(bench.plot->knot_pixel(1), bench.pixel(2.2, 1.2e-3));
    QCOMPARE(bench.knots()[1].x, 1.0);
    QVERIFY(near(bench.knots()[1].y, 1.2e-3, 2e-5));
    QVERIFY(!(bench.view->model()->flags(bench.view->model()->index(0, 0)) & Qt::ItemIsEditable));
    QVERIFY(bench.type(0, 1, "800 us"));
    QCOMPARE(bench.knots()[0].y, 800e-6);
    bench.type(0, 1, "-1 ms");
    QVERIFY(bench.problems().contains("at least"));
    QCOMPARE(bench.knots()[0].y, 800e-6);
  }

  void ok_is_one_undoable_step_and_cancel_none() {
    Bench bench;
    const scene::Scene before = bench.session.scene();
    bench.drag(bench.plot->knot_pixel(1), bench.pixel(1.5, 20.0));
    bench.click("function_insert");
    bench.click("function_cubic");
    const scene::FunctionDraft draft = bench.editor->draft();
    bench.editor->accept();
    QVERIFY(!bench.editor->isVisible());
    QCOMPARE(bench.stored().part[0], draft.parts[0]);
    QVERIFY(bench.session.document().history().undo_label().find("Trajectory of Ship") != std::string::npos);
    bench.session.undo();
    QVERIFY(bench.session.scene() == before);
    QVERIFY(!bench.session.document().history().can_undo());

    gui::FunctionEditor cancelled(bench.session, ship, "trajectory_m");
    cancelled.table().set_current(0);
    cancelled.findChild<QPushButton*>("function_insert")->click();
    cancelled.reject();
    QVERIFY(bench.session.scene() == before);
  }

  void a_data_file_is_saved_with_its_commented_header_and_loaded_again() {
    Bench bench;
    const scene::FunctionDraft before = bench.editor->draft();
    QVERIFY(bench.editor->save_file("path.dat"));
    const std::string text = file_text(bench.script.parent_path() / "path.dat");
    QCOMPARE(text.front(), '!');
    QVERIFY(text.find("position x") != std::string::npos);
    QCOMPARE(bench.editor->draft().file, std::string("path.dat"));
    QVERIFY(bench.editor->findChild<QRadioButton*>("function_in_file")->isChecked());
    bench.click("function_delete");
    QVERIFY(bench.editor->load_file("path.dat"));
    QCOMPARE(bench.editor->draft().parts, before.parts);
    bool asked = false;
    bench.editor->ask_unsaved = [&](const QString&) {
      asked = true;
      return gui::FunctionEditor::Unsaved::cancel;
    };
    bench.editor->accept();
    QVERIFY(!asked);
    QCOMPARE(bench.stored().file, std::string("path.dat"));
    QVERIFY(bench.session.document().text().find("path.dat") != std::string::npos);
  }

  void ok_asks_where_the_file_does_not_hold_the_samples() {
    Bench bench;
    QVERIFY(bench.editor->save_file("path.dat"));
    bench.click("function_delete");
    int asked = 0;
    bench.editor->ask_unsaved = [&](const QString&) {
      ++asked;
      return asked == 1 ? gui::FunctionEditor::Unsaved::cancel : gui::FunctionEditor::Unsaved::keep_inline;
    };
    bench.editor->accept();
    QVERIFY(bench.editor->isVisible());
    bench.editor->accept();
    QCOMPARE(asked, 2);
    QVERIFY(bench.stored().file.empty());
    QCOMPARE(bench.stored().part[0].knots.size(), std::size_t{3});
  }

  void tables_of_hdf5_are_shown_and_replaced_only_after_a_question() {
    Bench bench;
    // Two rows of time and three coordinates; their times descend until the first has its sign.
    std::string table = file_text(SARSIM_SOURCE_DIR "/fuzz/corpus/point_table/points.h5");
    const std::filesystem::path file = bench.script.parent_path() / "path.h5";
    write_file(file, table);
    QVERIFY(!bench.editor->load_file("path.h5"));
    QVERIFY(bench.problems().contains("must ascend"));
    const std::size_t time = table.find(std::string("\0\0\xc0\x3f", 4));
    QVERIFY(time != std::string::npos);
    table[time + 3] = '\xbf';
    write_file(file, table);
    QVERIFY(bench.editor->load_file("path.h5"));
    const std::vector<core::Knot> x{{-1.5, -2.0}, {-0.5, 1e6}};
    QVERIFY(bench.editor->draft().parts[0].knots == x);
    bench.editor->accept();
    QCOMPARE(bench.stored().file, std::string("path.h5"));
    gui::FunctionEditor again(bench.session, ship, "trajectory_m");
    QVERIFY(again.draft().parts[0].knots == x);
    again.ask_replace = [](const QString&) { return false; };
    QVERIFY(!again.save_file("path.h5"));
    QCOMPARE(file_text(file), table);
  }

  void an_existing_file_of_somebody_else_is_replaced_only_after_a_question() {
    Bench bench;
    const std::filesystem::path other = bench.script.parent_path() / "other.dat";
    write_file(other, "precious");
    bench.editor->ask_replace = [](const QString&) { return false; };
    QVERIFY(!bench.editor->save_file("other.dat"));
    QCOMPARE(file_text(other), std::string("precious"));
    bench.editor->ask_replace = [](const QString&) { return true; };
    QVERIFY(bench.editor->save_file("other.dat"));
    QVERIFY(file_text(other) != "precious");
  }

  void bad_files_are_explained_and_change_nothing() {
    const Bench bench;
    const scene::FunctionDraft before = bench.editor->draft();
    QVERIFY(!bench.editor->load_file("missing.dat"));
    QVERIFY(bench.problems().contains("missing.dat"));
    write_file(bench.script.parent_path() / "bad.dat", "2\n0 0\n1 one\n1\n0 0\n1\n0 0\n");
    QVERIFY(!bench.editor->load_file("bad.dat"));
    QVERIFY(bench.problems().contains("one"));
    QVERIFY(bench.problems().contains("Line 3"));
    write_file(bench.script.parent_path() / "short.dat", "2\n0 0\n1 1\n");
    QVERIFY(!bench.editor->load_file("short.dat"));
    QVERIFY(!bench.problems().isEmpty());
    QVERIFY(bench.editor->draft() == before);
    QVERIFY(!bench.editor->save_file("no/such/folder/x.dat"));
    QVERIFY(bench.problems().contains("x.dat"));
  }

  void csv_is_imported_inline() {
    Bench bench;
    const std::filesystem::path csv = bench.script.parent_path() / "track.csv";
    write_file(csv, "t,x,y,z\n0,1,2,3\n1,4,5,6\n");
    QVERIFY(bench.editor->import_csv(QString::fromStdString(csv.string())));
    QCOMPARE(bench.knots(), (std::vector<core::Knot>{{0.0, 1.0}, {1.0, 4.0}}));
    QVERIFY(bench.editor->draft().file.empty());
    write_file(csv, "t,x,y,z\n0,1,2,3\n1,4,apple,6\n");
    QVERIFY(!bench.editor->import_csv(QString::fromStdString(csv.string())));
    QVERIFY(bench.problems().contains("apple"));
  }

  void a_dark_palette_draws_light_axes() {
    const Bench bench;
    QPalette dark = bench.editor->palette();
    dark.setColor(QPalette::Window, QColor(20, 20, 20));
    dark.setColor(QPalette::WindowText, QColor(240, 240, 240));
    bench.editor->setPalette(dark);
    QApplication::processEvents();
    QVERIFY(bench.plot->xAxis->tickLabelColor().lightness() > 180);
    const QImage image = bench.plot->grab().toImage();
    QVERIFY(image.pixelColor(2, 2).lightness() < 60);
  }
};

const test::AddTest added("function_editor_test", test::run_test<FunctionEditorTest>);

}  // namespace sarsim::function_editor_test

#include "function_editor_test.moc"
