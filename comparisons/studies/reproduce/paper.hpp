#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/io/dataset/dataset.hpp"
#include "comparisons/io/dataset/published_values.hpp"

namespace rebound {

/// One core at one nominal speed, every number with its printed precision.
struct PaperShot {
  double speed = 0.0;             ///< nominal [m/s]
  PrintedNumber restitution;      ///< measured, Table 5 [-]
  PrintedNumber contact_time;     ///< measured, Table 5 [s]
  PrintedNumber mean_deflection;  ///< measured x_R, Table 4 [m]
  PublishedAtSpeed published;     ///< fitted or computed by the authors
};

struct PaperCore {
  std::string name;                ///< "A"
  PrintedNumber mass;              ///< Table 1 [kg]
  PrintedNumber diameter;          ///< Table 1 [m]
  PrintedNumber block_modulus;     ///< Table 2 [Pa]
  PrintedNumber platen_stiffness;  ///< Table 2, experimental κ_H [N/m^1.5]
  PublishedValues published;
  std::vector<PaperShot> shots;  ///< by speed, ascending
};

/// A number the paper states in its text.
struct Claim {
  std::string id;       ///< what it is of; claim_values() computes it
  std::string section;  ///< "Section 4.4", "Abstract"
  std::string quantity;
  std::string unit;  ///< "ms", "%" or "1"
  enum class Relation { equals, below, above } relation = Relation::equals;
  PrintedNumber value;
};

/// The stiffness sweep of section 4.5.
struct ParameterStudy {
  double mass = 0.0;               ///< [kg]
  double speed = 0.0;              ///< [m/s]
  double restitution = 0.0;        ///< put into Eq. (8) [-]
  double lowest_stiffness = 0.0;   ///< [N/m^1.5]
  double highest_stiffness = 0.0;  ///< [N/m^1.5]
};

struct Paper {
  std::vector<PaperCore> cores;
  std::vector<PooledPeak> typical_peaks;  ///< by speed, ascending
  std::vector<Claim> claims;
  ParameterStudy parameter_study;
  PrintedNumber standard_mass;      ///< of the game's ball, section 1 [kg]
  PrintedNumber standard_diameter;  ///< [m]

  std::size_t speeds() const { return cores.front().shots.size(); }
  double speed(std::size_t index) const { return cores.front().shots[index].speed; }
};

/// Reads the four cores (dataset.toml, published_model_values.toml) and the
/// claims of the text (sliotar-paper/claims.toml) below one folder.
///
/// Caution: a number's digits are its precision; files must keep trailing zeros.
/// Errors: Error(bad_input) with file and key, also where the measured and the
/// published speeds of a core differ; Error(input_output_failed).
Paper read_paper(const std::filesystem::path& data_folder);

/// The text of all files read_paper() reads, in order: for digests.
std::string paper_text(const std::filesystem::path& data_folder);

}  // namespace rebound
