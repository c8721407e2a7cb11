#include "workflow/record/products.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::workflow {

namespace {

std::vector<ProductJob> all_products(const OutputNames& names) {
  std::vector<ProductJob> jobs;
  for (std::size_t i = 0; i < names.simulations.size(); ++i) jobs.push_back({false, i, names.simulations[i]});
  for (std::size_t i = 0; i < names.tables.size(); ++i) jobs.push_back({true, i, names.tables[i]});
  return jobs;
}

const std::string& scripted_name(const scene::Scene& scene, const ProductJob& job) {
  return job.table ? scene.geometries[job.index].file : scene.simulations[job.index].file;
}

bool is_called(const scene::Scene& scene, const ProductJob& job, const std::string& word) {
  const std::string& name = scripted_name(scene, job);
  return core::equal_ignoring_case(name, word) || core::equal_ignoring_case(base_name(name), word) ||
         job.path == word || job.path.filename() == word;
}

[[noreturn]] void refuse(const scene::Scene& scene, const std::vector<ProductJob>& jobs, const std::string& word) {
  std::vector<std::string> names;
  for (const ProductJob& job : jobs) names.push_back(base_name(scripted_name(scene, job)));
  const std::string nearest = core::nearest_word(word, names);
  const std::size_t count = scene.simulations.size();
  std::string hint = count == 0
                         ? "the scene has no recording"
                         : fmt::format("recordings have the numbers 1 to {}; their output names work as well", count);
  if (!nearest.empty()) hint = fmt::format("did you mean '{}'?", nearest);
  throw core::InvalidRequest(fmt::format("the scene has no product '{}'", word), hint);
}

}  // namespace

std::vector<ProductJob> chosen_products(const scene::Scene& scene, const OutputNames& names,
                                        const std::vector<std::string>& words) {
  const std::vector<ProductJob> jobs = all_products(names);
  if (words.empty()) return jobs;
  std::vector<bool> chosen(jobs.size(), false);
  for (const std::string& word : words) {
    const auto number = core::parse_integer(word);
    bool any = false;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const bool numbered = number && !jobs[i].table && static_cast<std::int64_t>(jobs[i].index) + 1 == *number;
      if (!numbered && !is_called(scene, jobs[i], word)) continue;
      chosen[i] = any = true;
    }
    if (!any) refuse(scene, jobs, word);
  }
  std::vector<ProductJob> result;
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (chosen[i]) result.push_back(jobs[i]);
  return result;
}

}  // namespace sarsim::workflow
