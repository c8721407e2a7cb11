#pragma once

#include <QString>

#include "gui/common/background_job.hpp"

namespace sarsim::gui {

/// How work ended that was waited for.
struct Waited {
  JobEnd end = JobEnd::cancelled;  ///< Cancelled: it was given up.
  QString failure;                 ///< Words about its failure, where it failed.
};

/// Runs work on a thread of its own and waits for it: windows are painted, but take no keys and clicks. Work that takes
/// longer than a moment is shown in a dialog, with how far it is, the time left and a way out. Work that is given up is
/// asked to stop and not waited for, so it must hold on to all that it needs.
/// @param what  for the dialog: "Fill RCS"
[[nodiscard]] Waited run_and_wait(const QString& what, BackgroundJob::Work work);

}  // namespace sarsim::gui
