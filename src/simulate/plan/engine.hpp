#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "radar/echo/echo_batch.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// How echoes are added up. All compute the same definition of a row; the choice is a matter of speed.
enum class Engine {
  automatic,
  reference,  ///< Plain double-precision sum (radar/echo/reference_kernel.hpp).
  direct,     ///< Sample by sample in SIMD (radar/echo/direct_kernel.hpp).
  spectral,   ///< Non-uniform Fourier transform (radar/echo/spectral_kernel.hpp).
};

/// The word of an engine on the command line and in files.
[[nodiscard]] std::string_view name_of(Engine engine);
/// The engine of a word; nothing where there is none.
[[nodiscard]] std::optional<Engine> engine_from_name(std::string_view name);

/// An engine and why it was taken.
struct EngineChoice {
  Engine engine = Engine::reference;
  std::string reason;
};

/// Decides for one simulation, from counts: echoes per pulse, samples of a pulse, hard edges, Doppler terms. The same
/// on every machine.
/// @param wanted   Engine::automatic, or an engine, which is then taken as it is
/// @param pulses   of the simulation; a few of them are looked at for the span of Doppler
[[nodiscard]] EngineChoice choose_engine(Engine wanted, const ResolvedScene& scene, const ResolvedRadar& radar,
                                         const radar::EchoPulse& pulse, const radar::SampleGrid& grid,
                                         const radar::PulseRange& pulses, double tolerance);

}  // namespace sarsim::simulate
