#pragma once

#include <QObject>
#include <QString>
#include <QWidget>

#include <vector>

namespace sarsim::gui {

/// Where the guide speaks of a window or panel.
struct HelpPlace {
  QString page;     ///< A file of the documentation's folder.
  QString heading;  ///< Of a section; empty: the page from its beginning.
};

/// The place for a widget: that of the innermost of the windows and panels around it that the guide speaks of, or the
/// page about the workbench as a whole.
[[nodiscard]] HelpPlace help_place_of(const QWidget* widget);

/// Every place that F1 may lead to, so that tests can look whether it exists.
[[nodiscard]] std::vector<HelpPlace> all_help_places();

/// Listens to F1 in all windows of the program, dialogs included, which the actions of the main window do not reach.
class HelpKey : public QObject {
  Q_OBJECT

 public:
  explicit HelpKey(QObject* parent);

 signals:
  void pressed(QWidget* where);  ///< F1, with the keyboard in this widget.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace sarsim::gui
