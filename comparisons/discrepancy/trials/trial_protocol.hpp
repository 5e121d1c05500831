#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// What outcomes are made with: the frozen thresholds, and the program that applied them. Outcomes
/// of two protocols are no sample of one error rate.
struct TrialProtocol {
  std::string version;         ///< of the program
  std::string program_sha256;  ///< of its file: any change of the search is another protocol
  SelectionRules rules;
  std::uint64_t seed = 1;  ///< of the draws behind the thresholds
  bool ask_fem = false;    ///< may a diagnosis ask FE?
};

/// That of this program as it runs, with the thresholds of a diagnosis.
/// Errors: Error(input_output_failed) where the program's file cannot be read.
TrialProtocol protocol_of_this_program(std::uint64_t seed, bool ask_fem = false);

/// With "rules_sha256", of the thresholds alone.
Json to_json(const TrialProtocol& protocol);

/// Protocols by their digest: the first twelve digits of SHA-256 over the text of the JSON.
using TrialProtocols = std::map<std::string, Json>;
std::string protocol_digest(const Json& protocol);

/// In one line: version and digests.
std::string describe_protocol(const Json& protocol);

/// Errors: Error(bad_input) at `file` where there is more than one.
void refuse_several(const TrialProtocols& protocols, const std::string& file);

}  // namespace rebound
