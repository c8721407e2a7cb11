#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

namespace {

void write_receive_antenna(ScriptLines& lines, const Radar& radar) {
  if (radar.same_antenna)
    lines.field(field_of<&Radar::same_antenna>(), radar);
  else
    lines.field(field_of<&Radar::receive_antenna, &Antenna::pattern>(), radar);
  lines.fields(radar_order().receive_antenna, radar);
}

void write_stc(ScriptLines& lines, const Radar& radar) {
  if (radar.stc != Radar::Stc::none) lines.value(stc_switch, stc_switch_meaning);
  lines.field(field_of<&Radar::stc>(), radar);
  lines.fields(radar_order().stc, radar);
}

}  // namespace

void write_command(ScriptLines& lines, const Radar& radar) {
  lines.plain("$RADAR");
  lines.field(field_of<&Radar::name>(), radar);
  lines.fields(radar_order().up_to_power, radar);
  // Programs before 2015 know no gains; a radar without any stays readable for them.
  if (radar.transmit_gain.db() != 0.0 || radar.receive_gain.db() != 0.0) lines.fields(radar_order().gains, radar);
  lines.fields(radar_order().losses, radar);
  lines.fields(radar_order().transmit_antenna, radar);
  write_receive_antenna(lines, radar);
  lines.fields(radar_order().direction_and_window, radar);
  write_stc(lines, radar);
  lines.blank(2);
}

}  // namespace sarsim::scene::script
