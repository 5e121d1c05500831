#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// A number as printed: every value within half a unit of its last digit
/// would have been printed the same.
struct PrintedNumber {
  double value = 0.0;       ///< [SI]
  double half_width = 0.0;  ///< [SI]
};

/// What a paper fitted or computed for one ball at one speed. Nothing here is
/// measured.
struct PublishedAtSpeed {
  double speed = 0.0;                   ///< nominal [m/s]
  PrintedNumber hunt_crossley_damping;  ///< λ, by Eq. (8) [N s/m^2.5]
  PrintedNumber linear_damping;         ///< c_eq, Eq. (15) [N s/m]
  PrintedNumber linear_stiffness;       ///< k_eq, Eq. (15) [N/m]
  PrintedNumber damping_factor;         ///< ξ, Eq. (16) [-]
  PrintedNumber linear_contact_time;    ///< Eq. (12) [s]
  PrintedNumber linear_restitution;     ///< Eq. (13) [-]
};

struct PublishedValues {
  std::string name;
  std::string source;
  PrintedNumber poisson_ratio;            ///< assumed by the authors [-]
  PrintedNumber hertz_stiffness;          ///< κ_H from the block modulus, Eq. (10) [N/m^1.5]
  PrintedNumber hunt_crossley_stiffness;  ///< κ, fitted to all impacts [N/m^1.5]
  std::vector<PublishedAtSpeed> at_speed;
};

void describe(Visitor& visit, PublishedAtSpeed& at_speed);
void describe(Visitor& visit, PublishedValues& values);

/// Reads published_model_values.toml of a data-set folder.
/// Errors: Error(bad_input), Error(input_output_failed) as read_document().
PublishedValues read_published_values(const std::filesystem::path& folder);

/// The number at a key path of any document, with its printed precision:
/// "3.50e6 N/m^1.5" is ±0.005e6, 0.527 is ±0.0005.
///
/// Caution: trailing zeros count, so a file must keep those of its source.
/// Errors: Error(bad_input) when there is no number at that path.
PrintedNumber printed_number(const Document& document, const std::string& key);

}  // namespace rebound
