#pragma once

#include <QWidget>

class QCheckBox;
class QPushButton;
class QVBoxLayout;

namespace sarsim::gui {

class CardList;

/// What a new user sees over an empty scene ("welcome_page"): where to begin, scenes to begin with, the examples as
/// pictures, recent files. It lies over another widget and takes its size. It only says what is wanted.
class WelcomePage : public QWidget {
  Q_OBJECT

 public:
  /// @param over  the widget that it covers, its parent
  explicit WelcomePage(QWidget* over);

  /// Shows these files, the newest first.
  void set_recent(const QStringList& paths);
  /// Whether it is wanted at the start of the program, as the user left it.
  [[nodiscard]] static bool wanted_at_start();
  /// Reads and shrinks the pictures that are not there yet, one each time the window has nothing else to do.
  void load_pictures();

 signals:
  void example_wanted(const QString& file_name);  ///< "sar_r.toml", in the folder of examples.
  void template_wanted(int index);                ///< Of scene::starting_scenes().
  void file_wanted(const QString& path);          ///< A recent one.
  void open_wanted();                             ///< Another file is to be asked for.
  void tour_wanted();                             ///< The first example of the thesis, step by step.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* make_head();
  QWidget* make_templates();
  QWidget* make_examples();

  CardList* examples_ = nullptr;
  QPushButton* first_ = nullptr;
  QWidget* recent_box_ = nullptr;
  QVBoxLayout* recent_ = nullptr;
  int pictures_ = 0;  // how many examples have theirs
};

}  // namespace sarsim::gui
