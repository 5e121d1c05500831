#include "comparisons/studies/study/study_report.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rebound {

std::string overlay_key(const CoreStudy& core, const StudyShot& shot) {
  return fmt::format("{}/{:g}", core.label, shot.measured.impact.speed);
}

double spread(const StudyShot& shot, double ImpactScalars::*scalar) {
  return std::abs(shot.fem.scalars.*scalar - shot.fem_coarse.scalars.*scalar);
}

namespace {

/// "+38", and "0" for what rounds to it.
std::string whole_percent(double share) {
  const double percent = std::round(100 * share);
  return percent == 0.0 ? "0" : fmt::format("{:+.0f}", percent);
}

}  // namespace

std::string headline(const std::vector<CoreStudy>& cores) {
  // The impact at which the published law is furthest from the measured restitution.
  const CoreStudy* core = nullptr;
  std::size_t shot = 0;
  double worst = -1.0;
  constexpr std::size_t published = 0;  // rows as calibrate_laws() makes them
  constexpr std::size_t exact = 2;
  for (const auto& candidate : cores)
    for (std::size_t i = 0; i < candidate.shots.size(); ++i) {
      const auto& error = candidate.benchmark.cells[published][i].against_measured.restitution;
      if (!error || std::abs(*error) <= worst) continue;
      worst = std::abs(*error);
      core = &candidate;
      shot = i;
    }
  if (!core) return "No measured restitution to compare the laws with.";
  const auto& law = core->benchmark.cells[published][shot];
  const auto& repaired = core->benchmark.cells[exact][shot];
  return fmt::format(
      "Core {} at {:g} m/s: the published Hunt–Crossley parameters give a restitution of {:.3f} "
      "where {:.3f} was measured ({} %); damping by the exact relation instead of the "
      "low-loss formula gives {:.3f}{}.",
      core->label, core->shots[shot].measured.impact.speed, law.scalars.restitution,
      *core->shots[shot].measured.restitution.value,
      whole_percent(*law.against_measured.restitution), repaired.scalars.restitution,
      repaired.against_measured.restitution
          ? fmt::format(" ({} %)", whole_percent(*repaired.against_measured.restitution))
          : "");
}

report::Section provenance_section(const std::vector<CoreStudy>& cores,
                                   const Provenance& provenance) {
  report::Section section{
      .title = "Provenance", .folding = report::Section::Folding::folded, .blocks = {}};
  section.blocks.push_back(report::Verbatim{"Run", dump(to_json(provenance))});
  for (const auto& core : cores) {
    std::string notes;
    for (const auto& note : core.data.notes) notes += "– " + note + "\n";
    section.blocks.push_back(
        report::Verbatim{core.data.name + ": assumptions in the data set", notes});
  }
  return section;
}

namespace {

/// The section with another one folded behind it.
report::Section joined(report::Section section, const report::Section& further) {
  for (const auto* blocks : {&further.blocks, &further.details})
    section.details.insert(section.details.end(), blocks->begin(), blocks->end());
  return section;
}

}  // namespace

report::Report study_report(const StudyFile& study, const std::vector<CoreStudy>& cores,
                            const std::optional<JointScalars>& joint,
                            const std::vector<ExperimentStudy>& experiments,
                            const std::vector<report::Section>& paper,
                            const Provenance& provenance) {
  report::Report page;
  page.title = study.title;
  page.subtitle =
      "Lumped contact laws against finite elements and against the measurement; "
      "normal impact, no spin, no temperature";
  page.question =
      "Can the contact law be believed, at this speed, for this ball? If not, what is missing?";
  page.headline = answer(cores, joint);
  page.lead = {restitution_matrix(cores), measured_verdicts(cores)};
  page.sections = {matrix_section(cores), overlay_section(cores)};
  for (auto& section : diagnosis_overview(cores, experiments)) page.sections.push_back(section);
  for (auto& section : simulation_section(cores, joint)) page.sections.push_back(section);
  page.sections.push_back(joined(check_section(cores), credibility_section(cores)));
  page.sections.push_back(joined(parameter_section(cores), quasistatic_section(cores)));
  if (!paper.empty()) {
    page.sections.push_back(paper.front());
    for (std::size_t i = 1; i < paper.size(); ++i)
      page.sections.back() = joined(page.sections.back(), paper[i]);
  }
  page.sections.push_back(provenance_section(cores, provenance));
  return page;
}

}  // namespace rebound
