#include "cli/shell/watch.hpp"

#include <ostream>

namespace sarsim::cli {

Watch::Watch(Streams& streams, bool quiet) : streams_(streams), quiet_(quiet) {}

core::Observer Watch::observer() {
  core::Observer observer;
  observer.stop = streams_.stop;
  if (quiet_) return observer;
  observer.progress = [this](const std::string& stage, const core::Progress& progress) { show(stage, progress); };
  observer.remark = [this](const core::Problems& problems) {
    close();
    print_problems(streams_, problems);
  };
  observer.announce = [this](const std::string& line) {
    close();
    write_err(streams_, line + "\n");
  };
  return observer;
}

void Watch::show(const std::string& stage, const core::Progress& progress) {
  if (!display_ || stage != stage_) {
    display_.reset();
    stage_ = stage;
    display_.emplace(streams_.err, streams_.terminal ? ProgressDisplay::Style::bar : ProgressDisplay::Style::lines,
                     stage);
  }
  display_->update(progress);
}

}  // namespace sarsim::cli
