#pragma once

#include <QDialog>

class QLineEdit;
class QTextBrowser;
class QUrl;

namespace sarsim::gui {

/// The user guide ("help_window"): the pages of the documentation, with links between them.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent = nullptr);

  /// @param page     a file of the documentation's folder
  /// @param heading  of the section to begin with; empty, or one that is not there: the page's beginning
  void show_page(const QString& page, const QString& heading = QString());
  /// The heading of the section at the top of the window, or of the page; for tests and titles.
  [[nodiscard]] QString heading() const;
  /// Where the documentation is, or an empty text.
  [[nodiscard]] static QString folder();

 private:
  bool scroll_to(const QString& anchor);
  void follow(const QUrl& link);
  void find_next(bool from_here);

  QTextBrowser* browser_;
  QLineEdit* find_;
};

}  // namespace sarsim::gui
