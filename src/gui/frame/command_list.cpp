#include "gui/frame/command_list.hpp"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <string>
#include <vector>

#include "core/text/search.hpp"

namespace sarsim::gui {

namespace {

QString words_of(const QAction& action) {
  QString text = action.text().remove('&').remove(QString::fromUtf8("…"));
  const QString group = action.property("menu").toString();
  return group.isEmpty() ? text : group + ": " + text;
}

constexpr int keys_role = Qt::UserRole + 1;

// A command at the left, its keys at the right.
class CommandDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    painter->setPen(option.palette.color(chosen ? QPalette::HighlightedText : QPalette::PlaceholderText));
    painter->setFont(option.font);
    painter->drawText(option.rect.adjusted(0, 0, -gap(option), 0), Qt::AlignRight | Qt::AlignVCenter,
                      index.data(keys_role).toString());
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QSize words = QStyledItemDelegate::sizeHint(option, index);
    const int keys = option.fontMetrics.horizontalAdvance(index.data(keys_role).toString());
    return {words.width() + keys + 3 * gap(option), option.fontMetrics.height() * 3 / 2};
  }

 private:
  static int gap(const QStyleOptionViewItem& option) { return option.fontMetrics.height() / 2; }
};

}  // namespace

CommandList::CommandList(const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent), field_(new QLineEdit), list_(new QListWidget) {
  setObjectName("command_list");
  setWindowTitle(tr("Commands"));
  for (QAction* action : actions)
    if (action->isEnabled() && !action->isSeparator() && !action->text().isEmpty()) actions_.append(action);
  field_->setObjectName("command_search");
  field_->setPlaceholderText(tr("Type some letters of a command"));
  field_->setAccessibleName(tr("Search of commands"));
  field_->installEventFilter(this);
  list_->setObjectName("command_matches");
  list_->setItemDelegate(new CommandDelegate(list_));
  list_->setAccessibleName(tr("Commands that match"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(field_);
  layout->addWidget(list_);
  connect(field_, &QLineEdit::textChanged, this, &CommandList::search);
  connect(list_, &QListWidget::itemActivated, this, &CommandList::accept);
  resize(fontMetrics().averageCharWidth() * 64, fontMetrics().height() * 22);
  search();
}

void CommandList::search() {
  std::vector<std::string> texts;
  for (const QAction* action : actions_) texts.push_back(words_of(*action).toStdString());
  list_->clear();
  for (const std::size_t i : core::ranked_matches(field_->text().toStdString(), texts)) {
    const QAction* action = actions_[static_cast<qsizetype>(i)];
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    auto* item = new QListWidgetItem(words_of(*action), list_);
    item->setData(Qt::UserRole, static_cast<int>(i));
    item->setData(keys_role, keys);
    item->setData(Qt::AccessibleTextRole, keys.isEmpty() ? item->text() : item->text() + ", " + keys);
    item->setToolTip(action->toolTip());
  }
  list_->setCurrentRow(0);
}

void CommandList::accept() {
  const QListWidgetItem* item = list_->currentItem();
  QDialog::accept();
  if (item != nullptr) actions_[item->data(Qt::UserRole).toInt()]->trigger();
}

// The arrows move in the list while the keyboard stays in the field.
bool CommandList::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
      QCoreApplication::sendEvent(list_, event);
      return true;
    }
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      accept();
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace sarsim::gui
