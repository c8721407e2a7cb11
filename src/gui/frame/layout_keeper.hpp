#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include <map>

class QByteArray;
class QDockWidget;
class QMainWindow;
class QMenu;

namespace sarsim::gui {

/// Which panels stand beside the scene, and how much room they take: layouts with names, which are kept from one time
/// to the next.
class LayoutKeeper : public QObject {
  Q_OBJECT

 public:
  /// @param window  and its panels by their names; both must outlive it
  LayoutKeeper(QMainWindow& window, const std::map<QString, QDockWidget*>& docks);

  /// The layouts that there are, those that the program brings first.
  [[nodiscard]] QStringList names() const;
  /// Shows the panels of a layout: "scene", "echoes", "views" (echoes and image beside the scene), "script", or one
  /// that was saved. False where there is none of that name.
  bool apply(const QString& name);
  /// Keeps the panels as they are under a name.
  void save(const QString& name);
  /// Begins with a layout, whatever was kept of the last time.
  void use(const QString& name) { wanted_ = name; }
  /// The layout of a user who has not chosen any; "scene" unless said.
  void set_first(const QString& name) { first_ = name; }
  /// Puts all as it was the last time, or as it is at first.
  void restore();
  /// Whether `restore` found what was kept of the last time.
  [[nodiscard]] bool kept() const { return kept_; }
  /// Keeps all for the next time.
  void keep() const;
  /// Puts all windows back to their first places.
  void reset();
  /// Gives the panels their usual shares of the window.
  void size_docks();
  /// Entries for the layouts and what can be done with them.
  void fill(QMenu& menu);

 signals:
  void restored();  ///< Panels and tool bars may be as they were kept.

 private:
  bool restore_panels(const QByteArray& kept);

  QMainWindow& window_;
  const std::map<QString, QDockWidget*>& docks_;
  QString first_ = "scene";
  QString wanted_;
  bool kept_ = false;
};

}  // namespace sarsim::gui
