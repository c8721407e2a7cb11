#pragma once

#include <QProcess>
#include <QWidget>

#include <filesystem>
#include <memory>

#include "gui/common/session.hpp"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QTemporaryDir;

namespace sarsim::gui {

class ImageViewers;
class ProblemLine;

/// Makes images and profiles from the echoes of the scene (focused image, range profiles, turning target, range-Doppler
/// maps, PPI) and opens them in the image viewer. The work is done by the command that a script of the user's would
/// call, which is shown, so that it can be repeated without a window.
class ProductWindow : public QWidget {
  Q_OBJECT

 public:
  /// @param viewers  open what was made; must live longer
  ProductWindow(Session& session, ImageViewers& viewers, QWidget* owner);
  ~ProductWindow() override;

  [[nodiscard]] bool busy() const { return process_.state() != QProcess::NotRunning; }
  /// The command as a user would type it.
  [[nodiscard]] QString command() const;
  /// Begins; the scene is taken as it is now.
  void make();
  /// Ends the command, which leaves nothing behind.
  void stop();

 signals:
  /// @param made  false where it failed or was stopped
  void ended(bool made);

 private:
  void make_controls(QFormLayout* form);
  void make_foot();
  void show_simulations();
  void show_choices();
  void show_command();
  void take_errors();
  void take_end(int status, QProcess::ExitStatus how);
  void fail(const QStringList& words);
  [[nodiscard]] QStringList arguments(const QString& script, const QString& out) const;

  Session& session_;
  ImageViewers& viewers_;
  QProcess process_;
  std::shared_ptr<QTemporaryDir> folder_;  // of the scene and its product, as long as a viewer looks at it
  QString made_;
  QString errors_;
  bool stopped_ = false;
  QComboBox* product_ = nullptr;
  QComboBox* simulation_ = nullptr;
  QLabel* choice_title_ = nullptr;
  QComboBox* choice_ = nullptr;
  QComboBox* weighting_ = nullptr;
  QLineEdit* more_ = nullptr;
  QLineEdit* command_ = nullptr;
  QLabel* state_ = nullptr;
  QPlainTextEdit* report_ = nullptr;
  ProblemLine* problems_ = nullptr;
  QPushButton* make_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace sarsim::gui
