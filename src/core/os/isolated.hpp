#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

namespace sarsim::core {

/// How a trial ended. Too much work: it used up its processor time. Stopped: by a signal that asks programs to end, or
/// by whoever began it, which says nothing about the work.
enum class IsolatedResult { passed, crashed, too_much_work, stopped };

/// Address space that a trial may take beyond that of the process that begins it.
inline constexpr std::uint64_t isolated_bytes = std::uint64_t{512} << 20U;

/// The limit that was set for the memory of this process, where it leaves a trial less than `isolated_bytes`; 0: none.
/// Then a trial without memory says nothing of the file.
[[nodiscard]] std::uint64_t own_memory_limit_bytes();

/// How a trial ended, and what came out of it.
struct IsolatedReport {
  IsolatedResult result = IsolatedResult::passed;
  std::string text;  ///< What the work returned, where it passed.
};

/// Runs `work` in a child process and tells whether it survived, and what it returned: for calls into a library that a
/// damaged file can crash.
///
/// The child has its own copy of everything; but for the text, what it computes is lost. An exception counts as
/// survival with an empty text. The child prints nothing and may map at most 512 MB more than this process; one that
/// has used more than `seconds` of processor time is ended; time spent waiting for a processor or a disk does not
/// count. The text may have up to 60 000 bytes. SIGINT, SIGTERM and SIGHUP end the child,
/// but those that this process ignores; it ends with this process, too.
/// @param lock  that of the library: no other thread may be inside it while the child begins, because the child would
///              have its copy of what that thread was changing, for ever; null for none
/// @param ends  asked now and then: true ends the child, and the trial was stopped; empty: nobody asks for that
/// @throws std::system_error where no child can be made
[[nodiscard]] IsolatedReport run_isolated(const std::function<std::string()>& work, unsigned seconds,
                                          std::mutex* lock = nullptr, const std::function<bool()>& ends = {});

}  // namespace sarsim::core
