#include "cli/shell/signals.hpp"

#include "core/os/stop_signals.hpp"

namespace sarsim::cli {

namespace {

core::StopFlag stop_flag;

}  // namespace

const core::StopFlag& handle_signals(ProcessGroup company) {
  core::install_stop_signals(
      {.request = []() noexcept { stop_flag.request(); }, .noticed = []() noexcept { return stop_flag.noticed(); }},
      company == ProcessGroup::alone);
  return stop_flag;
}

int received_signal() { return core::received_signal(); }

}  // namespace sarsim::cli
