#include "gui/help_window.hpp"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QPushButton>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>
#include <QVBoxLayout>

namespace sarsim {

HelpWindow::HelpWindow(QWidget* parent) : QDialog(parent), browser_(new QTextBrowser) {
  setObjectName("help_window");
  setWindowTitle(tr("Help"));
  browser_->setObjectName("help_page");
  browser_->setAccessibleName(tr("Page of the guide"));
  browser_->setOpenExternalLinks(true);
  browser_->document()->setDocumentMargin(12);
  connect(browser_, &QTextBrowser::sourceChanged, this, &HelpWindow::lay_out_tables);
  if (!folder().isEmpty()) browser_->setSearchPaths({folder()});
  auto* buttons = new QDialogButtonBox;
  auto* back = buttons->addButton(tr("&Back"), QDialogButtonBox::ActionRole);
  auto* home = buttons->addButton(tr("&Contents"), QDialogButtonBox::ActionRole);
  buttons->addButton(QDialogButtonBox::Close);
  back->setEnabled(false);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(back, &QPushButton::clicked, browser_, &QTextBrowser::backward);
  connect(home, &QPushButton::clicked, this, [this] { show_page("README.md"); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(browser_);
  layout->addWidget(buttons);
  resize(fontMetrics().averageCharWidth() * 100, fontMetrics().height() * 40);
}

QString HelpWindow::folder() {
  const QDir program(QCoreApplication::applicationDirPath());
  for (const char* place : {"../share/doc/sarsim", "../../../docs", "../../docs"})
    if (program.exists(QString(place) + "/README.md")) return QDir::cleanPath(program.absoluteFilePath(place));
  return {};
}

// Rows of a table are told apart by one fine line, words by some room.
void HelpWindow::lay_out_tables() {
  const QColor line = palette().color(QPalette::PlaceholderText);
  for (QTextFrame* frame : browser_->document()->rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat format = table->format();
    format.setBorderCollapse(true);
    format.setBorder(1);
    format.setBorderBrush(line);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setCellPadding(5);
    format.setCellSpacing(0);
    format.setTopMargin(6);
    format.setBottomMargin(6);
    table->setFormat(format);
  }
}

void HelpWindow::show_page(const QString& page) {
  if (folder().isEmpty()) {
    browser_->setPlainText(tr("The documentation is not installed beside the program."));
    return;
  }
  browser_->setSource(QUrl::fromLocalFile(folder() + "/" + page), QTextDocument::MarkdownResource);
}

}  // namespace sarsim
