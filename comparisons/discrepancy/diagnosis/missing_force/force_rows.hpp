#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/missing_force/first_touch.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/force_samples.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/force_surface.hpp"

namespace rebound {

/// Functions that a missing force may be made of: their values at one sample of an impact at
/// speed number `speed`.
using ForceFunctions =
    std::function<Eigen::RowVectorXd(const ForceSamples&, std::size_t sample, std::size_t speed)>;

/// The unknowns of a fit with what the fit made of the measurement forgotten: errors as expected,
/// starts as the records tell them. A wrong law has moved both to where it fits best.
std::vector<double> values_by_themselves(const Observations& seen, const HypothesisFit& fit);

/// The records of one ball as whitened rows of a linear model: the missing force in unknown
/// coefficients, and nuisances.
class ForceRows {
 public:
  /// At these values of the fit's unknowns, in whose neighbourhood nuisances move it evenly.
  /// Errors: as force_samples().
  ForceRows(const Observations& seen, const HypothesisFit& fit, std::vector<double> values,
            std::size_t ball);

  bool empty() const { return shots_.empty(); }
  /// Mean speed of each group of shots, in increasing order [m/s].
  const std::vector<double>& speeds() const { return speeds_; }
  /// Samples of the first shot at a speed.
  const ForceSamples& samples_at(std::size_t speed) const { return first_at(speed).samples; }
  double largest_deflection() const;  ///< of all shots [m]

  /// `width` is the number of functions.
  NormalEquations equations(Eigen::Index width, const ForceFunctions& functions) const;
  /// ∂y/∂q at a position of the loop at a speed, q the nuisances in the order of the equations.
  Eigen::RowVectorXd slopes_at(std::size_t speed, double position) const;
  /// The unknowns of the fit where the missing force has these coefficients.
  std::vector<double> values_with(const NormalEquations& equations,
                                  const Eigen::VectorXd& coefficients) const;
  const std::vector<double>& values() const { return values_; }

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  struct Shot {
    const MeasuredImpact* measured = nullptr;
    std::size_t speed = 0;  ///< number of its group
    ForceSamples samples;
    Rows rows;  ///< whitened: y, ∂y by each of the unknowns below, samples that are not read
    Eigen::MatrixXd slopes;          ///< ∂y by each of the unknowns [N per unit]
    std::vector<std::size_t> moved;  ///< unknowns of the fit
    std::size_t unread = 0;          ///< samples at the turning point
  };
  /// An unknown of the fit beside the missing force: where it stands, and what is known of it.
  struct Known {
    std::size_t unknown = 0;
    double mean = 0.0;       ///< fitted less expected
    double precision = 0.0;  ///< 1/variance; 0: nothing known
  };
  void add_shot(const Observations& seen, const HypothesisFit& fit, std::size_t shot,
                std::size_t speed);
  void add_known(const HypothesisFit& fit, std::size_t unknown, bool of_law,
                 const FirstTouch& touch);
  const Shot& first_at(std::size_t speed) const;
  std::size_t place_of(std::size_t unknown) const;
  static void add_functions(const Shot& shot, const ForceFunctions& functions,
                            Eigen::Ref<Eigen::MatrixXd> wide);

  std::vector<double> values_;
  std::vector<double> speeds_;
  std::vector<Shot> shots_;
  std::vector<Known> known_;
  std::size_t unread_ = 0;  ///< samples of all shots that are not read
};

}  // namespace rebound
