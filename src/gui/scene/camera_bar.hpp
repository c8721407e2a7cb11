#pragma once

#include <QWidget>

#include <functional>

class QToolButton;

namespace sarsim::gui {

class ScenePanel;

/// A row of small buttons in a corner of the scene ("camera_bar"): what is shown and from where, and the tools of the
/// hand. Each does what an entry of the menu View does.
class CameraBar : public QWidget {
  Q_OBJECT

 public:
  /// @param panel  whose scene is looked at; must outlive it
  explicit CameraBar(ScenePanel& panel);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// What the picture of a button is.
  enum class Sign { all, selection, above, front, side, beam, follow, list, measure, path };

  QToolButton* add(Sign sign, const char* name, const QString& text, const QString& tip, std::function<void()> work);
  void add_tools();
  void show_signs();
  [[nodiscard]] static QIcon icon_of(Sign sign, const QColor& colour);

  ScenePanel& panel_;
};

}  // namespace sarsim::gui
