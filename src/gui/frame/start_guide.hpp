#pragma once

#include <QObject>
#include <QString>

#include <vector>

#include "gui/frame/workbench.hpp"
#include "scene/model/object.hpp"

class QMainWindow;
class QWidget;

namespace sarsim::gui {

struct SearchEntry;
class ToolWindows;
class TourPanel;
struct TourStep;
class WelcomePage;

/// What helps at the beginning, and what finds things: the welcome page, the tour, the search box.
class StartGuide : public QObject {
  Q_OBJECT

 public:
  /// Puts the welcome page over the middle of the window.
  /// @param tools  must outlive it, as the window
  StartGuide(const Workbench& parts, ToolWindows& tools, QMainWindow& window);

  [[nodiscard]] WelcomePage& welcome() { return *welcome_; }
  /// Shows the welcome page, with the keyboard.
  void show_welcome();
  /// The tour, hidden until `show_tour`.
  [[nodiscard]] TourPanel* tour_panel();
  /// Begins the tour, or shows it where it is.
  void show_tour();
  /// Asks what is to be found.
  void show_search();
  /// A box over all that can be found, not yet shown.
  [[nodiscard]] QWidget* search_box();

 signals:
  void file_wanted(const QString& path);  ///< A file is to be opened.

 private:
  void make_welcome();
  void leave_welcome();
  [[nodiscard]] std::vector<SearchEntry> search_entries();
  [[nodiscard]] std::vector<TourStep> tour_steps();
  void go_to_field(scene::ObjectKind kind, const QString& field);

  const Workbench parts_;
  ToolWindows& tools_;
  QMainWindow& window_;
  WelcomePage* welcome_ = nullptr;
  TourPanel* tour_ = nullptr;
};

}  // namespace sarsim::gui
