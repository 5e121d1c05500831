#include "comparisons/discrepancy/design/predicted_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/discrepancy/design/drawn_residuals.hpp"
#include "comparisons/inference/calibration/distributions.hpp"

namespace rebound {
namespace {

/// One effect more on one draw, at the way in which it gains most.
struct Gained {
  std::size_t name = 0;
  Eigen::Index way = -1;
  double gain = 0.0, criterion = 0.0, prediction = 0.0, unseen = 0.0;
};

void by_criterion(std::vector<Gained>& all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Gained& a, const Gained& b) { return a.criterion < b.criterion; });
}

/// What is within reach of the best by either criterion.
struct NearTheBest {
  double reach = 0.0;
  double criterion = std::numeric_limits<double>::infinity();
  double prediction = std::numeric_limits<double>::infinity();

  void reach_from(const Gained& g) {
    criterion = std::min(criterion, g.criterion);
    prediction = std::min(prediction, g.prediction);
  }
  bool holds(const Gained& g) const {
    return g.criterion <= criterion + reach || g.prediction <= prediction + reach;
  }
};

/// The steps of a diagnosis on one draw.
class Steps {
 public:
  struct Answer {
    bool gap = false, named = false;
  };
  Steps(const DrawnResiduals& residuals, const SelectionRules& rules, bool asks_unseen)
      : residuals_(residuals),
        rules_(rules),
        asks_unseen_(asks_unseen && residuals.rows().has_unseen()),
        most_chi_square_(chi_squared_quantile(std::max(1, residuals.rows().freedom()),
                                              1.0 - rules.smallest_adequate_p)) {}
  Answer answer(const HiddenChange* hidden, Eigen::Index draw) const;

 private:
  std::vector<Gained> tried(const HiddenChange* hidden, const DrawnStatistics& one) const;
  void keep_best_of_each_kind(std::vector<Gained>& best) const;
  bool leaves_little(const Gained& candidate, const DrawnStatistics& one) const;
  std::vector<Gained> candidates(const std::vector<Gained>& all_tried,
                                 const DrawnStatistics& one) const;
  void keep_within_reach(std::vector<Gained>& members) const;
  bool stands(const std::vector<Gained>& members, const DrawnStatistics& one) const;
  bool leaves_noise(const DrawnStatistics& one) const;

  const DrawnResiduals& residuals_;
  const SelectionRules& rules_;
  bool asks_unseen_;  ///< a search beside FE does not
  double most_chi_square_;
};

/// The effects that a search fits in full: the best of each kind.
std::vector<Gained> Steps::tried(const HiddenChange* hidden, const DrawnStatistics& one) const {
  std::vector<Gained> best(residuals_.names());
  const auto& ways = residuals_.ways();
  for (std::size_t j = 0; j < ways.size(); ++j) {
    Gained& name = best[ways[j].name];
    const auto way = static_cast<Eigen::Index>(j);
    const double z = one.seen[way], gained = residuals_.gain(ways[j], z, ways[j].length);
    if (name.way >= 0 && gained <= name.gain) continue;
    // To add ŝ = −z along this way moves the prediction of the unseen speed by ŝ e.
    name = {.name = ways[j].name, .way = way, .gain = gained};
    if (gained > 0.0)
      name.unseen = -2.0 * z * one.unseen[way] + z * z * residuals_.unseen_square(way);
  }
  // What is hidden is found at its own numbers, which no grid needs to hold.
  if (hidden && one.along > 0.0 && one.along * one.along > best[hidden->name].gain) {
    const double share = one.along / hidden->length;
    best[hidden->name].gain = one.along * one.along;
    best[hidden->name].unseen = share * (share * hidden->unseen_square - 2.0 * one.unseen_gained);
  }
  keep_best_of_each_kind(best);
  const double each = residuals_.rows().log_seen_data();
  for (Gained& g : best) {
    const EffectCost& cost = residuals_.cost(g.name);
    g.criterion = -g.gain + cost.numbers * each;
    g.prediction = -g.gain + 2.0 * cost.numbers + cost.frequencies * std::max(0.0, each - 2.0);
  }
  by_criterion(best);
  return best;
}

void Steps::keep_best_of_each_kind(std::vector<Gained>& best) const {
  std::erase_if(best, [](const Gained& g) { return g.way < 0; });
  std::stable_sort(best.begin(), best.end(),
                   [](const Gained& a, const Gained& b) { return a.gain > b.gain; });
  int physical = 0, faults = 0;
  std::erase_if(best, [&](const Gained& g) {
    return residuals_.cost(g.name).measurement ? ++faults > rules_.fitted_faults
                                               : ++physical > rules_.fitted_singles;
  });
}

/// Is what is left beside it noise, by the closer look that is taken at a candidate?
bool Steps::leaves_little(const Gained& candidate, const DrawnStatistics& one) const {
  if (one.chi_square - candidate.gain > most_chi_square_) return false;
  const Eigen::Index k = candidate.way;
  const auto left = [&](double statistic, double product) {
    const double rest = 1.0 - product * product;
    return rest > 1e-4 ? (statistic - product * one.seen[k]) / std::sqrt(rest) : 0.0;
  };
  for (Eigen::Index j = 0; j < one.seen.size(); ++j) {
    const EffectWay& way = residuals_.ways()[static_cast<std::size_t>(j)];
    if (way.name == candidate.name) continue;
    const double z = left(one.seen[j], residuals_.products()(j, k));
    if (residuals_.gain(way, z, way.length) > residuals_.candidate_limits.gain) return false;
  }
  for (Eigen::Index c = 0; c < one.cells.size(); ++c)
    if (std::abs(left(one.cells[c], residuals_.cell_products()(c, k))) >
        residuals_.candidate_limits.cell)
      return false;
  return true;
}

/// Those within reach of the best adequate one by either criterion, then with the unseen speed.
std::vector<Gained> Steps::candidates(const std::vector<Gained>& all_tried,
                                      const DrawnStatistics& one) const {
  std::vector<Gained> members;
  NearTheBest best{rules_.close_criterion};
  for (const Gained& g : all_tried) {
    if (!best.holds(g) || !leaves_little(g, one)) continue;
    best.reach_from(g);
    members.push_back(g);
  }
  keep_within_reach(members);
  if (!asks_unseen_) return members;
  for (Gained& g : members) {
    g.criterion += g.unseen;
    g.prediction += g.unseen;
  }
  keep_within_reach(members);
  by_criterion(members);
  return members;
}

void Steps::keep_within_reach(std::vector<Gained>& members) const {
  NearTheBest best{rules_.close_criterion};
  for (const Gained& g : members) best.reach_from(g);
  std::erase_if(members, [&](const Gained& g) { return !best.holds(g); });
}

/// Does the believed model stand, since effects of several families each explain a little?
bool Steps::stands(const std::vector<Gained>& members, const DrawnStatistics& one) const {
  constexpr double plain = 1.2, most_gained = 20.0, deviations = 3.0;
  const LinearRows& rows = residuals_.rows();
  if (!rows.has_unseen() || members.size() < 2 || one.chi_square > most_chi_square_ ||
      one.largest_cell > plain * residuals_.seen_limits.cell)
    return false;
  const auto family = [&](const Gained& g) { return residuals_.cost(g.name).family; };
  const bool one_family = std::all_of(members.begin(), members.end(), [&](const Gained& g) {
    return family(g) == family(members.front());
  });
  const bool gains_more = std::any_of(members.begin(), members.end(), [&](const Gained& g) {
    return (asks_unseen_ ? g.unseen : 0.0) - g.prediction > most_gained;
  });
  const double count = rows.unseen_data();
  return !one_family && !gains_more &&
         one.unseen_chi_square / count - 1.0 <= deviations * std::sqrt(2.0 / count) &&
         members.front().unseen >= 0.0;
}

/// Is what the believed model leaves noise, by the tests that a diagnosis begins with?
bool Steps::leaves_noise(const DrawnStatistics& one) const {
  const auto is_quiet = [](double gained, double cell, const StepLimits& limits) {
    return gained <= limits.gain && cell <= limits.cell;
  };
  return one.chi_square <= most_chi_square_ &&
         is_quiet(residuals_.largest_gain(one.first_seen, &EffectWay::length), one.largest_cell,
                  residuals_.seen_limits) &&
         (!asks_unseen_ ||
          is_quiet(residuals_.largest_gain(one.first_all, &EffectWay::length_of_all),
                   one.largest_cell_of_all, residuals_.all_limits));
}

Steps::Answer Steps::answer(const HiddenChange* hidden, Eigen::Index draw) const {
  const DrawnStatistics one = residuals_.draw(draw, hidden);
  if (leaves_noise(one)) return {};
  const std::vector<Gained> all_tried = tried(hidden, one);
  const std::vector<Gained> members = candidates(all_tried, one);
  const auto member = [&](std::size_t name) {
    return std::find_if(members.begin(), members.end(),
                        [&](const Gained& g) { return g.name == name; });
  };
  const bool worth_it = std::any_of(all_tried.begin(), all_tried.end(), [&](const Gained& g) {
    const auto found = member(g.name);
    return -(found == members.end() ? g : *found).criterion > rules_.close_criterion;
  });
  if (!worth_it && one.chi_square <= most_chi_square_ &&
      one.largest_cell <= residuals_.candidate_limits.cell)
    return {};
  if (stands(members, one)) return {};
  return {.gap = true, .named = hidden && member(hidden->name) != members.end()};
}

}  // namespace

PredictedDiagnosis::PredictedDiagnosis(const PlannedData& data, const SelectionRules& rules,
                                       std::uint64_t seed)
    : rules_(rules),
      asks_unseen_(!data.fit->model->fem()),
      residuals_(std::make_unique<const DrawnResiduals>(data, rules, seed)) {}
PredictedDiagnosis::~PredictedDiagnosis() = default;

DiagnosisChances PredictedDiagnosis::chances(const HiddenChange* hidden) const {
  const Steps steps(*residuals_, rules_, asks_unseen_);
  int gaps = 0, named = 0;
  for (Eigen::Index draw = 0; draw < residuals_->draws(); ++draw) {
    const Steps::Answer said = steps.answer(hidden, draw);
    gaps += said.gap;
    named += said.named;
  }
  const auto all = static_cast<double>(residuals_->draws());
  return {.gap = gaps / all, .named = named / all};
}

DiagnosisChances PredictedDiagnosis::with(const std::string& name, const Eigen::VectorXd& change,
                                          double share_seen) const {
  const HiddenChange hidden = residuals_->hidden(name, change, share_seen);
  return chances(&hidden);
}

DiagnosisChances PredictedDiagnosis::with_nothing() const {
  return chances(nullptr);
}

}  // namespace rebound
