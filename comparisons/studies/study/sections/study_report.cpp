#include "comparisons/studies/study/study_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparisons/discrepancy/diagnosis/diagnosis_report.hpp"
#include "comparisons/discrepancy/diagnosis/diagnosis_text.hpp"

namespace rebound {

std::string overlay_key(const CoreStudy& core, const StudyShot& shot) {
  return fmt::format("{}/{:g}", core.label, shot.measured.impact.speed);
}

double spread(const StudyShot& shot, double ImpactScalars::*scalar) {
  return std::abs(shot.fem.scalars.*scalar - shot.fem_coarse.scalars.*scalar);
}

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
      "where {:.3f} was measured ({:+.0f} %); damping by the exact relation instead of the "
      "low-loss formula gives {:.3f}{}.",
      core->label, core->shots[shot].measured.impact.speed, law.scalars.restitution,
      *core->shots[shot].measured.restitution.value, 100 * *law.against_measured.restitution,
      repaired.scalars.restitution,
      repaired.against_measured.restitution
          ? fmt::format(" ({:+.0f} %)", 100 * *repaired.against_measured.restitution)
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

/// Verdicts of all diagnoses in one table; pictures and maps follow, folded.
std::vector<report::Section> diagnosis_overview(const std::vector<CoreStudy>& cores,
                                                const std::vector<ExperimentStudy>& experiments) {
  report::Table table{.title = "Verdicts",
                      .caption =
                          "Gap: reduced whitened χ² before and after, the noise is 1; held "
                          "out: the same at a speed that no fit saw.",
                      .columns = {{"data"}, {"hidden"}, {"verdict"}, {"gap"}, {"held out"}},
                      .rows = {}};
  std::vector<report::Section> details;
  const auto add = [&](const std::string& name, const std::string& hidden, const Diagnosis& d) {
    const auto step = [](const std::optional<double>& before, const std::optional<double>& after) {
      if (!before) return std::string("–");
      return after ? fmt::format("{:.3g} to {:.3g}", *before, *after)
                   : fmt::format("{:.3g}", *before);
    };
    table.rows.push_back({report::text_cell(name), report::text_cell(hidden),
                          report::text_cell(headline(d)),
                          report::text_cell(step(d.gap.before, d.gap.after)),
                          report::text_cell(step(d.gap.held_out_before, d.gap.held_out_after))});
    for (auto& section : diagnosis_sections(d, name)) {
      section.folding = report::Section::Folding::folded;
      details.push_back(std::move(section));
    }
  };
  for (const auto& core : cores)
    add(fmt::format("core {}, the paper's Eq. (8) model", core.label), "measured, unknown",
        core.diagnosis);
  for (const auto& experiment : experiments)
    add(experiment.label, experiment.hidden, experiment.diagnosis);
  details.insert(
      details.begin(),
      {.title = "What is missing from the believed models",
       .folding = report::Section::Folding::open,
       .blocks = {
           report::Paragraph{"On the measurement: the paper's model with its own damping formula. "
                             "On synthetic experiments: a Hunt–Crossley model against data in "
                             "which the effect is hidden; the diagnosis sees the data set alone."},
           table}});
  return details;
}

}  // namespace

report::Report study_report(const StudyFile& study, const std::vector<CoreStudy>& cores,
                            const std::vector<ExperimentStudy>& experiments,
                            const std::vector<report::Section>& paper,
                            const Provenance& provenance) {
  report::Report page;
  page.title = study.title;
  page.subtitle =
      "Lumped contact laws against finite elements and against the measurement; "
      "normal impact, no spin, no temperature";
  page.headline = headline(cores);
  page.sections = {matrix_section(cores), overlay_section(cores), check_section(cores)};
  const auto append = [&](const std::vector<report::Section>& sections) {
    page.sections.insert(page.sections.end(), sections.begin(), sections.end());
  };
  append(diagnosis_overview(cores, experiments));
  append(paper);
  page.sections.push_back(parameter_section(cores));
  page.sections.push_back(quasistatic_section(cores));
  page.sections.push_back(credibility_section(cores));
  page.sections.push_back(provenance_section(cores, provenance));
  return page;
}

}  // namespace rebound
