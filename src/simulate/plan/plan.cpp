#include "simulate/plan/plan.hpp"

#include <utility>

#include "scene/model/scene.hpp"
#include "simulate/plan/row_kernel.hpp"

namespace sarsim::simulate {

bool Plan::filters_spectra() const {
  return row_kernel(engine.engine).filters && acquisition.reception.compressor &&
         acquisition.reception.stc_gain.empty() && sources.range_ambiguities.pulses.empty() &&
         acquisition.scene->options.eclipsing == scene::Eclipsing::none;
}

Plan plan_of(Acquisition acquisition, Engine engine, const core::StopFlag* stop) {
  Plan plan{.acquisition = std::move(acquisition), .sources = {}, .engine = {}};
  const ResolvedScene& scene = *plan.acquisition.scene;
  plan.sources.range_ambiguities =
      asked_for(find_range_ambiguities(plan.acquisition, stop), scene.options.ambiguous_echoes);
  plan.engine = choose_engine(engine, plan.acquisition);
  if (!row_kernel(plan.engine.engine).point_by_point)
    plan.sources.points = std::make_shared<const PointGroups>(group_points(scene, plan.acquisition.link, stop));
  return plan;
}

Plan make_plan(const scene::Scene& scene, std::size_t index, std::shared_ptr<const ResolvedScene> resolved,
               Engine engine, const core::StopFlag* stop) {
  return plan_of(acquisition_of(scene, index, std::move(resolved), stop), engine, stop);
}

raster::Product product_of(const Plan& plan, std::string script) {
  raster::Product product = product_of(plan.acquisition, std::move(script));
  product.engine = name_of(plan.engine.engine);
  return product;
}

}  // namespace sarsim::simulate
