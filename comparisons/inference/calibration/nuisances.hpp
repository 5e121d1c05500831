#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/toml/visitor.hpp"
#include "comparisons/models/instrument/measurement_chain.hpp"
#include "lumped/integration/direction.hpp"

/// What an experiment may have got wrong, as unknowns beside those of the physics.
namespace rebound {

/// The model's force at one datum with its slopes by law, mass and speed.
struct DatumWithSensitivities {
  double force = 0.0;
  std::span<const double> slopes;  ///< in the order of directions_of()
  double rate = 0.0;               ///< dF/dt, for a trigger [N/s]
  double speed = 0.0;              ///< as stated [m/s]
  double mass = 0.0;               ///< as stated [kg]
  double sigma = 1.0;
};

/// Whose error it is: one value for all shots, one a ball, one a shot.
enum class NuisanceScope { all_shots, each_ball, each_shot };

/// One error ε of the measuring chain.
struct NuisanceKind {
  std::string name;                 ///< "gain"; a key of [nuisance] where a file may ask for it
  std::string unit;                 ///< SI
  double MeasurementChain::*error;  ///< where ε enters
  Direction::Of moves = Direction::Of::nothing;  ///< what of the impact itself it changes
  /// ∂[(1 + g) F + b]/∂ε over σ; `moved` is ∂F by what it moves.
  double (*slope)(const DatumWithSensitivities& datum, double moved, const MeasurementChain& chain);

  /// A file asks for the error in its own words: the unknown is then a factor on the model's
  /// side where `error_of` is given, ε(factor), and ε itself otherwise.
  struct Asked {
    std::string sentence{};  ///< of the key; empty: no file may ask for it
    std::string shown_unit{};
    Range range{};
    NuisanceScope scope = NuisanceScope::each_shot;
    std::string label{};  ///< name of the unknown
    double (*error_of)(double factor) = nullptr;
    double (*slope_of)(double error) = nullptr;  ///< dε/dfactor
    bool over_time_only = false;                 ///< does not show in force over deflection
  } asked{};

  /// Data state its standard deviation, for ball or shot `index`; 0: held. Empty: they do not.
  struct Stated {
    NuisanceScope scope = NuisanceScope::all_shots;
    std::string label{};
    double (*deviation)(const Observations& seen, std::size_t index) = nullptr;
  } stated{};
};

/// The list. A new error is one entry more: files, joint fits, residuals and slopes take it up.
const std::vector<NuisanceKind>& all_nuisances();
/// Errors: Error(bad_input) for a name that is not in the list.
const NuisanceKind& find_nuisance(const std::string& name);

/// Standard deviations by name that a file asks for; absent or zero: held.
struct Nuisances {
  std::map<std::string, double> deviation{};

  double of(const std::string& name) const;
  bool any() const;
};

/// An error of one shot and the unknown that it is.
struct NuisancePlace {
  const NuisanceKind* kind = nullptr;
  std::size_t unknown = 0;
  bool is_factor = false;
};

/// The errors that are unknowns of a fit, each with a normal prior about "nothing wrong".
class NuisanceUnknowns {
 public:
  explicit NuisanceUnknowns(std::size_t shots) : places_(shots) {}

  /// As a file asks, kind by kind in the order of the list.
  void add_asked(const Nuisances& asked, std::vector<CalibrationParameter>& unknowns);
  /// As the data state: errors of all shots, then of balls.
  void add_stated(const Observations& seen, std::vector<CalibrationParameter>& unknowns);
  /// As the data state: errors of one shot alone.
  void add_stated_of_shot(const Observations& seen, std::size_t shot,
                          std::vector<CalibrationParameter>& unknowns);
  /// One error of these shots, whatever states it; returns its place.
  std::size_t add(const NuisanceKind& kind, const CalibrationParameter& unknown,
                  const std::vector<std::size_t>& shots,
                  std::vector<CalibrationParameter>& unknowns);

  std::span<const NuisancePlace> places(std::size_t shot) const { return places_[shot]; }
  /// Unknowns that belong to one shot alone.
  const std::vector<std::size_t>& of_shots() const { return of_shots_; }
  /// Adds the errors of a shot to a chain.
  void apply(const std::vector<double>& x, std::size_t shot, MeasurementChain& chain) const;

 private:
  std::vector<std::vector<NuisancePlace>> places_;  ///< per shot
  std::vector<std::size_t> of_shots_;
};

}  // namespace rebound
