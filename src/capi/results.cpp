// Versions, texts, problems and stop requests of sarsim.h.

#include "capi/call.hpp"
#include "core/build/version.hpp"

using namespace sarsim;

int sarsim_abi_version(void) { return SARSIM_ABI_VERSION; }
const char* sarsim_version(void) { return core::program_version; }

const char* sarsim_status_word(sarsim_status status) {
  switch (status) {
    case SARSIM_OK: return "ok";
    case SARSIM_BAD_INPUT: return "bad input";
    case SARSIM_STOPPED: return "stopped";
    case SARSIM_NO_MEMORY: return "no memory";
    case SARSIM_FAILED: return "failed";
    case SARSIM_BAD_ARGUMENT: return "bad argument";
    case SARSIM_TRY_AGAIN: return "try again";
    default: return "unknown status";
  }
}

void sarsim_text_free(sarsim_text* text) { delete text; }
const char* sarsim_text_chars(const sarsim_text* text) { return text != nullptr ? text->text.c_str() : ""; }
size_t sarsim_text_length(const sarsim_text* text) { return text != nullptr ? text->text.size() : 0; }

void sarsim_problems_free(sarsim_problems* problems) { delete problems; }
size_t sarsim_problems_count(const sarsim_problems* problems) {
  return problems != nullptr ? problems->problems.size() : 0;
}

sarsim_status sarsim_problems_get(const sarsim_problems* problems, size_t index, sarsim_problem* problem) {
  return capi::call(nullptr, [&](core::Problems&) {
    if (index >= sarsim_problems_count(problems)) throw capi::BadArgument("sarsim_problems_get: no such problem");
    const core::Problem& from = problems->problems[index];
    const sarsim_problem told{.struct_size = sizeof(sarsim_problem),
                              .severity = static_cast<sarsim_severity>(from.severity),
                              .message = from.message.c_str(),
                              .found = from.found.c_str(),
                              .expected = from.expected.c_str(),
                              .hint = from.hint.c_str(),
                              .file = from.place.file.c_str(),
                              .line = from.place.line,
                              .column = from.place.column,
                              .object = from.subject.kind.c_str(),
                              .object_index = from.subject.index,
                              .field = from.subject.field.c_str(),
                              .count = from.count,
                              .text = problems->texts[index].c_str()};
    capi::fill(told, problem, "sarsim_problems_get: problem");
  });
}

static_assert(static_cast<int>(core::Severity::error) == SARSIM_ERROR &&
              static_cast<int>(core::Severity::warning) == SARSIM_WARNING &&
              static_cast<int>(core::Severity::note) == SARSIM_NOTE);

sarsim_status sarsim_stop_new(sarsim_stop** stop, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_stop*& made = capi::cleared(stop, "sarsim_stop_new: stop");
    made = new sarsim_stop;
  });
}
void sarsim_stop_free(sarsim_stop* stop) { delete stop; }
void sarsim_stop_request(sarsim_stop* stop) {
  if (stop != nullptr) stop->flag.request();
}
