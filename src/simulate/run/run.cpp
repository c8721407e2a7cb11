#include "simulate/run/run.hpp"

#include <algorithm>
#include <memory>

#include "core/report/expect.hpp"
#include "simulate/plan/row_maker.hpp"

namespace sarsim::simulate {

namespace {

raster::Recorded recorded_of(const Plan& plan) {
  return {plan.acquisition.timing.rows, plan.acquisition.reception.columns, plan.acquisition.simulation.bits};
}

// The rows of a plan, computed; it has to outlive them.
raster::RowSource rows_of(const Plan& plan) {
  return [&plan]() -> raster::RowFill {
    return [rows = std::make_shared<RowMaker>(plan)](std::size_t row, std::span<std::complex<double>> volts,
                                                     const radar::SampleSpan& stale) {
      return rows->make_row(row, volts, stale);
    };
  };
}

}  // namespace

double resolved_lsb_v(const Plan& plan, const raster::RunControl& control) {
  CORE_EXPECT(plan.acquisition.scene != nullptr);
  if (plan.acquisition.simulation.lsb_v > 0.0) return plan.acquisition.simulation.lsb_v;
  double maximum_v = 0.0;
  raster::encode_rows(
      recorded_of(plan), {0, plan.acquisition.timing.rows}, 0.0, nullptr, control, rows_of(plan),
      [&](const raster::EncodedRows& block) { maximum_v = std::max(maximum_v, block.tally.maximum_v); });
  return raster::lsb_of_maximum_v(maximum_v, plan.acquisition.simulation.bits);
}

void run_rows(const Plan& plan, raster::RowRange rows, double lsb_v, const raster::Sink& encoder,
              const raster::RunControl& control, const std::function<void(const raster::EncodedRows&)>& take) {
  raster::encode_rows(recorded_of(plan), rows, lsb_v, &encoder, control, rows_of(plan), take);
}

raster::RunReport run(const Plan& plan, double lsb_v, raster::Sink& sink, const raster::RunControl& control) {
  CORE_EXPECT(plan.acquisition.scene != nullptr);
  return raster::encode_all(recorded_of(plan), lsb_v, sink, control, rows_of(plan));
}

Recording record(const Plan& plan, const raster::RunControl& control) {
  CORE_EXPECT(plan.acquisition.scene != nullptr);
  Recording recording;
  MemorySink sink(recording);
  run(plan, 0.0, sink, control);
  return recording;
}

}  // namespace sarsim::simulate
