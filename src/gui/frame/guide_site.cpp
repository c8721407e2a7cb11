#include "gui/frame/guide_site.hpp"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFile>

#include "gui/frame/help_key.hpp"

namespace sarsim::gui {

QString anchor_of(const QString& heading) {
  QString anchor;
  for (const QChar c : heading.toLower())
    if (c.isLetterOrNumber() || c == '-' || c == '_')
      anchor += c;
    else if (c == ' ')
      anchor += '-';
  return anchor;
}

GuideSite::GuideSite() : GuideSite(folder_beside(QCoreApplication::applicationDirPath()), QDesktopServices::openUrl) {}

GuideSite::GuideSite(QString folder, Opener opener) : folder_(std::move(folder)), opener_(std::move(opener)) {}

QString GuideSite::folder_beside(const QString& program_folder) {
  const QDir program(program_folder);
  for (const char* place : {"../share/doc/sarsim/html", "../site"})
    if (program.exists(QString(place) + "/index.html")) return QDir::cleanPath(program.absoluteFilePath(place));
  return {};
}

QUrl GuideSite::address_of(const HelpPlace& place) const {
  if (folder_.isEmpty()) return {};
  const QString stem = place.page.endsWith(".md") ? place.page.chopped(3) : place.page;
  const QString file = folder_ + "/" + (stem == "README" ? QStringLiteral("index") : stem) + ".html";
  if (!QFile::exists(file)) return {};
  QUrl address = QUrl::fromLocalFile(file);
  if (!place.heading.isEmpty()) address.setFragment(anchor_of(place.heading));
  return address;
}

bool GuideSite::open(const HelpPlace& place) const {
  const QUrl address = address_of(place);
  return !address.isEmpty() && opener_(address);
}

}  // namespace sarsim::gui
