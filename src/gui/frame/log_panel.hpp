#pragma once

#include <QPlainTextEdit>

#include <map>

#include "gui/common/session.hpp"

namespace sarsim::gui {

class ProblemWatch;

/// What the workbench did and what went wrong, a line each with its time ("log_panel"); also what is wrong with the
/// script, each problem once, and once for each document how strong its echoes are.
class LogPanel : public QPlainTextEdit {
  Q_OBJECT

 public:
  /// @param watch  of the problems; it outlives the panel
  LogPanel(Session& session, const ProblemWatch& watch, QWidget* parent = nullptr);

 private:
  void add_line(const QString& text);
  void tell_problems(const core::Problems& problems);
  void tell_echoes(const QString& echoes);

  // What was told of a document.
  struct Told {
    std::map<QString, std::size_t> problems;  // how often, by their causes
    bool echoes = false;
  };

  const Session& session_;
  std::map<int, Told> told_;  // by the numbers of documents
};

}  // namespace sarsim::gui
