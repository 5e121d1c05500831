#pragma once

#include <functional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"

/// Which of the fits of a search are candidates.
namespace rebound {

/// Judges those fits that may become candidates, best criterion first: what is beyond reach of an
/// adequate one need not be judged. `tried` must be in the order of the information criterion.
void judge_candidates(std::vector<AssessedFit>& tried, double reach,
                      const std::function<void(AssessedFit&)>& judge);

/// Adequate, within reach of the best adequate one by either criterion (χ² + k ln N, χ² + 2 k), and
/// without a smaller adequate set inside or one with a formula in place of a free curve. Sizes of
/// every ball, or one that all share: whichever is better by χ² + k ln N. Indices into `tried`.
std::vector<std::size_t> indistinguishable_models(const std::vector<AssessedFit>& tried,
                                                  double reach);

/// Those of `members` that hold no smaller set of theirs, and no free curve in place of a formula
/// of theirs.
std::vector<std::size_t> smallest_of(const std::vector<AssessedFit>& tried,
                                     const std::vector<std::size_t>& members);

/// May a search end with these candidates? Not with none, and not with single curves alone that
/// leave what noise does not: a curve bends to most of what two effects do together.
bool may_end_with(const std::vector<AssessedFit>& tried, const std::vector<std::size_t>& members,
                  std::size_t known);

/// The best fit whose χ² noise could make, where it is beyond reach of every adequate one, to the
/// better: something is left beside it, and what leaves nothing fits plainly worse. Null: none.
const AssessedFit* leader_over_adequate(const std::vector<AssessedFit>& tried, double reach,
                                        double smallest_p);

/// A single effect that is nearly adequate and beyond reach of all adequate sets, to the better:
/// what fits worse explains the data no better. Where there are some, they are adequate, and the
/// candidates. A formula that is nearly adequate and leads adequate single effects by less stands
/// beside them: it is no less likely for what it leaves than they are for fitting worse.
void prefer_nearly_adequate(std::vector<AssessedFit>& tried, std::size_t known, double reach,
                            std::vector<std::size_t>& members);

/// A curve beside one other effect that is nearly adequate, where nothing is adequate and all else
/// that was tried fits plainly worse, by five times `reach`: what it leaves is that its points are
/// few. It is adequate then, and the one candidate. Says whether there is one.
bool accept_leading_pair(std::vector<AssessedFit>& tried, std::size_t known, double reach,
                         std::vector<std::size_t>& members);

/// Takes out of `members` what shares no family with the leader over them, where there is one.
void deny_other_families_than_leader(const std::vector<AssessedFit>& tried, std::size_t known,
                                     double reach, double smallest_p,
                                     std::vector<std::size_t>& members);

/// Takes a form of many numbers out of `members` where a fit of fewer is beyond reach of it, to the
/// better, by χ² + k ln N, and leaves a χ² that noise could make: it bends to what that leaves.
void drop_many_numbers_behind_fewer(const std::vector<AssessedFit>& tried, double reach,
                                    double smallest_p, std::vector<std::size_t>& members);

/// Takes out of `members`, indices into `tried`, what is beyond reach of the best of them once the
/// unseen speed counts; the best by χ² + k ln N comes first.
void keep_within_reach(const std::vector<AssessedFit>& tried, double reach,
                       std::vector<std::size_t>& members);

/// By how much χ² + k ln N of `one` is better than that of `none`, the believed model alone; what
/// the unseen speed says counts where both were asked.
double gain_over(const AssessedFit& none, const AssessedFit& one);

/// Takes out of `members` what is better than `none` by more than `reach` neither by χ² + k ln N
/// nor by χ² + 2 k. A score test of few numbers shows gaps that leave χ² where it was; what lowers
/// it by chance, until the test is passed, explains none of them.
void drop_what_gains_nothing(const std::vector<AssessedFit>& tried, const AssessedFit& none,
                             double reach, std::vector<std::size_t>& members);

}  // namespace rebound
