#include "gui/start/card_list.hpp"

#include <QGuiApplication>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QWheelEvent>

#include <algorithm>

#include "gui/common/appearance.hpp"

namespace sarsim::gui {

namespace {

constexpr int sentence_role = Qt::UserRole + 1;
constexpr int picture_role = Qt::UserRole + 2;
constexpr int letters_across = 38;
constexpr int sentence_lines = 3;

int picture_height(const QFontMetrics& letters) { return letters.averageCharWidth() * letters_across / 2; }

int columns_in(int width, const QFontMetrics& letters) {
  return std::max(1, (width - 1) / (letters.averageCharWidth() * letters_across));
}

class CardDelegate : public QStyledItemDelegate {
 public:
  CardDelegate(bool with_pictures, const QListWidget& list)
      : QStyledItemDelegate(nullptr), list_(list), with_pictures_(with_pictures) {}

  // Cards of a row share its width.
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    const int width = list_.viewport()->width() - 1;
    return {width / columns_in(width + 1, option.fontMetrics), card_height(option.fontMetrics, with_pictures_)};
  }

  static int card_height(const QFontMetrics& letters, bool with_pictures) {
    const int line = letters.height();
    return line * (sentence_lines + 2) + line / 2 + (with_pictures ? picture_height(letters) : 0);
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const int line = option.fontMetrics.height();
    const QRect card = option.rect.adjusted(line / 4, line / 4, -line / 4, -line / 4);
    draw_ground(*painter, option, card);
    QRect words = card.adjusted(line / 3, line / 3, -line / 3, -line / 4);
    if (with_pictures_) {
      const QRect place(card.left() + line / 4, card.top() + line / 4, card.width() - line / 2,
                        picture_height(option.fontMetrics));
      draw_picture(*painter, place, index.data(picture_role).value<QPixmap>(), option.palette);
      words.setTop(place.bottom() + line / 3);
    } else {
      const int side = line * 2;
      index.data(Qt::DecorationRole).value<QIcon>().paint(painter, QRect(words.topLeft(), QSize(side, side)));
      words.setLeft(words.left() + side + line / 2);
    }
    draw_words(*painter, option, index, words);
    painter->restore();
  }

 private:
  static void draw_ground(QPainter& painter, const QStyleOptionViewItem& option, const QRect& card) {
    const bool chosen = option.state.testFlag(QStyle::State_Selected) && option.state.testFlag(QStyle::State_HasFocus);
    const bool under = option.state.testFlag(QStyle::State_MouseOver);
    const QColor strong = option.palette.color(QPalette::Highlight);
    painter.setPen(chosen || under ? QPen(strong, chosen ? 2.0 : 1.0) : QPen(rim_of(option.palette, false), 1.0));
    painter.setBrush(option.palette.color(QPalette::Base));
    painter.drawRoundedRect(QRectF(card).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  }

  static void draw_picture(QPainter& painter, const QRect& place, const QPixmap& picture, const QPalette& palette) {
    if (picture.isNull()) return painter.fillRect(place, palette.color(QPalette::AlternateBase));
    // Whole, on the paper that pictures of the gallery are drawn on.
    QRectF whole(QPointF(), QSizeF(picture.size()).scaled(QSizeF(place.size()), Qt::KeepAspectRatio));
    whole.moveCenter(QRectF(place).center());
    painter.fillRect(place, Qt::white);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawPixmap(whole, picture, QRectF(picture.rect()));
  }

  static void draw_words(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, QRect words) {
    QFont bold = option.font;
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(option.palette.color(QPalette::Text));
    const QString title = index.data(Qt::DisplayRole).toString();
    painter.drawText(words, Qt::AlignLeft | Qt::AlignTop,
                     QFontMetrics(bold).elidedText(title, Qt::ElideRight, words.width()));
    words.setTop(words.top() + option.fontMetrics.height() * 5 / 4);
    painter.setFont(option.font);
    painter.setPen(option.palette.color(QPalette::PlaceholderText));
    painter.drawText(words, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, index.data(sentence_role).toString());
  }

  const QListWidget& list_;
  bool with_pictures_;
};

}  // namespace

CardList::CardList(bool with_pictures, QWidget* parent) : QListWidget(parent), with_pictures_(with_pictures) {
  auto* delegate = new CardDelegate(with_pictures, *this);
  delegate->setParent(this);
  setItemDelegate(delegate);
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setMouseTracking(true);
  setFrameShape(QFrame::NoFrame);
  setSpacing(0);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  viewport()->setAutoFillBackground(false);
  viewport()->setCursor(Qt::PointingHandCursor);
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { emit chosen(row(item)); });
  connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
    if (!QGuiApplication::mouseButtons().testFlag(Qt::LeftButton)) emit chosen(row(item));
  });
}

void CardList::add_card(const QString& title, const QString& sentence) {
  auto* item = new QListWidgetItem(title, this);
  item->setData(sentence_role, sentence);
  item->setData(Qt::AccessibleTextRole, title + ". " + sentence);
  item->setToolTip(sentence);
  take_height();
}

void CardList::set_icon(int row, const QIcon& icon) { item(row)->setIcon(icon); }

// Kept about as large as it is shown: a large picture takes long to shrink whenever it is drawn.
void CardList::set_picture(int row, const QPixmap& picture) {
  const int height = qRound(1.4 * picture_height(fontMetrics()) * devicePixelRatioF());
  item(row)->setData(picture_role,
                     picture.scaled(QSize(2 * height, height), Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

void CardList::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  take_height();
}

// The page scrolls, not the list.
void CardList::wheelEvent(QWheelEvent* event) { event->ignore(); }

void CardList::take_height() {
  const int columns = columns_in(viewport()->width(), fontMetrics());
  const int rows = (count() + columns - 1) / columns;
  setFixedHeight(rows * CardDelegate::card_height(fontMetrics(), with_pictures_) + 2);
  scheduleDelayedItemsLayout();
}

}  // namespace sarsim::gui
