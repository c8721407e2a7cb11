#pragma once

#include <QWidget>

#include "picture/facts/report_pages.hpp"

class QLabel;
class QStackedWidget;
class QTabWidget;
class QTableWidget;

namespace sarsim::gui {

/// Shows what came of a request: a tab for each table and figure. Cells can be selected and copied (Ctrl+C) to a
/// spreadsheet, whole tables with their headings; figures can be saved.
class ReportView : public QWidget {
  Q_OBJECT

 public:
  /// @param words  what stands there while there is nothing to show
  explicit ReportView(const QString& words, QWidget* parent = nullptr);

  /// Shows a report in place of another one.
  void show_pages(const picture::ReportPages& pages);
  /// Shows nothing but the words.
  void clear();
  [[nodiscard]] bool empty() const;  ///< Nothing but the words is shown.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void add_table(const picture::ReportTable& table);
  void add_figure(const picture::Figure& figure);
  static void copy(const QTableWidget& table, bool whole);

  QStackedWidget* stack_ = nullptr;
  QTabWidget* tabs_ = nullptr;
};

}  // namespace sarsim::gui
