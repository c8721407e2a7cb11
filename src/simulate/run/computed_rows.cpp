#include "simulate/run/computed_rows.hpp"

#include <mutex>
#include <utility>

#include "core/task/worker_pool.hpp"
#include "simulate/plan/row_maker.hpp"

namespace sarsim::simulate {

namespace {

class ComputedRows {
 public:
  explicit ComputedRows(std::shared_ptr<const Acquisition> acquisition) : acquisition_(std::move(acquisition)) {}

  void copy(std::size_t row, std::span<std::complex<double>> out) {
    std::call_once(planned_,
                   [this] { plan_ = std::make_unique<const Plan>(plan_of(*acquisition_, Engine::automatic)); });
    makers_.lend([&](RowMaker& maker) { maker.make_row(row, out); });
  }

 private:
  std::shared_ptr<const Acquisition> acquisition_;
  std::once_flag planned_;
  std::unique_ptr<const Plan> plan_;
  core::WorkerPool<RowMaker> makers_{[this] { return std::make_unique<RowMaker>(*plan_); }};
};

}  // namespace

core::SampleRows<double> computed_rows(std::shared_ptr<const Acquisition> acquisition) {
  const std::size_t rows = acquisition->timing.rows;
  const std::size_t columns = acquisition->reception.columns;
  const auto computed = std::make_shared<ComputedRows>(std::move(acquisition));
  return {rows, columns,
          [computed](std::size_t row, std::span<std::complex<double>> out) { computed->copy(row, out); }};
}

}  // namespace sarsim::simulate
