#pragma once

#include <QApplication>
#include <QStandardPaths>

#include <ctime>

namespace sarsim::bench {

/// Processor time of the calling thread [ms]: how long the window is busy.
inline double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Prepares windows that need no display and keep no settings of a user; before the application is made.
inline void keep_apart() {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QStandardPaths::setTestModeEnabled(true);
  QCoreApplication::setOrganizationName("Sarsim test");
  QCoreApplication::setApplicationName("bench");
}

}  // namespace sarsim::bench
