#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/dataset/dataset.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"
#include "comparisons/models/effects/effect.hpp"
#include "fem/interface/fem_problem.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

enum class Tier { lumped, fem };

/// Which impacts a synthetic experiment holds, and what is seen of each.
struct SynthesisShot {
  double speed = 0.0;  ///< nominal, as the data set will state it [m/s]
  int repeats = 1;
  bool history = true;                             ///< is the force history recorded
  std::optional<double> speed_uncertainty;         ///< one standard deviation [m/s]
  std::optional<double> restitution_uncertainty;   ///< given: restitution is measured as well
  std::optional<double> contact_time_uncertainty;  ///< given: contact time is measured as well [s]
};

/// How the force is sampled.
struct SynthesisSampling {
  double rate = 200e3;          ///< [Hz]
  double before = 0.2e-3;       ///< recorded before first touch [s]
  double after = 0.5e-3;        ///< recorded after separation [s]
  double trigger_jitter = 0.0;  ///< one standard deviation of first touch in the record [s]
};

/// Effects that are drawn, of which the file does not say which.
struct RandomEffects {
  int count = 0;
  std::vector<std::string> among;  ///< empty: all that the tier has a form for, but free forms
};

/// A whole synthetic experiment: a model of either tier with effects, an
/// instrument, shots. Stated uncertainties are honest: true gain, mass and
/// speeds are drawn from them.
struct SynthesisFile {
  std::string name = "synthetic experiment";
  std::int64_t seed = 1;
  Sphere sphere;
  double mass_uncertainty = 0.0;  ///< [kg]
  Tier tier = Tier::lumped;
  LumpedModel lumped;  ///< of the lumped tier
  FemProblem fem;      ///< of the FE tier; its sphere and impact are not used
  std::vector<EffectChoice> effects;
  RandomEffects random;
  Instrument instrument;
  SynthesisSampling sampling;
  std::vector<SynthesisShot> shots;
};

void describe(Visitor& visit, SynthesisShot& shot);
void describe(Visitor& visit, SynthesisSampling& sampling);
void describe(Visitor& visit, RandomEffects& random);
void describe(Visitor& visit, SynthesisFile& file);

/// Reads a synthesis file. A plain impact file is one too: its one impact,
/// recorded by an ideal instrument.
/// Errors: Error(bad_input) also for no shots, or a shot of which nothing is seen.
SynthesisFile read_synthesis(const Document& document);

/// A synthesis file as written, and every check that follows a reading, for whoever changes its
/// numbers in between: density, shots, the mesh's path.
/// Errors: as above, with the place in `document`.
SynthesisFile read_uncompleted_synthesis(const Document& document);
void complete_synthesis(const Document& document, SynthesisFile& file);

}  // namespace rebound
