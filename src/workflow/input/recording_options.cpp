#include "workflow/input/recording_options.hpp"

#include <limits>

namespace sarsim::workflow {

OptionTable<SceneOverrides> run_choice_options() {
  using scene::Profile;
  using scene::PulseDefinition;
  OptionTable<SceneOverrides> table;
  table.choice<Profile>("--profile", {{"physical", Profile::physical}, {"classic", Profile::classic}},
                        "conventions: today's physics, or those of the 1998 programs", &SceneOverrides::profile);
  table.choice<PulseDefinition>("--pulse",
                                {{"ideal", PulseDefinition::ideal}, {"band-limited", PulseDefinition::band_limited}},
                                "hard-edged pulses, or pulses confined to their band", &SceneOverrides::pulse);
  table.number("--tolerance", "X", "relative error that fast engines may make", &SceneOverrides::tolerance);
  table.whole("--seed", 0, std::numeric_limits<std::uint64_t>::max(), "of the random numbers", &SceneOverrides::seed);
  table.texts("--targets", "[PLATFORM=]CSV", "targets to add, from a table of x, y, z and cross-section; repeat",
              [](SceneOverrides& overrides, const std::string& word) { overrides.targets.push_back(word); });
  return table;
}

OptionTable<SceneOverrides> scene_override_options() {
  OptionTable<SceneOverrides> table = run_choice_options();
  table.texts("--set", "FIELD=VALUE", "a field of the script and its value, as Radar1.bandwidth=10MHz; repeat",
              [](SceneOverrides& overrides, const std::string& word) { overrides.settings.push_back(word); });
  table.texts("--let", "NAME=VALUE", "a name of [let] and its value, as speed=300; repeat",
              [](SceneOverrides& overrides, const std::string& word) { overrides.let.push_back(word); });
  return table;
}

OptionTable<RecordingArguments> script_file_option() {
  OptionTable<RecordingArguments> table;
  table.text("--script", "SCENE", "script that wrote the file of samples, where it carries none",
             &RecordingArguments::script);
  return table;
}

OptionTable<RecordingArguments> script_options(const std::string& otherwise) {
  OptionTable<RecordingArguments> table = script_file_option();
  table.whole(
      "--simulation", 1, std::uint64_t{1} << 40,
      "which simulation of the script (default: the one with the file's name; of a script, " + otherwise + ")",
      [](RecordingArguments& arguments, std::uint64_t n) { arguments.simulation = static_cast<std::int64_t>(n); });
  table.text("--dataset", "NAME", "dataset of the samples in an HDF5 file (default: /samples)",
             &RecordingArguments::dataset);
  return table;
}

OptionTable<RecordingArguments> recording_options(const std::string& otherwise) {
  OptionTable<RecordingArguments> table = script_options(otherwise);
  table.include(scene_override_options(), &RecordingArguments::overrides);
  return table;
}

}  // namespace sarsim::workflow
