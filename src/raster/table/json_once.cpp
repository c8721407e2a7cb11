#include "raster/table/json_once.hpp"

#include <set>
#include <vector>

#include <nlohmann/json.hpp>

namespace sarsim::raster {

nlohmann::json parse_json_once(std::string_view text, std::string& twice) {
  using Event = nlohmann::json::parse_event_t;
  std::vector<std::set<std::string>> open;  // The keys of each object that is not closed yet.
  return nlohmann::json::parse(text, [&](int /*depth*/, Event event, nlohmann::json& value) {
    if (event == Event::object_start) open.emplace_back();
    if (event == Event::object_end) open.pop_back();
    if (event != Event::key) return true;
    constexpr std::size_t longest = 60;
    const auto& name = value.get_ref<const std::string&>();
    if (!open.back().insert(name).second && twice.empty()) twice = name.empty() ? "(empty)" : name.substr(0, longest);
    return true;
  });
}

}  // namespace sarsim::raster
