#pragma once

#include <QWidget>

#include <filesystem>

#include "core/report/problem.hpp"

class QLabel;

namespace sarsim::gui {

/// What is wrong, in words: "Error: the pulse width is not above zero; found 0 s, expected more than 0 s". Severity is
/// told by the first word, so that neither colour nor icon is needed to understand it.
[[nodiscard]] QString problem_text(const core::Problem& problem);

/// True where a place is in a script itself, rather than in a file that it speaks of, or nowhere.
/// @param script  its file; may be empty
[[nodiscard]] bool stands_in(const core::Place& place, const std::filesystem::path& script);

/// The same with its place: "Line 47: Error: unknown command", with the name of any other file before it.
/// @param script  the file of the script; may be empty
[[nodiscard]] QString placed_problem_text(const core::Problem& problem, const std::filesystem::path& script);

/// "Error", "Warning" or "Note".
[[nodiscard]] QString severity_word(core::Severity severity);

/// The icon of a severity in the style of the desktop.
[[nodiscard]] QIcon severity_icon(core::Severity severity, const QWidget& widget);

/// A line below a field or panel that says what is wrong; takes no room where nothing is.
class ProblemLine : public QWidget {
  Q_OBJECT

 public:
  explicit ProblemLine(QWidget* parent = nullptr);

  /// Shows some texts below each other, with icon and colour of the severity.
  void show_texts(core::Severity severity, const QStringList& texts);
  /// Nothing is wrong: takes no room.
  void clear();
  /// What it says; empty where nothing is wrong.
  [[nodiscard]] QString text() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void colour_text();

  QLabel* icon_ = nullptr;
  QLabel* text_ = nullptr;
  core::Severity severity_ = core::Severity::error;
};

}  // namespace sarsim::gui
