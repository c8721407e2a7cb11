#pragma once

#include <QDialog>

class QTextBrowser;

namespace sarsim {

/// The user guide ("help_window"): the pages of the documentation, with links between them.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent = nullptr);

  /// @param page  a file of the documentation's folder
  void show_page(const QString& page);
  /// Where the documentation is, or an empty text.
  [[nodiscard]] static QString folder();

 private:
  void lay_out_tables();

  QTextBrowser* browser_;
};

}  // namespace sarsim
