#pragma once

#include <optional>
#include <string>
#include <vector>

namespace trials {

/// One viscoelastic branch of a ball in finite elements.
struct FemBranch {
  double ratio = 0.0;  ///< over the long-term modulus
  double time = 0.0;   ///< [s]
  bool deviator_alone = false;
  double rate_exponent = 1.0;  ///< flow strain grows as rate to this power; near 0: it yields
  double reference_strain = 0.1;
};

/// One term of an energy of principal stretches.
struct StretchShare {
  double weight = 1.0;
  double exponent = 2.0;
};

/// From a distance to the centre outward.
struct FemLayer {
  double from = 0.0;  ///< over the radius
  double modulus_factor = 1.0;
};

/// A plate that the load cell carries.
struct FemPlate {
  double stiffness = 0.0;  ///< [N/m]
  double mass = 0.0;       ///< [kg]
  double damping_ratio = 0.02;
};

/// A surface that sticks.
struct StickySurface {
  double work = 0.0;   ///< of adhesion [J/m²]
  double range = 0.0;  ///< [m]
};

/// What a ball of finite size is made of, and what it hits; numbers of a deck for `rebound fem`.
struct FemBall {
  std::string material;  ///< in words, for scores: no comma
  std::string elastic = "neo-hookean";
  double modulus = 0.0;  ///< Young's, long-term [Pa]
  double poisson_ratio = 0.3;
  double second_share = 0.0;  ///< of Mooney–Rivlin
  std::vector<StretchShare> terms;
  std::vector<FemBranch> branches;
  std::vector<FemLayer> layers;
  double mullins = 0.0;
  double friction = 0.0;
  std::optional<FemPlate> plate;
  std::optional<StickySurface> sticky;
};

/// Cells that say what can be seen of an effect, and those that data are computed on: fine enough
/// that nodes which touch one by one leave no ripple in the noise of a trial.
inline constexpr int cells_of_visibility = 2500, cells_of_data = 10'000;

/// One impact of such a ball.
struct FemImpact {
  double mass = 0.0;    ///< [kg]
  double radius = 0.0;  ///< [m]
  double speed = 0.0;   ///< [m/s]
  int cells = cells_of_visibility;
};

/// A model file of such a ball: what it is made of alone, on a mesh that the reader chooses.
std::string fem_model_text(const FemBall& ball);

/// The deck of one impact.
std::string deck_text(const FemBall& ball, const FemImpact& impact);

}  // namespace trials
