#include "comparisons/discrepancy/diagnosis/search/selection_bootstrap.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

BootstrapCandidate candidate_of(const HypothesisFit& fit) {
  const auto rows = static_cast<Eigen::Index>(fit.residuals.size());
  BootstrapCandidate candidate{
      .residuals = Eigen::Map<const Eigen::VectorXd>(fit.residuals.data(), rows),
      .basis = Eigen::MatrixXd(rows, 0),
      .penalty = fit.penalty_of_refits};
  if (fit.values.empty()) return candidate;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian_at(*fit.model, fit.values));
  candidate.basis = qr.householderQ() * Eigen::MatrixXd::Identity(rows, qr.rank());
  return candidate;
}

/// The baseline, then the best adequate fits.
std::vector<const HypothesisFit*> fits_of(const EffectSelection& selection) {
  constexpr std::size_t most = 8;
  std::vector<const HypothesisFit*> fits{&selection.baseline.fit};
  for (const AssessedFit& one : selection.tried)  // best criterion first
    if (one.adequate && !one.unseen_denies && fits.size() <= most) fits.push_back(&one.fit);
  return fits;
}

}  // namespace

double SelectionBootstrap::inclusion(const std::string& effect) const {
  double share = 0.0;
  for (const SelectionFrequency& one : chosen)
    if (std::find(one.effects.begin(), one.effects.end(), effect) != one.effects.end())
      share += one.share;
  return share;
}

std::vector<double> chosen_shares(const std::vector<BootstrapCandidate>& candidates,
                                  std::size_t truth, Eigen::Index data_rows, int draws,
                                  std::uint64_t seed) {
  // |P (d − ε)|² = |P d|² − 2 (P d)·ε + |ε|² − |Bᵀ ε|², with |ε|² the same for all.
  struct Part {
    Eigen::VectorXd left;  // P d, of the rows of data
    Eigen::MatrixXd basis;
    double constant = 0.0;
  };
  std::vector<Part> parts;
  for (const BootstrapCandidate& one : candidates) {
    Eigen::VectorXd distance = one.residuals;
    distance.head(data_rows) -= candidates[truth].residuals.head(data_rows);
    distance -= one.basis * (one.basis.transpose() * distance).eval();
    parts.push_back({.left = distance.head(data_rows),
                     .basis = one.basis.topRows(data_rows),
                     .constant = distance.squaredNorm() + one.penalty});
  }
  std::vector<int> count(candidates.size(), 0);
  boost::random::mt19937_64 generator(seed);
  boost::random::normal_distribution<double> normal;
  Eigen::VectorXd noise(data_rows);
  for (int draw = 0; draw < draws; ++draw) {
    for (double& value : noise) value = normal(generator);
    std::size_t best = 0;
    double least = 0.0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Part& part = parts[k];
      const double criterion = part.constant - 2.0 * part.left.dot(noise) -
                               (part.basis.transpose() * noise).squaredNorm();
      if (k > 0 && criterion >= least) continue;
      best = k;
      least = criterion;
    }
    ++count[best];
  }
  std::vector<double> shares;
  shares.reserve(count.size());
  for (const int one : count) shares.push_back(static_cast<double>(one) / std::max(1, draws));
  return shares;
}

SelectionBootstrap bootstrap_selection(const EffectSelection& selection, int draws,
                                       std::uint64_t seed) {
  SelectionBootstrap result;
  const std::vector<const HypothesisFit*> fits = fits_of(selection);
  if (draws < 1 || fits.size() < 2) return result;
  std::vector<BootstrapCandidate> candidates(fits.size());
  in_parallel(fits.size(), [&](std::size_t k) { candidates[k] = candidate_of(*fits[k]); });
  const auto rows = static_cast<Eigen::Index>(fits.front()->data_rows());
  const std::vector<double> shares = chosen_shares(candidates, 1, rows, draws, seed);
  result.draws = draws;
  for (std::size_t k = 0; k < fits.size(); ++k) {
    if (shares[k] == 0.0) continue;
    SelectionFrequency& one = result.chosen.emplace_back();
    one.share = shares[k];
    one.effects = added_effects(*fits[k], selection.baseline.fit.effects.size());
  }
  std::stable_sort(result.chosen.begin(), result.chosen.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  return result;
}

}  // namespace rebound
