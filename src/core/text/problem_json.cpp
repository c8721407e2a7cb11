#include "core/text/problem_json.hpp"

namespace sarsim::core {

void write_json(JsonWriter& json, const Problem& problem) {
  static constexpr const char* severities[] = {"error", "warning", "note"};
  json.begin_object().member("severity", severities[static_cast<std::size_t>(problem.severity)]);
  json.member("message", problem.message).member("found", problem.found).member("expected", problem.expected);
  json.member("hint", problem.hint).member("file", problem.place.file).member("line", problem.place.line);
  json.member("column", problem.place.column).member("count", problem.count);
  json.member("text", to_string(problem)).end_object();
}

void write_json(JsonWriter& json, const Problems& problems) {
  json.begin_array();
  for (const Problem& problem : problems) write_json(json, problem);
  json.end_array();
}

}  // namespace sarsim::core
