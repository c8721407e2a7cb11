#pragma once

#include <QTabBar>

namespace sarsim::gui {

class DocumentKeeper;
class Session;

/// The open documents as tabs, in the order of the session's row: a star says that one is unsaved, a tip where its file
/// is. Hands may put them in another order.
class DocumentTabs : public QTabBar {
  Q_OBJECT

 public:
  /// Both outlive the tabs.
  DocumentTabs(Session& session, const DocumentKeeper& documents, QWidget* parent = nullptr);

 signals:
  void turn_wanted(int index);   ///< The user wants to work on this document.
  void close_wanted(int index);  ///< The user is done with this document.

 protected:
  /// The middle button closes.
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void show_row();
  void show_at_hand();
  void show_document(int index);
  [[nodiscard]] QString short_name(int index) const;

  Session& session_;
  const DocumentKeeper& documents_;
  bool moving_ = false;  // a hand moves a tab
};

}  // namespace sarsim::gui
