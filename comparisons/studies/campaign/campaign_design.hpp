#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

enum class DesignKind { grid, latin_hypercube, sobol };
constexpr auto names_of(DesignKind) {
  return names_list<DesignKind>({{"grid", DesignKind::grid},
                                 {"latin-hypercube", DesignKind::latin_hypercube},
                                 {"sobol", DesignKind::sobol}});
}

enum class Spacing { linear, logarithmic };
constexpr auto names_of(Spacing) {
  return names_list<Spacing>({{"linear", Spacing::linear}, {"logarithmic", Spacing::logarithmic}});
}

/// One number of the base file that is varied, between two ends or over given values [SI].
struct CampaignFactor {
  std::string key;  ///< key path in the base file
  Key about;        ///< its unit and range there
  std::optional<double> low, high;
  std::vector<double> values;
  int points = 0;  ///< of a grid, ends included
  Spacing spacing = Spacing::linear;
};

/// Which members a campaign has.
struct CampaignDesign {
  DesignKind kind = DesignKind::grid;
  std::int64_t count = 0;  ///< members of a Latin hypercube or of Sobol points
  std::int64_t seed = 1;   ///< of a Latin hypercube
  std::vector<CampaignFactor> factors;
  std::vector<Key> known;  ///< numbers that may be varied, named by their paths; set before reading
};

void describe(Visitor& visit, CampaignDesign& design);

/// The most members of a campaign.
inline constexpr std::int64_t most_members = 10'000'000;

/// What needs more than one value: ends in order, what belongs to which kind, number of members.
/// Errors: Error(bad_input) with the key.
void check_design(const Document& document, const CampaignDesign& design);

/// Members of a design that was checked.
std::size_t member_count(const CampaignDesign& design);

/// The points of a design, any of them at any time.
///
///   level u in [0, 1]   linear: low + u (high − low); logarithmic: low (high/low)^u
///   grid                u = k/(points − 1); the last factor changes fastest
///   latin-hypercube     u = (π(i) + ½)/count, π a random permutation a factor (McKay, Beckman &
///                       Conover 1979, centred cells)
///   sobol               u from Boost's Sobol sequence (Joe & Kuo 2008), without its zero point
///   values              value number ⌊u · their number⌋ but for a grid, which takes each
///
/// Limit: every cell of a Latin hypercube holds one point, the first 2ᵏ − 1 Sobol points fill every
///        binary interval but one -> tests CampaignDesignTest
/// Memory: four bytes a member and factor for a Latin hypercube, else none a member.
class DesignSampler {
 public:
  explicit DesignSampler(const CampaignDesign& design);
  ~DesignSampler();

  /// One value a factor, in SI, of member `index`.
  std::vector<double> at(std::size_t index);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace rebound
