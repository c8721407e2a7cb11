#include <fmt/format.h>

#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

void read_options(Reading& reading, const Token& command, Scene& scene) {
  constexpr Field option{"", "option"};
  FieldReader reader(reading, command, "options", 0);
  reader.note_object();
  const Order<RunOptions> order = script_order<RunOptions>();
  std::vector<std::string> keys;
  for (const FieldOf<RunOptions>* const field : order) keys.push_back(option_key(field->spec));
  const std::vector<std::string_view> words(keys.begin(), keys.end());
  std::vector<bool> given(keys.size());
  while (reader.more()) {
    const Token token = reader.peek();
    const std::size_t key = reader.keyword(option, words);
    if (reader.broken()) break;
    if (given[key])
      reader.warning(token, option, {"the option is given twice; the last one counts", shown(token.text)});
    given[key] = true;
    reader.read(*order[key], scene.options);
  }
  reader.finish();
}

}  // namespace sarsim::scene::script
