#include "comparisons/discrepancy/synthesis/truth.hpp"

#include <fmt/format.h>
#include <openssl/rand.h>

#include <array>

#include "comparisons/io/results/digest.hpp"

namespace rebound {

Json truth_json(const SynthesisFile& file, const std::string& file_text, const Synthesis& made) {
  Json effects = Json::array();
  for (const EffectChoice& effect : file.effects) {
    Json parameters = Json::object();
    for (const auto& [name, value] : effect.parameters) parameters[name] = value;
    effects.push_back({{"name", effect.name}, {"size", effect.size}, {"parameters", parameters}});
  }
  Json shots = Json::array();
  for (const HiddenShot& shot : made.hidden) {
    shots.push_back({{"speed_m_s", shot.speed},
                     {"restitution", shot.scalars.restitution},
                     {"contact_time_s", shot.scalars.contact_time},
                     {"peak_force_N", shot.scalars.peak_force},
                     {"peak_deflection_m", shot.scalars.peak_deflection}});
    if (shot.cells > 0) shots.back()["cells"] = shot.cells;
  }
  return {{"schema", 1},
          {"name", file.name},
          {"tier", file.tier == Tier::fem ? "fem" : "lumped"},
          {"effects", effects},
          {"seed", file.seed},
          {"mass_kg", made.true_mass},
          {"force_gain", made.true_force_gain},
          {"shots", shots},
          {"file", file_text}};
}

SealedTruth seal(Json truth) {
  std::array<unsigned char, 32> nonce{};
  if (RAND_bytes(nonce.data(), static_cast<int>(nonce.size())) != 1)
    throw Error(ExitCode::input_output_failed, "the system gives no random numbers for a nonce");
  std::string digits;
  for (const unsigned char byte : nonce) digits += fmt::format("{:02x}", byte);
  truth["nonce"] = digits;
  SealedTruth sealed{.truth = dump(truth), .seal = {}};
  sealed.seal = dump({{"schema", 1},
                      {"sha256", sha256(sealed.truth)},
                      {"of", "the bytes of the truth file, which holds a 256-bit nonce"}});
  return sealed;
}

}  // namespace rebound
