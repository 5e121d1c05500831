#pragma once

#include <string>
#include <vector>

#include "comparisons/studies/reproduce/claim_rows.hpp"
#include "comparisons/studies/reproduce/repair_search.hpp"

namespace rebound {

/// Something the paper's numbers say about each other, with the numbers that
/// show it. Statement and evidence are written from computed values.
struct Finding {
  std::string id;
  std::string statement;
  std::string evidence;
};

/// What findings are computed from.
struct Evidence {
  const Paper& paper;
  const std::vector<std::vector<ModelRun>>& runs;  ///< [core][speed]
  const std::vector<Row>& rows;                    ///< all tables and claims
  const std::vector<BlockSearch>& searches;        ///< Tables 2 to 5
};

/// Eq. (10) and Table 2: the factor, one contact or two, block against ball.
std::vector<Finding> stiffness_findings(const Evidence& evidence);

/// Which single change would repair a block, and which blocks have none.
std::vector<Finding> repair_findings(const Evidence& evidence);

/// Eqs (7) and (8), the speeds behind Table 3, what the damping really returns.
std::vector<Finding> damping_findings(const Evidence& evidence);

/// Contact time, restitution, deflection and pulse over speed.
std::vector<Finding> trend_findings(const Evidence& evidence);

/// Numbers of the text that contradict each other or the tables.
std::vector<Finding> summary_findings(const Evidence& evidence);

/// The paper with each core's mass replaced by the one that repairs its block
/// of Table 5, where there is one.
Paper with_repaired_masses(const Evidence& evidence);

}  // namespace rebound
