#include "capi/call.hpp"

#include <new>
#include <optional>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/report/retryable.hpp"
#include "core/task/stop.hpp"
#include "core/text/json.hpp"
#include "scene/model/object.hpp"

namespace sarsim::capi {

namespace {

core::Problems failure(const char* message, const char* hint = "") { return {core::error(message).hint(hint)}; }

// As the command prints it. An object that a program added stands in no file: its kind and number are its place.
std::string words_of(const core::Problem& problem) {
  const core::Subject& subject = problem.subject;
  const std::optional<scene::ObjectKind> kind = scene::kind_called(subject.kind);
  if (!problem.place.file.empty() || !kind) return core::to_string(problem);
  core::Problem placed = problem;
  placed.message = fmt::format("{} {}: {}", subject.kind, subject.index + 1, problem.message);
  return core::to_string(placed);
}

sarsim_status status_and_problems(core::Problems& problems) {
  try {
    throw;
  } catch (const core::InvalidRequest& refused) {
    problems = refused.problems;
    return core::is_retryable(refused) ? SARSIM_TRY_AGAIN : SARSIM_BAD_INPUT;
  } catch (const core::Interrupted&) {
    problems = failure("stopped");
    return SARSIM_STOPPED;
  } catch (const BadArgument& mistake) {
    problems = failure(mistake.what(), "this is a mistake in the calling program; sarsim.h says what is expected");
    return SARSIM_BAD_ARGUMENT;
  } catch (const std::bad_alloc&) {
    problems = failure("there is not enough memory");
    return SARSIM_NO_MEMORY;
  } catch (const std::logic_error& mistake) {
    problems = failure(mistake.what(), "this is a mistake in Sarsim; please report it with the scene");
    return SARSIM_FAILED;
  } catch (const std::system_error& error) {
    problems = failure(error.what());
    return core::is_retryable(error.code()) ? SARSIM_TRY_AGAIN : SARSIM_FAILED;
  } catch (const std::exception& error) {
    problems = failure(error.what());
    return SARSIM_FAILED;
  } catch (...) {
    problems = failure("failed for an unknown reason");
    return SARSIM_FAILED;
  }
}

void make_utf8(core::Problem& problem) {
  for (std::string* const text : {&problem.message, &problem.found, &problem.expected, &problem.hint,
                                  &problem.place.file, &problem.subject.kind, &problem.subject.field})
    *text = core::valid_utf8(*text);
}

}  // namespace

sarsim_status status_of_exception(core::Problems& problems) noexcept {
  try {
    problems.clear();
    return status_and_problems(problems);
  } catch (...) {  // No memory for the words.
    return SARSIM_NO_MEMORY;
  }
}

void hand_over(core::Problems found, sarsim_problems** problems) noexcept {
  if (problems == nullptr || found.empty()) return;
  try {
    auto list = std::make_unique<sarsim_problems>();
    list->problems = core::ranked(std::move(found));
    for (core::Problem& problem : list->problems) {
      make_utf8(problem);
      list->texts.push_back(words_of(problem));
    }
    *problems = list.release();
  } catch (const std::bad_alloc&) {
    *problems = nullptr;
  }
}

sarsim_work work_of(const sarsim_work* work) {
  constexpr unsigned max_threads = 65535;
  const sarsim_work how = taken(work, "work");
  static_cast<void>(told_count(how.threads, max_threads, "work->threads"));
  return how;
}

std::size_t told_count(std::size_t count, std::size_t most, const char* name) {
  if (count <= most) return count;
  throw BadArgument(fmt::format("{} is {}; expected {} at most", name, count, most));
}

sarsim_text* text_handle(const std::string& text) { return new sarsim_text{core::valid_utf8(text)}; }

core::Observer observer_of(const sarsim_work& work) {
  core::Observer observer;
  if (work.stop != nullptr) observer.stop = &work.stop->flag;
  if (work.progress != nullptr)
    observer.progress = [progress = work.progress, user = work.user](const std::string& stage,
                                                                     const core::Progress& done) {
      progress(user, stage.c_str(), done.done, done.total);
    };
  return observer;
}

}  // namespace sarsim::capi
