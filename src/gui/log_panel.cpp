#include "gui/log_panel.hpp"

#include <QTime>

namespace sarsim {

LogPanel::LogPanel(Session& session, QWidget* parent) : QPlainTextEdit(parent) {
  setObjectName("log_panel");
  setAccessibleName(tr("Log"));
  setReadOnly(true);
  setMaximumBlockCount(10'000);
  connect(&session, &Session::logged, this, [this](int severity, const QString& text) {
    const QString word = severity == static_cast<int>(Severity::error)     ? tr("Error: ")
                         : severity == static_cast<int>(Severity::warning) ? tr("Warning: ")
                                                                           : QString();
    appendPlainText(QTime::currentTime().toString("HH:mm:ss ") + word + text);
  });
}

}  // namespace sarsim
