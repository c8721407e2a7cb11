#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "scene/model/object_id.hpp"
#include "scene/model/scene.hpp"

/// The one list of the kinds of objects that a scene holds. A new kind is its struct and list in scene.hpp, a word here
/// in ObjectKind and an entry in `kinds`; code that treats all kinds alike loops over that.
namespace sarsim::scene {

/// A kind of object: its names and its list in a scene.
template <class Object>
struct Kind {
  ObjectKind kind;
  std::string_view name;     ///< As in core::Subject::kind: "geometry".
  std::string_view title;    ///< For people, as the first word of a sentence: "Geometry table".
  std::string_view command;  ///< Of the script language, without `$`.
  std::string_view meaning;
  std::vector<Object> Scene::*list;

  /// Others mean it by its name.
  static constexpr bool is_named = requires(Object object) { object.name; };
  /// It is carried by a platform, which it means by name.
  static constexpr bool stands_on_platform = requires(Object object) { object.platform; };
  /// It says what is made of a radar's echoes or pulses, and means the radar by name.
  static constexpr bool belongs_to_radar = requires(Object object) { object.radar; };
};

/// All of them, in the order of ObjectKind.
inline constexpr std::tuple kinds{
    Kind<Platform>{ObjectKind::platform, "platform", "Platform", "PLATFORM", "A frame that carries targets and radars.",
                   &Scene::platforms},
    Kind<Target>{ObjectKind::target, "target", "Target", "TARGET", "A point that reflects.", &Scene::targets},
    Kind<Cloud>{ObjectKind::cloud, "cloud", "Cloud", "CLOUD", "Points that reflect, from a table in a file.",
                &Scene::clouds},
    Kind<Surface>{ObjectKind::surface, "surface", "Surface", "SURFACE", "A triangle that reflects.", &Scene::surfaces},
    Kind<Radar>{ObjectKind::radar, "radar", "Radar", "RADAR", "A transmitter and receiver.", &Scene::radars},
    Kind<Simulation>{ObjectKind::simulation, "simulation", "Simulation", "SIMULATION", "A recording to be made.",
                     &Scene::simulations},
    Kind<GeometryTable>{ObjectKind::geometry, "geometry", "Geometry table", "GEOMETRY",
                        "A table of delays, amplitudes and speeds to be made.", &Scene::geometries}};

/// A table of which a scene has one: `[world]`.
template <class Table>
struct Single {
  std::string_view header;   ///< In format 2, and `Subject::kind`.
  std::string_view command;  ///< Of the script language, without `$`; empty: it cannot say it.
  std::string_view meaning;
  Table Scene::*member;
};

/// All of them, in the order in which they are read: positions depend on the world.
inline constexpr std::tuple singles{
    Single<World>{"world", "", "Where and when the scene is: on a plane, or on the turning Earth.", &Scene::world},
    Single<Atmosphere>{"atmosphere", "", "What lies between radars and targets: air, rain, the ionosphere.",
                       &Scene::atmosphere},
    Single<RunOptions>{"options", "OPTIONS", "Settings for all outputs of the scene; the command line overrides them.",
                       &Scene::options}};

/// Calls `visit` with each Single.
template <class Visit>
constexpr void for_each_single(Visit&& visit) {
  std::apply([&](const auto&... single) { (visit(single), ...); }, singles);
}

/// Whether a header is that of a single table.
[[nodiscard]] constexpr bool is_single(std::string_view header) {
  bool found = false;
  for_each_single([&](const auto& single) { found = found || single.header == header; });
  return found;
}

inline constexpr std::size_t kind_count = std::tuple_size_v<decltype(kinds)>;

inline constexpr std::array<ObjectKind, kind_count> all_object_kinds =
    std::apply([](const auto&... kind) { return std::array{kind.kind...}; }, kinds);

/// The order in which scripts are written.
inline constexpr std::array<ObjectKind, kind_count> written_object_kinds{
    ObjectKind::platform, ObjectKind::surface,    ObjectKind::target,  ObjectKind::cloud,
    ObjectKind::radar,    ObjectKind::simulation, ObjectKind::geometry};

/// Calls `visit` with each Kind, in the order of ObjectKind.
template <class Visit>
constexpr void for_each_kind(Visit&& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (visit(std::get<I>(kinds)), ...); }
  (std::make_index_sequence<kind_count>{});
}

/// Calls `visit` with the Kind that is meant and returns what it returns.
template <std::size_t First = 0, class Visit>
constexpr decltype(auto) visit_kind(ObjectKind kind, Visit&& visit) {
  static_assert(std::get<First>(kinds).kind == static_cast<ObjectKind>(First));
  if constexpr (First + 1 < kind_count) {
    if (kind != static_cast<ObjectKind>(First)) return visit_kind<First + 1>(kind, std::forward<Visit>(visit));
  } else if (kind != static_cast<ObjectKind>(First)) {
    throw std::logic_error("no such kind of object");
  }
  return visit(std::get<First>(kinds));
}

/// Calls `visit` with the scene's list of a kind and returns what it returns.
template <class SceneType, class Visit>
decltype(auto) visit_list(SceneType& scene, ObjectKind kind, Visit&& visit) {
  return visit_kind(kind, [&](const auto& known) -> decltype(auto) { return visit(scene.*known.list); });
}

/// Whether others mean an object of a kind by its name.
[[nodiscard]] constexpr bool is_named(ObjectKind kind) {
  return visit_kind(kind, [](const auto& known) { return known.is_named; });
}
/// Whether it is carried by a platform.
[[nodiscard]] constexpr bool stands_on_platform(ObjectKind kind) {
  return visit_kind(kind, [](const auto& known) { return known.stands_on_platform; });
}
/// Whether it says what is made of a radar's echoes or pulses.
[[nodiscard]] constexpr bool belongs_to_radar(ObjectKind kind) {
  return visit_kind(kind, [](const auto& known) { return known.belongs_to_radar; });
}
/// What reflects: carried by platforms, without names and perhaps a million of them.
[[nodiscard]] constexpr bool reflects(ObjectKind kind) { return stands_on_platform(kind) && !is_named(kind); }

/// The kind of object that a kind refers to by name: a radar for simulations and geometry tables, else a platform.
[[nodiscard]] constexpr ObjectKind carrier_kind(ObjectKind kind) {
  return belongs_to_radar(kind) ? ObjectKind::radar : ObjectKind::platform;
}

namespace detail {

template <class... Objects>
std::variant<Objects...> any_of_kinds(const std::tuple<Kind<Objects>...>&);
template <class... Objects>
std::variant<std::monostate, std::shared_ptr<const Objects>...> kept_of_kinds(const std::tuple<Kind<Objects>...>&);

}  // namespace detail

/// Any object by value. The alternatives stand in the order of ObjectKind.
using AnyObject = decltype(detail::any_of_kinds(kinds));

}  // namespace sarsim::scene
