#include "gui/frame/document_tabs.hpp"

#include <QMouseEvent>
#include <QSignalBlocker>

#include "gui/common/session.hpp"
#include "gui/common/text.hpp"
#include "gui/frame/document_keeper.hpp"

namespace sarsim::gui {

DocumentTabs::DocumentTabs(Session& session, const DocumentKeeper& documents, QWidget* parent)
    : QTabBar(parent), session_(session), documents_(documents) {
  setObjectName("document_tabs");
  setAccessibleName(tr("Open scenes"));
  setDocumentMode(true);
  setDrawBase(false);
  setExpanding(false);
  setMovable(true);
  setTabsClosable(true);
  setElideMode(Qt::ElideNone);  // Many are scrolled through: of cut names nothing would be left.
  setUsesScrollButtons(true);
  connect(&session_, &Session::row_changed, this, &DocumentTabs::show_row);
  connect(&session_, &Session::document_replaced, this, &DocumentTabs::show_at_hand);
  connect(&session_, &Session::scene_changed, this, &DocumentTabs::show_at_hand);
  connect(&session_, &Session::document_changed, this, &DocumentTabs::show_row);  // a name may be that of another one
  connect(this, &QTabBar::currentChanged, this, [this](int index) {
    if (!moving_) emit turn_wanted(index);
  });
  connect(this, &QTabBar::tabCloseRequested, this, &DocumentTabs::close_wanted);
  connect(this, &QTabBar::tabMoved, this, [this](int from, int to) {
    moving_ = true;
    session_.move(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    moving_ = false;
  });
  show_row();
}

void DocumentTabs::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) {
    if (const int index = tabAt(event->pos()); index >= 0) emit close_wanted(index);
    return;
  }
  QTabBar::mouseReleaseEvent(event);
}

// While a hand moves a tab they stand as they should already.
void DocumentTabs::show_row() {
  if (moving_) return;
  const QSignalBlocker quiet(this);
  const int documents = static_cast<int>(session_.document_count());
  while (count() < documents) addTab(QString());
  while (count() > documents) removeTab(count() - 1);
  for (int i = 0; i < documents; ++i) show_document(i);
  setCurrentIndex(static_cast<int>(session_.at_hand()));
}

void DocumentTabs::show_at_hand() {
  const int index = static_cast<int>(session_.at_hand());
  if (index >= count()) return;  // The row is told of in a moment.
  const QSignalBlocker quiet(this);
  show_document(index);
  setCurrentIndex(index);
}

void DocumentTabs::show_document(int index) {
  const auto place = static_cast<std::size_t>(index);
  const QString text = short_name(index).replace('&', "&&") + (documents_.unsaved(place) ? "*" : "");
  if (tabText(index) != text) setTabText(index, text);
  setTabToolTip(index, documents_.shown_name(place));
}

// The name of the file; of files of one name also that of the folder.
QString DocumentTabs::short_name(int index) const {
  const auto place = static_cast<std::size_t>(index);
  const std::filesystem::path& path = session_.document_at(place).path();
  if (path.empty()) return documents_.shown_name(place);
  for (std::size_t i = 0; i < session_.document_count(); ++i)
    if (i != place && session_.document_at(i).path().filename() == path.filename())
      return text_of(path.parent_path().filename() / path.filename());
  return text_of(path.filename());
}

}  // namespace sarsim::gui
