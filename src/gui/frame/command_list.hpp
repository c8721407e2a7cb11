#pragma once

#include <QDialog>
#include <QList>

class QAction;
class QLineEdit;
class QListWidget;

namespace sarsim::gui {

/// All commands of the workbench with their shortcuts, found by typing a few letters ("command_list").
class CommandList : public QDialog {
  Q_OBJECT

 public:
  /// Lists those of these commands that are enabled and have words.
  explicit CommandList(const QList<QAction*>& actions, QWidget* parent = nullptr);

  void accept() override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void search();

  QList<QAction*> actions_;
  QLineEdit* field_ = nullptr;
  QListWidget* list_ = nullptr;
};

}  // namespace sarsim::gui
