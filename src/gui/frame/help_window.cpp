#include "gui/frame/help_window.hpp"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>
#include <QVBoxLayout>

#include "gui/common/palette_colours.hpp"
#include "gui/frame/guide_site.hpp"

namespace sarsim::gui {

namespace {

// Shows pictures that are wider than the window smaller.
class GuidePage : public QTextBrowser {
 public:
  // Laid out once, not for each piece of it that is read.
  void doSetSource(const QUrl& page, QTextDocument::ResourceType type) override {
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    QTextBrowser::doSetSource(page, type);
    cursor.endEditBlock();
    lay_out_tables();
  }
  QVariant loadResource(int type, const QUrl& name) override {
    const QVariant resource = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return resource;
    QImage picture = resource.userType() == QMetaType::QByteArray ? QImage::fromData(resource.toByteArray())
                                                                  : resource.value<QImage>();
    if (picture.isNull()) return resource;
    // With room for the scroll bar, which may come later.
    const int bar = verticalScrollBar()->sizeHint().width();
    const int most = width() - 2 * frameWidth() - bar - 3 * static_cast<int>(document()->documentMargin());
    const double scale = devicePixelRatioF();
    if (most < fontMetrics().height() || picture.width() <= most) return picture;
    picture = picture.scaledToWidth(qRound(most * scale), Qt::SmoothTransformation);
    picture.setDevicePixelRatio(scale);
    return picture;
  }

 private:
  // Rows of a table are told apart by one fine line, words by some room.
  void lay_out_tables() {
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    const QColor line = palette().color(QPalette::PlaceholderText);
    for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
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
    cursor.endEditBlock();
  }
};

bool is_heading(const QTextBlock& block) { return block.blockFormat().headingLevel() > 0; }

}  // namespace

HelpWindow::HelpWindow(QWidget* parent) : QDialog(parent), browser_(new GuidePage), find_(new QLineEdit) {
  setObjectName("help_window");
  setWindowTitle(tr("Help"));
  browser_->setObjectName("help_page");
  browser_->setAccessibleName(tr("Page of the guide"));
  browser_->setOpenLinks(false);
  browser_->document()->setDocumentMargin(12);
  if (!folder().isEmpty()) browser_->setSearchPaths({folder()});
  auto* buttons = new QDialogButtonBox;
  auto* back = buttons->addButton(tr("&Back"), QDialogButtonBox::ActionRole);
  auto* home = buttons->addButton(tr("&Contents"), QDialogButtonBox::ActionRole);
  buttons->addButton(QDialogButtonBox::Close);
  for (auto* button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
  back->setEnabled(false);
  connect(browser_, &QTextBrowser::anchorClicked, this, &HelpWindow::follow);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(back, &QPushButton::clicked, browser_, &QTextBrowser::backward);
  connect(home, &QPushButton::clicked, this, [this] { show_page("README.md"); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  find_->setObjectName("help_find");
  find_->setPlaceholderText(tr("Find in this page"));
  find_->setAccessibleName(tr("Find in this page"));
  find_->setToolTip(tr("Enter goes on to the next place. Ctrl+K in the main window finds pages and headings."));
  connect(find_, &QLineEdit::textEdited, this, [this] { find_next(true); });
  connect(find_, &QLineEdit::returnPressed, this, [this] { find_next(false); });
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(find_);
  layout->addWidget(browser_);
  layout->addWidget(buttons);
  resize(fontMetrics().averageCharWidth() * 100, fontMetrics().height() * 40);
}

QString HelpWindow::folder() {
  const QDir program(QCoreApplication::applicationDirPath());
  for (const char* place : {"../share/doc/sarsim", "../../../docs", "../../docs", "../../../../docs"})
    if (program.exists(QString(place) + "/README.md")) return QDir::cleanPath(program.absoluteFilePath(place));
  return {};
}

void HelpWindow::show_page(const QString& page, const QString& heading) {
  if (folder().isEmpty()) {
    browser_->setPlainText(
        tr("The user guide is not installed beside the program. It is the folder docs of the sources, "
           "where tools/site makes pages of it for a browser; installed, they are in "
           "share/doc/sarsim/html."));
    return;
  }
  browser_->setSource(QUrl::fromLocalFile(folder() + "/" + page), QTextDocument::MarkdownResource);
  if (heading.isEmpty() || !scroll_to(anchor_of(heading))) browser_->verticalScrollBar()->setValue(0);
}

bool HelpWindow::scroll_to(const QString& anchor) {
  for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next()) {
    if (!is_heading(block) || anchor_of(block.text()) != anchor) continue;
    QTextCursor cursor(block);
    browser_->setTextCursor(cursor);
    browser_->verticalScrollBar()->setValue(browser_->verticalScrollBar()->value() + browser_->cursorRect().top());
    return true;
  }
  return false;
}

// Round the end; in red where there is no such place.
void HelpWindow::find_next(bool from_here) {
  QTextCursor cursor = browser_->textCursor();
  if (from_here) cursor.setPosition(cursor.selectionStart());
  browser_->setTextCursor(cursor);
  bool found = find_->text().isEmpty() || browser_->find(find_->text());
  if (!found) {
    browser_->moveCursor(QTextCursor::Start);
    found = browser_->find(find_->text());
  }
  QPalette colours = palette();
  if (!found) colours.setColor(QPalette::Text, colour_of(picture::Role::error, colours));
  find_->setPalette(colours);
}

QString HelpWindow::heading() const {
  QTextBlock block = browser_->textCursor().block();
  if (browser_->verticalScrollBar()->value() == 0 && !is_heading(block)) block = browser_->document()->begin();
  return is_heading(block) ? block.text() : QString();
}

// Pages are shown here; folders, which only a browser of files shows well, by what they hold; the rest by the desktop.
void HelpWindow::follow(const QUrl& link) {
  const QUrl whole = browser_->source().resolved(link);
  const QFileInfo file(whole.toLocalFile());
  if (!whole.isLocalFile()) {
    QDesktopServices::openUrl(whole);
  } else if (file.isDir()) {
    QStringList lines{"# " + file.fileName()};
    for (const QString& name : QDir(file.filePath()).entryList({"*.md", "*.toml", "*.scr"}, QDir::Files, QDir::Name))
      lines += QString("- [%1](%2/%1)").arg(name, whole.path());
    browser_->setMarkdown(lines.join('\n'));
  } else if (file.suffix() == "md") {
    const bool same = file == QFileInfo(browser_->source().toLocalFile());
    if (!same) browser_->setSource(whole.adjusted(QUrl::RemoveFragment), QTextDocument::MarkdownResource);
    if (whole.hasFragment()) scroll_to(whole.fragment());
  } else {
    browser_->setSource(whole, QTextDocument::UnknownResource);
  }
}

}  // namespace sarsim::gui
