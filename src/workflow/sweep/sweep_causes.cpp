#include "workflow/sweep/sweep_causes.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace sarsim::workflow {

void Causes::add(std::size_t variation, std::size_t alike, const core::Problems& problems) {
  const std::scoped_lock hold(lock_);
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const core::Problem& p = problems[i];
    const auto [found, is_new] = causes_.try_emplace(
        Key{p.severity, p.message, p.subject.kind, p.subject.index, p.subject.field}, Cause{p, variation, i, 0});
    Cause& cause = found->second;
    cause.variations += alike;
    if (is_new || variation >= cause.first) continue;
    cause.problem = p;
    cause.first = variation;
    cause.order = i;
  }
}

core::Problems Causes::problems(const Sweep& sweep, std::size_t variations) const {
  std::vector<const Cause*> causes;
  for (const auto& [key, cause] : causes_) causes.push_back(&cause);
  std::ranges::sort(causes, {}, [](const Cause* c) { return std::tuple(c->problem.severity, c->first, c->order); });
  core::Problems problems;
  for (const Cause* cause : causes) {
    problems.push_back(cause->problem);
    if (cause->variations >= variations) continue;
    const std::string where = cause->variations == 1
                                  ? fmt::format("with {}", sweep.label(cause->first))
                                  : fmt::format("in {} of {} variations, first with {}", cause->variations, variations,
                                                sweep.label(cause->first));
    std::string& hint = problems.back().hint;
    if (hint.ends_with('.')) hint.pop_back();
    hint += hint.empty() ? where : "; " + where;
  }
  return problems;
}

}  // namespace sarsim::workflow
