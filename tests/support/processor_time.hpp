#pragma once

#include <sys/resource.h>
#include <time.h>

namespace sarsim::test {

/// Processor time since it was made, by all threads of this process or by this one. Limits of tests are limits of this
/// and not of a clock on the wall, which goes on while other programs have the processors.
class ProcessorTime {
 public:
  ProcessorTime() = default;
  [[nodiscard]] static ProcessorTime of_this_thread() { return ProcessorTime(CLOCK_THREAD_CPUTIME_ID); }

  /// Seconds so far; those of several threads are added.
  [[nodiscard]] double seconds() const { return now_s(clock_) - begin_s_; }

 private:
  explicit ProcessorTime(clockid_t clock) : clock_(clock) {}
  static double now_s(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  clockid_t clock_ = CLOCK_PROCESS_CPUTIME_ID;
  double begin_s_ = now_s(clock_);
};

/// Processor seconds of all programs that this one started and waited for.
[[nodiscard]] inline double processor_s_of_ended_programs() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace sarsim::test
