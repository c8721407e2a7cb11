#include "workflow/convert/convert_options.hpp"

#include <limits>

#include <fmt/format.h>

#include "core/report/refused.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::uint64_t most_columns = std::numeric_limits<std::int64_t>::max();

scene::FileFormat format_of_word(const char* option, const std::string& word) {
  if (const auto format = raster::format_from_name(word)) return *format;
  throw core::Refused(fmt::format("{}: '{}' is not a format of samples", option, word),
                      "formats are " + raster::format_words());
}

}  // namespace

OptionTable<SampleArguments> sample_option_table() {
  OptionTable<SampleArguments> table;
  table.text("--from", "FORMAT", fmt::format("format of the file (default: found): {}", raster::format_words()),
             [](SampleArguments& sample, const std::string& word) { sample.format = format_of_word("--from", word); });
  table.whole("--columns", 1, most_columns, "samples of a row, of BINARY",
              [](SampleArguments& sample, std::uint64_t n) { sample.columns = static_cast<std::int64_t>(n); });
  table.whole("--bits", 1, 64, "A/D bits, of BINARY and CSV",
              [](SampleArguments& sample, std::uint64_t n) { sample.bits = static_cast<std::int64_t>(n); });
  table.number("--lsb", "V", "volts of a count", &SampleArguments::lsb_v);
  table.text("--script", "SCENE", "script that wrote the file, where it carries none", &SampleArguments::script);
  return table;
}

OptionTable<ConvertRequest> convert_option_table() {
  OptionTable<ConvertRequest> table;
  table.text("--to", "FORMAT",
             fmt::format("format to write (default: that of the name's ending): {}", raster::format_words()),
             [](ConvertRequest& request, const std::string& word) { request.to = format_of_word("--to", word); });
  table.flag("--counts", "counts of the A/D converter in HDF5 and NPY, in place of volts", &ConvertRequest::counts);
  table.flag("--header", "a header line in CSV", &ConvertRequest::header);
  table.flag("--force", "replace the file where it exists", &ConvertRequest::force);
  return table;
}

}  // namespace sarsim::workflow
