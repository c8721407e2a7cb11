#include "gui/script/script_editor.hpp"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QListWidget>
#include <QSplitter>
#include <QTextBlock>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "gui/common/find_bar.hpp"
#include "gui/common/flow_layout.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/script/script_completer.hpp"
#include "gui/script/script_text.hpp"

namespace sarsim::gui {

namespace {

constexpr int pause_ms = 300;
constexpr int run_end_ms = 2000;
constexpr int problems_ms = 100;
constexpr std::size_t max_listed = 500;

// What stands between the common beginning and the common end of two texts.
DecodedChange difference_of(const QString& from, const QString& to) {
  const auto shorter = std::min(from.size(), to.size());
  qsizetype head = 0;
  while (head < shorter && from[head] == to[head]) ++head;
  if (head > 0 && head < shorter && from[head - 1].isHighSurrogate()) --head;
  qsizetype tail = 0;
  while (tail < shorter - head && from[from.size() - 1 - tail] == to[to.size() - 1 - tail]) ++tail;
  if (tail > 0 && from[from.size() - tail].isLowSurrogate()) --tail;
  return {static_cast<int>(head), static_cast<int>(from.size() - head - tail), to.mid(head, to.size() - head - tail)};
}

}  // namespace

QString shell_word(const QString& name) {
  return u'\'' + QString(name).replace(u'\'', QStringLiteral("'\\''")) + u'\'';
}

ScriptEditor::ScriptEditor(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      text_(new ScriptText(this)),
      find_bar_(new FindBar(text_, this)),
      problems_(new QListWidget(this)),
      position_(new QLabel(this)),
      state_(new QLabel(this)) {
  setObjectName("script_editor");
  setAccessibleName(tr("Script editor"));
  setFocusProxy(text_);
  problems_->setObjectName("script_problems");
  problems_->setAccessibleName(tr("Problems of the script"));
  problems_->setWordWrap(true);
  problems_->setUniformItemSizes(false);
  position_->setObjectName("script_position");
  state_->setObjectName("script_state");
  make_actions();
  lay_out();
  for (QTimer* timer : {&pause_, &run_end_, &problems_soon_}) timer->setSingleShot(true);
  pause_.setInterval(pause_ms);
  run_end_.setInterval(run_end_ms);
  problems_soon_.setInterval(problems_ms);
  connect_text();
  connect(&session_, &Session::scene_changed, this, &ScriptEditor::take_session_text);
  connect(&session_, &Session::document_replaced, this, &ScriptEditor::take_document);
  connect(&session_, &Session::document_changed, this,
          [this] { copy_command_->setEnabled(!session_.document().path().empty()); });
  take_document();
}

ScriptEditor::~ScriptEditor() { text_->disconnect(); }

void ScriptEditor::lay_out() {
  auto* tools = new FlowLayout;
  const int gap = fontMetrics().height() / 3;
  tools->setContentsMargins(gap, gap, gap, 0);
  for (QAction* action : {find_, copy_command_}) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setObjectName(action->objectName() + "_button");
    button->setAccessibleName(action->text());
    tools->addWidget(button);
  }
  tools->addWidget(state_);
  tools->addWidget(position_);
  auto* split = new QSplitter(Qt::Vertical, this);
  split->addWidget(text_);
  split->addWidget(problems_);
  split->setStretchFactor(0, 5);
  split->setStretchFactor(1, 1);
  split->setCollapsible(0, false);
  split->setMinimumHeight(6 * fontMetrics().height());  // The list of problems comes and goes without moving the scene.
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(tools);
  layout->addWidget(split, 1);
  layout->addWidget(find_bar_);
}

void ScriptEditor::connect_text() {
  connect(&pause_, &QTimer::timeout, this, &ScriptEditor::commit);
  connect(&run_end_, &QTimer::timeout, &session_, &Session::end_run);
  connect(&problems_soon_, &QTimer::timeout, this, &ScriptEditor::refresh_problems);
  connect(text_, &QPlainTextEdit::textChanged, this, &ScriptEditor::note_typing);
  connect(text_, &QPlainTextEdit::cursorPositionChanged, this, &ScriptEditor::show_position);
  connect(text_, &ScriptText::completed, this, [this] {
    problems_soon_.start();
    if (is_seen()) catch_up();
  });
  text_->installEventFilter(this);
  // Windows lose the keyboard while they are taken down: by then the session may be gone, and this connection with it.
  connect(text_, &ScriptText::left, &session_, [this] {
    commit();
    if (run_end_.isActive()) session_.end_run();
    run_end_.stop();
  });
  text_->completer().set_names([this]() -> const scene::language::KnownNames& { return names(); });
  connect(text_, &ScriptText::undo_wanted, this, [this] {
    commit();
    session_.undo();
  });
  connect(text_, &ScriptText::redo_wanted, this, [this] {
    commit();
    session_.redo();
  });
  connect(problems_, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { jump_to(places_[static_cast<std::size_t>(problems_->row(item))]); });
  connect(problems_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { jump_to(places_[static_cast<std::size_t>(problems_->row(item))]); });
}

void ScriptEditor::make_actions() {
  find_ = new QAction(tr("&Find …"), this);
  find_->setObjectName("script_find");
  find_->setShortcut(QKeySequence::Find);
  find_->setToolTip(tr("Search the script (Ctrl+F)"));
  copy_command_ = new QAction(tr("&Copy as command line"), this);
  copy_command_->setObjectName("script_copy_command");
  copy_command_->setToolTip(tr("Copies the command that runs this script without the workbench; save it first"));
  complete_ = new QAction(tr("Complete the &word"), this);
  complete_->setObjectName("script_complete");
  complete_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Space));
  complete_->setToolTip(tr("Lists completions at the cursor, in a script of format 2 (Ctrl+Space)"));
  auto* next = new QAction(tr("Find next"), this);
  next->setShortcut(QKeySequence(Qt::Key_F3));
  auto* previous = new QAction(tr("Find previous"), this);
  previous->setShortcut(QKeySequence(Qt::SHIFT | Qt::Key_F3));
  for (QAction* action : {find_, next, previous, copy_command_, complete_}) {
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(action);
  }
  text_->addActions({complete_, find_, copy_command_});
  connect(find_, &QAction::triggered, find_bar_, &FindBar::open);
  connect(next, &QAction::triggered, find_bar_, &FindBar::find_next);
  connect(previous, &QAction::triggered, find_bar_, &FindBar::find_previous);
  connect(complete_, &QAction::triggered, &text_->completer(), &ScriptCompleter::complete);
  connect(copy_command_, &QAction::triggered, this, &ScriptEditor::copy_command);
}

// Behind another panel it is not seen either, although Qt calls it visible.
bool ScriptEditor::is_seen() const { return isVisible() && !visibleRegion().isEmpty(); }

void ScriptEditor::take_document() {
  pause_.stop();
  names_.reset();
  run_end_.stop();
  of_echoes_.clear();
  agreed_ = true;
  stale_ = other_document_ = true;
  copy_command_->setEnabled(!session_.document().path().empty());
  if (is_seen())
    catch_up();
  else
    refresh_problems();
}

void ScriptEditor::show_document() {
  coding_ = coding_of(session_.document().text());
  shared_ = decoded(session_.document().text(), coding_);
  splicing_ = true;
  text_->set_script(shared_);
  splicing_ = false;
  refresh_problems();
  show_position();
}

bool ScriptEditor::event(QEvent* event) {
  if (event->type() == QEvent::Show) catch_up();
  if (event->type() == QEvent::Paint && stale_)
    QTimer::singleShot(0, this, [this] {
      if (is_seen()) catch_up();
    });
  return QWidget::event(event);
}

bool ScriptEditor::eventFilter(QObject* watched, QEvent* event) {
  if (watched == text_ && event->type() == QEvent::FocusIn) catch_up();
  return QWidget::eventFilter(watched, event);
}

// Puts in what it missed while nobody looked, or while a long text came in.
void ScriptEditor::catch_up() {
  if (!stale_ || (!other_document_ && !text_->is_complete())) return;
  stale_ = false;
  if (std::exchange(other_document_, false))
    show_document();
  else
    take_whole_text();
  revision_ = session_.document().revision();
  problems_soon_.start();
}

// Puts in what the session changed since the two last agreed.
void ScriptEditor::take_session_text() {
  names_.reset();
  if (stale_ || (!is_seen() && !pause_.isActive()) || !text_->is_complete()) {
    stale_ = true;
    return;
  }
  if (!take_last_changes()) take_whole_text();
  revision_ = session_.document().revision();
  problems_soon_.start();
}

// The usual case, a drag for instance: one step more than is shown, and nothing typed. Costs little in a long script.
bool ScriptEditor::take_last_changes() {
  const scene::Document& document = session_.document();
  if (!agreed_) return false;
  if (document.revision() == revision_) return true;
  if (document.revision() != revision_ + 1 || !document.last_edit()) return false;
  const auto& [edit, forwards] = *document.last_edit();
  const auto changes = decoded_changes(edit->script.changes, forwards, document.text(), coding_);
  if (!changes) return false;
  shared_ = changed_text(std::move(shared_), *changes);
  splicing_ = true;
  text_->splice(*changes);
  splicing_ = false;
  return true;
}

// What was typed meanwhile elsewhere in the text stays, and is given to the session in its turn; where both changed the
// same place the session's text counts.
void ScriptEditor::take_whole_text() {
  coding_ = coding_of(session_.document().text());
  QString now = decoded(session_.document().text(), coding_);
  if (now == shared_) return;
  const QString typed = text_->script();
  DecodedChange change = difference_of(shared_, now);
  bool still_typing = false;
  if (typed != shared_) {
    const DecodedChange own = difference_of(shared_, typed);
    const int grown = static_cast<int>(typed.size() - shared_.size());
    still_typing = own.at + own.removed <= change.at || change.at + change.removed <= own.at;
    if (!still_typing)
      change = difference_of(typed, now);
    else if (own.at + own.removed <= change.at)
      change.at += grown;
  }
  shared_ = std::move(now);
  splicing_ = true;
  text_->splice({change});
  splicing_ = false;
  agreed_ = !still_typing;
  if (still_typing)
    text_->complete();  // It is read before long.
  else
    pause_.stop();
}

void ScriptEditor::note_typing() {
  if (splicing_ || !text_->is_complete()) return;
  agreed_ = false;
  pause_.start();
}

void ScriptEditor::commit() {
  pause_.stop();
  if (agreed_ || stale_) return;
  QString typed = text_->script();
  agreed_ = typed == shared_;
  if (agreed_) return;
  shared_ = typed;
  names_.reset();
  session_.type_text(encoded(typed, coding_));  // Not to be taken back as a change made elsewhere: still not agreed.
  agreed_ = true;
  run_end_.start();
  refresh_problems();
}

core::Problems ScriptEditor::listed_problems() const {
  core::Problems found = session_.problems();
  if (of_echoes_.empty() || core::has_errors(found)) return found;
  core::append(found, of_echoes_);
  return core::ranked(std::move(found));
}

const scene::language::KnownNames& ScriptEditor::names() {
  if (names_) return *names_;
  names_ = scene::language::known_names(session_.scene(), session_.document().text());
  if (const scene::LetNames* const let = session_.document().let_names())
    for (const std::string_view name : let->all())  // Those of included files.
      if (std::ranges::find(names_->let, name, &scene::language::LetText::name) == names_->let.end())
        names_->let.push_back({std::string(name), {}});
  return *names_;
}

void ScriptEditor::refresh_problems() {
  problems_soon_.stop();
  const core::Problems found = listed_problems();
  const std::filesystem::path& script = session_.document().path();
  places_.clear();
  problems_->clear();
  std::vector<core::Problem> here;
  for (const core::Problem& problem : found) {
    const bool ours = stands_in(problem.place, script);
    if (ours) here.push_back(problem);
    if (places_.size() == max_listed) continue;
    const QString text = placed_problem_text(problem, script);
    auto* item = new QListWidgetItem(severity_icon(problem.severity, *this), text, problems_);
    item->setToolTip("<p>" + text.toHtmlEscaped() + "</p>");
    places_.push_back(ours ? problem.place : core::Place{});
  }
  if (found.size() > max_listed) {
    problems_->addItem(tr("and %1 more").arg(found.size() - max_listed));
    places_.emplace_back();
  }
  problems_->setVisible(!found.empty());
  // Between two pauses the places are those of the text before the last keys.
  if (!pause_.isActive() && !stale_) text_->underline(here, coding_);
  state_->setText(!text_->is_complete()               ? tr("Loading script; editing starts when it is complete.")
                  : session_.document().text_broken() ? tr("Scene not updated: the script has errors.")
                                                      : QString());
}

void ScriptEditor::jump_to(const core::Place& place) {
  text_->complete();
  catch_up();
  text_->complete();
  text_->jump_to(place, coding_);
}

void ScriptEditor::show_problem(const core::Place& place) {
  text_->setFocus();
  if (stands_in(place, session_.document().path())) jump_to(place);
}

void ScriptEditor::list_also(core::Problems of_echoes) {
  of_echoes_ = std::move(of_echoes);
  problems_soon_.start();
}

void ScriptEditor::show_position() {
  const QTextCursor cursor = text_->textCursor();
  position_->setText(tr("Line %1, column %2").arg(cursor.blockNumber() + 1).arg(cursor.positionInBlock() + 1));
}

QString ScriptEditor::command_line() const {
  const std::filesystem::path& path = session_.document().path();
  if (path.empty()) return {};
  return "sarsim run " + shell_word(QString::fromStdString(path.string()));
}

void ScriptEditor::copy_command() {
  commit();
  const QString command = command_line();
  if (command.isEmpty()) return;
  QApplication::clipboard()->setText(command);
  if (session_.document().changed())
    session_.log(core::Severity::note, tr("Copied '%1'; it runs the script as it was saved last.").arg(command));
  else
    session_.log(core::Severity::note, tr("Copied '%1'.").arg(command));
}

}  // namespace sarsim::gui
