#include "comparisons/discrepancy/diagnosis/missing_force/force_words.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rebound {
namespace {

constexpr int splines = 12;
constexpr double as_good = 3.0;        // of log evidence: twenty to one
constexpr double stands_out = 6.0;     // over no force at all: many structures are tried
constexpr double plainly_less = 10.0;  // a power of x is one of the share, times one of v₀

enum class Part { even, odd, loading, unloading, both };
enum class Dependence { deflection, rate, share };

struct Structure {
  Part part = Part::even;
  Dependence dependence = Dependence::deflection;
  double power = 0.0;  ///< α, where it depends on the share
};

std::vector<Structure> all_structures(bool several_speeds) {
  std::vector<Structure> all;
  for (const Part part : {Part::even, Part::odd, Part::loading, Part::unloading, Part::both}) {
    all.push_back({part, Dependence::deflection});
    all.push_back({part, Dependence::rate});
    if (!several_speeds) continue;  // the share of one deflection is the deflection
    for (const double power : {0.0, 0.8, 1.6, 2.4}) all.push_back({part, Dependence::share, power});
  }
  return all;
}

/// Where a structure's functions take their values from.
struct Scales {
  double deflection = 0.0, speed = 0.0;  ///< largest [m], [m/s]
};

Eigen::RowVectorXd functions_of(const Structure& structure, const Scales& scales,
                                const ForceSamples& samples, std::size_t i) {
  const bool two = structure.part == Part::both;
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(two ? 2 * splines : splines);
  if (samples.position(i) < 0.0) return row;
  const bool loads = samples.velocity[i] > 0.0;
  if (structure.part == Part::loading && !loads) return row;
  if (structure.part == Part::unloading && loads) return row;
  const bool shared = structure.dependence == Dependence::share;
  const double scale = shared ? samples.loop.largest_deflection : scales.deflection;
  const double share = std::clamp(samples.deflection[i] / scale, 0.0, 1.0);
  double weight = structure.part == Part::odd && !loads ? -1.0 : 1.0;
  if (structure.dependence == Dependence::rate)
    weight *= std::abs(samples.velocity[i]) / scales.speed;
  if (shared) weight *= std::pow(samples.speed / scales.speed, structure.power);
  // Over the root of the share: forces bend where contact begins.
  row.segment(two && !loads ? splines : 0, splines) =
      weight * cubic_splines(std::sqrt(share), 0.0, 1.0, splines);
  return row;
}

/// Largest over the size and the smoothness of the curves.
double largest_evidence(const NormalEquations& equations, int curves) {
  const double size = std::sqrt(equations.total / std::max(1e-300, equations.gram.trace()));
  double best = 0.0;  // that of no force at all
  for (const double roughness : {0.1, 1.0, 10.0, 100.0, 1e3, 1e4}) {
    const Eigen::MatrixXd one = smooth_covariance(splines, roughness).llt().matrixL();
    Eigen::MatrixXd root = Eigen::MatrixXd::Zero(curves * splines, curves * splines);
    for (int k = 0; k < curves; ++k) root.block(k * splines, k * splines, splines, splines) = one;
    for (double factor = 0.03; factor < 100.0; factor *= 2.0)
      best = std::max(best, log_evidence_of(equations, factor * size * root));
  }
  return best;
}

std::string sentence_of(Part part) {
  switch (part) {
    case Part::even: return "it is even in the velocity: the same while loading and unloading";
    case Part::odd: return "it is odd in the velocity: it changes its sign where the ball turns";
    case Part::loading: return "it acts while loading only";
    case Part::unloading: return "it acts while unloading only";
    case Part::both: return "it acts while loading and while unloading, each in its own way";
  }
  return {};
}

std::string sentence_of(Dependence dependence) {
  switch (dependence) {
    case Dependence::deflection: return "it depends on the deflection, the same at every rate";
    case Dependence::rate: return "it grows with the rate of the deflection, in proportion";
    case Dependence::share:
      return "it follows the share of the largest deflection: it depends on what happened before";
  }
  return {};
}

}  // namespace

std::vector<std::string> words_of_missing_force(const ForceRows& rows, double surface_evidence) {
  const bool several_speeds = rows.speeds().size() > 1;
  const Scales scales{rows.largest_deflection(), rows.speeds().back()};
  const std::vector<Structure> structures = all_structures(several_speeds);
  std::vector<double> evidence;
  for (const Structure& one : structures) {
    const int curves = one.part == Part::both ? 2 : 1;
    evidence.push_back(largest_evidence(
        rows.equations(curves * splines,
                       [&](const ForceSamples& samples, std::size_t sample, std::size_t) {
                         return functions_of(one, scales, samples, sample);
                       }),
        curves));
  }
  const double simple = *std::max_element(evidence.begin(), evidence.end());
  if (std::max(simple, surface_evidence) < stands_out)
    return {"no force stands out of the noise that the law could not take"};
  if (surface_evidence > simple + as_good)
    return {
        several_speeds
            ? "no one curve over deflection, rate or share of the largest deflection is enough: "
              "it depends on what happened before, or on several things at once"
            : "no simple dependence on deflection and velocity is enough"};
  std::vector<Structure> good;
  bool shares_alone = true;
  for (std::size_t i = 0; i < structures.size(); ++i) {
    if (structures[i].dependence != Dependence::share && evidence[i] > simple - plainly_less)
      shares_alone = false;
    if (evidence[i] > simple - as_good) good.push_back(structures[i]);
  }
  const bool one_dependence = std::all_of(good.begin(), good.end(), [&](const Structure& one) {
    return one.dependence == good.front().dependence;
  });
  std::vector<std::string> words;
  if (std::all_of(good.begin(), good.end(),
                  [&](const Structure& one) { return one.part == good.front().part; }))
    words.push_back(sentence_of(good.front().part));
  if (several_speeds && one_dependence &&
      (good.front().dependence != Dependence::share || shares_alone))
    words.push_back(sentence_of(good.front().dependence));
  if (words.empty()) words.push_back("these data do not tell what it depends on");
  return words;
}

}  // namespace rebound
