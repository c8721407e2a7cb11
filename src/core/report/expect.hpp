#pragma once

#include <stdexcept>
#include <string>

namespace sarsim::core {

/// Throws std::invalid_argument with `what` where a precondition does not hold, in every build. `what` names the
/// function and what it expects: "back projection: a step is zero". For what a caller of the library may get wrong.
inline void expect(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

/// A mistake in the program: an expectation of CORE_EXPECT, CORE_ENSURE or CORE_ASSERT that did not hold.
class BrokenExpectation : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Throws BrokenExpectation "FILE:LINE: KIND: CONDITION"; what the macros below call.
[[noreturn]] inline void break_expectation(const char* kind, const char* condition, const char* file, int line) {
  throw BrokenExpectation(std::string(file) + ":" + std::to_string(line) + ": " + kind + ": " + condition);
}

/// Whether this build of the library checks the expectations of its functions (CMake: SARSIM_EXPECTATIONS).
[[nodiscard]] bool checks_expectations();

}  // namespace sarsim::core

/// CORE_EXPECT states a precondition of a function, CORE_ENSURE what holds of its result, CORE_ASSERT what holds in
/// between. Where SARSIM_EXPECTATIONS is 1, a condition that does not hold throws core::BrokenExpectation; otherwise it
/// is compiled but never evaluated. They stand once in a call, never once in a sample, and in sources only, because
/// other programs include our headers without SARSIM_EXPECTATIONS.
#if defined(SARSIM_EXPECTATIONS) && SARSIM_EXPECTATIONS
#define SARSIM_EXPECTATION(kind, ...) \
  ((__VA_ARGS__) ? void() : ::sarsim::core::break_expectation(kind, #__VA_ARGS__, __FILE__, __LINE__))
#else
#define SARSIM_EXPECTATION(kind, ...) static_cast<void>(sizeof((__VA_ARGS__) ? 1 : 0))
#endif
#define CORE_EXPECT(...) SARSIM_EXPECTATION("expected", __VA_ARGS__)
#define CORE_ENSURE(...) SARSIM_EXPECTATION("ensured", __VA_ARGS__)
#define CORE_ASSERT(...) SARSIM_EXPECTATION("asserted", __VA_ARGS__)
