#include <fmt/format.h>

#include "scene/schema/scene_grammar.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

namespace {

void read_option(FieldReader& reader, options_grammar::Key key, RunOptions& options) {
  switch (key) {
    case options_grammar::Key::profile:
      reader.choice(options_grammar::profile, options_grammar::profiles, options.profile);
      break;
    case options_grammar::Key::seed: reader.seed(options_grammar::seed, options.seed); break;
    case options_grammar::Key::pulse:
      reader.choice(options_grammar::pulse, options_grammar::pulses, options.pulse);
      break;
    case options_grammar::Key::tolerance: reader.number(options_grammar::tolerance, options.tolerance); break;
  }
}

}  // namespace

void read_options(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "options", 0);
  reader.note_object();
  std::array<bool, options_grammar::keys.size()> given{};
  while (reader.more()) {
    const Token token = reader.peek();
    options_grammar::Key key{};
    reader.choice(options_grammar::key, options_grammar::keys, key);
    if (reader.broken()) break;
    bool& again = given[static_cast<std::size_t>(key)];
    if (again)
      reader.warning(token, options_grammar::key,
                     {"the option is given twice; the last one counts", shown(token.text)});
    again = true;
    read_option(reader, key, scene.options);
  }
  reader.finish();
}

}  // namespace sarsim::scene::script
