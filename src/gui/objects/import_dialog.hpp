#pragma once

#include <QDialog>

#include <memory>
#include <string>

#include "gui/common/latest_only_work.hpp"
#include "gui/common/session.hpp"
#include "scene/edit/import_targets.hpp"

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;

namespace sarsim::gui {

/// Reads targets from a text or CSV file of x, y, z and perhaps RCS (thesis: Import DEM): shows the first lines, the
/// lines that cannot be read, and adds the others to a platform in one undo step.
class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ImportDialog(Session& session, QWidget* parent = nullptr);
  ~ImportDialog() override;

  /// Reads this file.
  void set_file(const QString& path);
  /// The targets go onto this platform.
  void set_platform(const std::string& platform);
  void accept() override;

 private:
  struct Table;

  void make_widgets();
  void browse();
  void read_file();
  void show_table();
  static void read_into(Table& table, const std::string& platform, const scene::World& world,
                        const core::StopFlag& stop, const BackgroundJob::Report& report);

  Session& session_;
  LatestOnlyWork reading_;
  std::shared_ptr<Table> wanted_;  // what is chosen, while it is read
  std::shared_ptr<Table> read_;    // null: is not read yet
  QLineEdit* file_ = nullptr;
  QComboBox* platform_ = nullptr;
  QPlainTextEdit* preview_ = nullptr;
  QLabel* summary_ = nullptr;
  QListWidget* bad_lines_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

/// Text of bytes in UTF-8, or in UTF-16 with a byte order mark as spreadsheets write it.
[[nodiscard]] QString text_of_bytes(const QByteArray& bytes);

}  // namespace sarsim::gui
