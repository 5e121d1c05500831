#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/toml/visitor.hpp"
#include "fem/interface/material.hpp"

namespace rebound {

/// A mean of the nominal stress over a range of compressive strain; a single
/// strain where both ends are the same.
struct StatedStress {
  double strain_from = 0.0;  ///< 1 − λ [-]
  double strain_to = 0.0;
  double mean_stress = 0.0;  ///< compressive [Pa]
  double uncertainty = 0.0;  ///< [Pa]; 0: the source's own formula, exact
};

/// What the source says of the foam, apart from its constants.
struct StatedValues {
  double youngs_modulus = 0.0;              ///< at small strain, slowly [Pa]
  double youngs_modulus_uncertainty = 0.0;  ///< [Pa]; 0: follows from the constants
  std::optional<double> poisson_ratio;
  std::vector<StatedStress> stresses;
};

/// A published foam: constants in this program's terms, and what they must give.
struct PublishedFoam {
  std::string name;
  std::string source;
  Material material;
  StatedValues stated;
};

void describe(Visitor& visit, StatedStress& stress);
void describe(Visitor& visit, StatedValues& stated);
void describe(Visitor& visit, PublishedFoam& foam);

PublishedFoam read_foam(const std::filesystem::path& file);

/// Those that ship with the program, by file name.
std::vector<PublishedFoam> published_foams();

}  // namespace rebound
