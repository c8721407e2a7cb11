#include <fmt/format.h>

#include "scene/schema/scene_grammar.hpp"
#include "scene/script/read_commands.hpp"

namespace sarsim::script {

namespace {

namespace grammar = options_grammar;

void read_option(FieldReader& reader, grammar::Key key, RunOptions& options) {
  switch (key) {
    case grammar::Key::profile: reader.choice(grammar::profile, grammar::profiles, options.profile); break;
    case grammar::Key::seed: reader.seed(grammar::seed, options.seed); break;
    case grammar::Key::pulse: reader.choice(grammar::pulse, grammar::pulses, options.pulse); break;
    case grammar::Key::tolerance: reader.number(grammar::tolerance, options.tolerance); break;
  }
}

}  // namespace

void read_options(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "options", 0);
  reader.note_object();
  std::array<bool, grammar::keys.size()> given{};
  while (reader.more()) {
    const Token token = reader.peek();
    grammar::Key key{};
    reader.choice(grammar::key, grammar::keys, key);
    if (reader.broken()) break;
    bool& again = given[static_cast<std::size_t>(key)];
    if (again)
      reader.warning(token, grammar::key, {"the option is given twice; the last one counts", shown(token.text)});
    again = true;
    read_option(reader, key, scene.options);
  }
  reader.finish();
}

}  // namespace sarsim::script
