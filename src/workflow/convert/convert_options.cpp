#include "workflow/convert/convert_options.hpp"

#include "raster/table/formats.hpp"

namespace sarsim::workflow {

std::vector<std::pair<std::string, scene::FileFormat>> format_choices() {
  std::vector<std::pair<std::string, scene::FileFormat>> choices;
  for (const raster::Format& row : raster::recording_formats())
    choices.emplace_back(raster::word_of(row), *row.recording);
  return choices;
}

OptionTable<SampleArguments> sample_option_table() {
  OptionTable<SampleArguments> table;
  table.choice("--from", format_choices(), "format of the file, where content and extension mislead",
               &SampleArguments::format);
  table.whole("--columns", 1, std::uint64_t{1} << 40, "samples of a row (BINARY)", &SampleArguments::columns);
  table.whole("--bits", 1, 64, "A/D bits of its counts", &SampleArguments::bits);
  table.number("--lsb", "V", "volts of a count", &SampleArguments::lsb_v);
  table.text("--dataset", "NAME", "dataset of the samples in an HDF5 file (default: /samples)",
             &SampleArguments::dataset);
  table.text("--script", "SCENE", "script whose simulation wrote the file, instead of the above",
             &SampleArguments::script);
  return table;
}

OptionTable<ConvertRequest> convert_option_table() {
  OptionTable<ConvertRequest> table;
  table.choice("--to", format_choices(), "format of the new file (default: from its extension)", &ConvertRequest::to);
  table.flag("--counts", "converter counts instead of volts in HDF5, NPY, Zarr and SigMF", &ConvertRequest::counts);
  table.flag("--header", "a header line in CSV", &ConvertRequest::header);
  table.flag("--force", "replace the new file where it exists", &ConvertRequest::force);
  return table;
}

}  // namespace sarsim::workflow
