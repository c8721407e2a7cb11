#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulate/plan/acquisition.hpp"
#include "simulate/plan/engine_kind.hpp"

namespace sarsim::simulate {

/// The word of an engine on the command line and in files.
[[nodiscard]] std::string_view name_of(Engine engine);
/// Engines and their words, as lists of choices show them.
[[nodiscard]] std::vector<std::pair<std::string, Engine>> named_engines();
/// The engine of a word; nothing where there is none.
[[nodiscard]] std::optional<Engine> engine_from_name(std::string_view name);

/// An engine and why it was taken.
struct EngineChoice {
  Engine engine = Engine::reference;
  std::string reason;
};

/// Decides for one simulation, from counts: echoes per pulse, samples of a pulse, hard edges, Doppler terms; a few
/// pulses are examined for the span of Doppler. The same on every machine.
/// @param wanted   Engine::automatic, or an engine, which is then taken as it is
[[nodiscard]] EngineChoice choose_engine(Engine wanted, const Acquisition& acquisition);

}  // namespace sarsim::simulate
