#pragma once

#include <optional>
#include <string>

#include "cli/shell/context.hpp"
#include "cli/shell/progress_display.hpp"
#include "core/task/observer.hpp"

namespace sarsim::cli {

/// What a person at a terminal sees of a workflow: one progress display at a time, problems and announcements on
/// standard error. Quiet, it shows nothing.
class Watch {
 public:
  /// @param streams  must outlive this object
  Watch(Streams& streams, bool quiet);

  /// The observer to hand to a workflow; valid as long as this object.
  [[nodiscard]] core::Observer observer();
  /// Ends the display of a stage. To be called before anything else is printed once a workflow has returned.
  void close() { display_.reset(); }

 private:
  void show(const std::string& stage, const core::Progress& progress);

  Streams& streams_;
  bool quiet_;
  std::string stage_;
  std::optional<ProgressDisplay> display_;
};

}  // namespace sarsim::cli
