// Another program's view of the library: makes the recordings of a script in a folder, with a few pulses of each.
//
//   library_program SCRIPT FOLDER

#include <exception>
#include <filesystem>
#include <iostream>

#include "core/report/refused.hpp"
#include "workflow/record/record.hpp"

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  sarsim::workflow::RecordRequest request;
  request.script = argv[1];
  request.folder = argv[2];
  request.overrides.format = sarsim::scene::FileFormat::binary;
  request.overrides.settings = {"Simulation1.time_start=0s", "Simulation1.time_end=0.02s"};
  request.products = {"1"};
  request.force = true;
  sarsim::core::Observer observer;
  observer.announce = [](const std::string& line) { std::cout << line << '\n'; };
  const sarsim::workflow::RecordReport report = sarsim::workflow::record(request, observer);
  const sarsim::workflow::RecordingReport& recording = report.products.at(0).recording.value();
  std::cout << recording.run.rows << " x " << recording.run.columns << " samples in " << recording.file << '\n';
  const auto bytes = std::filesystem::file_size(recording.file);
  return recording.run.rows > 0 && recording.run.maximum_v > 0.0 && static_cast<double>(bytes) == recording.bytes ? 0
                                                                                                                  : 1;
} catch (const sarsim::core::Refused& refused) {
  for (const sarsim::core::Problem& problem : refused.problems) std::cerr << to_string(problem) << '\n';
  return 2;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
