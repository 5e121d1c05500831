#pragma once

#include "comparisons/io/report/report.hpp"
#include "comparisons/studies/reproduce/reproduction.hpp"

/// Figures 3 to 6 of the paper, drawn again from its parameters. No line here
/// was measured: the paper prints none.
namespace rebound {

/// Figs 3 and 4: force over deflection and deflection over time, one overlay
/// per core and speed, with the id "published-impacts".
report::Overlays published_impacts(const Reproduction& reproduction);

/// The way into those overlays: model against measured contact time, in %.
report::Matrix contact_time_matrix(const Reproduction& reproduction);

/// Fig. 5: contact times, measured and of the published Hunt–Crossley models.
report::Figure figure_5(const Reproduction& reproduction);

/// Fig. 6: the stiffness sweep of section 4.5, (a) and (b).
std::vector<report::Figure> figure_6(const Reproduction& reproduction);

}  // namespace rebound
