#pragma once

#include <QString>

#include <vector>

namespace sarsim::gui {

/// A heading of the guide.
struct HelpHeading {
  QString page;     ///< A file of the documentation's folder: "guide/workbench.md".
  QString title;    ///< That of the page: "The workbench".
  QString heading;  ///< Empty: the page itself.
};

/// The pages of the guide, of formats and of theory, each followed by its headings down to the third level. Nothing for
/// a folder without pages.
/// @param folder  of the documentation
[[nodiscard]] std::vector<HelpHeading> help_headings(const QString& folder);

}  // namespace sarsim::gui
