#pragma once

#include <QListWidget>

namespace sarsim::gui {

/// Cards side by side, as many in a row as fit: a picture or an icon, a title, and a sentence. As high as its cards, so
/// that it stands in a page that scrolls. A click or Enter chooses a card (itemActivated, itemClicked).
class CardList : public QListWidget {
  Q_OBJECT

 public:
  /// @param with_pictures  a picture above the words, otherwise an icon beside them
  explicit CardList(bool with_pictures, QWidget* parent = nullptr);

  /// Adds a card behind the others.
  void add_card(const QString& title, const QString& sentence);
  /// Gives a card its icon.
  void set_icon(int row, const QIcon& icon);
  /// Shown whole, as large as its place allows.
  void set_picture(int row, const QPixmap& picture);

 signals:
  void chosen(int row);  ///< A card was clicked, or Enter was pressed on it.

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void take_height();

  bool with_pictures_;
};

}  // namespace sarsim::gui
