#pragma once

#include <optional>
#include <vector>

#include "fem/contact/adhesive_layer.hpp"
#include "fem/contact/free_plate.hpp"
#include "fem/discretisation/discretisation.hpp"

namespace rebound::fem {

/// What the plate and the body did to each other over one step.
struct PlateStep {
  double impulse = 0.0;          ///< on the body, away from the plate, adhesion not in it [N s]
  double pull = 0.0;             ///< impulse of adhesion, towards the plate [N s]
  double constraint_work = 0.0;  ///< done on body and plate together, ≤ 0 [J]
  double friction_work = 0.0;    ///< done on the body by friction, ≤ 0 in the mean [J]
  double contact_radius = 0.0;   ///< largest radius of a node in contact; 0: none [m]
  double reading = 0.0;          ///< impulse on the load cell; rigid plate: not set [N s]
};

/// Time span of one central-difference step.
struct StepSpan {
  double kick = 0.0;   ///< ½ (Δtₙ₋₁ + Δtₙ): over which forces change velocity [s]
  double drift = 0.0;  ///< Δtₙ: over which velocity changes position [s]
};

/// Where the plate is and what energy it has, at one instant.
struct PlateState {
  double displacement = 0.0;  ///< away from the ball [m]
  double velocity = 0.0;      ///< over the step to come [m/s]
  double kinetic = 0.0;       ///< [J]
  double spring = 0.0;        ///< [J]
  double damper = 0.0;        ///< dissipated so far [J]
};

/// What touching the plate brings beside being held.
struct PlateSurface {
  double friction = 0.0;      ///< μ [-]
  AdhesiveTraction adhesion;  ///< with its range chosen
};

/// A plate at z = 0 that acts on the nodes of the contact group.
///
/// Coulomb friction acts on the nodes that the plate pushes:
///
///   I_t = −sign(v_r) min(m |v_r|, μ I),   work = I_t (v_r,before + v_r')/2
///
///   v_r  radial velocity without friction, v_r' with it [m/s]
///   I    normal impulse of the step [N s];  μ  coefficient [-]
///
/// A node sticks where the impulse that stops it is within the cone, and slides
/// otherwise; no regularisation.
/// Limit:  μ = 0 leaves every bit; a large μ stops every node that touches
///         -> tests FrictionTest, FrictionImpact.
/// Caution: a step without normal impulse has no friction; with the contact's
///          ripple a sticking node may creep at the edge of the contact.
///
/// Where there is adhesion, it pulls on every node within its range, those that the
/// plate pushes included: the normal impulse of friction is then the greater by it.
class PlateContact {
 public:
  explicit PlateContact(const Discretisation& body, const PlateSurface& surface = {});
  virtual ~PlateContact() = default;

  /// Keeps the normal and radial velocities that the step's forces are about to change.
  void remember(const std::vector<double>& velocity);

  /// Corrects `velocity` of the nodes that would penetrate. Displacement and
  /// velocity are [node][2] (r, z).
  virtual PlateStep apply_contact(const std::vector<double>& displacement,
                                  std::vector<double>& velocity, const StepSpan& span) = 0;

  /// Moves the plate itself over the step.
  virtual void drift(double) {}

  virtual PlateState state() const { return {}; }

  /// Whether a body that is not touched now will not be touched again.
  virtual bool is_clear_of(const std::vector<double>& displacement,
                           const Departure& body) const = 0;

  /// Potential of adhesion, against that at rest, first touch [J].
  double adhesive_energy(const std::vector<double>& displacement) const;

  /// Smallest height above z = 0 of a node that may touch [m].
  double gap(const std::vector<double>& displacement) const;

 protected:
  struct ContactNode {
    int node;
    double r, z, mass;
  };
  /// Friction on contact node `i`, pushed by `impulse`; adds it to `step`.
  void rub(std::size_t i, double impulse, std::vector<double>& velocity, PlateStep& step) const;

  /// Adhesion over the step, into `velocity`; the plate's surface is at z = −`plate`. [N s]
  double attract(const std::vector<double>& displacement, double plate, const StepSpan& span,
                 std::vector<double>& velocity) const;

  std::vector<ContactNode> nodes_;
  std::vector<double> velocity_before_;
  std::vector<double> radial_before_;

 private:
  double potential(const std::vector<double>& displacement, double plate) const;

  double friction_;
  std::optional<AdhesiveLayer> adhesion_;
  double potential_at_rest_ = 0.0;
};

}  // namespace rebound::fem
