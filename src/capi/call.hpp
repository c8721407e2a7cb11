#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "capi/handles.hpp"
#include "capi/sarsim.h"
#include "core/report/problem.hpp"
#include "core/task/observer.hpp"

/// What all functions of the C interface have in common: how arguments come in, and how results and exceptions go out.
namespace sarsim::capi {

/// A mistake of the calling program.
struct BadArgument : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws BadArgument where a pointer is null.
/// @param name  of the argument, with its function
template <class T>
T& given(T* pointer, const char* name) {
  if (pointer == nullptr) throw BadArgument(std::string(name) + " is NULL");
  return *pointer;
}

/// What the exception that is being handled means. Never throws.
/// @param[out] problems  what is wrong; empty where memory does not suffice to say it
[[nodiscard]] sarsim_status status_of_exception(core::Problems& problems) noexcept;

/// Hands a list over; nothing where there is none, nobody asks, or no memory is left.
void hand_over(core::Problems found, sarsim_problems** problems) noexcept;

/// Calls `body(found)`, which adds remarks to `found`, and makes a status and a list of what comes of it.
template <class Body>
sarsim_status call(sarsim_problems** problems, const Body& body) noexcept {
  if (problems != nullptr) *problems = nullptr;
  core::Problems found;
  sarsim_status status = SARSIM_OK;
  try {
    body(found);
  } catch (...) {
    status = status_of_exception(found);
  }
  hand_over(std::move(found), problems);
  return status;
}

/// The place for a handle, which is null until it is made.
template <class Handle>
Handle*& cleared(Handle** place, const char* name) {
  Handle*& result = given(place, name);
  result = nullptr;
  return result;
}

/// The size that a caller says its structure has. Throws BadArgument for one that was not set.
template <class Structure>
std::size_t told_size(const Structure* structure, const char* name) {
  constexpr std::size_t most = 65536;  // no structure will ever be so large
  std::size_t size = 0;
  std::memcpy(&size, &given(structure, name), sizeof size);
  if (size < sizeof size || size > most)
    throw BadArgument(std::string(name) + "->struct_size is not set; use SARSIM_INIT");
  return size;
}

/// A structure of options as this library knows it, from one of any size: what the caller does not know has its
/// default. Throws BadArgument where the caller's is larger and says something with it.
template <class Options>
Options taken(const Options* from, const char* name) {
  Options options{};
  if (from == nullptr) return options;
  const std::size_t size = told_size(from, name);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(from);
  for (std::size_t i = sizeof(Options); i < size; ++i)
    if (bytes[i] != 0)
      throw BadArgument(std::string(name) + " says what this library does not know; a newer libsarsim.so.0 is needed");
  std::memcpy(static_cast<void*>(&options), from, std::min(size, sizeof(Options)));
  return options;
}

/// The options of a call, the defaults for null. Throws BadArgument for more than 65 535 threads, which a negative
/// number turns into.
[[nodiscard]] sarsim_work work_of(const sarsim_work* work);

/// A count given by a caller, unchanged. Throws BadArgument above `most`, which a negative number turns into.
/// @param name  of the argument, for the message
std::size_t told_count(std::size_t count, std::size_t most, const char* name);

/// Largest number of options, and of values of [let], that is accepted.
inline constexpr std::size_t max_words = 1'000'000;

/// Fills in a structure of results, of which the caller may know less, or more, which is then zero.
template <class Results>
void fill(const Results& results, Results* out, const char* name) {
  const std::size_t size = told_size(out, name);
  auto* const bytes = reinterpret_cast<unsigned char*>(out);
  const std::size_t known = std::min(size, sizeof(Results));
  const auto* const from = reinterpret_cast<const unsigned char*>(&results);
  std::copy(from + sizeof size, from + known, bytes + sizeof size);
  std::fill(bytes + known, bytes + size, static_cast<unsigned char>(0));
}

/// A text as a handle, in UTF-8.
[[nodiscard]] sarsim_text* text_handle(const std::string& text);

/// How work is done, as workflows take it; keeps no reference to `work`.
[[nodiscard]] core::Observer observer_of(const sarsim_work& work);

}  // namespace sarsim::capi
