#include "gui/frame/document_keeper.hpp"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>

#include <exception>
#include <utility>

#include "gui/common/text.hpp"
#include "scene/language/format_mark.hpp"

namespace sarsim::gui {

namespace {

constexpr int most_recent = 10;
constexpr int keep_after_ms = 2000;
constexpr int look_every_ms = 2000;

std::filesystem::path recovery_folder() {
  return std::filesystem::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) /
         "recovery";
}

QString name_of_document(const std::filesystem::path& path) {
  return path.empty() ? DocumentKeeper::tr("a scene that was never saved") : text_of(path);
}

}  // namespace

DocumentKeeper::DocumentKeeper(Session& session, QWidget* window)
    : QObject(window),
      session_(session),
      window_(window),
      recovery_(recovery_folder(), static_cast<long>(QCoreApplication::applicationPid())) {
  make_questions();
  keep_soon_.setSingleShot(true);
  keep_soon_.setInterval(keep_after_ms);
  connect(&keep_soon_, &QTimer::timeout, this, &DocumentKeeper::keep_copy);
  const auto keep = [this] {
    if (!session_.document().changed())
      recovery_.forget();
    else if (!keep_soon_.isActive())  // whoever edits without a pause wants copies too
      keep_soon_.start();
  };
  connect(&session_, &Session::scene_changed, this, keep);
  connect(&session_, &Session::document_changed, this, keep);
  connect(&session_, &Session::document_replaced, this, [this] { example_.clear(); });
  look_.setInterval(look_every_ms);
  connect(&look_, &QTimer::timeout, this, &DocumentKeeper::look_at_disk);
  look_.start();
}

DocumentKeeper::~DocumentKeeper() = default;

bool DocumentKeeper::make_new() {
  if (!may_close()) return false;
  session_.take(scene::Document());
  return true;
}

bool DocumentKeeper::open() {
  if (!may_close()) return false;
  const QString path = ask_open_name();
  return !path.isEmpty() && open_file(path);
}

bool DocumentKeeper::open_file(const QString& name) {
  // Copies for recovery outlive the folder that the program was started in.
  const QString path = QFileInfo(name).absoluteFilePath();
  scene::Document document = scene::Document::open(path.toStdString());
  if (document.path().empty()) {
    const core::Problems& problems = document.problems();
    tell(tr("'%1' could not be opened.").arg(path),
         problems.empty() ? tr("Not a script.") : QString::fromStdString(core::to_string(problems.front())));
    return false;
  }
  session_.take(std::move(document));
  note_recent(path);
  session_.log(core::Severity::note, tr("Opened %1").arg(path));
  return true;
}

bool DocumentKeeper::open_example(const QString& path) {
  const scene::Document example = scene::Document::open(path.toStdString());
  scene::Document copy = scene::Document::from_text(example.text());
  // What stands in files beside the example is not found from a copy.
  if (example.path().empty() || core::has_errors(copy.problems())) return open_file(path);
  session_.take(std::move(copy));
  if (core::has_errors(session_.document().problems())) return open_file(path);
  example_ = QFileInfo(path).fileName();
  emit session_.document_changed();
  session_.log(core::Severity::note, tr("Opened a copy of the example %1").arg(QFileInfo(path).fileName()));
  return true;
}

QString DocumentKeeper::shown_name() const {
  const std::filesystem::path& path = session_.document().path();
  if (!path.empty()) return text_of(path);
  return example_.isEmpty() ? tr("New scene") : tr("%1 (copy of the example)").arg(example_);
}

bool DocumentKeeper::begin_with(const scene::StartingScene& starting) {
  session_.take(scene::Document::from_text(std::string(starting.format_2)));
  example_.clear();
  emit session_.document_changed();
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
  recovery_.forget();
  note_recent(path);
  session_.log(core::Severity::note, tr("Saved %1").arg(path));
  if (answer == DataAnswer::write)
    for (const scene::DataFileWrite& file : data)
      session_.log(core::Severity::note, tr("Saved %1").arg(text_of(file.path)));
  return true;
}

// A file of data that was written, and then taken back, differs although the script is as it was saved.
bool DocumentKeeper::unsaved() const {
  const scene::Document& document = session_.document();
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
  for (const char* place :
       {"../share/sarsim/examples", "../../../../examples", "../../../examples", "../../examples", "examples"})
    if (program.exists(place)) return program.cleanPath(program.absoluteFilePath(place)).toStdString();
  return {};
}

bool DocumentKeeper::keep_copy() {
  keep_soon_.stop();
  if (!session_.document().changed()) return false;
  try {
    recovery_.keep(session_.document().path(), session_.document().text());
  } catch (const std::exception& error) {
    session_.log(core::Severity::warning,
                 tr("No copy for recovery could be kept: %1").arg(QString::fromUtf8(error.what())));
    return false;
  }
  return true;
}

void DocumentKeeper::offer_recovery() {
  const std::vector<scene::Recovery::Copy> copies = scene::Recovery::orphans(recovery_folder());
  for (std::size_t i = 0; i < copies.size(); ++i) {
    const Answer answer = ask_recovery(copies[i].document);
    if (answer == Answer::cancel) return;
    if (answer == Answer::discard) {
      scene::Recovery::discard(copies[i]);
      continue;
    }
    recover(copies[i]);
    if (const auto others = static_cast<int>(copies.size() - i) - 1; others > 0)
      session_.log(core::Severity::note, tr("%n more scene(s) can be recovered at the next start", nullptr, others));
    return;
  }
}

// The copy goes only when this program has one of its own.
void DocumentKeeper::recover(const scene::Recovery::Copy& copy) {
  session_.take(copy.document.empty() ? scene::Document() : scene::Document::open(copy.document));
  session_.type_text(copy.text);
  session_.end_run();
  if (session_.document().changed() && !keep_copy()) return;
  scene::Recovery::discard(copy);
  session_.log(core::Severity::note, tr("Recovered %1").arg(name_of_document(copy.document)));
}

void DocumentKeeper::close() {
  keep_soon_.stop();
  look_.stop();
  recovery_.forget();
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
  if (version == seen_) return;
  seen_ = std::move(version);
  if (!session_.document().changed_on_disk()) return;
  asking_ = true;
  const QString path = text_of(session_.document().path());
  if (ask_read_again(session_.document().changed())) open_file(path);
  asking_ = false;
}

void DocumentKeeper::tell(const QString& what, const QString& why) {
  session_.log(core::Severity::error, what + " " + why);
  show_failure(what, why);
}

}  // namespace sarsim::gui
