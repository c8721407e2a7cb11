#include "workflow/sweep/sweep_check.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "raster/table/formats.hpp"
#include "scene/check/check.hpp"
#include "scene/script/reader.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/survey/survey.hpp"
#include "workflow/record/known_machine.hpp"
#include "workflow/sweep/sweep_causes.hpp"

namespace sarsim::workflow {

namespace {

// Of objects those at some positions.
template <class Object>
std::vector<Object> picked(const std::vector<Object>& objects, const std::vector<std::size_t>& positions) {
  std::vector<Object> some;
  for (const std::size_t position : positions) some.push_back(objects.at(position));
  return some;
}

// Looks at one variation; used on several threads at once.
class Looker {
 public:
  Looker(const SweepToCheck& work, const core::StopFlag* stop) : work_(work), stop_(stop) {
    for (const workflow::ProductJob& job : work.products) (job.table ? tables_ : simulations_).push_back(job.index);
  }

  // What is not made is not looked at either: it may be as wrong as it likes.
  core::Problems look(std::size_t variation, std::vector<ProductSize>& sizes) const {
    const core::WorkControl alone{1, stop_};
    core::Problems problems;
    scene::Scene scene = work_.sweep.scene(work_.base, variation, problems, stop_);
    if (!problems.empty()) return problems;
    scene.simulations = picked(scene.simulations, simulations_);
    scene.geometries = picked(scene.geometries, tables_);
    problems = scene::check(scene, alone);
    if (!core::has_errors(problems)) {
      const auto resolved = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(scene, alone));
      core::append(problems, simulate::survey(scene, resolved, alone));
      if (!core::has_errors(problems)) sizes = sizes_of(scene, resolved);
    }
    number_as_in_script(problems);
    locate_values(problems, variation);
    return core::ranked(std::move(problems));
  }

 private:
  // @param scene  with the chosen products alone
  [[nodiscard]] std::vector<ProductSize> sizes_of(
      const scene::Scene& scene, const std::shared_ptr<const simulate::ResolvedScene>& resolved) const {
    std::vector<ProductSize> sizes;
    std::size_t simulation = 0;
    for (const workflow::ProductJob& job : work_.products) {
      ProductSize size;
      if (!job.table) {
        const simulate::Plan plan = simulate::make_plan(scene, simulation++, resolved, work_.engine, stop_);
        size.rows = plan.acquisition.timing.rows;
        size.columns = plan.acquisition.reception.columns;
        size.bytes = raster::expected_bytes(simulate::product_of(plan, {}),
                                            {plan.acquisition.simulation.format, false, work_.counts, false});
        const scene::FileFormat format = plan.acquisition.simulation.format;
        size.min_bytes = raster::min_bytes(format, size.bytes);
        const bool twice = plan.acquisition.simulation.lsb_v <= 0.0 && raster::holds_counts(format, work_.counts);
        size.seconds = simulate::estimated_cost(plan, 1, known_machine()).seconds * (twice ? 2.0 : 1.0);
      }
      sizes.push_back(size);
    }
    return sizes;
  }

  void number_as_in_script(core::Problems& problems) const {
    for (core::Problem& problem : problems) {
      core::Subject& subject = problem.subject;
      if (subject.kind != "simulation" && subject.kind != "geometry") continue;
      const auto& positions = subject.kind == "simulation" ? simulations_ : tables_;
      if (subject.index < positions.size()) subject.index = positions[subject.index];
    }
  }

  // A place in the script is of no help where the value does not stand there.
  void locate_values(core::Problems& problems, std::size_t variation) const {
    scene::locate(problems, work_.places);
    for (core::Problem& problem : problems)
      if (work_.sweep.varies(problem.subject)) problem.place = work_.sweep.place_of(problem.subject, variation);
  }

  const SweepToCheck& work_;
  const core::StopFlag* stop_;
  std::vector<std::size_t> simulations_;  // Positions of those that are chosen.
  std::vector<std::size_t> tables_;
};

}  // namespace

double sum_of(const SweepChecks& checks, double ProductSize::*member) {
  double sum = 0.0;
  for (const auto& sizes : checks.sizes)
    for (const ProductSize& size : sizes) sum += size.*member;
  return sum;
}

SweepChecks check_sweep(const SweepToCheck& work, const core::WorkControl& control) {
  std::map<std::size_t, std::size_t> representatives;  // First of those alike -> how many of them.
  for (const std::size_t variation : work.variations) ++representatives[work.sweep.first_alike(variation)];
  const std::vector<std::pair<std::size_t, std::size_t>> looked_at(representatives.begin(), representatives.end());
  std::vector<std::vector<ProductSize>> sizes(looked_at.size());
  Causes causes;
  const Looker looker(work, control.stop);
  core::parallel_ranges(looked_at.size(), 1, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      causes.add(looked_at[i].first, looked_at[i].second, looker.look(looked_at[i].first, sizes[i]));
  });
  SweepChecks checks;
  checks.problems = causes.problems(work.sweep, work.variations.size());
  if (core::has_errors(checks.problems)) return checks;
  for (const std::size_t variation : work.variations) {
    const auto found = std::ranges::lower_bound(looked_at, work.sweep.first_alike(variation), {},
                                                &std::pair<std::size_t, std::size_t>::first);
    checks.sizes.push_back(sizes[static_cast<std::size_t>(found - looked_at.begin())]);
  }
  return checks;
}

}  // namespace sarsim::workflow
