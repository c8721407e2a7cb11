#include "gui/frame/document_keeper.hpp"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include <exception>
#include <utility>

#include "gui/common/text.hpp"
#include "scene/language/format_mark.hpp"

namespace sarsim::gui {

namespace {

constexpr int max_recent = 10;
constexpr int keep_after_ms = 2000;
constexpr int look_every_ms = 2000;

std::filesystem::path recovery_folder() {
  return std::filesystem::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) /
         "recovery";
}

QString name_of_document(const std::filesystem::path& path) {
  return path.empty() ? DocumentKeeper::tr("a new scene") : text_of(path);
}

}  // namespace

DocumentKeeper::DocumentKeeper(Session& session, QWidget* window)
    : QObject(window), session_(session), window_(window) {
  make_questions();
  keep_soon_.setSingleShot(true);
  keep_soon_.setInterval(keep_after_ms);
  connect(&keep_soon_, &QTimer::timeout, this, &DocumentKeeper::keep_copies);
  connect(&session_, &Session::scene_changed, this, &DocumentKeeper::guard_change);
  connect(&session_, &Session::document_changed, this, &DocumentKeeper::guard_change);
  connect(&session_, &Session::document_closed, this, [this](int number) {
    guard(number).copy.forget();
    guards_.erase(number);
  });
  look_.setInterval(look_every_ms);
  connect(&look_, &QTimer::timeout, this, &DocumentKeeper::look_at_disk);
  look_.start();
}

DocumentKeeper::~DocumentKeeper() = default;

DocumentKeeper::Guard& DocumentKeeper::guard(int number) {
  const auto found = guards_.find(number);
  if (found != guards_.end()) return found->second;
  const auto process = static_cast<long>(QCoreApplication::applicationPid());
  return guards_.emplace(number, Guard{{}, scene::Recovery(recovery_folder(), process, number), false, {}})
      .first->second;
}

// Whoever edits without a pause wants copies too.
void DocumentKeeper::guard_change() {
  Guard& own = guard(session_.number());
  own.copy_is_due = session_.document().changed();
  if (!own.copy_is_due)
    own.copy.forget();
  else if (!keep_soon_.isActive())
    keep_soon_.start();
}

// A new scene in which nothing was done gives way.
void DocumentKeeper::open_beside(scene::Document document) {
  const scene::Document& present = session_.document();
  const bool untouched = present.path().empty() && !present.changed() && !present.history().can_redo() &&
                         present.text() == scene::Document().text();
  untouched ? session_.take(std::move(document)) : session_.add(std::move(document));
}

std::optional<std::size_t> DocumentKeeper::place_of(const std::filesystem::path& path) const {
  for (std::size_t i = 0; i < session_.document_count(); ++i) {
    std::error_code none;
    const std::filesystem::path& open = session_.document_at(i).path();
    if (!open.empty() && (open == path || std::filesystem::equivalent(open, path, none))) return i;
  }
  return std::nullopt;
}

bool DocumentKeeper::make_new() {
  open_beside(scene::Document());
  return true;
}

bool DocumentKeeper::open() {
  const QString path = ask_open_name();
  return !path.isEmpty() && open_file(path);
}

bool DocumentKeeper::open_file(const QString& name) {
  // Copies for recovery outlive the folder that the program was started in.
  const QString path = QFileInfo(name).absoluteFilePath();
  if (const auto open = place_of(path.toStdString())) {
    session_.turn_to(*open);
    note_recent(path);
    return true;
  }
  auto document = read(path);
  if (!document) return false;
  open_beside(*std::move(document));
  note_recent(path);
  session_.log(core::Severity::note, tr("Opened %1").arg(path));
  return true;
}

std::optional<scene::Document> DocumentKeeper::read(const QString& path) {
  scene::Document document = scene::Document::open(path.toStdString());
  const core::Problems& problems = document.problems();
  // A scene in JSON becomes one that was never saved.
  if (!document.path().empty() || !core::has_errors(problems)) return document;
  tell(tr("'%1' could not be opened.").arg(path),
       problems.empty() ? tr("Not a script.") : QString::fromStdString(core::to_string(problems.front())));
  return std::nullopt;
}

bool DocumentKeeper::open_example(const QString& path) {
  const scene::Document example = scene::Document::open(path.toStdString());
  scene::Document copy = scene::Document::from_text(example.text());
  // What stands in files beside the example is not found from a copy.
  if (example.path().empty() || core::has_errors(copy.problems())) return open_file(path);
  open_beside(std::move(copy));
  if (core::has_errors(session_.document().problems())) {
    session_.close(session_.at_hand());
    return open_file(path);
  }
  guard(session_.number()).example = QFileInfo(path).fileName();
  emit session_.document_changed();
  session_.log(core::Severity::note, tr("Opened a copy of the example %1").arg(QFileInfo(path).fileName()));
  return true;
}

QString DocumentKeeper::shown_name(std::size_t index) const {
  const std::filesystem::path& path = session_.document_at(index).path();
  if (!path.empty()) return text_of(path);
  const auto known = guards_.find(session_.number_at(index));
  const QString example = known == guards_.end() ? QString() : known->second.example;
  return example.isEmpty() ? tr("New scene") : tr("%1 (copy of the example)").arg(example);
}

bool DocumentKeeper::begin_with(const scene::StartingScene& starting) {
  open_beside(scene::Document::from_text(std::string(starting.format_2)));
  session_.log(core::Severity::note, tr("A new scene: %1").arg(text_of(starting.meaning)));
  return true;
}

bool DocumentKeeper::save() {
  const auto& path = session_.document().path();
  return path.empty() ? save_as() : save_to(text_of(path));
}

bool DocumentKeeper::save_as() {
  QString path = ask_save_name();
  if (path.isEmpty()) return false;
  const QString usual = QString::fromStdString(scene::usual_ending(session_.document().text()));
  const QString ending = QFileInfo(path).suffix().toLower();
  if (ending.isEmpty()) path += "." + usual;
  const bool is_of_other = ending != usual && (ending == "toml" || ending == "scr");
  return (!is_of_other || ask_ending(path)) && save_to(path);
}

bool DocumentKeeper::save_to(const QString& name) {
  const QString path = QFileInfo(name).absoluteFilePath();
  const std::vector<scene::DataFileWrite> data = scene::data_to_write(session_.document(), path.toStdString());
  const DataAnswer answer = data.empty() ? DataAnswer::leave : ask_data(data);
  if (answer == DataAnswer::cancel) return false;
  try {
    // The data first: a script is never newer than what it speaks of.
    if (answer == DataAnswer::write) scene::write_data(data);
    session_.save(path.toStdString());
  } catch (const std::exception& error) {
    tell(tr("The scene was not saved."), QString::fromUtf8(error.what()));
    return false;
  }
  guard(session_.number()).copy.forget();
  note_recent(path);
  session_.log(core::Severity::note, tr("Saved %1").arg(path));
  if (answer == DataAnswer::write)
    for (const scene::DataFileWrite& file : data)
      session_.log(core::Severity::note, tr("Saved %1").arg(text_of(file.path)));
  return true;
}

// A file of data that was written, and then taken back, differs although the script is as it was saved.
bool DocumentKeeper::unsaved(std::size_t index) const {
  const scene::Document& document = session_.document_at(index);
  if (document.changed()) return true;
  return !document.pending_data().empty() && !scene::data_to_write(document, document.path()).empty();
}

bool DocumentKeeper::may_close() {
  if (!unsaved()) return true;
  switch (ask_unsaved()) {
    case Answer::save: return save();
    case Answer::discard: return true;
    case Answer::cancel: return false;
  }
  return false;
}

bool DocumentKeeper::may_close_all() {
  for (std::size_t i = 0; i < session_.document_count(); ++i) {
    if (!unsaved(i)) continue;
    session_.turn_to(i);
    if (!may_close()) return false;
  }
  return true;
}

bool DocumentKeeper::close() {
  if (!may_close()) return false;
  session_.close(session_.at_hand());
  return true;
}

QStringList DocumentKeeper::recent() const {
  QStringList there;
  for (const QString& path : QSettings().value("recent").toStringList())
    if (QFileInfo::exists(path)) there.append(path);
  return there;
}

void DocumentKeeper::note_recent(const QString& path) {
  const QString whole = QFileInfo(path).absoluteFilePath();
  QStringList paths = QSettings().value("recent").toStringList();
  paths.removeAll(whole);
  paths.prepend(whole);
  QSettings().setValue("recent", QStringList(paths.mid(0, max_recent)));
  emit recent_changed();
}

std::filesystem::path DocumentKeeper::examples_folder() {
  const QDir program(QCoreApplication::applicationDirPath());
  for (const char* place :
       {"../share/sarsim/examples", "../../../../examples", "../../../examples", "../../examples", "examples"})
    if (program.exists(place)) return program.cleanPath(program.absoluteFilePath(place)).toStdString();
  return {};
}

bool DocumentKeeper::keep_copies() {
  keep_soon_.stop();
  bool any = false;
  bool good = true;
  for (std::size_t i = 0; i < session_.document_count(); ++i) {
    const scene::Document& document = session_.document_at(i);
    any = any || document.changed();
    Guard& own = guard(session_.number_at(i));
    if (!own.copy_is_due) continue;
    try {
      own.copy.keep(document.path(), document.text());
      own.copy_is_due = false;
    } catch (const std::exception& error) {
      session_.log(core::Severity::warning,
                   tr("No copy for recovery could be kept: %1").arg(QString::fromUtf8(error.what())));
      good = false;
    }
  }
  return any && good;
}

void DocumentKeeper::offer_recovery() {
  std::optional<int> first;
  for (const scene::Recovery::Copy& copy : scene::Recovery::orphans(recovery_folder())) {
    const Answer answer = ask_recovery(copy.document);
    if (answer == Answer::cancel) break;
    if (answer == Answer::discard) {
      scene::Recovery::discard(copy);
      continue;
    }
    recover(copy);
    if (!first) first = session_.number();
  }
  for (std::size_t i = 0; first && i < session_.document_count(); ++i)
    if (session_.number_at(i) == *first) session_.turn_to(i);
}

// The copy goes only when this program has one of its own.
void DocumentKeeper::recover(const scene::Recovery::Copy& copy) {
  const auto open = copy.document.empty() ? std::nullopt : place_of(copy.document);
  if (open && !session_.document_at(*open).changed())
    session_.turn_to(*open);
  else
    open_beside(copy.document.empty() ? scene::Document() : scene::Document::open(copy.document));
  session_.type_text(copy.text);
  session_.end_run();
  if (session_.document().changed() && !keep_copies()) return;
  scene::Recovery::discard(copy);
  session_.log(core::Severity::note, tr("Recovered %1").arg(name_of_document(copy.document)));
}

void DocumentKeeper::end() {
  keep_soon_.stop();
  look_.stop();
  for (auto& [number, own] : guards_) own.copy.forget();
}

DocumentKeeper::Version DocumentKeeper::version_of(const std::filesystem::path& path) {
  std::error_code gone;
  Version version{path, std::filesystem::last_write_time(path, gone), std::filesystem::file_size(path, gone)};
  return gone ? Version{path, {}, 0} : version;
}

void DocumentKeeper::look_at_disk() {
  if (asking_ || session_.document().path().empty() || !window_->isVisible()) return;
  if (QApplication::activeModalWidget() != nullptr) return;
  // Taken before the file is read: what changes later has another one.
  Version version = version_of(session_.document().path());
  std::optional<Version>& seen = guard(session_.number()).seen;
  if (version == seen) return;
  seen = std::move(version);
  if (!session_.document().changed_on_disk()) return;
  asking_ = true;
  if (ask_read_again(session_.document().changed())) read_again();
  asking_ = false;
}

void DocumentKeeper::read_again() {
  const QString path = text_of(session_.document().path());
  auto document = read(path);
  if (!document) return;
  session_.take(*std::move(document));
  session_.log(core::Severity::note, tr("Opened %1").arg(path));
}

void DocumentKeeper::tell(const QString& what, const QString& why) {
  session_.log(core::Severity::error, what + " " + why);
  show_failure(what, why);
}

// --- The dialogs in which a document keeper asks.

namespace {

QString script_filter() { return DocumentKeeper::tr("Sarsim scenes (*.toml *.TOML *.scr *.SCR);;All files (*)"); }

}  // namespace

void DocumentKeeper::make_questions() {
  ask_unsaved = [this] {
    const QString name =
        session_.document().path().empty() ? tr("the new scene") : text_of(session_.document().path().filename());
    const auto button =
        QMessageBox::question(window_, tr("Unsaved changes"), tr("Save the changes to %1?").arg(name),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    return button == QMessageBox::Save      ? Answer::save
           : button == QMessageBox::Discard ? Answer::discard
                                            : Answer::cancel;
  };
  ask_open_name = [this] { return QFileDialog::getOpenFileName(window_, tr("Open"), QString(), script_filter()); };
  // The dialog adds the ending itself, so that it asks about the file that is really written.
  ask_save_name = [this] {
    const auto& path = session_.document().path();
    QFileDialog dialog(window_, tr("Save As"), QString(), script_filter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    const QString ending = QString::fromStdString(scene::usual_ending(session_.document().text()));
    dialog.setDefaultSuffix(ending);
    dialog.selectFile(path.empty() ? "scene." + ending : text_of(path));
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
  };
  ask_ending = [this](const QString& path) {
    const bool is_2 = scene::is_format_2(session_.document().text());
    QMessageBox box(QMessageBox::Question, tr("Save As"),
                    is_2 ? tr("Save a scene of format 2 as '%1'?").arg(path)
                         : tr("Save a scene in the language of 1998 as '%1'?").arg(path),
                    QMessageBox::Save | QMessageBox::Cancel, window_);
    box.setInformativeText(tr("The ending of the name does not change the language, which Sarsim tells by the content. "
                              "The usual ending of "
                              "this one is .%1; the command 'sarsim convert' writes the other one.")
                               .arg(QString::fromStdString(scene::usual_ending(session_.document().text()))));
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() == QMessageBox::Save;
  };
  ask_read_again = [this](bool unsaved) {
    const QString path = text_of(session_.document().path());
    return QMessageBox::question(
               window_, tr("File changed on disk"),
               unsaved
                   ? tr("'%1' was changed by another program. Read it again and lose the changes made here?").arg(path)
                   : tr("'%1' was changed by another program. Read it again?").arg(path),
               QMessageBox::Yes | QMessageBox::No, unsaved ? QMessageBox::No : QMessageBox::Yes) == QMessageBox::Yes;
  };
  ask_data = [this](const std::vector<scene::DataFileWrite>& files) { return data_question(files); };
  show_failure = [this](const QString& what, const QString& why) {
    QMessageBox box(QMessageBox::Warning, tr("Sarsim"), what, QMessageBox::Ok, window_);
    box.setInformativeText(why);
    box.exec();
  };
  ask_recovery = [this](const std::filesystem::path& document) {
    const QString name = document.empty() ? tr("a new scene") : text_of(document);
    QMessageBox box(QMessageBox::Question, tr("Recovery"),
                    tr("Sarsim closed unexpectedly. Restore the unsaved changes to %1?").arg(name),
                    QMessageBox::Yes | QMessageBox::No | QMessageBox::Cancel, window_);
    box.setInformativeText(
        tr("Restore opens the recovered scene, still unsaved. Discard deletes the changes. Ask Next Time keeps them "
           "until the next start."));
    box.button(QMessageBox::Yes)->setText(tr("&Restore"));
    box.button(QMessageBox::No)->setText(tr("&Discard"));
    box.button(QMessageBox::Cancel)->setText(tr("&Ask Next Time"));
    box.setDefaultButton(QMessageBox::Yes);
    const int button = box.exec();
    return button == QMessageBox::Yes ? Answer::save : button == QMessageBox::No ? Answer::discard : Answer::cancel;
  };
}

DocumentKeeper::DataAnswer DocumentKeeper::data_question(const std::vector<scene::DataFileWrite>& files) const {
  constexpr std::size_t max_shown = 8;
  QStringList lines;
  for (std::size_t i = 0; i < files.size() && i < max_shown; ++i)
    lines += (files[i].replaces ? tr("%1 (is replaced)") : tr("%1 (new)")).arg(text_of(files[i].path));
  if (files.size() > max_shown) lines += tr("and %1 more").arg(files.size() - max_shown);
  QMessageBox box(QMessageBox::Question, tr("Data files"),
                  tr("Data files of this scene are out of date. Write these files too?"), QMessageBox::Cancel, window_);
  box.setInformativeText(lines.join('\n'));
  QPushButton* write = box.addButton(tr("&Write them"), QMessageBox::AcceptRole);
  const QPushButton* leave = box.addButton(tr("&Only the script"), QMessageBox::DestructiveRole);
  box.setDefaultButton(write);
  box.exec();
  if (box.clickedButton() == write) return DataAnswer::write;
  return box.clickedButton() == leave ? DataAnswer::leave : DataAnswer::cancel;
}

}  // namespace sarsim::gui
