#include "gui/script/script_text.hpp"

#include <QFontDatabase>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolTip>

#include <algorithm>

#include "gui/common/palette_colours.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/script/explanation_tip.hpp"
#include "gui/script/object_lines.hpp"
#include "gui/script/script_completer.hpp"
#include "gui/script/script_highlighter.hpp"
#include "scene/language/cursor.hpp"
#include "scene/language/hover.hpp"

namespace sarsim::gui {

namespace {

constexpr std::size_t max_marks = 500;
constexpr qsizetype max_at_once = 60'000;  // characters, which take some milliseconds
constexpr double smallest_size_pt = 5.0;
constexpr double largest_size_pt = 60.0;

// End of what begins at a byte of a line, in characters.
int end_of_piece(const QString& line, std::size_t column, const ScriptCoding& coding) {
  const std::size_t end = scene::language::piece_end(encoded(line, coding), column - 1);
  return position_of_column(line, end + 1, coding);
}

// The span of a line that a character is in; one of no length where there is none.
ScriptSpan span_at(const QString& line, int at) {
  for (const ScriptSpan& span : script_spans(line))
    if (span.at <= at && at < span.at + span.length) return span;
  return {at, 0};
}

QString paragraphs_of(const QString& lines) {
  if (lines.isEmpty()) return {};
  return "<p>" + lines.toHtmlEscaped().replace('\n', QStringLiteral("</p><p>")) + "</p>";
}

// Paints the line numbers; everything about them is known by the text.
class LineNumbers : public QWidget {
 public:
  explicit LineNumbers(ScriptText* text) : QWidget(text), text_(text) {
    setObjectName("script_line_numbers");
    setAccessibleName(ScriptText::tr("Line numbers"));
  }
  [[nodiscard]] QSize sizeHint() const override { return {text_->margin_width(), 0}; }

 protected:
  void paintEvent(QPaintEvent* event) override { text_->paint_margin(event); }
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }

 private:
  ScriptText* text_;
};

}  // namespace

ScriptText::ScriptText(QWidget* parent) : QPlainTextEdit(parent), margin_(new LineNumbers(this)) {
  setObjectName("script_text");
  setAccessibleName(tr("Script"));
  setAccessibleDescription(tr("Text of the script; typing changes the scene"));
  setLineWrapMode(NoWrap);
  setUndoRedoEnabled(false);
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setTabStopDistance(8.0 * fontMetrics().horizontalAdvance(u' '));
  first_size_pt_ = font().pointSizeF() > 0.0 ? font().pointSizeF() : 10.0;
  highlighter_ = std::make_unique<ScriptHighlighter>();
  completer_ = new ScriptCompleter(this);
  more_.setSingleShot(true);
  connect(&more_, &QTimer::timeout, this, [this] {
    if (!is_complete()) put_in_more();
  });
  connect(this, &QPlainTextEdit::blockCountChanged, this, &ScriptText::place_margin);
  connect(this, &QPlainTextEdit::updateRequest, this, &ScriptText::scroll_margin);
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &ScriptText::show_marks);
  refresh_colours();
  place_margin();
}

ScriptText::~ScriptText() = default;

QString ScriptText::script() const {
  // Not toPlainText, which turns blanks that do not break into ones that do.
  QString text = document()->toRawText();
  return text.replace(QChar::ParagraphSeparator, u'\n');
}

void ScriptText::set_script(const QString& text) {
  marks_.clear();
  waiting_.clear();
  clear();
  splice({{0, 0, text}});
  moveCursor(QTextCursor::Start);
  show_marks();
}

void ScriptText::splice(const std::vector<DecodedChange>& changes) {
  for (const DecodedChange& change : changes) {
    waiting_.push_back({change.at, change.removed, change.put_in.left(max_at_once)});
    for (qsizetype put = max_at_once; put < change.put_in.size(); put += max_at_once)
      waiting_.push_back({change.at + static_cast<int>(put), 0, change.put_in.mid(put, max_at_once)});
  }
  put_in_more();
}

// As much of what waits as keeps nobody waiting.
void ScriptText::put_in_more() {
  const int across = horizontalScrollBar()->value();
  QTextCursor top(firstVisibleBlock());
  QTextCursor edit(document());
  putting_in_ = true;
  edit.beginEditBlock();
  for (qsizetype put = 0; !waiting_.empty() && put < max_at_once; waiting_.pop_front()) {
    const DecodedChange& change = waiting_.front();
    edit.setPosition(change.at);
    edit.setPosition(change.at + change.removed, QTextCursor::KeepAnchor);
    edit.insertText(change.put_in);
    put += change.put_in.size();
  }
  edit.endEditBlock();
  putting_in_ = false;
  // The scroll bar counts lines: the line that was on top stays there.
  verticalScrollBar()->setValue(top.block().firstLineNumber());
  horizontalScrollBar()->setValue(across);
  if (isReadOnly() == is_complete()) setReadOnly(!is_complete());
  if (is_complete())
    emit completed();
  else
    more_.start();
}

void ScriptText::complete() {
  while (!is_complete()) put_in_more();
}

QTextCursor ScriptText::stretch_of(const core::Place& place, const ScriptCoding& coding) const {
  const QTextBlock block = document()->findBlockByNumber(static_cast<int>(place.line) - 1);
  if (!block.isValid()) return {};
  const QString line = block.text();
  int begin = position_of_column(line, place.column, coding);
  int end = static_cast<int>(line.size());
  if (place.column > 0 && is_format_2(*document()))
    end = end_of_piece(line, place.column, coding);
  else if (const ScriptSpan span = span_at(line, begin); place.column > 0 && span.length > 0)
    end = span.at + span.length;
  if (begin >= end) begin = 0;
  QTextCursor cursor(block);
  cursor.setPosition(block.position() + begin);
  cursor.setPosition(block.position() + end, QTextCursor::KeepAnchor);
  return cursor;
}

void ScriptText::underline(const std::vector<core::Problem>& problems, const ScriptCoding& coding) {
  marks_.clear();
  for (const core::Problem& problem : problems) {
    if (marks_.size() == max_marks) break;
    if (problem.place.line == 0) continue;
    Mark mark{stretch_of(problem.place, coding), problem_text(problem), problem.severity};
    if (!mark.where.isNull()) marks_.push_back(std::move(mark));
  }
  show_marks();
}

std::vector<std::pair<int, int>> ScriptText::underlined() const {
  std::vector<std::pair<int, int>> stretches;
  for (const Mark& mark : marks_) stretches.emplace_back(mark.where.selectionStart(), mark.where.selectionEnd());
  return stretches;
}

QString ScriptText::problem_at(int position) const {
  QStringList texts;
  for (const Mark& mark : marks_)
    if (position >= mark.where.selectionStart() && position <= mark.where.selectionEnd()) texts += mark.text;
  return texts.join('\n');
}

QString ScriptText::explanation_at(int position) const {
  std::optional<scene::language::Explanation> found;
  if (is_format_2(*document())) {
    if (const auto lines = object_lines(*document(), position))
      found = scene::language::explanation_at(lines->text, lines->offset);
  } else {
    const QTextBlock block = document()->findBlock(position);
    const ScriptSpan span = span_at(block.text(), position - block.position());
    if (span.length > 0 && span.part == ScriptPart::command)
      found = scene::language::explanation_of_command(block.text().mid(span.at + 1, span.length - 1).toStdString());
  }
  return found ? explanation_tip(*found) : QString();
}

// Words of problems and of what stands under the mouse.
QString ScriptText::tip_at(const QPoint& place) const {
  QTextCursor cursor = cursorForPosition(place);
  QString tip = paragraphs_of(problem_at(cursor.position()));
  const bool is_behind = cursorRect(cursor).left() > place.x();  // The cursor is at the nearer end of the character.
  if (is_behind) cursor.movePosition(QTextCursor::PreviousCharacter);
  if (!is_behind && cursor.atBlockEnd()) return tip;
  const QString explanation = explanation_at(cursor.position());
  if (!tip.isEmpty() && !explanation.isEmpty()) tip += QStringLiteral("<hr>");
  return tip + explanation;
}

void ScriptText::jump_to(const core::Place& place, const ScriptCoding& coding) {
  const QTextCursor stretch = stretch_of(place, coding);
  if (stretch.isNull()) return;
  QTextCursor cursor = textCursor();
  cursor.setPosition(stretch.selectionStart());
  setTextCursor(cursor);
  centerCursor();
  setFocus();
}

// The current line first, so that underlines are painted over it.
void ScriptText::show_marks() {
  QList<QTextEdit::ExtraSelection> selections;
  QTextEdit::ExtraSelection line;
  QColor tint = colour_of(picture::Role::selected, palette());
  tint.setAlphaF(is_dark(palette()) ? 0.18F : 0.09F);
  line.format.setBackground(tint);
  line.format.setProperty(QTextFormat::FullWidthSelection, true);
  line.cursor = textCursor();
  line.cursor.clearSelection();
  selections += line;
  for (auto mark = marks_.rbegin(); mark != marks_.rend(); ++mark) {
    QTextEdit::ExtraSelection selection;
    selection.cursor = mark->where;
    selection.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    const picture::Role role = mark->severity == core::Severity::error     ? picture::Role::error
                               : mark->severity == core::Severity::warning ? picture::Role::warning
                                                                           : picture::Role::curve;
    selection.format.setUnderlineColor(colour_of(role, palette()));
    selections += selection;
  }
  setExtraSelections(selections);
}

void ScriptText::zoom(int steps) {
  QFont scaled = font();
  const double now = scaled.pointSizeF() > 0.0 ? scaled.pointSizeF() : first_size_pt_;
  scaled.setPointSizeF(steps == 0 ? first_size_pt_ : std::clamp(now + steps, smallest_size_pt, largest_size_pt));
  setFont(scaled);
  setTabStopDistance(8.0 * fontMetrics().horizontalAdvance(u' '));
  place_margin();
}

int ScriptText::margin_width() const {
  const int digits = std::max(3, static_cast<int>(QString::number(std::max(1, blockCount())).size()));
  return fontMetrics().horizontalAdvance(u'9') * (digits + 1);
}

void ScriptText::paint_margin(QPaintEvent* event) {
  QPainter painter(margin_);
  painter.fillRect(event->rect(), palette().color(QPalette::AlternateBase));
  painter.setFont(font());
  const int current = textCursor().blockNumber();
  const int right = margin_->width() - fontMetrics().horizontalAdvance(u'9') / 2;
  QTextBlock block = firstVisibleBlock();
  double top = blockBoundingGeometry(block).translated(contentOffset()).top();
  while (block.isValid() && top <= event->rect().bottom()) {
    const double height = blockBoundingRect(block).height();
    if (block.isVisible() && top + height >= event->rect().top()) {
      const bool here = block.blockNumber() == current;
      painter.setPen(here ? palette().color(QPalette::Text) : colour_of(picture::Role::platform, palette()));
      painter.drawText(QRectF(0.0, top, right, fontMetrics().height()), Qt::AlignRight,
                       QString::number(block.blockNumber() + 1));
    }
    top += height;
    block = block.next();
  }
}

void ScriptText::place_margin() {
  setViewportMargins(margin_width(), 0, 0, 0);
  const QRect inner = contentsRect();
  margin_->setGeometry(inner.left(), inner.top(), margin_width(), inner.height());
  margin_->update();
}

void ScriptText::scroll_margin(const QRect& area, int dy) {
  if (dy != 0)
    margin_->scroll(0, dy);
  else
    margin_->update(0, area.y(), margin_->width(), area.height());
}

// Before lines are seen.
void ScriptText::paintEvent(QPaintEvent* event) {
  QTextBlock line = firstVisibleBlock();
  for (double top = contentOffset().y(); line.isValid() && top <= viewport()->height(); line = line.next()) {
    highlighter_->colour(line);
    top += blockBoundingRect(line).height();  // Lays it out where that is needed.
  }
  QPlainTextEdit::paintEvent(event);
}

void ScriptText::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  place_margin();
}

void ScriptText::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Undo)) return emit undo_wanted();
  if (event->matches(QKeySequence::Redo)) return emit redo_wanted();
  if (event->matches(QKeySequence::ZoomIn)) return zoom(1);
  if (event->matches(QKeySequence::ZoomOut)) return zoom(-1);
  if (event->modifiers() == Qt::ControlModifier && event->key() == Qt::Key_0) return zoom(0);
  if (completer_->take_key(*event)) return event->accept();
  QPlainTextEdit::keyPressEvent(event);
  completer_->follow_key(*event);
}

void ScriptText::wheelEvent(QWheelEvent* event) {
  if (!event->modifiers().testFlag(Qt::ControlModifier)) return QPlainTextEdit::wheelEvent(event);
  if (event->angleDelta().y() != 0) zoom(event->angleDelta().y() > 0 ? 1 : -1);
  event->accept();
}

void ScriptText::focusOutEvent(QFocusEvent* event) {
  QPlainTextEdit::focusOutEvent(event);
  completer_->hide();
  emit left();
}

void ScriptText::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) refresh_colours();
  if (event->type() == QEvent::FontChange && margin_ != nullptr) place_margin();
}

bool ScriptText::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QPlainTextEdit::viewportEvent(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString tip = tip_at(help->pos());
  if (tip.isEmpty())
    QToolTip::hideText();
  else
    QToolTip::showText(help->globalPos(), tip, viewport());
  return true;
}

void ScriptText::contextMenuEvent(QContextMenuEvent* event) {
  QMenu* menu = createStandardContextMenu(event->pos());
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const QList<QAction*> own = actions();
  if (!own.isEmpty()) menu->addSeparator();
  menu->addActions(own);
  menu->popup(event->globalPos());
}

void ScriptText::refresh_colours() {
  if (highlighter_ == nullptr) return;
  highlighter_->set_palette(palette());
  show_marks();
}

}  // namespace sarsim::gui
