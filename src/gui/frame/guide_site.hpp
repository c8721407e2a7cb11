#pragma once

#include <QString>
#include <QUrl>

#include <functional>

namespace sarsim::gui {

struct HelpPlace;

/// What forges and the site call a heading in links: "Mouse and keys: a list" is "mouse-and-keys-a-list".
[[nodiscard]] QString anchor_of(const QString& heading);

/// The user guide as pages for a browser, which tools/site makes of docs/.
class GuideSite {
 public:
  /// Shows an address; false where that is not possible.
  using Opener = std::function<bool(const QUrl&)>;

  /// The site beside the program, shown by the desktop's browser.
  GuideSite();
  /// @param folder  of the site; empty where there is none
  GuideSite(QString folder, Opener opener);

  /// Where the site is: installed (share/doc/sarsim/html) or built (site), relative to the folder of the program. Empty
  /// where it is in neither place.
  [[nodiscard]] static QString folder_beside(const QString& program_folder);
  /// The address of a place in the guide; empty where there is no site or the site has no such page.
  [[nodiscard]] QUrl address_of(const HelpPlace& place) const;
  /// Shows the place; false where it has no address or could not be shown.
  [[nodiscard]] bool open(const HelpPlace& place) const;

 private:
  QString folder_;
  Opener opener_;
};

}  // namespace sarsim::gui
