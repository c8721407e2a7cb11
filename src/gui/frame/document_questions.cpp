#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

#include "gui/common/text.hpp"
#include "gui/frame/document_keeper.hpp"
#include "scene/language/format_mark.hpp"

// The dialogs in which a document keeper asks.

namespace sarsim::gui {

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
    const QString name = document.empty() ? tr("a scene that was never saved") : text_of(document);
    QMessageBox box(QMessageBox::Question, tr("Recovery"),
                    tr("The program ended before the changes to %1 were saved. Take them up again?").arg(name),
                    QMessageBox::Yes | QMessageBox::No | QMessageBox::Cancel, window_);
    box.setInformativeText(
        tr("A copy of the scene with these changes was kept. It is opened as it was, with the changes "
           "unsaved; or deleted, and the changes with it; or kept, and asked about at the next start."));
    box.button(QMessageBox::Yes)->setText(tr("&Take Them Up"));
    box.button(QMessageBox::No)->setText(tr("&Delete the Copy"));
    box.button(QMessageBox::Cancel)->setText(tr("&Keep It for Later"));
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
                  tr("Data files of this scene do not hold its current functions. Write these files too?"),
                  QMessageBox::Cancel, window_);
  box.setInformativeText(lines.join('\n'));
  QPushButton* write = box.addButton(tr("&Write them"), QMessageBox::AcceptRole);
  const QPushButton* leave = box.addButton(tr("&Only the script"), QMessageBox::DestructiveRole);
  box.setDefaultButton(write);
  box.exec();
  if (box.clickedButton() == write) return DataAnswer::write;
  return box.clickedButton() == leave ? DataAnswer::leave : DataAnswer::cancel;
}

}  // namespace sarsim::gui
