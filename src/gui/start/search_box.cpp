#include "gui/start/search_box.hpp"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <string>
#include <utility>

#include "core/text/search.hpp"
#include "gui/common/icons.hpp"

namespace sarsim::gui {

namespace {

constexpr int detail_role = Qt::UserRole + 1;
constexpr std::size_t max_matches = 200;  // more nobody reads, and a list of them is slow to fill

// Words at the left, the detail at the right; words that do not fit beside it end in an ellipsis.
class MatchDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    painter->setPen(option.palette.color(chosen ? QPalette::HighlightedText : QPalette::PlaceholderText));
    painter->setFont(option.font);
    painter->drawText(option.rect.adjusted(0, 0, -gap(option), 0), Qt::AlignRight | Qt::AlignVCenter,
                      index.data(detail_role).toString());
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QSize words = QStyledItemDelegate::sizeHint(option, index);
    return {words.width(), option.fontMetrics.height() * 3 / 2};
  }

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const int detail = option->fontMetrics.horizontalAdvance(index.data(detail_role).toString());
    const int room = option->rect.width() - detail - option->decorationSize.width() - 4 * gap(*option);
    if (option->rect.width() > 0) option->text = option->fontMetrics.elidedText(option->text, Qt::ElideRight, room);
  }

 private:
  static int gap(const QStyleOptionViewItem& option) { return option.fontMetrics.height() / 2; }
};

QString icon_name(SearchEntry::Kind kind) {
  switch (kind) {
    case SearchEntry::Kind::command: return QStringLiteral("run");
    case SearchEntry::Kind::field: return QStringLiteral("field");
    case SearchEntry::Kind::help: return QStringLiteral("help");
  }
  return {};
}

QString spoken_kind(SearchEntry::Kind kind) {
  switch (kind) {
    case SearchEntry::Kind::command: return SearchBox::tr("command");
    case SearchEntry::Kind::field: return SearchBox::tr("field");
    case SearchEntry::Kind::help: return SearchBox::tr("page of the guide");
  }
  return {};
}

// Those that the trade calls so, or by a word that begins so.
std::vector<std::size_t> entries_called(const std::vector<SearchEntry>& entries, const QString& typed) {
  constexpr qsizetype enough = 4;  // letters: fewer begin too many words
  const QString plain = typed.simplified().toLower().replace(' ', '_');
  std::vector<std::size_t> found;
  const auto is_it = [&](const QString& word) {
    return word == plain || (plain.size() >= enough && word.startsWith(plain));
  };
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (std::ranges::any_of(entries[i].also, is_it)) found.push_back(i);
  return found;
}

}  // namespace

SearchBox::SearchBox(std::vector<SearchEntry> entries, QWidget* parent)
    : QDialog(parent), entries_(std::move(entries)), field_(new QLineEdit), list_(new QListWidget) {
  setObjectName("search_box");
  setWindowTitle(tr("Search"));
  std::ranges::stable_sort(entries_, {}, &SearchEntry::kind);
  for (const SearchEntry& entry : entries_) texts_.push_back(entry.words.toStdString());
  field_->setObjectName("search_field");
  field_->setPlaceholderText(tr("Some letters of a command, a field or a page of the guide"));
  field_->setAccessibleName(tr("Search for"));
  field_->setToolTip(tr("Up and Down choose, Enter does it, Escape leaves"));
  field_->installEventFilter(this);
  list_->setObjectName("search_matches");
  list_->setItemDelegate(new MatchDelegate(list_));
  list_->setAccessibleName(tr("What matches"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(field_);
  layout->addWidget(list_);
  connect(field_, &QLineEdit::textChanged, this, &SearchBox::search);
  connect(list_, &QListWidget::itemActivated, this, &SearchBox::accept);
  resize(fontMetrics().averageCharWidth() * 84, fontMetrics().height() * 24);
  search();
}

void SearchBox::search() {
  list_->clear();
  std::vector<std::size_t> matches = entries_called(entries_, field_->text());
  for (const std::size_t i : core::ranked_matches(field_->text().toStdString(), texts_))
    if (std::ranges::find(matches, i) == matches.end()) matches.push_back(i);
  matches.resize(std::min(matches.size(), max_matches));
  for (const std::size_t i : matches) {
    const SearchEntry& entry = entries_[i];
    auto* item = new QListWidgetItem(icon_of(icon_name(entry.kind)), entry.words, list_);
    item->setData(Qt::UserRole, static_cast<qulonglong>(i));
    item->setData(detail_role, entry.detail);
    QStringList spoken{entry.words, spoken_kind(entry.kind)};
    if (!entry.detail.isEmpty()) spoken += entry.detail;
    item->setData(Qt::AccessibleTextRole, spoken.join(", "));
    item->setToolTip(entry.tip.isEmpty() ? entry.words : entry.tip);
  }
  list_->setCurrentRow(0);
}

void SearchBox::accept() {
  const QListWidgetItem* item = list_->currentItem();
  const auto work = item == nullptr ? std::function<void()>() : entries_[item->data(Qt::UserRole).toULongLong()].work;
  QDialog::accept();
  if (work) work();
}

// The arrows move in the list while the keyboard stays in the field.
bool SearchBox::eventFilter(QObject* watched, QEvent* event) {
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
