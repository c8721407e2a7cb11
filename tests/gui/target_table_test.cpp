#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "gui/common/problem_line.hpp"
#include "gui/gui_test.hpp"
#include "gui/objects/import_dialog.hpp"
#include "gui/objects/target_table.hpp"
#include "gui/objects/target_table_model.hpp"
#include "small_scene.hpp"
#include "support/processor_time.hpp"

namespace sarsim::target_table_test {
namespace {

struct Bench {
  Bench() { start(test::small_scene()); }
  explicit Bench(const scene::Scene& scene) { start(scene); }
  void start(const scene::Scene& scene) {
    test::open(session, scene);
    table.resize(900, 500);
    table.show();
    view = table.findChild<QTableView*>("target_cells");
    model = qobject_cast<gui::TargetTableModel*>(view->model());
  }
  [[nodiscard]] QModelIndex cell(int row, const std::string& field) const {
    return model->index(row, model->column_of(field));
  }
  [[nodiscard]] QString text(int row, const std::string& field) const { return cell(row, field).data().toString(); }
  [[nodiscard]] QString message() const { return table.findChild<gui::ProblemLine*>("table_message")->text(); }
  void select_column(const std::string& field, int first, int last) const {
    view->setCurrentIndex(cell(first, field));
    view->selectionModel()->select(QItemSelection(cell(first, field), cell(last, field)),
                                   QItemSelectionModel::ClearAndSelect);
  }
  // Types into a cell as a user does.
  void type(int row, const std::string& field, const QString& text) const {
    view->setCurrentIndex(cell(row, field));
    view->edit(cell(row, field));
    auto* editor = view->viewport()->findChild<QLineEdit*>("cell_editor");
    QVERIFY(editor != nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
    QTest::qWait(1);  // The view takes the text in the next turn of the event loop.
  }
  [[nodiscard]] const std::vector<scene::Target>& targets() const { return session.scene().targets; }

  gui::Session session;
  gui::TargetTable table{session};
  QTableView* view = nullptr;
  gui::TargetTableModel* model = nullptr;
};

QString file_with(const QTemporaryDir& folder, const QByteArray& bytes) {
  const QString path = folder.filePath("points.csv");
  QFile file(path);
  if (file.open(QIODevice::WriteOnly)) file.write(bytes);
  return path;
}

}  // namespace

class TargetTableTest : public QObject {
  Q_OBJECT

 private slots:
  void a_column_has_one_unit_which_its_heading_names() {
    Bench bench;
    const auto heading = [&](const std::string& field) {
      return bench.model->headerData(bench.model->column_of(field), Qt::Horizontal, Qt::DisplayRole).toString();
    };
    QVERIFY2(heading("position_m.x").endsWith(" [m]"), qPrintable(heading("position_m.x")));
    QVERIFY2(heading("rcs_m2").endsWith(" [m²]"), qPrintable(heading("rcs_m2")));
    QCOMPARE(heading("platform"), QString("Platform name"));
    bench.type(0, "position_m.x", "199 mm");
    bench.type(1, "position_m.x", "1.359 km");
    QCOMPARE(bench.text(0, "position_m.x"), QString("0.199"));
    QCOMPARE(bench.text(1, "position_m.x"), QString("1359"));
    bench.type(1, "position_m.x", "1360");
    QCOMPARE(bench.targets()[1].position_m.x, 1360.0);
  }

  void a_cell_takes_an_expression_which_the_text_keeps() {
    Bench bench;
    bench.session.take(
        scene::Document::from_text("format = \"sarsim 2\"\n[let]\nspacing = \"1.5 km\"\n"
                                   "[[target]]\nposition = [1, 2, 3]\n[[target]]\nposition = [4, 5, 6]\n"));
    bench.type(0, "rcs_m2", "2 * 3");
    QCOMPARE(bench.targets()[0].rcs_m2, 6.0);
    bench.type(1, "position_m.x", "2 * spacing");
    QCOMPARE(bench.targets()[1].position_m.x, 3000.0);
    const std::string text = bench.session.document().text();
    QVERIFY2(text.find("2 * spacing") != std::string::npos, text.c_str());
    QVERIFY2(text.find("2 * 3") != std::string::npos, text.c_str());
    bench.select_column("position_m.y", 0, 1);
    QCOMPARE(bench.model->fill(bench.view->selectionModel()->selectedIndexes(), {"spacing / 2"}), QString());
    QCOMPARE(bench.targets()[0].position_m.y, 750.0);
    QCOMPARE(bench.targets()[1].position_m.y, 750.0);
    bench.type(0, "position_m.z", "2 * nothing");
    QVERIFY2(bench.message().contains("nothing"), qPrintable(bench.message()));
    QCOMPARE(bench.targets()[0].position_m.z, 3.0);
  }

  void a_heading_that_is_clicked_sorts() {
    Bench bench;
    bench.type(0, "position_m.x", "10 km");
    bench.session.select_only(test::target(0));
    const int column = bench.model->column_of("position_m.x");
    const QHeaderView& heads = *bench.view->horizontalHeader();
    const QPoint head(heads.sectionViewportPosition(column) + 20, heads.height() / 2);
    const auto order = [&] {
      return std::vector<std::size_t>{bench.model->target_at(0).index, bench.model->target_at(1).index,
                                      bench.model->target_at(2).index};
    };
    QVERIFY(order() == (std::vector<std::size_t>{0, 1, 2}));
    QTest::mouseClick(heads.viewport(), Qt::LeftButton, {}, head);
    QVERIFY(order() == (std::vector<std::size_t>{1, 2, 0}));
    QCOMPARE(bench.view->selectionModel()->selectedRows().value(0).row(), 2);  // The selection stays with its target.
    bench.type(2, "rcs_m2", "7");
    QCOMPARE(bench.targets()[0].rcs_m2, 7.0);
    QTest::mouseClick(heads.viewport(), Qt::LeftButton, {}, head);
    QVERIFY(order() == (std::vector<std::size_t>{0, 2, 1}));
    bench.table.add_target();
    QCOMPARE(bench.model->target_at(3).index, std::size_t{3});
    QTest::mouseClick(heads.viewport(), Qt::LeftButton, {}, head);
    QVERIFY(order() == (std::vector<std::size_t>{0, 1, 2}));
  }

  void a_row_shows_a_target() {
    const Bench bench;
    QCOMPARE(bench.model->rowCount(), 3);
    QCOMPARE(bench.text(1, "position_m.x"), QString("2000"));
    QCOMPARE(bench.text(1, "rcs_m2"), QString("1"));
    QCOMPARE(bench.text(2, "platform"), QString("Ship"));
    QCOMPARE(bench.text(0, "reflectivity"), QString("Isotropic"));
    QCOMPARE(bench.model->column_of("gain_db"), -1);
  }

  void a_cell_takes_a_value_with_its_unit() {
    Bench bench;
    bench.type(0, "position_m.y", "300 ft");
    QCOMPARE(bench.targets()[0].position_m.y, 91.44);
    bench.session.undo();
    QCOMPARE(bench.targets()[0].position_m.y, 0.0);
  }

  void a_bad_value_is_explained_and_stays_in_the_cell() {
    Bench bench;
    const scene::Scene before = bench.session.scene();
    bench.type(0, "position_m.x", "3 kg");
    QVERIFY(bench.session.scene() == before);
    QVERIFY2(bench.message().contains("'3 kg' is not a valid length"), qPrintable(bench.message()));
    QLineEdit* editor = nullptr;
    QTRY_VERIFY((editor = bench.view->viewport()->findChild<QLineEdit*>("cell_editor")) != nullptr &&
                editor->text() == "3 kg");
    editor->selectAll();
    QTest::keyClicks(editor, "3 km");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(bench.targets()[0].position_m.x, 3000.0);
    QVERIFY(bench.message().isEmpty());
  }

  void a_field_without_meaning_cannot_be_edited() {
    Bench bench;
    QCOMPARE(bench.text(0, "azimuth"), QString("-"));
    QVERIFY(!bench.model->flags(bench.cell(0, "azimuth")).testFlag(Qt::ItemIsEditable));
    QVERIFY(bench.model->setData(bench.cell(0, "reflectivity"), "Directional", Qt::EditRole));
    QVERIFY(bench.model->flags(bench.cell(0, "azimuth")).testFlag(Qt::ItemIsEditable));
    QVERIFY(bench.targets()[0].traits->reflectivity == scene::Target::Reflectivity::directional);
  }

  void one_value_fills_all_selected_cells_in_one_step() {
    Bench bench;
    const scene::Scene before = bench.session.scene();
    bench.select_column("rcs_m2", 0, 2);
    bench.table.findChild<QLineEdit*>("fill_value")->setText("10 dBsm");
    QTest::mouseClick(bench.table.findChild<QPushButton*>("fill_cells"), Qt::LeftButton);
    for (const scene::Target& target : bench.targets()) QCOMPARE(target.rcs_m2, 10.0);
    QCOMPARE(QString::fromStdString(bench.session.document().history().undo_label()), QString("Change 3 targets"));
    bench.session.undo();
    QVERIFY(bench.session.scene() == before);
  }

  void a_value_that_one_cell_refuses_changes_none() {
    Bench bench;
    const scene::Scene before = bench.session.scene();
    bench.select_column("azimuth", 0, 2);
    QVERIFY(bench.model->setData(bench.cell(1, "reflectivity"), "Directional", Qt::EditRole));
    const scene::Scene after_choice = bench.session.scene();
    bench.select_column("azimuth", 0, 2);
    bench.table.fill_selection("5 deg");
    QVERIFY(bench.session.scene() == after_choice);
    QVERIFY2(bench.message().contains("target 1"), qPrintable(bench.message()));
    bench.session.undo();
    QVERIFY(bench.session.scene() == before);
  }

  void targets_are_pasted_from_a_spreadsheet_and_undone_together() {
    Bench bench;
    const scene::Scene before = bench.session.scene();
    bench.view->clearSelection();
    QApplication::clipboard()->setText("x\ty\tz\tRCS\n1\t2\t3\t4\n5\t6\t7\t8\n");
    QTest::keyClick(bench.view, Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(bench.targets().size(), std::size_t{5});
    QVERIFY((bench.targets()[4].position_m == core::Vec3{5.0, 6.0, 7.0}));
    QCOMPARE(bench.targets()[4].rcs_m2, 8.0);
    QCOMPARE(bench.model->rowCount(), 5);
    bench.session.undo();
    QVERIFY(bench.session.scene() == before);
  }

  void bad_lines_of_a_paste_are_named_and_the_others_taken() {
    Bench bench;
    bench.view->clearSelection();
    QApplication::clipboard()->setText("1\t2\t3\nnot\ta\tpoint\n4\t5\t6\n");
    bench.table.paste();
    QCOMPARE(bench.targets().size(), std::size_t{5});
    QVERIFY2(bench.message().contains("Line 2"), qPrintable(bench.message()));
  }

  void a_paste_goes_to_the_platform_that_is_shown() {
    Bench bench;
    auto* platform = bench.table.findChild<QComboBox*>("table_platform");
    platform->setCurrentIndex(platform->findText("Ship"));
    QCOMPARE(bench.model->rowCount(), 1);
    QApplication::clipboard()->setText("1,2,3\n");
    bench.table.paste();
    QCOMPARE(bench.targets().back().platform, std::string("Ship"));
    QCOMPARE(bench.model->rowCount(), 2);
  }

  void copied_targets_paste_back_the_same() {
    Bench bench;
    bench.select_column("rcs_m2", 0, 1);
    QTest::keyClick(bench.view, Qt::Key_C, Qt::ControlModifier);
    QVERIFY(QApplication::clipboard()->text().contains('\t'));
    bench.table.paste();
    QCOMPARE(bench.targets().size(), std::size_t{5});
    QVERIFY(bench.targets()[3].position_m == bench.targets()[0].position_m);
    QVERIFY(bench.targets()[4].position_m == bench.targets()[1].position_m);
  }

  void single_values_are_pasted_into_cells() {
    Bench bench;
    bench.select_column("position_m.z", 0, 2);
    QApplication::clipboard()->setText("250 m\n");
    bench.table.paste();
    for (const scene::Target& target : bench.targets()) QCOMPARE(target.position_m.z, 250.0);
    bench.select_column("position_m.z", 1, 1);
    QApplication::clipboard()->setText("1\r\n2\r\n");
    bench.table.paste();
    QCOMPARE(bench.targets()[0].position_m.z, 250.0);
    QCOMPARE(bench.targets()[1].position_m.z, 1.0);
    QCOMPARE(bench.targets()[2].position_m.z, 2.0);
    QCOMPARE(bench.targets().size(), std::size_t{3});
  }

  void an_empty_clipboard_is_told() {
    Bench bench;
    QApplication::clipboard()->clear();
    bench.table.paste();
    QVERIFY(bench.message().contains("no text"));
  }

  void targets_are_added_and_deleted() {
    Bench bench;
    bench.table.add_target();
    QCOMPARE(bench.targets().size(), std::size_t{4});
    QVERIFY(bench.session.selection() == std::set<scene::ObjectId>{test::target(3)});
    bench.select_column("rcs_m2", 0, 1);
    QTest::keyClick(bench.view, Qt::Key_Delete);
    QCOMPARE(bench.targets().size(), std::size_t{2});
    QCOMPARE(bench.targets()[0].position_m.x, 3000.0);
    bench.session.undo();
    QCOMPARE(bench.targets().size(), std::size_t{4});
  }

  void selection_is_the_sessions_both_ways() {
    Bench bench;
    bench.select_column("rcs_m2", 1, 2);
    QVERIFY(bench.session.selection() == (std::set<scene::ObjectId>{test::target(1), test::target(2)}));
    QCOMPARE(bench.view->selectionModel()->selectedIndexes().size(), 2);
    bench.session.select_only(test::target(0));
    const QModelIndexList rows = bench.view->selectionModel()->selectedRows();
    QCOMPARE(rows.size(), 1);
    QCOMPARE(rows[0].row(), 0);
  }

  void a_file_is_previewed_and_imported_in_one_step() {
    Bench bench;
    const scene::Scene before = bench.session.scene();
    const QTemporaryDir folder;
    gui::ImportDialog dialog(bench.session);
    auto* add = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    QVERIFY(!add->isEnabled());
    dialog.set_file(file_with(folder, "x;y;z;rcs\r\n1;2;3;4\r\nbad;line\r\n5;6;7;8\r\n"));
    QVERIFY(dialog.findChild<QPlainTextEdit*>("import_preview")->toPlainText().contains("1;2;3;4"));
    auto* bad = dialog.findChild<QListWidget*>("import_bad_lines");
    QCOMPARE(bad->count(), 1);
    QVERIFY(bad->item(0)->text().startsWith("Line 3:"));
    QCOMPARE(dialog.findChild<QLabel*>("import_summary")->text(), QString("2 targets; 1 line is left out:"));
    QVERIFY(add->isEnabled());
    dialog.findChild<QComboBox*>("import_platform")->setCurrentText("Ship");
    QTest::mouseClick(add, Qt::LeftButton);
    QCOMPARE(dialog.result(), static_cast<int>(QDialog::Accepted));
    QCOMPARE(bench.targets().size(), std::size_t{5});
    QCOMPARE(bench.targets().back().platform, std::string("Ship"));
    QCOMPARE(bench.targets().back().rcs_m2, 8.0);
    bench.session.undo();
    QVERIFY(bench.session.scene() == before);
  }

  void a_file_that_cannot_be_read_is_named() {
    Bench bench;
    const QTemporaryDir folder;
    gui::ImportDialog dialog(bench.session);
    const auto summary = [&] { return dialog.findChild<QLabel*>("import_summary")->text(); };
    dialog.set_file(folder.filePath("missing.txt"));
    QVERIFY2(summary().contains("missing.txt cannot be read"), qPrintable(summary()));
    dialog.set_file(folder.path());
    QVERIFY2(summary().contains("is a folder"), qPrintable(summary()));
    dialog.accept();
    QCOMPARE(bench.targets().size(), std::size_t{3});
  }

  void a_long_file_is_read_while_the_window_answers() {
    Bench bench;
    const QTemporaryDir folder;
    QByteArray lines("x y z\n");
    for (int i = 0; i < 100000; ++i) lines += "1.25 2.5 3\n";
    gui::ImportDialog dialog(bench.session);
    auto* add = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    const auto summary = [&] { return dialog.findChild<QLabel*>("import_summary")->text(); };
    const QString path = file_with(folder, lines);
    dialog.set_file(path);
    QVERIFY2(summary().startsWith("Reading"), qPrintable(summary()));
    QVERIFY(!add->isEnabled());
    QTRY_COMPARE_WITH_TIMEOUT(summary(), QString("100000 targets."), 20000);
    QVERIFY(add->isEnabled());
    // Another platform reads it anew; a short file in its place ends that.
    dialog.findChild<QComboBox*>("import_platform")->setCurrentText("Ship");
    QVERIFY(!add->isEnabled());
    QFile::remove(path);
    dialog.set_file(file_with(folder, "1 2 3\n"));
    QCOMPARE(summary(), QString("1 target."));
    QTest::qWait(300);
    QCOMPARE(summary(), QString("1 target."));
  }

  void text_of_spreadsheets_in_utf_16_is_read() {
    QByteArray bytes("\xFF\xFE", 2);
    for (const char c : {'1', ' ', '2', ' ', '3', '\n'}) bytes += QByteArray(1, c) + QByteArray(1, '\0');
    QCOMPARE(gui::text_of_bytes(bytes), QString("1 2 3\n"));
    QCOMPARE(gui::text_of_bytes("\xEF\xBB\xBF"
                                "1,2,3"),
             QString("1,2,3"));
  }

  void ten_thousand_targets_stay_quick() {
    Bench bench(test::many_targets(10000));
    QCOMPARE(bench.model->rowCount(), 10000);
    bench.select_column("rcs_m2", 0, 9999);
    const test::ProcessorTime time;
    bench.table.fill_selection("2 m2");
    const double filled_s = time.seconds();
    qInfo() << "filling 10000 cells:" << 1e3 * filled_s << "ms";
    QCOMPARE(bench.targets()[9999].rcs_m2, 2.0);
    QVERIFY(filled_s < 5.0);
    // Also so many are refused in words, and changed in one step.
    bench.table.fill_selection("2 s");
    QVERIFY2(bench.message().contains("target 1:") && bench.message().contains("Nothing was changed"),
             qPrintable(bench.message()));
    QCOMPARE(bench.targets()[0].rcs_m2, 2.0);
    bench.session.undo();
    QVERIFY(std::ranges::all_of(bench.targets(), [](const scene::Target& target) { return target.rcs_m2 == 1.0; }));
  }

  void many_rows_apart_from_each_other_are_selected_at_once() {
    constexpr std::size_t count = 60000;
    Bench bench(test::many_targets(count));
    std::set<scene::ObjectId> even;
    std::set<scene::ObjectId> odd;
    for (std::size_t i = 0; i < count; ++i) (i % 2 == 0 ? even : odd).insert(test::target(i));
    const test::ProcessorTime time;
    bench.session.select(even);
    bench.session.select(odd);
    QCOMPARE(bench.view->selectionModel()->selection().size(), qsizetype{count / 2});
    QVERIFY(bench.view->selectionModel()->isRowSelected(1, {}) && !bench.view->selectionModel()->isRowSelected(2, {}));
    // All of them, less every other, and back.
    even.merge(odd);
    bench.session.select(even);
    bench.session.perform(scene::remove_objects(bench.session.scene(), {even.begin(), std::next(even.begin(), 9)}));
    bench.session.undo();
    const double selected_s = time.seconds();
    qInfo() << "selecting and undoing:" << 1e3 * selected_s << "ms";
    QVERIFY(selected_s < 3.0);  // 0.3 s; when ranges were compared with each other, 8 s
  }
};

const test::AddTest added("target_table_test", test::run_test<TargetTableTest>);

}  // namespace sarsim::target_table_test

#include "target_table_test.moc"
