#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QLineEdit;
class QListWidget;

namespace sarsim::gui {

/// Something that the search box finds, and what is done when it is chosen.
struct SearchEntry {
  /// What it is; of entries that match equally well, commands stand first, then fields.
  enum class Kind { command, field, help };
  Kind kind = Kind::command;
  QString words;   ///< What is matched: "Geometry: New Radar", "Radar: Pulse width".
  QString detail;  ///< At the right: keys, a value, a page.
  QString tip;
  std::function<void()> work;
  QStringList also = {};  ///< Synonyms: an entry with a synonym that begins with the typed text comes first.
};

/// One box over commands, fields of the scene and pages of the guide, found by a few letters ("search_box"). Up and
/// Down choose, Enter does it, Escape leaves.
class SearchBox : public QDialog {
  Q_OBJECT

 public:
  /// @param entries  in the order in which equals are listed within their kind
  explicit SearchBox(std::vector<SearchEntry> entries, QWidget* parent = nullptr);

  void accept() override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void search();

  std::vector<SearchEntry> entries_;
  std::vector<std::string> texts_;  // what is matched, one for each entry
  QLineEdit* field_ = nullptr;
  QListWidget* list_ = nullptr;
};

}  // namespace sarsim::gui
