#include "gui/frame/tool_windows.hpp"

#include <qcustomplot.h>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QEventLoop>
#include <QFormLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QTimer>

#include <array>
#include <map>

#include "core/build/version.hpp"
#include "core/maths/rounding.hpp"
#include "gui/common/icons.hpp"
#include "gui/common/session.hpp"
#include "gui/echo/data_saver.hpp"
#include "gui/echo/radar_view_window.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/help_key.hpp"
#include "gui/frame/help_window.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/image_viewers.hpp"
#include "gui/image/open_image_dialog.hpp"
#include "gui/objects/function_editor.hpp"
#include "gui/objects/import_dialog.hpp"
#include "gui/objects/target_table.hpp"
#include "gui/runs/product_window.hpp"
#include "gui/runs/save_data_dialog.hpp"
#include "gui/runs/save_queue.hpp"
#include "gui/scene/geometry_window.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "picture/figure/ticks.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::gui {

namespace {

constexpr int longest_picture_ms = 5000;

}  // namespace

ToolWindows::ToolWindows(const Workbench& parts, QWidget& window) : QObject(&window), parts_(parts), window_(window) {}

// Thesis 4.7: a platform that is followed, or a point.
void ToolWindows::show_focus() {
  QDialog dialog(&window_);
  dialog.setObjectName("focus_dialog");
  dialog.setWindowTitle(tr("Select Focus"));
  auto* form = new QFormLayout(&dialog);
  auto* platform = new QComboBox;
  platform->setObjectName("focus_platform");
  platform->setAccessibleName(tr("Follow"));
  platform->setToolTip(tr("A platform stays in the middle while the time runs"));
  platform->addItem(tr("A point"));
  for (const scene::Platform& p : parts_.session.scene().platforms) platform->addItem(QString::fromStdString(p.name));
  if (parts_.scene.followed() && parts_.scene.followed()->kind == scene::ObjectKind::platform)
    platform->setCurrentIndex(static_cast<int>(parts_.scene.followed()->index) + 1);
  form->addRow(tr("&Follow"), platform);
  const core::Vec3 focus = parts_.scene.scene().camera().focus_world_m;
  std::array<QLineEdit*, 3> fields{};
  // Finer than a tenth of a pixel nobody sees.
  const double fine_m = picture::round_below(0.1 / parts_.scene.scene().camera().pixels_per_m);
  const std::array<double, 3> values{core::rounded_to(focus.x, fine_m), core::rounded_to(focus.y, fine_m),
                                     core::rounded_to(focus.z, fine_m)};
  for (std::size_t i = 0; i < 3; ++i) {
    fields[i] = new QLineEdit(QString::fromStdString(scene::quantity_text(values[i], scene::Quantity::length, "m")));
    fields[i]->setObjectName(QString("focus_%1").arg(QChar("xyz"[i])));
    fields[i]->setAccessibleName(tr("%1 of the focus").arg(QChar("XYZ"[i])));
    fields[i]->setToolTip(tr("In the world; any unit: 100 m, 2.5 km"));
    fields[i]->setMinimumWidth(fields[i]->fontMetrics().horizontalAdvance("-000.000000 km  "));
    form->addRow(QString("&%1").arg(QChar("XYZ"[i])), fields[i]);
    fields[i]->setEnabled(platform->currentIndex() == 0);
  }
  connect(platform, &QComboBox::currentIndexChanged, &dialog, [&](int index) {
    for (QLineEdit* field : fields) field->setEnabled(index == 0);
  });
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  if (dialog.exec() != QDialog::Accepted) return;
  if (platform->currentIndex() > 0) {
    parts_.scene.follow(
        scene::ObjectId{scene::ObjectKind::platform, static_cast<std::size_t>(platform->currentIndex() - 1)});
    return;
  }
  std::array<double, 3> wanted = values;
  for (std::size_t i = 0; i < 3; ++i) {
    const scene::QuantityReading reading =
        scene::read_quantity(fields[i]->text().toStdString(), scene::Quantity::length);
    if (reading.value)
      wanted[i] = *reading.value;
    else
      parts_.session.log(core::Severity::warning, QString::fromStdString(reading.failure));
  }
  parts_.scene.follow(std::nullopt);
  parts_.scene.focus_on({wanted[0], wanted[1], wanted[2]});
}

void ToolWindows::show_geometry() {
  if (geometry_ == nullptr) {
    geometry_ = new GeometryWindow(parts_.session, &window_);
    geometry_->setWindowFlag(Qt::Window);
  }
  geometry_->show();
  geometry_->raise();
  geometry_->activateWindow();
}

void ToolWindows::show_targets() {
  if (targets_ == nullptr) targets_ = new TargetTableDialog(parts_.session, &window_);
  targets_->show();
  targets_->raise();
  targets_->activateWindow();
}

void ToolWindows::show_help(const HelpPlace& place) {
  if (!guide_.open(place)) show_help_window(place);
}

// A dialog that holds up the rest of the program must not hold up its own help.
void ToolWindows::show_help_window(const HelpPlace& place) {
  QWidget* parent = QApplication::activeModalWidget();
  if (parent == nullptr || qobject_cast<HelpWindow*>(parent) != nullptr) parent = &window_;
  auto* help = parent->findChild<HelpWindow*>("help_window", Qt::FindDirectChildrenOnly);
  if (help == nullptr) help = new HelpWindow(parent);
  help->show();  // before the page, which is scrolled in a window that has its size
  help->show_page(place.page, place.heading);
  help->raise();
  help->activateWindow();
}

void ToolWindows::show_about() {
  QMessageBox box(QMessageBox::NoIcon, tr("About Sarsim"),
                  tr("<h3>Sarsim %1</h3><p>Radar echo simulator: from a scene to complex baseband samples.</p>"
                     "<p>Qt %2, QCustomPlot %3, HDF5 %4</p>"
                     "<p>Free software under the <a href=\"https://www.gnu.org/licenses/gpl-3.0.html\">GNU General "
                     "Public License</a>, version 3 or later, without any warranty.</p>")
                      .arg(core::program_version, qVersion(), QCUSTOMPLOT_VERSION_STR, core::hdf5_version),
                  QMessageBox::Ok, &window_);
  box.setObjectName("about");
  box.setIconPixmap(program_icon().pixmap(box.fontMetrics().height() * 5));
  box.setTextFormat(Qt::RichText);
  box.setTextInteractionFlags(Qt::TextBrowserInteraction);
  box.exec();
}

QWidget* ToolWindows::show_products() {
  parts_.commit_typed();
  if (products_ == nullptr) products_ = new ProductWindow(parts_.session, parts_.image_viewers, &window_);
  products_->show();
  products_->raise();
  products_->activateWindow();
  return products_;
}

QStringList ToolWindows::work_under_way() const {
  QStringList work;
  if (geometry_ != nullptr && geometry_->saving()) work << tr("A geometry table is being saved.");
  if (products_ != nullptr && products_->busy()) work << tr("An image is being made from echoes.");
  return work;
}

void ToolWindows::end_work() {
  if (geometry_ != nullptr) geometry_->cancel_saving();
  if (products_ != nullptr) products_->stop();
}

QStringList ToolWindows::names() {
  return {"main",       "objects",       "properties", "script",   "simulations",   "log",           "geometry",
          "simulation", "compressed",    "targets",    "function", "commands",      "help",          "import",
          "viewer",     "output",        "save_data",  "saving",   "range_profile", "range_doppler", "doppler_time",
          "spectrum",   "phase_history", "products",   "welcome",  "tour",          "image"};
}

// A window of echoes: of the stored simulation that is selected, otherwise a new one.
SimulationWindow* ToolWindows::open_simulation() {
  const auto current = parts_.session.current();
  if (current && current->kind == scene::ObjectKind::simulation) return parts_.simulation_windows.open_stored(*current);
  return parts_.simulation_windows.open_new(scene::Processing::raw);
}

// Windows that belong to one of echoes, which is opened with them.
QWidget* ToolWindows::simulation_part(const QString& name) {
  static const std::map<QString, picture::RadarView> views{{"range_profile", picture::RadarView::range_profile},
                                                           {"range_doppler", picture::RadarView::range_doppler},
                                                           {"doppler_time", picture::RadarView::doppler_time},
                                                           {"spectrum", picture::RadarView::spectrum},
                                                           {"phase_history", picture::RadarView::phase_history}};
  if (name == "saving") return &parts_.saver.queue();
  const auto view = views.find(name);
  if (view == views.end() && name != "save_data") return nullptr;
  SimulationWindow* window = open_simulation();
  if (window == nullptr) return nullptr;
  if (view != views.end()) return window->open_radar_view(view->second);
  // The dialog tells of the picture, which must be there first.
  QEventLoop until_shown;
  connect(window, &SimulationWindow::finished, &until_shown, &QEventLoop::quit);
  QTimer::singleShot(longest_picture_ms, &until_shown, &QEventLoop::quit);
  until_shown.exec();
  return parts_.saver.ask(window->simulation(), *window);
}

QWidget* ToolWindows::named(const QString& name) {
  if (name == "geometry") return show_geometry(), geometry_;
  if (name == "simulation") return open_simulation();
  if (name == "compressed") return parts_.simulation_windows.open_new(scene::Processing::matched_filter);
  if (name == "viewer") {
    const auto viewers = parts_.image_viewers.viewers();
    return viewers.empty() ? parts_.image_viewers.open_empty() : viewers.front();
  }
  if (name == "output") return parts_.image_viewers.ask_file();
  if (name == "products") return show_products();
  if (QWidget* of_simulation = simulation_part(name)) return of_simulation;
  if (name == "targets") return show_targets(), targets_;
  if (name == "help") return show_help_window({"README.md", {}}), window_.findChild<HelpWindow*>("help_window");
  if (name == "import") return new ImportDialog(parts_.session, &window_);
  if (name != "function") return nullptr;
  // The first function that the scene has.
  for (const scene::ObjectKind kind :
       {scene::ObjectKind::platform, scene::ObjectKind::radar, scene::ObjectKind::target})
    for (std::size_t i = 0; i < scene::count_of(parts_.session.scene(), kind); ++i) {
      const scene::AnyObject object = scene::object_of(parts_.session.scene(), {kind, i});
      for (const scene::Field& field : scene::fields_of(kind))
        if (field.kind == scene::FieldKind::function && scene::field_applies(object, field.id))
          return new FunctionEditor(parts_.session, {kind, i}, field.id, &window_);
    }
  return nullptr;
}

}  // namespace sarsim::gui
