#include "gui/runs/stored_simulations.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <array>

#include "gui/common/text.hpp"
#include "gui/runs/run_panel.hpp"
#include "scene/edit/edit.hpp"
#include "scene/schema/quantity.hpp"

namespace sarsim::gui {

namespace fs = std::filesystem;

namespace {

enum Column { processing, radar, slant_range, azimuth_range, rate, bits, lsb, file, column_count };

QString text(double value, scene::Quantity quantity) { return read_out(scene::quantity_text(value, quantity)); }

QString span_text(double from, double to, scene::Quantity quantity) {
  return StoredSimulations::tr("%1 to %2").arg(text(from, quantity), text(to, quantity));
}

QString processing_text(scene::Processing kind) {
  switch (kind) {
    case scene::Processing::matched_filter: return StoredSimulations::tr("Compressed");
    case scene::Processing::srp: return StoredSimulations::tr("Range profiles");
    case scene::Processing::raw: return StoredSimulations::tr("Raw");
  }
  return {};
}

std::array<QString, column_count> cells_of(const scene::Simulation& s) {
  std::array<QString, column_count> cells;
  cells[processing] = processing_text(s.processing);
  cells[radar] = QString::fromStdString(s.radar);
  cells[slant_range] = span_text(s.range_start_m, s.range_end_m, scene::Quantity::length);
  cells[azimuth_range] = span_text(s.time_start_s, s.time_end_s, scene::Quantity::time);
  cells[rate] = text(s.sample_rate_hz, scene::Quantity::frequency);
  cells[bits] = QString::number(s.bits);
  cells[lsb] = s.lsb_v > 0.0 ? text(s.lsb_v, scene::Quantity::voltage) : StoredSimulations::tr("estimated");
  cells[file] = QString::fromStdString(s.file);
  return cells;
}

QStringList headings() {
  return {StoredSimulations::tr("Data"),    StoredSimulations::tr("Radar"), StoredSimulations::tr("Slant range"),
          StoredSimulations::tr("Azimuth"), StoredSimulations::tr("A/D"),   StoredSimulations::tr("Bits"),
          StoredSimulations::tr("LSB"),     StoredSimulations::tr("File")};
}

}  // namespace

StoredSimulations::StoredSimulations(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      table_(new QTableWidget(0, column_count, this)),
      empty_(new QLabel(tr("No simulation is stored in this script."), this)),
      run_panel_(new RunPanel(this)) {
  setObjectName("stored_simulations");
  setAccessibleName(tr("Stored simulations"));
  table_->setObjectName("stored_table");
  table_->setAccessibleName(tr("Stored simulations"));
  table_->setHorizontalHeaderLabels(headings());
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  table_->horizontalHeader()->setStretchLastSection(true);
  empty_->setObjectName("stored_empty");
  empty_->setWordWrap(true);

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(empty_);
  layout->addWidget(table_, 1);
  layout->addLayout(make_buttons());
  layout->addWidget(run_panel_);

  make_questions();
  connect(table_, &QTableWidget::itemSelectionChanged, this, &StoredSimulations::refresh_buttons);
  connect(table_, &QTableWidget::cellDoubleClicked, this, &StoredSimulations::show_chosen);
  connect(run_panel_, &RunPanel::ended, this, &StoredSimulations::refresh_buttons);
  connect(run_panel_, &RunPanel::lsb_wanted, this, &StoredSimulations::take_lsb);
  connect(&session_, &Session::scene_changed, this, &StoredSimulations::refresh);
  connect(&session_, &Session::document_replaced, this, &StoredSimulations::refresh);
  connect(&session_, &Session::selection_changed, this, &StoredSimulations::follow_selection);
  refresh();
}

QHBoxLayout* StoredSimulations::make_buttons() {
  auto* buttons = new QHBoxLayout;
  const auto add = [&](const QString& label, const char* name, const QString& tip, void (StoredSimulations::*slot)()) {
    QPushButton* button = add_button(label, name, tip, slot);
    buttons->addWidget(button);
    return button;
  };
  of_chosen_ = {
      add(tr("Sho&w"), "stored_show", tr("Opens a window with the echoes of this simulation"),
          &StoredSimulations::show_chosen),
      add(tr("Ed&it"), "stored_edit", tr("Shows the fields of this simulation"), &StoredSimulations::edit_chosen),
      add(tr("&Run …"), "stored_run", tr("Computes the file of this simulation"), &StoredSimulations::run_chosen),
      add(tr("De&lete"), "stored_delete", tr("Takes this simulation out of the script"),
          &StoredSimulations::delete_chosen)};
  new_ = add(tr("&New"), "stored_new", tr("Stores a new simulation of the current radar"), &StoredSimulations::add_new);
  buttons->addStretch(1);
  return buttons;
}

void StoredSimulations::make_questions() {
  ask_folder = [this]() -> std::optional<fs::path> {
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder for the file of the simulation"));
    if (chosen.isEmpty()) return std::nullopt;
    return fs::path(chosen.toStdString());
  };
  ask_replace = [this](const fs::path& existing) {
    return QMessageBox::question(this, tr("Run simulation"),
                                 tr("'%1' exists. Replace it?").arg(QString::fromStdString(existing.string()))) ==
           QMessageBox::Yes;
  };
}

QPushButton* StoredSimulations::add_button(const QString& label, const char* name, const QString& tip,
                                           void (StoredSimulations::*slot)()) {
  auto* button = new QPushButton(label, this);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  connect(button, &QPushButton::clicked, this, slot);
  return button;
}

std::optional<scene::ObjectId> StoredSimulations::chosen() const {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  if (rows.isEmpty()) return std::nullopt;
  const scene::ObjectId id{scene::ObjectKind::simulation, static_cast<std::size_t>(rows.front().row())};
  return scene::has_object(session_.scene(), id) ? std::optional(id) : std::nullopt;
}

void StoredSimulations::choose(scene::ObjectId simulation) {
  if (simulation.kind == scene::ObjectKind::simulation) table_->selectRow(static_cast<int>(simulation.index));
}

void StoredSimulations::refresh() {
  const std::vector<scene::Simulation>& stored = session_.scene().simulations;
  if (stored != shown_) {
    const int row = table_->currentRow();
    const QSignalBlocker quiet(table_);
    table_->setRowCount(static_cast<int>(stored.size()));
    for (std::size_t i = 0; i < stored.size(); ++i) {
      const auto cells = cells_of(stored[i]);
      for (std::size_t column = 0; column < cells.size(); ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        item->setToolTip(cells[column]);
        table_->setItem(static_cast<int>(i), static_cast<int>(column), item);
      }
    }
    if (shown_.empty()) table_->resizeColumnsToContents();
    shown_ = stored;
    if (row >= 0 && !stored.empty()) table_->selectRow(std::min(row, static_cast<int>(stored.size()) - 1));
  }
  empty_->setVisible(stored.empty());
  follow_selection();
  refresh_buttons();
}

void StoredSimulations::refresh_buttons() {
  const bool any = chosen().has_value();
  for (QPushButton* button : of_chosen_) button->setEnabled(any);
  if (run_panel_->running()) of_chosen_[2]->setEnabled(false);
  new_->setEnabled(!session_.scene().radars.empty());
  new_->setToolTip(session_.scene().radars.empty() ? tr("Create a radar first")
                                                   : tr("Stores a new simulation of the current radar"));
}

void StoredSimulations::follow_selection() {
  if (const auto current = session_.current(); current && current->kind == scene::ObjectKind::simulation)
    choose(*current);
}

void StoredSimulations::show_chosen() {
  if (const auto id = chosen()) emit show_requested(*id);
}

void StoredSimulations::edit_chosen() {
  if (const auto id = chosen()) session_.select_only(*id);
}

void StoredSimulations::delete_chosen() {
  const auto id = chosen();
  if (!id) return;
  session_.end_run();
  session_.perform(scene::remove_objects(session_.scene(), {*id}));
}

void StoredSimulations::add_new() {
  const scene::Scene& scene = session_.scene();
  if (scene.radars.empty()) return;
  const auto current = session_.current();
  const bool on_radar = current && current->kind == scene::ObjectKind::radar && scene::has_object(scene, *current);
  session_.end_run();
  session_.perform(scene::add_object(scene, suitable_simulation(scene, on_radar ? current->index : 0)));
  const scene::ObjectId made{scene::ObjectKind::simulation, session_.scene().simulations.size() - 1};
  session_.select_only(made);
  choose(made);
}

std::optional<fs::path> StoredSimulations::folder() const {
  const fs::path& script = session_.document().path();
  if (!script.empty()) return fs::absolute(script).parent_path();
  return ask_folder();
}

void StoredSimulations::run_chosen() {
  const auto id = chosen();
  if (!id || run_panel_->running()) return;
  const auto into = folder();
  if (!into) return;
  const fs::path path = run_file(session_.scene(), id->index, *into);
  if (path.empty()) {
    QMessageBox::warning(this, tr("Run simulation"), tr("The simulation has no file name. Give it one first."));
    return;
  }
  std::error_code failure;
  const bool exists = fs::exists(path, failure);
  if (exists && !ask_replace(path)) return;
  run_into(*id, path, exists);
}

void StoredSimulations::run_into(scene::ObjectId simulation, const fs::path& path, bool replace) {
  if (run_panel_->running()) return;
  run_of_ = session_.number();
  run_panel_->run({session_.scene(), simulation.index, path, replace});
  refresh_buttons();
}

// The simulation may have moved or changed since it was run; the best LSB is only of use to the same one.
void StoredSimulations::take_lsb(const scene::Simulation& simulation, double lsb_v) {
  if (run_of_ != session_.number()) {
    session_.log(core::Severity::warning,
                 tr("The run was of another scene; its LSB was left as it is. Turn to that scene first."));
    return;
  }
  const std::vector<scene::Simulation>& stored = session_.scene().simulations;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    if (!(stored[i] == simulation)) continue;
    scene::Simulation changed = stored[i];
    changed.lsb_v = lsb_v;
    session_.end_run();
    session_.perform(scene::replace_object(session_.scene(), {scene::ObjectKind::simulation, i}, changed,
                                           tr("Set best LSB").toStdString()));
    return;
  }
  session_.log(core::Severity::warning, tr("The simulation was changed after its run; its LSB was left as it is."));
}

}  // namespace sarsim::gui
