// The rasters of sarsim.h.

#include "capi/rasters.hpp"

#include <algorithm>
#include <complex>
#include <limits>
#include <span>
#include <utility>

#include "capi/call.hpp"
#include "capi/labels.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "core/text/json.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/computed_raster.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/product_attributes.hpp"
#include "workflow/convert/convert.hpp"
#include "workflow/convert/convert_options.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/image/placed_image.hpp"
#include "workflow/input/output_names.hpp"

using namespace sarsim;

namespace {

// Attributes that a raster's own description has a place for.
void describe(raster::RasterInfo& info) {
  if (const auto rate = core::parse_number(raster::attribute_of(info.attributes, "sample_rate_hz")))
    info.sample_rate_hz = *rate;
  if (const auto bits = core::parse_integer(raster::attribute_of(info.attributes, "bits")))
    info.bits = static_cast<int>(std::clamp<std::int64_t>(*bits, 0, 64));
  if (const auto lsb = core::parse_number(raster::attribute_of(info.attributes, "lsb_v"))) info.lsb_v = *lsb;
}

// The caller's memory as it is described now.
std::shared_ptr<const raster::Raster> raster_of_memory(const sarsim_raster& known, std::size_t rows,
                                                       std::size_t columns, bool pairs) {
  raster::RasterInfo info;
  info.columns = columns;
  info.value = pairs ? raster::ImageValue::complex : raster::ImageValue::real;
  info.attributes = known.attributes;
  describe(info);
  std::optional<raster::RasterAxes> axes;
  if (!known.axes.empty()) axes = workflow::axes_of(known.axes, rows, columns);
  return std::make_shared<raster::ComputedRaster>(
      std::move(info), rows, std::move(axes),
      [memory = known.memory, columns, pairs](const raster::ImageWindow& window, std::span<std::complex<float>> out) {
        for (std::size_t i = 0; i < window.rows; ++i)
          for (std::size_t k = 0; k < window.cols; ++k) {
            const std::size_t at = window.row(i) * columns + window.column(k);
            out[i * window.cols + k] =
                pairs ? std::complex<float>(memory[2 * at], memory[2 * at + 1]) : std::complex<float>(memory[at], 0.0F);
          }
      });
}

sarsim_raster& described(sarsim_raster* raster, const char* name) {
  sarsim_raster& known = capi::given(raster, name);
  if (known.memory == nullptr) throw capi::BadArgument(std::string(name) + " is not of the caller's memory");
  return known;
}

void describe_anew(sarsim_raster& known) {
  const raster::Raster& before = *known.samples;
  known.samples =
      raster_of_memory(known, before.rows(), before.columns(), before.info().value == raster::ImageValue::complex);
}

sarsim_value value_of(raster::ImageValue value) {
  switch (value) {
    case raster::ImageValue::real: return SARSIM_REAL;
    case raster::ImageValue::magnitude: return SARSIM_MAGNITUDE;
    case raster::ImageValue::power: return SARSIM_POWER;
    case raster::ImageValue::rgb: return SARSIM_COLOUR;
    case raster::ImageValue::complex: break;
  }
  return SARSIM_COMPLEX;
}

// How many of so many are wanted from one on.
std::size_t wanted_of(std::uint64_t first, std::uint64_t count, std::uint64_t step, std::size_t all, const char* what) {
  const bool within = first < all || (first == all && count == 0);
  const std::size_t rest = within && first < all ? 1 + static_cast<std::size_t>((all - first - 1) / step) : 0;
  const std::size_t wanted = count == 0 ? rest : static_cast<std::size_t>(count);
  if (within && wanted <= rest) return wanted;
  throw capi::BadArgument(std::string("the window is not within the ") + std::to_string(all) + " " + what);
}

raster::ImageWindow window_of(const sarsim_window* given, const raster::Raster& samples) {
  const sarsim_window window = capi::taken(given, "window");
  raster::ImageWindow wanted;
  wanted.row_step = static_cast<std::size_t>(std::max<std::uint64_t>(1, window.row_step));
  wanted.col_step = static_cast<std::size_t>(std::max<std::uint64_t>(1, window.column_step));
  wanted.rows = wanted_of(window.first_row, window.rows, wanted.row_step, samples.rows(), "rows");
  wanted.cols = wanted_of(window.first_column, window.columns, wanted.col_step, samples.columns(), "columns");
  wanted.row0 = static_cast<std::size_t>(window.first_row);
  wanted.col0 = static_cast<std::size_t>(window.first_column);
  return wanted;
}

// Whole rows, of which columns are taken.
void read_doubles(const raster::Raster& samples, const raster::ImageWindow& window, std::complex<double>* out,
                  const core::StopFlag* stop) {
  if (window.row_step != 1 || window.col_step != 1)
    throw capi::BadArgument("sarsim_raster_read_double: a window without steps is expected");
  std::vector<std::complex<double>> row(samples.columns());
  for (std::size_t i = 0; i < window.rows; ++i) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    samples.read_rows(window.row(i), 1, row);
    std::copy_n(row.begin() + static_cast<std::ptrdiff_t>(window.col0), window.cols, out + i * window.cols);
  }
}

workflow::SampleArguments said_of(const char* const* options, std::size_t count) {
  workflow::SampleArguments said;
  const auto table = workflow::sample_option_table();
  workflow::TakenProblems problems = table.take_words(capi::words_of(table.options(), options, count), said);
  if (!problems.empty()) throw core::InvalidRequest(std::move(problems.early));
  return said;
}

void write_raster(const sarsim_raster& known, workflow::ConvertRequest request, const core::Observer& observer,
                  core::Problems& found) {
  if (known.image && !request.to && !request.counts && !request.header) {
    workflow::expect_image_ending(request.output, "the file");
    workflow::InputList sources = workflow::InputList::named({known.path});
    if (known.image->input) sources.add(workflow::InputList::named(workflow::named_sources(*known.image->input)));
    workflow::expect_free_outputs(workflow::files_of_image(request.output), {sources, request.force, "the file"});
    workflow::write_image(*known.image, request.output, request.force, observer.stop);
    return;
  }
  request.input = known.path.empty() ? "memory" : known.path;
  request.sample = known.said;
  if (known.path.empty()) request.held = known.samples;
  const workflow::ConvertReport report = workflow::convert(request, observer);
  core::append(found, report.remarks);
}

}  // namespace

namespace sarsim::capi {

sarsim_raster raster_of_file(const std::string& path, const workflow::SampleArguments& said,
                             const core::Observer& observer) {
  const workflow::PlacedImage placed = workflow::open_placed_image({path, said, {}}, observer);
  sarsim_raster made;
  made.samples = placed.source;
  made.path = path;
  made.said = said;
  const raster::RasterInfo& info = placed.source->info();
  if (info.format != nullptr) made.format = placed.header ? "envi" : raster::word_of(*info.format);
  made.attributes = placed.header ? placed.header->fields : info.attributes;
  if (placed.focused)
    made.axes = workflow::named_axes(*placed.focused, placed.source->rows(), placed.source->columns());
  if (placed.axes) made.axes = workflow::named_axes(*placed.axes);
  for (auto& [name, value] : made.attributes) {
    name = core::valid_utf8(name);
    value = core::valid_utf8(value);
  }
  return made;
}

sarsim_raster raster_of_image(workflow::InMemoryImage image) {
  sarsim_raster made;
  const auto kept = std::make_shared<const workflow::InMemoryImage>(std::move(image));
  const raster::EnviHeader& header = kept->content.header;
  raster::RasterInfo info;
  info.columns = header.samples;
  info.value = header.pixel == raster::EnviHeader::Pixel::real_float ? raster::ImageValue::magnitude
                                                                     : raster::ImageValue::complex;
  made.samples = std::make_shared<raster::ComputedRaster>(
      std::move(info), header.lines, std::nullopt,
      [kept](const raster::ImageWindow& window, std::span<std::complex<float>> out) {
        std::vector<std::complex<float>> row(kept->rows.columns);
        for (std::size_t i = 0; i < window.rows; ++i) {
          kept->rows.read(window.row(i), row);
          for (std::size_t k = 0; k < window.cols; ++k) out[i * window.cols + k] = row[window.column(k)];
        }
      });
  made.attributes = header.fields;
  made.axes = workflow::named_axes(workflow::places_of(header, "the image"), header.lines, header.samples);
  made.image = kept;
  return made;
}

}  // namespace sarsim::capi

void sarsim_raster_free(sarsim_raster* raster) { delete raster; }

sarsim_status sarsim_raster_open(const char* path, const char* const* options, size_t option_count,
                                 const sarsim_work* work, sarsim_raster** raster, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems& found) {
    sarsim_raster*& result = capi::cleared(raster, "sarsim_raster_open: raster");
    const std::string file = &capi::given(path, "sarsim_raster_open: path");
    core::Observer observer = capi::observer_of(capi::work_of(work));
    observer.remark = [&found](const core::Problems& more) { core::append(found, more); };
    result = new sarsim_raster(capi::raster_of_file(file, said_of(options, option_count), observer));
  });
}

sarsim_status sarsim_raster_of_floats(const float* samples, uint64_t rows, uint64_t columns, int pairs,
                                      sarsim_raster** raster, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_raster*& result = capi::cleared(raster, "sarsim_raster_of_floats: raster");
    if (rows == 0 || columns == 0 || columns > std::numeric_limits<std::int64_t>::max() / 8 / rows)
      throw capi::BadArgument("sarsim_raster_of_floats: rows and columns are expected that memory can hold");
    auto made = std::make_unique<sarsim_raster>();
    made->memory = &capi::given(samples, "sarsim_raster_of_floats: samples");
    made->samples =
        raster_of_memory(*made, static_cast<std::size_t>(rows), static_cast<std::size_t>(columns), pairs != 0);
    result = made.release();
  });
}

sarsim_status sarsim_raster_set_axis(sarsim_raster* raster, const char* name, const double* values, uint64_t count,
                                     sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_raster& known = described(raster, "sarsim_raster_set_axis: raster");
    const std::string called = &capi::given(name, "sarsim_raster_set_axis: name");
    static_cast<void>(capi::told_count(count, std::max(known.samples->rows(), known.samples->columns()),
                                       "sarsim_raster_set_axis: count"));
    const double* const first = count > 0 ? &capi::given(values, "sarsim_raster_set_axis: values") : nullptr;
    sarsim_raster changed = known;
    std::erase_if(changed.axes, [&](const workflow::NamedAxis& axis) { return axis.name == called; });
    changed.axes.push_back({called, {}, false, std::vector<double>(first, first + count)});
    changed.axes =
        workflow::named_axes(workflow::axes_of(changed.axes, known.samples->rows(), known.samples->columns()));
    describe_anew(changed);
    known = std::move(changed);
  });
}

sarsim_status sarsim_raster_set_attribute(sarsim_raster* raster, const char* name, const char* value,
                                          sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_raster& known = described(raster, "sarsim_raster_set_attribute: raster");
    const std::string called = &capi::given(name, "sarsim_raster_set_attribute: name");
    const std::string said = &capi::given(value, "sarsim_raster_set_attribute: value");
    sarsim_raster changed = known;
    std::erase_if(changed.attributes, [&](const auto& attribute) { return attribute.first == called; });
    changed.attributes.emplace_back(core::valid_utf8(called), core::valid_utf8(said));
    describe_anew(changed);
    known = std::move(changed);
  });
}

sarsim_status sarsim_raster_get_info(const sarsim_raster* raster, sarsim_raster_info* info,
                                     sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const sarsim_raster& known = capi::given(raster, "sarsim_raster_get_info: raster");
    const raster::RasterInfo& of = known.samples->info();
    const sarsim_raster_info told{.struct_size = sizeof(sarsim_raster_info),
                                  .rows = known.samples->rows(),
                                  .columns = known.samples->columns(),
                                  .value = value_of(of.value),
                                  .counts = of.counts ? 1 : 0,
                                  .bits = of.bits,
                                  .lsb_v = of.lsb_v.value_or(0.0),
                                  .sample_rate_hz = of.sample_rate_hz.value_or(0.0),
                                  .format = known.format.c_str(),
                                  .path = known.path.c_str(),
                                  .attributes = known.attributes.size(),
                                  .axes = known.axes.size()};
    capi::fill(told, info, "sarsim_raster_get_info: info");
  });
}

const char* sarsim_raster_attribute_name(const sarsim_raster* raster, size_t index) {
  return raster != nullptr && index < raster->attributes.size() ? raster->attributes[index].first.c_str() : "";
}
const char* sarsim_raster_attribute_value(const sarsim_raster* raster, size_t index) {
  return raster != nullptr && index < raster->attributes.size() ? raster->attributes[index].second.c_str() : "";
}
const char* sarsim_raster_attribute(const sarsim_raster* raster, const char* name) {
  if (raster == nullptr || name == nullptr) return nullptr;
  for (const auto& [called, value] : raster->attributes)
    if (core::equal_ignoring_case(called, name)) return value.c_str();
  return nullptr;
}

sarsim_status sarsim_raster_axis_info(const sarsim_raster* raster, size_t index, sarsim_axis_info* info,
                                      sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const sarsim_raster& known = capi::given(raster, "sarsim_raster_axis_info: raster");
    if (index >= known.axes.size()) throw capi::BadArgument("sarsim_raster_axis_info: no such axis");
    const workflow::NamedAxis& axis = known.axes[index];
    const sarsim_axis_info told{.struct_size = sizeof(sarsim_axis_info),
                                .name = axis.name.c_str(),
                                .unit = axis.unit.c_str(),
                                .of_columns = axis.of_columns ? 1 : 0,
                                .count = axis.values.size()};
    capi::fill(told, info, "sarsim_raster_axis_info: info");
  });
}

sarsim_status sarsim_raster_axis(const sarsim_raster* raster, size_t index, uint64_t first, uint64_t count,
                                 double* values, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const sarsim_raster& known = capi::given(raster, "sarsim_raster_axis: raster");
    if (index >= known.axes.size()) throw capi::BadArgument("sarsim_raster_axis: no such axis");
    const std::vector<double>& all = known.axes[index].values;
    if (first > all.size() || count > all.size() - first)
      throw capi::BadArgument("sarsim_raster_axis: there are " + std::to_string(all.size()) + " values");
    if (count == 0) return;
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(first), count,
                &capi::given(values, "sarsim_raster_axis: values"));
  });
}

sarsim_status sarsim_raster_read_float(const sarsim_raster* raster, const sarsim_window* window, float* samples,
                                       const sarsim_work* work, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const raster::Raster& known = *capi::given(raster, "sarsim_raster_read_float: raster").samples;
    const raster::ImageWindow wanted = window_of(window, known);
    const sarsim_work how = capi::work_of(work);
    if (wanted.samples() == 0) return;
    auto* const memory =
        reinterpret_cast<std::complex<float>*>(&capi::given(samples, "sarsim_raster_read_float: samples"));
    const core::Observer observer = capi::observer_of(how);
    known.read_window(wanted, {memory, wanted.samples()}, observer.control(core::thread_count(how.threads)));
  });
}

sarsim_status sarsim_raster_read_double(const sarsim_raster* raster, const sarsim_window* window, double* samples,
                                        const sarsim_work* work, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const raster::Raster& known = *capi::given(raster, "sarsim_raster_read_double: raster").samples;
    const raster::ImageWindow wanted = window_of(window, known);
    const sarsim_work how = capi::work_of(work);
    if (wanted.samples() == 0) return;
    auto* const memory =
        reinterpret_cast<std::complex<double>*>(&capi::given(samples, "sarsim_raster_read_double: samples"));
    read_doubles(known, wanted, memory, capi::observer_of(how).stop);
  });
}

sarsim_status sarsim_raster_write(const sarsim_raster* raster, const char* path, const char* const* options,
                                  size_t option_count, const sarsim_work* work, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems& found) {
    const sarsim_raster& known = capi::given(raster, "sarsim_raster_write: raster");
    workflow::ConvertRequest request;
    const auto table = workflow::convert_option_table();
    workflow::TakenProblems mistakes =
        table.take_words(capi::words_of(table.options(), options, option_count), request);
    if (!mistakes.empty()) throw core::InvalidRequest(std::move(mistakes.early));
    request.output = &capi::given(path, "sarsim_raster_write: path");
    const sarsim_work how = capi::work_of(work);
    core::Observer observer = capi::observer_of(how);
    observer.remark = [&found](const core::Problems& more) { core::append(found, more); };
    write_raster(known, std::move(request), observer, found);
  });
}
