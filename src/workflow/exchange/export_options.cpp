#include "workflow/exchange/export_options.hpp"

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/letters.hpp"
#include "workflow/input/earth_place.hpp"

namespace sarsim::workflow {

OptionTable<ExportRequest> exchange_option_table() {
  std::vector<std::pair<std::string, raster::SignalEncoding>> encodings;
  for (const raster::SignalEncodingName& entry : raster::signal_encodings)
    encodings.emplace_back(core::lower_case(entry.name), entry.encoding);
  OptionTable<ExportRequest> table;
  table.choice(
      "--encoding", encodings,
      "of CPHD and CRSD: samples as floats (default), or as integers of 16 or 8 bits with a scale for each pulse",
      &ExportRequest::encoding);
  table.text(
      "--reference-point", "POINT",
      "of CPHD and CRSD: what phases are relative to: fixed, the middle of the scene (default); moving, with the "
      "flight; or X,Y,Z in m",
      [](ExportRequest& request, const std::string& word) { request.reference = reference_point_from(word); });
  return table;
}

OptionTable<ExportRequest> export_option_table() {
  OptionTable<ExportRequest> table = exchange_option_table();
  table.text("--out", "FILE", "file to write; .cphd or .crsd says which standard",
             [](ExportRequest& request, const std::string& word) { request.output = word; });
  table.text(
      "--anchor", "LAT,LON,HEIGHT[,HEADING]",
      "of a flat scene: its origin on the Earth, in degrees and m over the ellipsoid, and the direction of +y "
      "from north",
      [](ExportRequest& request, const std::string& word) { request.anchor = anchor_from_text(word, "--anchor"); });
  table.flag("--force", "replace the file where it exists", &ExportRequest::force);
  return table;
}

ExportRequest export_request(const RecordingArguments& input, const GivenWords& given) {
  ExportRequest request;
  TakenProblems mistakes = export_option_table().take_words(given, request);
  if (!mistakes.empty()) throw core::InvalidRequest(std::move(mistakes.early));
  request.input = input;
  if (!is_exchange_file(request.output))
    throw core::InvalidRequest(fmt::format("'{}' is not the name of a CPHD or CRSD file", request.output.string()),
                               "let --out end with .cphd or .crsd");
  return request;
}

}  // namespace sarsim::workflow
