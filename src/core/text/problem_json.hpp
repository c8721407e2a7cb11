#pragma once

#include "core/report/problem.hpp"
#include "core/text/json.hpp"

namespace sarsim::core {

/// A problem as one JSON object: severity, message, place and the rest of its members, and all of it as a text.
void write_json(JsonWriter& json, const Problem& problem);
/// Problems as an array of such objects.
void write_json(JsonWriter& json, const Problems& problems);

}  // namespace sarsim::core
