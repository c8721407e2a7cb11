#include "workflow/input/sample_facts.hpp"

#include <algorithm>
#include <complex>
#include <utility>
#include <vector>

namespace sarsim::workflow {

namespace {

signal::SampleStatistics statistics_of(const raster::Raster& file, const core::StopFlag* stop) {
  const raster::RasterInfo& info = file.info();
  signal::SampleStatistics statistics;
  std::vector<std::complex<double>> values;
  const std::size_t rows = rows_at_once(info.columns);
  for (std::size_t first = 0; first < file.rows(); first += rows) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    const std::size_t count = std::min(rows, file.rows() - first);
    values.resize(count * info.columns);
    file.read_rows(first, count, values);
    statistics.add(values, first, info.columns);
  }
  return statistics;
}

}  // namespace

SampleFacts facts_of_samples(const std::string& path, const SampleArguments& sample, const core::Observer& observer) {
  std::shared_ptr<const raster::Raster> file = open_samples(path, hints_for(path, sample), observer);
  signal::SampleStatistics statistics = statistics_of(*file, observer.stop);
  return {std::move(file), statistics};
}

}  // namespace sarsim::workflow
