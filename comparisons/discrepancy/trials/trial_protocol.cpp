#include "comparisons/discrepancy/trials/trial_protocol.hpp"

#include <fmt/format.h>

#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/results/provenance.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t digest_digits = 12;

Json rules_json(const SelectionRules& rules) {
  // By all members at once: a threshold that is added there does not compile here without its name.
  const auto& [gap_level, candidate_level, close, adequate_p, score, singles, faults, pairs, most,
               draws, inclusion] = rules;
  return {{"false_gap_level", gap_level}, {"candidate_level", candidate_level},
          {"close_criterion", close},     {"smallest_adequate_p", adequate_p},
          {"least_likely_score", score},  {"fitted_singles", singles},
          {"fitted_faults", faults},      {"fitted_pairs", pairs},
          {"most_effects", most},         {"bootstrap_draws", draws},
          {"least_inclusion", inclusion}};
}

}  // namespace

TrialProtocol protocol_of_this_program(std::uint64_t seed, bool ask_fem) {
  return {.version = to_json(Provenance{}).at("version"),
          .program_sha256 = sha256(bytes_of("/proc/self/exe")),
          .rules = {},
          .seed = seed,
          .ask_fem = ask_fem};
}

Json to_json(const TrialProtocol& protocol) {
  const Json rules = rules_json(protocol.rules);
  return {{"schema", 1},
          {"version", protocol.version},
          {"program_sha256", protocol.program_sha256},
          {"rules", rules},
          {"rules_sha256", sha256(dump(rules))},
          {"seed", protocol.seed},
          {"ask_fem", protocol.ask_fem}};
}

std::string protocol_digest(const Json& protocol) {
  return sha256(dump(protocol)).substr(0, digest_digits);
}

std::string describe_protocol(const Json& protocol) {
  constexpr std::size_t shown = 12;
  const auto start = [&](const char* key) {
    return protocol.at(key).get<std::string>().substr(0, shown);
  };
  return fmt::format("version {}, thresholds {}, program {}, seed {}{}",
                     protocol.at("version").get<std::string>(), start("rules_sha256"),
                     start("program_sha256"), protocol.at("seed").get<std::uint64_t>(),
                     protocol.value("ask_fem", false) ? ", FE asked" : "");
}

void refuse_several(const TrialProtocols& protocols, const std::string& file) {
  if (protocols.size() < 2) return;
  std::string list;
  for (const auto& [digest, protocol] : protocols)
    list += fmt::format("{}{}", list.empty() ? "" : "; ", describe_protocol(protocol));
  throw Error(ExitCode::bad_input, "outcomes would be of more than one protocol: " + list,
              {.file = file,
               .key = "--mixed",
               .allowed = "outcomes of one program and its thresholds, or --mixed"});
}

}  // namespace rebound
