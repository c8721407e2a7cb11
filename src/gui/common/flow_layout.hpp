#pragma once

#include <QLayout>
#include <QList>

namespace sarsim::gui {

/// Widgets in rows, as many beside each other as there is room for: a row of buttons that may be narrow. Qt has none.
class FlowLayout : public QLayout {
 public:
  explicit FlowLayout(QWidget* parent = nullptr);
  ~FlowLayout() override;

  void addItem(QLayoutItem* item) override { items_.append(item); }
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override { return items_.value(index); }
  QLayoutItem* takeAt(int index) override;
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return place({0, 0, width, 0}, false); }
  void setGeometry(const QRect& rect) override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSize() const override;

 private:
  // Puts the items into rows of a rectangle, or only counts; returns the height.
  int place(const QRect& rect, bool really) const;

  QList<QLayoutItem*> items_;
};

}  // namespace sarsim::gui
