// Several documents in one window: the row of tabs, turning from one to another, closing.

#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QToolBar>

#include "gui/frame/document_keeper.hpp"
#include "gui/frame/document_tabs.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/objects/property_panel.hpp"
#include "gui/script/script_editor.hpp"

namespace sarsim::gui {

// Above everything that shows the document, and only where there is a choice.
void MainWindow::make_document_row() {
  addToolBarBreak();
  document_row_ = addToolBar(tr("Open scenes"));
  document_row_->setObjectName("document_row");
  document_row_->setMovable(false);
  document_row_->toggleViewAction()->setVisible(false);
  auto* const tabs = new DocumentTabs(session_, *documents_, document_row_);
  document_row_->addWidget(tabs);
  connect(tabs, &DocumentTabs::turn_wanted, this, &MainWindow::turn_to_document);
  connect(tabs, &DocumentTabs::close_wanted, this, &MainWindow::close_document);
  connect(&session_, &Session::row_changed, this, &MainWindow::show_document_row);
  show_document_row();
}

void MainWindow::show_document_row() {
  const bool several = session_.document_count() > 1;
  document_row_->setVisible(several);
  for (const char* name : {"file_next", "file_previous"})
    if (auto* const action = findChild<QAction*>(name)) action->setEnabled(several);
}

// What is typed and not yet entered belongs to what is saved, run or left.
void MainWindow::commit_typed() {
  script_->commit();
  panel_->commit();
}

void MainWindow::turn_to_document(int index) {
  commit_typed();
  session_.turn_to(static_cast<std::size_t>(index));
}

void MainWindow::step_to_document(int step) {
  const auto count = static_cast<int>(session_.document_count());
  turn_to_document((static_cast<int>(session_.at_hand()) + step + count) % count);
}

// Where the last one was closed there is a choice of what to begin with.
void MainWindow::close_document(int index) {
  turn_to_document(index);
  const bool last = session_.document_count() == 1;
  if (documents_->close() && last) show_welcome();
}

// Echoes, images and other windows of their own close before the document does.
void MainWindow::close_what_is_active() {
  QWidget* const active = QApplication::activeWindow();
  const bool is_part = active == nullptr || active == this || qobject_cast<QDockWidget*>(active) != nullptr;
  if (is_part)
    close_document(static_cast<int>(session_.at_hand()));
  else
    active->close();
}

}  // namespace sarsim::gui
