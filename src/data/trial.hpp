#pragma once

#include <functional>

namespace sarsim {

/// How a trial ended.
enum class TrialResult { passed, crashed, timed_out };

/// Runs `work` in a child process and tells whether it survived: for calls into a library that a damaged file can
/// crash.
///
/// The child has its own copy of everything; what it computes is lost, exceptions count as survival, it prints nothing,
/// and it may map at most 512 MB more than this process. A child that still runs after `seconds` is ended.
/// @throws std::system_error where no child can be made
[[nodiscard]] TrialResult run_trial(const std::function<void()>& work, unsigned seconds);

}  // namespace sarsim
