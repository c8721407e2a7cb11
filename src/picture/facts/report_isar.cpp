#include <algorithm>
#include <utility>

#include "picture/facts/report_parts.hpp"
#include "workflow/stepped/stepped_report.hpp"

namespace sarsim::picture {

namespace {

core::Facts numbered(std::size_t image, core::Facts facts) {
  facts.insert(facts.begin(), {"", "Image", image});
  return facts;
}

}  // namespace

ReportPages pages_of(const workflow::IsarReport& made) {
  core::Facts facts = facts_of(made);
  core::FactRows images;
  core::FactRows targets;
  for (const workflow::WrittenIsarImage& image : made.images) {
    images.push_back(numbered(images.size() + 1, facts_of(image, false)));
    for (const workflow::HeldPoint& point : image.image.points)
      targets.push_back(numbered(images.size(), facts_of(point)));
  }
  // Those of the only image stand among the facts of the report.
  if (made.images.size() == 1) {
    const auto seconds = std::ranges::find(facts, "seconds", &core::Fact::key);
    facts.insert(seconds, {"", "", facts_of(made.images.front(), true)});
  }
  if (made.images.size() > 1) facts.push_back({"", "Images", std::move(images)});
  facts.push_back({"", "Targets", std::move(targets)});
  return report::pages_of(facts);
}

}  // namespace sarsim::picture
