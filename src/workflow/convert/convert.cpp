#include "workflow/convert/convert.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <memory>
#include <span>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/image_export.hpp"
#include "raster/format/sinks.hpp"
#include "raster/sicd/sicd_writer.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/product_attributes.hpp"
#include "scene/model/world_frame.hpp"
#include "scene/schema/trade_words.hpp"
#include "workflow/convert/copied_image.hpp"
#include "workflow/focus/image_collection.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/image/image_script.hpp"
#include "workflow/image/sicd_image.hpp"
#include "workflow/input/earth_place.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/override_words.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/input/scene_words.hpp"

namespace sarsim::workflow {

namespace {

namespace fs = std::filesystem;

struct CopiedImage {
  std::shared_ptr<const raster::Raster> file;
  raster::EnviHeader header;
  signal::FocusedImage image;
  ImageOrigin origin;
};

CopiedImage opened_image(const ConvertRequest& request, const core::Observer& observer) {
  CopiedImage opened;
  const raster::RasterHints hints = hints_for(request.input, {}, {}, observer);
  opened.file = open_samples(request.input, hints, observer).file;
  auto header = header_beside(request.input, *opened.file);
  if (!header || !header->field("image plane"))
    throw core::InvalidRequest(fmt::format("'{}' is not a focused image, and a SICD file is one", request.input),
                               "name an image of sarsim focus, in ENVI, NPY or HDF5; or focus into .nitf");
  if (is_of_magnitudes(*header))
    throw core::InvalidRequest(fmt::format("'{}' holds magnitudes, and a SICD file has phases", request.input),
                               "name the complex image beside it");
  opened.header = *std::move(header);
  read_header(opened.header, request.input, opened.image, opened.origin);
  return opened;
}

// The recording that the image was made from, for its plan and its track.
FocusInput recorded(const CopiedImage& opened, const ConvertRequest& request, const core::Observer& observer,
                    const core::WorkControl& control) {
  WayBack way = way_back(opened.header, opened.origin, request.input, request.sample.script, observer.stop);
  observer.remarks(way.problems);
  RecordingArguments arguments;
  arguments.path = way.source;
  arguments.script = way.script;
  arguments.simulation = request.simulation.value_or(static_cast<std::int64_t>(opened.origin.simulation) + 1);
  arguments.overrides = overrides_from_words(opened.origin.settings);
  return open_focus_input(arguments, control);
}

void copy_rows(const CopiedImage& opened, raster::SicdWriter& writer, const core::StopFlag* stop) {
  std::vector<std::complex<float>> row(opened.file->columns());
  for (std::size_t r = 0; r < opened.file->rows(); ++r) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    opened.file->read_window({r, 1, 0, row.size(), 1, 1}, row);
    writer.append(row);
  }
  writer.finish();
}

// Writes a focused image, as ENVI, NPY or HDF5, as a SICD file (docs/formats/sicd.md). Its script says how it was
// collected: it is found as `measure` finds it. Throws like `convert`; core::InvalidRequest where the file is no
// focused image with phases, its script is not there, or nothing says where on the Earth it lies.
ConvertReport convert_to_sicd(const ConvertRequest& request, const core::Observer& observer) {
  if (request.to || request.counts || request.header)
    throw core::InvalidRequest("--to, --counts and --header are for files of samples, and a SICD file is an image",
                               "leave them out");
  const core::WorkControl control = observer.control(core::thread_count(0));
  const CopiedImage opened = opened_image(request, observer);
  OutputCare care{{request.input}, request.force, "OUT"};
  expect_free_outputs({request.output}, care);
  const FocusInput input = recorded(opened, request, observer, control);
  care.sources.add(input.sources);
  expect_free_outputs({request.output}, care);
  const EarthPlace place = earth_place(input.world, request.anchor, "SICD");
  const ImageMaking making{opened.image, opened.origin.options, opened.origin.algorithm == "back-projection"};
  ImageOrigin origin = opened.origin;
  origin.radar = input.acquisition->link.name;
  const raster::EnviHeader header = header_of_copy(opened.header, request.input, request.output, false);
  const SicdImage sicd = sicd_of(opened.image, origin, collection_of(input, making, place, control), header,
                                 fs::path(request.output).stem().string());
  raster::SicdWriter writer(request.output, sicd.description, sicd.backwards, request.force);
  copy_rows(opened, writer, observer.stop);
  ConvertReport report;
  report.files = {request.output};
  report.rows = sicd.description.rows;
  report.columns = sicd.description.columns;
  report.remarks = place.remarks;
  return report;
}

// The format of the new file; nothing for an ENVI image, which only images become.
std::optional<scene::FileFormat> output_format(const ConvertRequest& request, bool image) {
  if (request.to) return *request.to;
  if (const auto format = raster::format_from_path(request.output)) return *format;
  if (core::equal_ignoring_case(std::filesystem::path(request.output).extension().string(), ".img")) {
    if (image && !request.counts) return std::nullopt;
    throw core::InvalidRequest(
        image ? fmt::format("--counts: an image such as '{}' holds volts", request.output)
              : fmt::format("'{}' has no header that makes it an image as '{}'", request.input, request.output),
        fmt::format("say another format with --to {}", raster::format_words()));
  }
  expect_no_picture(request.output, "--out");
  const std::string extension = std::filesystem::path(request.output).extension().string();
  const scene::TradeChoice* const meant = extension.empty() ? nullptr : scene::trade_choice(extension, "format");
  throw core::InvalidRequest(
      fmt::format("the extension of '{}' names no format", request.output),
      meant != nullptr && !meant->word.empty()
          ? fmt::format("say --to {}{}", meant->word, meant->note.empty() ? "" : fmt::format(": {}", meant->note))
          : fmt::format("say it with --to {}", raster::format_words()));
}

// The description of the recording as far as its file gives it.
raster::Product product_of_file(const raster::Raster& file, std::optional<raster::RasterAxes> axes) {
  const raster::RasterInfo& info = file.info();
  raster::Product product;
  product.rows = file.rows();
  product.columns = info.columns;
  product.bits = info.bits;
  product.lsb_v = info.lsb_v.value_or(0.0);
  product.sample_rate_hz = info.sample_rate_hz.value_or(0.0);
  product.script = raster::attribute_of(info.attributes, "script");
  raster::take_origin(info.attributes, product);
  if (product.script.empty()) product.unknown.emplace_back("script");
  if (!info.sample_rate_hz) product.unknown.emplace_back("sample_rate_hz");
  if (!axes) axes = file.axes();
  if (axes) {
    const auto shared = std::make_shared<const raster::RasterAxes>(std::move(*axes));
    product.row_time_s = [shared](std::size_t row) { return shared->row_time_s[row]; };
    product.row_carrier_hz = [shared](std::size_t row) { return shared->row_carrier_hz[row]; };
    if (!shared->row_pose.empty()) product.row_pose = [shared](std::size_t row) { return shared->row_pose[row]; };
    product.column_range_m = [shared](std::size_t column) { return shared->column_range_m[column]; };
    product.image.columns = shared->column_axis;
    product.image.rows = shared->row_axis;
    if (!shared->row_m.empty()) product.image.row_m = [shared](std::size_t row) { return shared->row_m[row]; };
  }
  return product;
}

// The header of an image, for its copy or to be left behind.
struct CarriedHeader {
  std::optional<raster::EnviHeader> copy;
  std::filesystem::path file;  // of the copy
  core::Problems notes;        // what is lost
};

CarriedHeader carried_header(const raster::EnviHeader& header, const ConvertRequest& request,
                             std::optional<scene::FileFormat> format) {
  const bool array = format && raster::format_of(*format).envi_header;
  const auto left = [&](const std::string& why) {
    return CarriedHeader{
        {},
        {},
        {core::note(fmt::format("axes and all else in the header of '{}' are left behind: {}", request.input, why))
             .hint("NPY in volts and .img keep them")}};
  };
  if (format && !array) return left(fmt::format("{} has no place for them", format_word(*format)));
  if (request.counts) return left("counts do not make an image");
  if (array && is_of_magnitudes(header)) {
    CarriedHeader carried = left("as NPY the magnitudes become complex numbers, which would be taken for the image");
    carried.notes.back().hint = ".img keeps them";
    return carried;
  }
  return {header_of_copy(header, request.input, request.output, array),
          header_file_of_copy(request.input, request.output),
          {}};
}

// What happens to each sample on its way.
enum class Change { none, to_volts, to_counts };

// Turns blocks of one file into those of another.
class Conversion {
 public:
  Conversion(const raster::Raster& file, std::optional<raster::RasterAxes> axes, const raster::RasterHints& hints,
             const ConvertRequest& request, const core::Observer& observer)
      : file_(file), product_(product_of_file(file, std::move(axes))), request_(request), observer_(observer) {
    choose_converter(hints);
    const auto image = request.held ? std::nullopt : header_beside(request.input, file);
    const auto format = output_format(request, image.has_value());
    if (image) header_ = carried_header(*image, request, format);
    envi_ = !format;
    options_.replace = request.force;
    options_.counts = format ? raster::holds_counts(*format, request.counts) : request.counts;
    options_.header = request.header;
    if (format) options_.format = *format;
    const bool volts_in = !file.info().counts;
    change_ = volts_in == !options_.counts ? Change::none : volts_in ? Change::to_counts : Change::to_volts;
    expect_known();
  }

  // Of the new file and, for images, its header.
  [[nodiscard]] std::vector<std::filesystem::path> outputs() const {
    if (header_.copy) return {request_.output, header_.file};
    return raster::files_of(envi_ ? nullptr : &raster::format_of(options_.format), request_.output);
  }

  ConvertReport carry_out() {
    const std::unique_ptr<raster::Sink> sink = envi_ ? make_pixel_sink(request_.output, *header_.copy, options_.replace)
                                                     : raster::make_sink(request_.output, product_, options_);
    const std::unique_ptr<core::OutputFile> header = begun_header();
    const core::ProgressReport progress = observer_.stage(request_.output);
    const std::size_t rows = rows_at_once(product_.columns);
    for (std::size_t first = 0; first < product_.rows; first += rows) {
      if (observer_.stop != nullptr && observer_.stop->requested()) throw core::Interrupted();
      if (progress) progress({first, product_.rows, product_.columns});
      const std::size_t count = std::min(rows, product_.rows - first);
      read(first, count);
      sink->append(sink->encode({first, count, product_.columns, volts_, counts_}), first, count);
    }
    sink->finish(run_report());
    if (header) header->commit();
    return report();
  }

 private:
  // Counts were made by the converter that their file tells of; volts may go through any other.
  void choose_converter(const raster::RasterHints& hints) {
    const bool volts = !file_.info().counts;
    if (hints.bits > 0 && (volts || product_.bits == 0)) product_.bits = hints.bits;
    if (hints.lsb_v > 0.0 && (volts || product_.lsb_v <= 0.0)) product_.lsb_v = hints.lsb_v;
  }

  // Complete but for its name, which it gets after the data.
  [[nodiscard]] std::unique_ptr<core::OutputFile> begun_header() const {
    if (!header_.copy) return nullptr;
    auto file = std::make_unique<core::OutputFile>(header_.file, options_.replace);
    const std::string text = raster::to_text(*header_.copy);
    file->write(std::as_bytes(std::span(text)));
    file->secure();
    return file;
  }

  // Everything that the change needs must be known before the first row.
  void expect_known() {
    core::Problems problems;
    const auto need = [&](const char* what, const char* option) {
      problems.push_back(
          core::error(fmt::format("{} of '{}' {} not known, but {} needs {}", what, request_.input,
                                  std::string_view(what).ends_with("bits") ? "are" : "is", format_word(options_.format),
                                  std::string_view(what).ends_with("bits") ? "them" : "it"))
              .hint(hint_for(option)));
    };
    const bool sized = raster::format_of(options_.format).needs_bits;
    if (product_.bits == 0 && options_.counts && (sized || change_ == Change::to_counts))
      need("the A/D bits", "--bits");
    if (product_.lsb_v <= 0.0 && change_ != Change::none) need("the LSB", "--lsb");
    if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
    if (product_.lsb_v <= 0.0) product_.unknown.emplace_back("lsb_v");
    if (product_.bits > 0) return;
    // Enough for all counts; volts have none.
    product_.bits = 64;
    product_.unknown.emplace_back("bits");
  }

  // A script that was given says the bits, but may leave the LSB to the data.
  [[nodiscard]] std::string hint_for(std::string_view option) const {
    if (option == "--lsb" && !request_.sample.script.empty())
      return "the script leaves the LSB to the data (0): give with --lsb the lsb_v of the run's report "
             "(sarsim run --json)";
    return fmt::format("give {}, or the script that wrote the file with --script", option);
  }

  void read(std::size_t first, std::size_t count) {
    volts_.resize(count * product_.columns);
    file_.read_rows(first, count, volts_);
    if (change_ == Change::to_volts)
      for (auto& sample : volts_) sample *= product_.lsb_v;
    if (!options_.counts) {
      raster::expect_single_precision(volts_, first, product_.columns);
      note_what_is_not_finite(first);
      return;
    }
    counts_.resize(2 * volts_.size());
    // Counts pass through a converter of 1 V a count: unchanged as long as they fit its bits.
    radar::Converter{product_.bits, change_ == Change::to_counts ? product_.lsb_v : 1.0}.convert(volts_, counts_,
                                                                                                 tally_);
  }

  // They are copied as they are, and every focusing of them will be refused.
  void note_what_is_not_finite(std::size_t first_row) {
    for (std::size_t i = 0; i < volts_.size(); ++i) {
      if (std::isfinite(volts_[i].real()) && std::isfinite(volts_[i].imag())) continue;
      if (not_finite_++ == 0) first_not_finite_ = first_row * product_.columns + i;
    }
  }

  [[nodiscard]] core::Problem what_is_not_finite() const {
    return core::warning(fmt::format(
        "{} of {} samples are not finite and were copied so; the first is row {}, sample {} (from 0)", not_finite_,
        product_.rows * product_.columns, first_not_finite_ / product_.columns, first_not_finite_ % product_.columns));
  }

  // Whether all samples have become count 0 although they were something.
  [[nodiscard]] bool lost_all() const {
    return change_ == Change::to_counts && tally_.maximum_v > 0.0 && tally_.zero == product_.rows * product_.columns;
  }

  [[nodiscard]] core::Problem loss() const {
    return core::warning(fmt::format("all counts are 0: the LSB is {:g} V, the largest voltage {:g} V", product_.lsb_v,
                                     tally_.maximum_v))
        .hint(
            fmt::format("give a smaller one: --lsb {:.6G}", tally_.maximum_v / radar::full_scale_count(product_.bits)));
  }

  [[nodiscard]] core::Problem clipping() const {
    return core::warning(fmt::format("{} of {} samples were clipped to {} bits; {}", tally_.saturated,
                                     product_.rows * product_.columns, product_.bits, remedy_of_clipping()));
  }

  [[nodiscard]] std::string remedy_of_clipping() const {
    constexpr int max_bits = 64;
    if (!std::isfinite(tally_.maximum_v)) return "some of the numbers are infinite";
    if (change_ == Change::to_counts)
      return fmt::format("an LSB of {:.6G} V would avoid clipping",
                         tally_.maximum_v / radar::full_scale_count(product_.bits));
    if (product_.bits < max_bits && tally_.maximum_v <= radar::full_scale_count(max_bits))
      return "more --bits would avoid clipping";
    return fmt::format("{} are the most that counts can have", max_bits);
  }

  [[nodiscard]] core::Problem what_is_no_number() const {
    return core::warning(fmt::format("I or Q of {} of {} samples is not a number; count 0 stands for it",
                                     tally_.not_numbers, product_.rows * product_.columns));
  }

  [[nodiscard]] ConvertReport report() const {
    ConvertReport report;
    report.files = outputs();
    report.rows = product_.rows;
    report.columns = product_.columns;
    report.counts = options_.counts;
    report.tally = tally_;
    report.remarks = header_.notes;
    if (tally_.saturated > 0) report.remarks.push_back(clipping());
    if (tally_.not_numbers > 0) report.remarks.push_back(what_is_no_number());
    if (not_finite_ > 0) report.remarks.push_back(what_is_not_finite());
    if (lost_all()) report.remarks.push_back(loss());
    return report;
  }

  [[nodiscard]] raster::RunReport run_report() const {
    raster::RunReport report;
    report.rows = product_.rows;
    report.columns = product_.columns;
    report.lsb_v = product_.lsb_v;
    return report;
  }

  const raster::Raster& file_;
  raster::Product product_;
  const ConvertRequest& request_;
  const core::Observer& observer_;
  raster::SinkOptions options_;
  CarriedHeader header_;
  bool envi_ = false;  // pixels of an image without a format of samples
  Change change_ = Change::none;
  std::vector<std::complex<double>> volts_;
  std::vector<std::int64_t> counts_;
  radar::ConversionTally tally_;
  std::size_t not_finite_ = 0;
  std::size_t first_not_finite_ = 0;
};

}  // namespace

ConvertReport convert(const ConvertRequest& request, const core::Observer& observer) {
  if (is_sicd(request.output) && !request.to) return convert_to_sicd(request, observer);
  if (request.anchor)
    throw core::InvalidRequest("--anchor places a SICD file on the Earth", "name the output .nitf, or leave it out");
  if (request.simulation && request.sample.script.empty())
    throw core::InvalidRequest("--simulation is a number in a script", "name it with --script");
  const raster::RasterHints hints =
      request.held ? raster::RasterHints() : hints_for(request.input, request.sample, request.simulation, observer);
  SampleFile samples = request.held ? SampleFile{request.held, {}} : open_samples(request.input, hints, observer);
  Conversion conversion(*samples.file, std::move(samples.axes), hints, request, observer);
  std::vector<std::filesystem::path> named{request.sample.script};
  if (!request.held) named.emplace_back(request.input);
  expect_free_outputs(conversion.outputs(), {InputList::named(std::move(named)), request.force, "OUT"});
  return conversion.carry_out();
}

}  // namespace sarsim::workflow
