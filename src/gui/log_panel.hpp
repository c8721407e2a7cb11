#pragma once

#include <QPlainTextEdit>

#include "gui/session.hpp"

namespace sarsim {

/// What the workbench did and what went wrong, a line each with its time ("log_panel").
class LogPanel : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit LogPanel(Session& session, QWidget* parent = nullptr);
};

}  // namespace sarsim
