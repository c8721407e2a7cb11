#include "workflow/exchange/export.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "raster/cphd/cphd_writer.hpp"
#include "workflow/exchange/cphd_of_collection.hpp"
#include "workflow/exchange/crsd_of_collection.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/sample_input.hpp"

namespace sarsim::workflow {

namespace {

// Refuses what leaves no phase history, and remarks on what spoils it.
void expect_divisible(const Collection& collection, const HistoryShape& shape, core::Problems& remarks) {
  constexpr double min_share = 0.05;
  const simulate::Acquisition& acquisition = *collection.acquisition;
  const DelaySpan whole = whole_echoes(acquisition);
  if (!(whole.first_s < whole.last_s))
    throw core::InvalidRequest(
        {core::error("the recorded window is shorter than the pulse: it contains no complete echo")
             .found(fmt::format("{:.6g} us", 1e6 * static_cast<double>(acquisition.reception.raw_grid.count) *
                                                 acquisition.reception.raw_grid.interval_s))
             .expected(fmt::format("more than the pulse width, {:.6g} us", 1e6 * acquisition.link.pulse.width_s))
             .hint("record a longer range, or shorten the pulse")});
  const double lost = 1.0 - (shape.toa2_s - shape.toa1_s) / (whole.last_s - whole.first_s);
  const char* const other = "add --reference-point moving, or record for a shorter time";
  if (!(lost < 1.0))
    throw core::InvalidRequest(
        {core::error("no range around the reference point is recorded in all pulses").hint(other)});
  if (lost > 0.5)
    remarks.push_back(
        core::warning(
            "export.swath-lost",
            fmt::format(
                "{:.0f} % of the recorded swath is lost: it is not recorded in all pulses around one reference point",
                100.0 * lost))
            .hint(other));
  const double share = PhaseHistory(collection, shape).weakest_share(acquisition.timing.rows / 2);
  if (!(share >= min_share))
    throw core::InvalidRequest({core::error("the spectrum of the pulse has gaps, by which CPHD cannot divide")
                                    .found(fmt::format("{:.2g} of its largest magnitude", share))
                                    .expected(fmt::format("at least {:g} within the band", min_share))
                                    .hint("use a chirp; CRSD takes any pulse as it is")});
  if (acquisition.scene->options.pulse != scene::PulseDefinition::band_limited)
    remarks.push_back(core::warning("export.pulse-edges",
                                    "the pulse has hard edges, whose spectrum extends beyond half the sampling rate: "
                                    "the samples of each vector have rms errors of 3 to 7 %")
                          .hint(collection.computed
                                    ? "add --pulse band-limited, which reduces the error below 0.1 %"
                                    : "convert the scene in place of its recording, which reduces the error below 0.1 "
                                      "%: sarsim convert SCENE OUT.cphd --pulse band-limited"));
}

// Several vectors as bytes: enough work for a thread.
using VectorBlock = std::vector<raster::EncodedVector>;

void write_vectors(const Collection& collection, const HistoryShape& shape, raster::SignalEncoding encoding,
                   raster::CphdWriter& writer, unsigned threads, const core::Observer& observer,
                   const core::ProgressReport& progress) {
  const std::size_t rows = collection.acquisition->timing.rows;
  const std::size_t together = std::max<std::size_t>(1, rows_at_once(shape.grid.transform) / 16);
  const auto make_worker = [&] {
    auto history = std::make_unique<PhaseHistory>(collection, shape);
    return [&, history = std::move(history),
            samples = std::vector<std::complex<double>>(shape.grid.samples)](std::size_t block) mutable {
      VectorBlock encoded;
      for (std::size_t row = block * together; row < std::min(rows, (block + 1) * together); ++row) {
        const raster::PhaseVector vector = history->make(row, samples);
        encoded.push_back(raster::encode_vector(vector, samples, encoding));
      }
      return encoded;
    };
  };
  core::ordered_parallel<VectorBlock>((rows + together - 1) / together, threads, make_worker,
                                      [&](std::size_t block, VectorBlock&& encoded) {
                                        for (const raster::EncodedVector& vector : encoded) writer.append(vector);
                                        if (progress)
                                          progress({std::min(rows, (block + 1) * together), rows, shape.grid.samples});
                                      },
                                      observer.stop);
}

// Several rows with their pulses as bytes.
struct ReceivedRow {
  std::vector<std::byte> pulse;
  raster::EncodedVector row;
};
using RowBlock = std::vector<ReceivedRow>;

void write_rows(const Collection& collection, raster::CrsdWriter& writer, unsigned threads,
                const core::Observer& observer, const core::ProgressReport& progress) {
  const std::size_t rows = collection.acquisition->timing.rows;
  const std::size_t columns = collection.acquisition->reception.columns;
  const std::size_t together = std::max<std::size_t>(1, rows_at_once(columns) / 16);
  const auto make_worker = [&] {
    auto pulses = std::make_unique<ReceivedPulses>(collection);
    return [&, pulses = std::move(pulses),
            samples = std::vector<std::complex<double>>(columns)](std::size_t block) mutable {
      RowBlock encoded;
      for (std::size_t row = block * together; row < std::min(rows, (block + 1) * together); ++row) {
        collection.rows.read(row, samples);
        const raster::ReceivedPulse pulse = pulses->pulse_of(row);
        encoded.push_back({writer.pulse_bytes(pulse), writer.encode(pulse, row, samples)});
      }
      return encoded;
    };
  };
  core::ordered_parallel<RowBlock>((rows + together - 1) / together, threads, make_worker,
                                   [&](std::size_t block, RowBlock&& encoded) {
                                     for (const ReceivedRow& row : encoded) writer.append(row.pulse, row.row);
                                     if (progress) progress({std::min(rows, (block + 1) * together), rows, columns});
                                   },
                                   observer.stop);
}

bool is_crsd(const std::filesystem::path& path) {
  return core::equal_ignoring_case(path.extension().string(), ".crsd");
}

raster::SignalEncoding encoding_of(const ExportRequest& request) {
  return request.encoding.value_or(raster::SignalEncoding::cf8);
}

void write_crsd(const Collection& collection, const CollectionExtent& extent, const ExportRequest& request,
                core::Problems remarks, unsigned threads, const core::Observer& observer) {
  expect_receivable(*collection.acquisition);
  observer.remarks(core::ranked(std::move(remarks)));
  const raster::CphdDescription cphd =
      cphd_of(collection, extent, history_shape(collection, extent), encoding_of(request));
  raster::CrsdWriter writer(request.output, crsd_of(collection, extent, cphd), request.force);
  write_rows(collection, writer, threads, observer, observer.stage(request.output.string()));
  writer.finish();
}

}  // namespace

bool is_exchange_file(const std::filesystem::path& path) {
  return core::equal_ignoring_case(path.extension().string(), ".cphd") || is_crsd(path);
}

ExportReport export_recording(const ExportRequest& request, const core::Observer& observer) {
  const unsigned threads = core::thread_count(request.threads);
  const core::WorkControl control = observer.control(threads);
  OutputCare care{InputList::named(named_sources(request.input)), request.force, "OUT"};
  expect_free_outputs({request.output}, care);
  core::Problems remarks;
  Collection collection = open_collection({request.input, is_crsd(request.output) ? "CRSD" : "CPHD",
                                           request.reference.value_or(ReferencePoint{}), request.anchor},
                                          control, remarks);
  collection.name = request.output.stem().string();
  care.sources.add(collection.sources);
  expect_free_outputs({request.output}, care);
  const CollectionExtent extent = extent_of(collection, control);
  if (is_crsd(request.output)) {
    write_crsd(collection, extent, request, std::move(remarks), threads, observer);
    return {collection.acquisition->timing.rows, collection.acquisition->reception.columns};
  }
  const HistoryShape shape = history_shape(collection, extent);
  expect_divisible(collection, shape, remarks);
  observer.remarks(core::ranked(std::move(remarks)));
  raster::CphdWriter writer(request.output, cphd_of(collection, extent, shape, encoding_of(request)), request.force);
  write_vectors(collection, shape, encoding_of(request), writer, threads, observer,
                observer.stage(request.output.string()));
  writer.finish();
  return {collection.acquisition->timing.rows, shape.grid.samples};
}

}  // namespace sarsim::workflow
