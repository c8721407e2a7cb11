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
  table.choice("--encoding", encodings,
               "samples of CPHD and CRSD: floats (default), or 16- or 8-bit integers with a scale for each pulse",
               &ExportRequest::encoding);
  table.text("--reference-point", "POINT",
             "phase reference of CPHD and CRSD: fixed, the scene centre (default); moving along with the flight; or "
             "X,Y,Z in m",
             [](ExportRequest& request, const std::string& word) { request.reference = reference_point_from(word); });
  return table;
}

OptionTable<ExportRequest> export_option_table() {
  OptionTable<ExportRequest> table = exchange_option_table();
  table.text("--out", "FILE", "file to write; its extension, .cphd or .crsd, selects the standard",
             [](ExportRequest& request, const std::string& word) { request.output = word; });
  table.text(
      "--anchor", "LAT,LON,HEIGHT[,HEADING]",
      "where the origin of a flat scene is on the Earth (degrees, m above the ellipsoid), and the heading of +y",
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
