#include "scene/ephemeris/satellite_choice.hpp"

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::scene::ephemeris {

namespace {

constexpr std::size_t max_listed = 20;
constexpr std::size_t max_suggested = 1000;

bool same_number(std::string_view a, std::string_view b) {
  const auto first = core::parse_integer(a);
  return first && first == core::parse_integer(b);
}

}  // namespace

SatelliteChoice::SatelliteChoice(std::string_view wanted) : wanted_(core::trimmed(wanted)) {}

bool SatelliteChoice::is_wanted(std::string_view name, std::string_view id) const {
  return core::equal_ignoring_case(wanted_, name) || core::equal_ignoring_case(wanted_, id) || same_number(wanted_, id);
}

void SatelliteChoice::remember(std::string_view name, std::string_view id) {
  const std::string key = core::lower_case(id.empty() ? name : id);
  const bool is_new = keys_.insert(key).second;
  if (is_new && listed_.size() < max_listed)
    listed_.push_back(name.empty() || id.empty() ? core::clipped(name.empty() ? id : name)
                                                 : fmt::format("{} ({})", core::clipped(name), core::clipped(id)));
  if (is_new && words_.size() + 2 <= max_suggested) {
    words_.push_back(core::clipped(name));
    words_.push_back(core::clipped(id));
  }
  last_taken_ = wanted_.empty() ? !any_ || key == first_taken_ : is_wanted(name, id);
  if (last_taken_ && first_taken_.empty()) first_taken_ = key;
  if (last_taken_ && is_new) ++taken_;
  any_ = true;
}

bool SatelliteChoice::takes(std::string_view name, std::string_view id) {
  if (!any_ || last_name_ != name || last_id_ != id) {
    remember(name, id);
    last_name_ = name;
    last_id_ = id;
  }
  return last_taken_;
}

std::string SatelliteChoice::list() const {
  std::string all;
  for (const std::string& one : listed_) all += (all.empty() ? "" : ", ") + one;
  if (keys_.size() > listed_.size()) all += fmt::format(", and {} more", keys_.size() - listed_.size());
  return all;
}

bool SatelliteChoice::report(FileProblems& problems) const {
  if (wanted_.empty()) {
    if (keys_.size() < 2) return true;
    problems.error({}, {fmt::format("the file holds {} satellites, and none is selected", keys_.size()), "",
                        "one of " + list(), "select one by its name or number"});
    return false;
  }
  if (taken_ == 1) return true;
  if (taken_ > 1) {
    problems.error({}, {fmt::format("{} satellites have the name that was chosen", taken_), wanted_,
                        "the number of one of " + list(), "choose one by its number"});
    return false;
  }
  if (keys_.empty()) return true;           // No data at all is another problem.
  if (problems.has_errors()) return false;  // Perhaps its data were not understood.
  const std::string nearest = core::nearest_word(wanted_, words_);
  problems.error({}, {"the file does not hold the satellite that was chosen", wanted_, "one of " + list(),
                      nearest.empty() ? "" : fmt::format("did you mean {}?", nearest)});
  return false;
}

}  // namespace sarsim::scene::ephemeris
