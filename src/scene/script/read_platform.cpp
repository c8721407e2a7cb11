#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

void read_platform(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "platform", scene.platforms.size());
  Platform platform;
  if (reader.leading_name(field_of<&Platform::name>().in_script, platform.name)) {
    reader.read(platform_order().path, platform);
    // The 1997 programs knew neither the keyword nor the rates.
    if (reader.more() && begins_like_number(reader.peek().text))
      reader.read(field_of<&Platform::rotation>(), platform);
    else
      reader.read(platform_order().rotation, platform);
    reader.read(platform_order().errors, platform);
    scene.platforms.push_back(std::move(platform));
  }
  reader.finish();
}

}  // namespace sarsim::scene::script
