#include "workflow/stepped/profiles_options.hpp"

#include <fmt/format.h>

#include "raster/table/formats.hpp"
#include "workflow/input/recording_options.hpp"
#include "workflow/options/window_option.hpp"

namespace sarsim::workflow {

namespace {

void add_speeds(OptionTable<ProfilesRequest>& table) {
  table.text("--velocity", "none|scene|estimated|M/S",
             "radial speed to compensate: none (default), that of the scene's targets, estimated for the sharpest "
             "profiles, or in m/s, positive receding",
             [](ProfilesRequest& request, const std::string& word) { request.velocity = velocity_choice(word); });
  table.number("--fastest", "M/S", "largest speed searched by --velocity estimated (default: 500)",
               &ProfilesRequest::fastest_mps);
  table.flag("--align", "place targets at their mid-scan range instead of that of each burst; mean profiles always do",
             &ProfilesRequest::align);
}

void add_profile(OptionTable<ProfilesRequest>& table) {
  table.text("--window", "WINDOW",
             "over the band: rectangular, hann, hamming, bartlett, blackman, kaiser[:BETA], taylor[:DB:NBAR]; default: "
             "the script's",
             [](ProfilesRequest& request, const std::string& word) { request.window = window_of("--window", word); });
  table.number("--from", "M", "first range (default: the script's)", &ProfilesRequest::from_m);
  table.number("--to", "M", "last range (default: the script's, as far as the recording shows it)",
               &ProfilesRequest::to_m);
  table.whole("--oversampling", 1, 64, "samples per resolution cell (default: 4)", &ProfilesRequest::oversampling);
  table.number("--illumination", "DB",
               "bursts within so many dB of the strongest, two-way, belong to a scan (default: 6)",
               &ProfilesRequest::illumination_db);
  table.whole("--burst", 1, std::uint64_t{1} << 40,
              "which burst is compared with the script (default: the middle of the strongest scan)",
              [](ProfilesRequest& request, std::uint64_t n) { request.burst = static_cast<std::size_t>(n - 1); });
}

}  // namespace

OptionTable<ProfilesRequest> profiles_option_table() {
  using Grouping = ProfileGrouping;
  OptionTable<ProfilesRequest> table;
  table.text("--out", "OUT",
             fmt::format("profiles to write: ENVI (.img, default), .csv for magnitudes against range, or {}",
                         raster::image_extensions(true)),
             &ProfilesRequest::output);
  table.choice<Grouping>(
      "--group", {{"bursts", Grouping::bursts}, {"scans", Grouping::scans}, {"encounter", Grouping::encounter}},
      "a profile for each burst (default), or the mean power of each scan or of all scans", &ProfilesRequest::set);
  add_speeds(table);
  add_profile(table);
  table.include(recording_options("the first that suits"), &ProfilesRequest::input);
  table.whole("--threads", 0, 4096, "threads; 0 for one per core (default); never changes a byte",
              &ProfilesRequest::threads);
  table.flag("--force", "replace files that exist", &ProfilesRequest::replace);
  return table;
}

ProfilesRequest profiles_request(const std::string& input, const GivenWords& given) {
  // What was said so until --set came to mean values of the script, here as elsewhere.
  for (auto [word, last] = given.equal_range("--set"); word != last; ++word)
    if (word->second == "bursts" || word->second == "scans" || word->second == "encounter")
      throw core::InvalidRequest(
          fmt::format("--set {}: a field of the script and its value are expected", word->second),
          fmt::format("one profile for each burst, scan or encounter is asked for with --group {}", word->second));
  ProfilesRequest request;
  request.input.path = input;
  const TakenProblems problems = profiles_option_table().take_words(given, request);
  if (!problems.empty()) throw core::InvalidRequest(core::Problems{problems.early.front()});
  return request;
}

}  // namespace sarsim::workflow
