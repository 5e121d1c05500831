#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_grid.hpp"

namespace rebound {

/// How one effect would move the whitened residuals of a fitted model, with
/// all that the fit can absorb taken out.
///
///   d = (∂r/∂s)⊥,   ŝ = −d·r/(d·d),   σ_s = 1/|d|,   Δχ² = (d·r)²/(d·d)
struct EffectSensitivity {
  EffectChoice effect;          ///< name, and the further parameters it was taken at
  Eigen::VectorXd sensitivity;  ///< d, per unit of size [rows]
  double absorbed = 0.0;        ///< share of |∂r/∂s|² that the fit's own unknowns can mimic
  double noise_freedom = 0.0;   ///< of the noise where the effect shows, see noise_freedom_at()

  double size_error() const { return 1.0 / sensitivity.norm(); }
};

/// The score of one effect on the residuals at hand.
struct EffectScore {
  std::string name;
  double size = 0.0;             ///< ŝ, to first order
  double size_error = 0.0;       ///< σ_s
  double gain_chi_square = 0.0;  ///< Δχ² to first order; 0 where ŝ is on the wrong side
  /// The gain that would be as unlikely without an effect if the noise were known and not
  /// estimated: what threshold() is for.
  double gain_of_known_noise = 0.0;
};

/// One effect at one finite size, nothing refitted.
struct EffectProbe {
  EffectChoice effect;
  /// χ² of the moved residuals once the fit's own unknowns have taken what
  /// they can, to first order: what a search from here starts with.
  double chi_square = 0.0;
};

/// Everything that first-order algebra says around one fitted model.
class EffectSensitivities {
 public:
  /// `effects` are those to be looked at; those without a form for this model,
  /// or that the data cannot see at all, are left out. `seen` must
  /// outlive this.
  EffectSensitivities(const Observations& seen, HypothesisFit fit, std::vector<std::string> effects,
                      GridDetail detail = GridDetail::fine);

  /// Tries finite sizes of every effect, for starts() and best_probe(). Apart,
  /// since it takes an impact a shot and point of the grid.
  void look_for_starts();

  const std::vector<EffectSensitivity>& all() const { return sensitivities_; }
  const std::vector<std::string>& effects() const { return effects_; }

  /// An effect at every point of the grid of its further parameters, size left at null.
  std::vector<EffectChoice> over_its_parameters(const EffectCard& card) const;
  /// How far χ² rises with an effect of this size and these parameters, once the fit's own
  /// unknowns have taken what they can, the starts of records first where the force jumps at touch;
  /// nothing where it has no form here or no answer.
  std::optional<double> rise(const EffectChoice& effect) const;
  /// Impacts of the fit are kept in its model: run before threads ask for rise(), they are only
  /// read.
  void run_impacts() const;

  EffectScore score_of(const EffectSensitivity& sensitivity) const;
  /// Best score of each effect over the parameters it was taken at.
  std::vector<EffectScore> scores() const;

  /// The most promising numbers to start a search for one effect from: the
  /// best of a grid over its sizes and fitted parameters. A plate that rings
  /// has a narrow valley for every frequency; no search finds it from afar: of what swings, every
  /// strength at the best frequency.
  std::vector<EffectChoice> starts(const std::string& name, std::size_t count) const;
  /// Frequencies of what swings that gain most: the first alone, each further one beside those
  /// before it [Hz].
  std::vector<double> frequencies_that_show(const std::string& name, std::size_t count) const;
  /// Those of `choices` that a search best starts from, none that is farther from the data than
  /// the fit itself. It takes an impact a shot and choice.
  std::vector<EffectChoice> best_of(const std::vector<EffectChoice>& choices,
                                    std::size_t count) const;
  /// χ² at the best of starts(); infinite when there is none.
  double best_probe(const std::string& name) const;

  /// What max Δχ² over all effects exceeds with probability `level` when
  /// nothing is missing: seeded draws of noise through the same algebra.
  double threshold(double level, std::uint64_t seed) const;

  /// Cosines between effects, the fit's unknowns projected out; of the
  /// sensitivity with the least absorbed share for each name.
  struct Cosines {
    std::vector<std::string> names;
    Eigen::MatrixXd cosine;
  };
  Cosines cosines() const;

  /// Takes what the fit can absorb out of a column of rows.
  Eigen::VectorXd project(const Eigen::VectorXd& column) const;

  /// Of the fit, [rows][unknowns]; zero for what the data hold at its bound.
  const Eigen::MatrixXd& jacobian() const { return jacobian_; }

 private:
  std::vector<EffectChoice> stronger_where_it_shows(const EffectCard& card) const;
  std::vector<EffectChoice> best_to_first_order(const EffectCard& card) const;
  std::vector<EffectProbe> probed(const std::vector<EffectChoice>& choices) const;
  /// χ² of rows once the fit's own unknowns have taken what they can.
  double left_of(const Eigen::VectorXd& rows) const;
  void add_sensitivity(const EffectChoice& small, const Eigen::VectorXd& moved);
  /// residuals_with() of each, side by side.
  std::vector<std::optional<Eigen::VectorXd>> moved_residuals(
      const std::vector<EffectChoice>& choices) const;

  const Observations& seen_;
  HypothesisFit fit_;
  std::vector<std::string> effects_;
  GridDetail of_starts_;
  Eigen::MatrixXd jacobian_;
  Eigen::MatrixXd basis_;         ///< orthonormal columns of the Jacobian
  double chi_square_left_ = 0.0;  ///< left_of() the fit's own residuals
  std::vector<EffectSensitivity> sensitivities_;
  std::vector<EffectProbe> probes_;  ///< best first
};

}  // namespace rebound
