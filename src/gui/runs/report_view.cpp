#include "gui/runs/report_view.hpp"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "core/text/number_text.hpp"
#include "gui/common/figure_plot.hpp"
#include "gui/common/named.hpp"

namespace sarsim::gui {

namespace {

// Numbers of a column stand below each other; facts are read from the left.
QTableWidgetItem* cell_of(const std::string& text, bool fact) {
  auto* const cell = new QTableWidgetItem(QString::fromStdString(text));
  const bool number = !fact && core::parse_number(text).has_value();
  cell->setTextAlignment(Qt::AlignVCenter | (number ? Qt::AlignRight : Qt::AlignLeft));
  return cell;
}

QAction* add_action(QWidget* widget, const QString& words) {
  auto* const action = new QAction(words, widget);
  widget->addAction(action);
  widget->setContextMenuPolicy(Qt::ActionsContextMenu);
  return action;
}

}  // namespace

ReportView::ReportView(const QString& words, QWidget* parent)
    : QWidget(parent), stack_(new QStackedWidget(this)), tabs_(new QTabWidget(this)) {
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(stack_);
  auto* const label = new QLabel(words, this);
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);
  label->setEnabled(false);
  tabs_->setObjectName("report_tabs");
  tabs_->setDocumentMode(true);
  stack_->addWidget(label);
  stack_->addWidget(tabs_);
}

void ReportView::show_pages(const picture::ReportPages& pages) {
  clear();
  for (const picture::ReportTable& table : pages.tables) add_table(table);
  for (const picture::Figure& figure : pages.figures) add_figure(figure);
  if (tabs_->count() > 0) stack_->setCurrentWidget(tabs_);
}

void ReportView::clear() {
  stack_->setCurrentIndex(0);
  while (tabs_->count() > 0) {
    QWidget* const page = tabs_->widget(0);
    tabs_->removeTab(0);
    delete page;
  }
}

bool ReportView::empty() const { return tabs_->count() == 0; }

void ReportView::add_table(const picture::ReportTable& table) {
  const auto rows = static_cast<int>(table.rows.size());
  const auto columns = static_cast<int>(table.columns.size());
  const QString title = QString::fromStdString(table.title);
  auto* const shown =
      named(new QTableWidget(rows, columns, tabs_), "report_table", title, tr("Ctrl+C copies the selected cells"));
  for (int c = 0; c < columns; ++c) {
    auto* const head = new QTableWidgetItem(QString::fromStdString(table.columns[static_cast<std::size_t>(c)]));
    shown->setHorizontalHeaderItem(c, head);
    for (int r = 0; r < rows; ++r)
      shown->setItem(r, c, cell_of(table.rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)], table.facts));
  }
  shown->setEditTriggers(QAbstractItemView::NoEditTriggers);
  shown->setAlternatingRowColors(true);
  shown->setTabKeyNavigation(false);
  shown->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  shown->verticalHeader()->setVisible(false);
  shown->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  shown->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  shown->resizeColumnsToContents();
  shown->horizontalHeader()->setStretchLastSection(table.facts);
  if (table.facts) shown->horizontalHeader()->setDefaultAlignment(Qt::AlignVCenter | Qt::AlignLeft);
  shown->installEventFilter(this);
  connect(add_action(shown, tr("&Copy")), &QAction::triggered, shown, [shown] { copy(*shown, false); });
  connect(add_action(shown, tr("Copy the &Table")), &QAction::triggered, shown, [shown] { copy(*shown, true); });
  tabs_->addTab(shown, title);
}

void ReportView::add_figure(const picture::Figure& figure) {
  const QString title = QString::fromStdString(figure.title);
  auto* const plot = named(new FigurePlot(tabs_), "report_figure", title, {});
  plot->setMinimumHeight(fontMetrics().height() * 12);
  plot->set_figure(figure);
  connect(add_action(plot, tr("&Save the Picture…")), &QAction::triggered, plot,
          [plot] { ask_and_save_picture(*plot, plot->figure(), "report.png"); });
  tabs_->addTab(plot, title);
}

// Rows on lines, cells between tabs; what is not selected stays empty.
void ReportView::copy(const QTableWidget& table, bool whole) {
  QStringList lines;
  QStringList head;
  for (int c = 0; c < table.columnCount(); ++c) head << table.horizontalHeaderItem(c)->text();
  if (whole) lines << head.join('\t');
  int first = table.columnCount();
  int last = -1;
  for (const QTableWidgetSelectionRange& range : table.selectedRanges()) {
    first = std::min(first, range.leftColumn());
    last = std::max(last, range.rightColumn());
  }
  if (whole) {
    first = 0;
    last = table.columnCount() - 1;
  }
  for (int r = 0; r < table.rowCount(); ++r) {
    QStringList cells;
    bool any = whole;
    for (int c = first; c <= last; ++c) {
      const bool wanted = whole || table.item(r, c)->isSelected();
      any = any || wanted;
      cells << (wanted ? table.item(r, c)->text() : QString());
    }
    if (any) lines << cells.join('\t');
  }
  if (!lines.isEmpty()) QGuiApplication::clipboard()->setText(lines.join('\n'));
}

bool ReportView::eventFilter(QObject* watched, QEvent* event) {
  const auto* const table = qobject_cast<const QTableWidget*>(watched);
  if (table == nullptr || event->type() != QEvent::KeyPress ||
      !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy))
    return QWidget::eventFilter(watched, event);
  copy(*table, false);
  return true;
}

}  // namespace sarsim::gui
