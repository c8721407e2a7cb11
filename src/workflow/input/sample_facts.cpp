#include "workflow/input/sample_facts.hpp"

#include <algorithm>
#include <chrono>
#include <complex>
#include <filesystem>
#include <thread>
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

// A text says how many rows it has by its lines alone. Reading a shorter one takes less than a tenth of a second.
bool is_long(const std::string& path) {
  constexpr std::uintmax_t least = std::uintmax_t{1} << 24U;
  std::error_code failure;
  const std::uintmax_t bytes = std::filesystem::file_size(path, failure);
  return !failure && bytes >= least;
}

// Rows of a text by how many its beginning has, which is looked through for a moment.
void estimate_rows(SampleFacts& facts) {
  constexpr std::chrono::milliseconds moment(30);
  std::this_thread::sleep_for(moment);
  const double share = facts.file->indexed();
  facts.rows = facts.file->rows();
  facts.rows_estimated = share < 1.0;
  if (facts.rows_estimated)
    facts.rows = static_cast<std::size_t>(static_cast<double>(facts.rows) / std::max(share, 1e-9));
}

}  // namespace

SampleFacts facts_of_samples(const std::string& path, const SampleArguments& sample, bool statistics,
                             const core::Observer& observer) {
  const raster::RasterHints hints = hints_for(path, sample, observer);
  const bool growing = !statistics && is_long(path);
  SampleFacts facts;
  facts.file =
      open_samples(path, hints, observer, growing ? raster::Integrity::partial : raster::Integrity::whole).file;
  if (facts.file->indexed() < 1.0)
    estimate_rows(facts);
  else
    facts.rows = facts.file->rows();
  if (statistics) facts.statistics = statistics_of(*facts.file, observer.stop);
  return facts;
}

}  // namespace sarsim::workflow
