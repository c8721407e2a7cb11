// Another program's view of the library: records a script, focuses the recording and measures the image.
//
//   library_program SCRIPT FOLDER

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

#include "core/report/invalid_request.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/record/record.hpp"

using namespace sarsim;

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  core::Observer observer;
  observer.announce = [](const std::string& line) { std::cout << line << '\n'; };

  workflow::RecordRequest recording;
  recording.script = argv[1];
  recording.folder = argv[2];
  recording.force = true;
  const workflow::RecordReport recorded = workflow::record(recording, observer);

  workflow::FocusRequest focusing;
  focusing.input.path = recorded.products.at(0).recording.value().file;
  focusing.output = std::string(argv[2]) + "/image.img";
  focusing.force = true;
  const workflow::FocusReport focused = workflow::focus(focusing, observer);

  workflow::MeasureRequest measuring;
  measuring.image = focusing.output;
  const workflow::MeasureReport measured = workflow::measure(measuring, observer);
  const auto right = [](const workflow::MeasuredTarget& target) {
    return target.found && std::abs(target.phase_error_rad()) < 0.02 && std::abs(target.amplitude_error_db()) < 0.2;
  };
  const auto count = std::ranges::count_if(measured.targets, right);
  std::cout << focused.image.image.azimuth.count << " rows, " << count << " of " << measured.targets.size()
            << " targets as they should be\n";
  return !measured.targets.empty() && count == std::ssize(measured.targets) ? 0 : 1;
} catch (const core::InvalidRequest& refused) {
  for (const core::Problem& problem : refused.problems) std::cerr << to_string(problem) << '\n';
  return 2;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
