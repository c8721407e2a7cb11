#include "gui/document_keeper.hpp"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>

#include <exception>

namespace sarsim {

namespace {

constexpr int most_recent = 10;
constexpr int keep_after_ms = 2000;
constexpr int look_every_ms = 2000;

std::filesystem::path recovery_folder() {
  return std::filesystem::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) /
         "recovery";
}

QString text_of(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

}  // namespace

DocumentKeeper::DocumentKeeper(Session& session, QWidget* window)
    : QObject(window),
      session_(session),
      window_(window),
      recovery_(recovery_folder(), static_cast<long>(QCoreApplication::applicationPid())) {
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
  const QString filter = tr("Sarsim scripts (*.scr *.SCR);;All files (*)");
  ask_open_name = [this, filter] { return QFileDialog::getOpenFileName(window_, tr("Open"), QString(), filter); };
  ask_save_name = [this, filter] {
    const auto& path = session_.document().path();
    return QFileDialog::getSaveFileName(window_, tr("Save As"), path.empty() ? "scene.scr" : text_of(path), filter);
  };
  keep_soon_.setSingleShot(true);
  keep_soon_.setInterval(keep_after_ms);
  connect(&keep_soon_, &QTimer::timeout, this, &DocumentKeeper::keep_copy);
  connect(&session_, &Session::document_changed, this, [this] {
    if (session_.document().changed())
      keep_soon_.start();
    else
      recovery_.forget();
  });
  look_.setInterval(look_every_ms);
  connect(&look_, &QTimer::timeout, this, &DocumentKeeper::look_at_disk);
  look_.start();
}

DocumentKeeper::~DocumentKeeper() = default;

bool DocumentKeeper::make_new() {
  if (!may_close()) return false;
  session_.take(Document());
  return true;
}

bool DocumentKeeper::open() {
  if (!may_close()) return false;
  const QString path = ask_open_name();
  return !path.isEmpty() && open_file(path);
}

bool DocumentKeeper::open_file(const QString& path) {
  Document document = Document::open(path.toStdString());
  if (document.path().empty()) {
    const Problems& problems = document.problems();
    tell(tr("'%1' could not be opened.").arg(path),
         problems.empty() ? tr("It is no script.") : QString::fromStdString(to_string(problems.front())));
    return false;
  }
  session_.take(std::move(document));
  note_recent(path);
  session_.log(Severity::note, tr("Opened %1").arg(path));
  return true;
}

bool DocumentKeeper::save() {
  const auto& path = session_.document().path();
  return path.empty() ? save_as() : save_to(text_of(path));
}

bool DocumentKeeper::save_as() {
  QString path = ask_save_name();
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) path += ".scr";
  return save_to(path);
}

bool DocumentKeeper::save_to(const QString& path) {
  try {
    session_.save(path.toStdString());
  } catch (const std::exception& error) {
    tell(tr("The scene was not saved."), QString::fromUtf8(error.what()));
    return false;
  }
  recovery_.forget();
  note_recent(path);
  session_.log(Severity::note, tr("Saved %1").arg(path));
  return true;
}

bool DocumentKeeper::may_close() {
  if (!session_.document().changed()) return true;
  switch (ask_unsaved()) {
    case Answer::save: return save();
    case Answer::discard: return true;
    case Answer::cancel: return false;
  }
  return false;
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
  QSettings().setValue("recent", QStringList(paths.mid(0, most_recent)));
  emit recent_changed();
}

std::filesystem::path DocumentKeeper::examples_folder() {
  const QDir program(QCoreApplication::applicationDirPath());
  for (const char* place : {"../share/sarsim/examples", "../../../examples", "../../examples", "examples"})
    if (program.exists(place)) return program.cleanPath(program.absoluteFilePath(place)).toStdString();
  return {};
}

void DocumentKeeper::keep_copy() {
  if (!session_.document().changed()) return;
  try {
    recovery_.keep(session_.document().path(), session_.document().text());
  } catch (const std::exception& error) {
    session_.log(Severity::warning, tr("No copy for recovery could be kept: %1").arg(QString::fromUtf8(error.what())));
  }
}

void DocumentKeeper::offer_recovery() {
  for (const Recovery::Copy& copy : Recovery::orphans(recovery_folder())) {
    const QString name = copy.document.empty() ? tr("a scene that was never saved") : text_of(copy.document);
    const auto button = QMessageBox::question(
        window_, tr("Recovery"),
        tr("The program ended before the changes to %1 were saved. Take them up again?").arg(name),
        QMessageBox::Yes | QMessageBox::No | QMessageBox::Cancel, QMessageBox::Yes);
    if (button == QMessageBox::Cancel) return;
    if (button == QMessageBox::No) {
      Recovery::discard(copy);
      continue;
    }
    Document document = copy.document.empty() ? Document() : Document::open(copy.document);
    session_.take(std::move(document));
    session_.type_text(copy.text);
    session_.end_run();
    Recovery::discard(copy);
    keep_copy();
    session_.log(Severity::note, tr("Recovered %1").arg(name));
    return;
  }
}

void DocumentKeeper::close() {
  keep_soon_.stop();
  look_.stop();
  recovery_.forget();
}

void DocumentKeeper::look_at_disk() {
  if (asking_ || session_.document().path().empty() || !window_->isVisible()) return;
  if (QApplication::activeModalWidget() != nullptr || !session_.document().changed_on_disk()) return;
  asking_ = true;
  const QString path = text_of(session_.document().path());
  const bool unsaved = session_.document().changed();
  const auto button = QMessageBox::question(
      window_, tr("File changed on disk"),
      unsaved ? tr("'%1' was changed by another program. Read it again and lose the changes made here?").arg(path)
              : tr("'%1' was changed by another program. Read it again?").arg(path),
      QMessageBox::Yes | QMessageBox::No, unsaved ? QMessageBox::No : QMessageBox::Yes);
  if (button == QMessageBox::Yes)
    open_file(path);
  else
    look_.stop();
  asking_ = false;
}

void DocumentKeeper::tell(const QString& what, const QString& why) {
  session_.log(Severity::error, what + " " + why);
  QMessageBox box(QMessageBox::Warning, tr("Sarsim"), what, QMessageBox::Ok, window_);
  box.setInformativeText(why);
  box.exec();
}

}  // namespace sarsim
