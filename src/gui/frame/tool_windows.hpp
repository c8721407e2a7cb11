#pragma once

#include <QObject>
#include <QStringList>

#include <utility>

#include "gui/frame/guide_site.hpp"
#include "gui/frame/workbench.hpp"

class QWidget;

namespace sarsim::gui {

class GeometryWindow;
struct HelpPlace;
class ProductWindow;
class SimulationWindow;

/// The windows and dialogs beside the main window, which are made when they are first asked for.
class ToolWindows : public QObject {
  Q_OBJECT

 public:
  /// @param window  above which they stand
  ToolWindows(const Workbench& parts, QWidget& window);

  /// The table of ranges, delays, amplitudes and speeds for every pulse.
  void show_geometry();
  /// The table of targets.
  void show_targets();
  /// Where images are made of echoes.
  QWidget* show_products();
  /// Asks what the scene is to be looked at about (thesis 4.7): a platform that is followed, or a point.
  void show_focus();
  /// Opens the site with the guide where that is possible, otherwise a window of the program.
  void show_help(const HelpPlace& place);
  /// What this program is.
  void show_about();
  /// A window of echoes: of the stored simulation that is selected, otherwise a new one.
  SimulationWindow* open_simulation();
  void set_guide(GuideSite guide) { guide_ = std::move(guide); }

  /// What would be lost with these windows, in words.
  [[nodiscard]] QStringList work_under_way() const;
  /// Ends it.
  void end_work();

  /// One of the windows by its name (`names`), which is opened; null for another name, and for the panels and pages of
  /// the main window.
  [[nodiscard]] QWidget* named(const QString& name);
  /// The names of all windows, with those of the main window itself.
  [[nodiscard]] static QStringList names();

 private:
  void show_help_window(const HelpPlace& place);
  [[nodiscard]] QWidget* simulation_part(const QString& name);

  const Workbench parts_;
  QWidget& window_;
  GeometryWindow* geometry_ = nullptr;
  QWidget* targets_ = nullptr;
  ProductWindow* products_ = nullptr;
  GuideSite guide_;
};

}  // namespace sarsim::gui
