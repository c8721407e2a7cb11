#include "raster/cphd/phase_vector.hpp"

#include "raster/cphd/big_endian.hpp"

namespace sarsim::raster {

namespace {

using V = PhaseVector;

constexpr std::size_t word = 8;

constexpr PvpField number(std::string_view name, double V::*member, bool optional = false) {
  return {.name = name, .words = 1, .optional = optional, .number = member};
}
constexpr PvpField place(std::string_view name, core::Vec3 V::*member) {
  return {.name = name, .words = 3, .optional = false, .place = member};
}

constexpr std::array<PvpField, 19> fields{{number("TxTime", &V::tx_time_s),
                                           place("TxPos", &V::tx_m),
                                           place("TxVel", &V::tx_mps),
                                           number("RcvTime", &V::rcv_time_s),
                                           place("RcvPos", &V::rcv_m),
                                           place("RcvVel", &V::rcv_mps),
                                           place("SRPPos", &V::srp_m),
                                           number("AmpSF", &V::amplitude, true),
                                           number("aFDOP", &V::doppler),
                                           number("aFRR1", &V::rate1),
                                           number("aFRR2", &V::rate2),
                                           number("FX1", &V::fx1_hz),
                                           number("FX2", &V::fx2_hz),
                                           number("TOA1", &V::toa1_s),
                                           number("TOA2", &V::toa2_s),
                                           number("TDTropoSRP", &V::tropo_s),
                                           number("SC0", &V::first),
                                           number("SCSS", &V::step),
                                           {.name = "SIGNAL", .words = 1, .optional = true, .integer = &V::signal}}};

}  // namespace

const SignalEncodingName& entry_of(SignalEncoding encoding) {
  return *std::ranges::find(signal_encodings, encoding, &SignalEncodingName::encoding);
}

std::span<const PvpField> pvp_fields() { return fields; }

void put_pvp(const PvpField& field, const PhaseVector& vector, std::byte* to) {
  if (field.integer != nullptr) put_big_endian(vector.*field.integer, to);
  if (field.number != nullptr) put_big_endian(vector.*field.number, to);
  if (field.place == nullptr) return;
  const core::Vec3& v = vector.*field.place;
  put_big_endian(v.x, to);
  put_big_endian(v.y, to + word);
  put_big_endian(v.z, to + 2 * word);
}

void get_pvp(const PvpField& field, const std::byte* from, PhaseVector& vector) {
  if (field.integer != nullptr) vector.*field.integer = get_big_endian<std::int64_t>(from);
  if (field.number != nullptr) vector.*field.number = get_big_endian<double>(from);
  if (field.place != nullptr)
    vector.*field.place = {get_big_endian<double>(from), get_big_endian<double>(from + word),
                           get_big_endian<double>(from + 2 * word)};
}

}  // namespace sarsim::raster
