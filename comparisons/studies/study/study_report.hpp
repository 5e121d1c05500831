#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/consistency/joint_scalars.hpp"
#include "comparisons/io/report/report.hpp"
#include "comparisons/io/results/provenance.hpp"
#include "comparisons/studies/study/core_study.hpp"
#include "comparisons/studies/study/study_experiments.hpp"

/// The report of a study, one function a section, in the order of reading.
namespace rebound {

/// One sentence to take away: what the published damping formula predicts for
/// one core at one speed, what was measured, which change closes it.
std::string headline(const std::vector<CoreStudy>& cores);

/// The sentences of the first screen: the published law at its worst, which law is nearest to FE
/// and whether FE follows the data, which observables contradict each other, what the diagnosis
/// says and the gap before and after.
std::string answer(const std::vector<CoreStudy>& cores, const std::optional<JointScalars>& joint);

/// What a diagnosis found, in the words that stand behind "the diagnosis names".
std::string missing_in_words(const Diagnosis& diagnosis);

/// Does the fitted FE material follow restitution and contact time within their uncertainty?
bool fem_follows(const CoreStudy& core);

/// Law × core × speed: error of the restitution against the measurement.
report::Matrix restitution_matrix(const std::vector<CoreStudy>& cores);

/// Verdict and gap of each core's diagnosis, linked to its page.
report::Table measured_verdicts(const std::vector<CoreStudy>& cores);

/// What was found on the measurement, then on the synthetic experiments where there are some.
std::vector<report::Section> diagnosis_overview(const std::vector<CoreStudy>& cores,
                                                const std::vector<ExperimentStudy>& experiments);

/// A page that the report leads to; `file` is relative to the report's folder.
struct StudyPage {
  std::string file;
  report::Report report;
};
std::vector<StudyPage> diagnosis_pages(const std::vector<CoreStudy>& cores,
                                       const std::vector<ExperimentStudy>& experiments,
                                       const Provenance& provenance);

/// Law × core × speed: distance of the force trace from FE, errors against
/// the measurement.
report::Section matrix_section(const std::vector<CoreStudy>& cores);

/// The chosen impact: force–deflection, deflection–time, scalars side by side.
report::Section overlay_section(const std::vector<CoreStudy>& cores);

/// The FE model against all scalars: which of them contradict each other; nothing where no core
/// has been diagnosed yet. Without `joint`, core by core alone.
std::vector<report::Section> simulation_section(const std::vector<CoreStudy>& cores,
                                                const std::optional<JointScalars>& joint);
/// Which kind of observable contradicts the others over all cores together, and by how much.
report::Notice joint_contradiction(const std::vector<CoreStudy>& cores, const JointScalars& joint);
/// The effect that brings all cores nearest together, one size or several, and what it is worth.
report::Notice joint_effect(const std::vector<CoreStudy>& cores, const JointScalars& joint);
/// Gap at the unseen speed: believed, with an effect of each core, with one of all.
report::Matrix gap_matrix(const std::vector<CoreStudy>& cores, const JointScalars& joint);
/// Fits with one kind left out over all cores; effects in all of them.
std::vector<report::Table> joint_tables(const std::vector<CoreStudy>& cores,
                                        const JointScalars& joint);
/// What all cores together say, in two sentences for a terminal; empty without `joint`.
std::string joint_text(const std::vector<CoreStudy>& cores,
                       const std::optional<JointScalars>& joint);
/// The contradiction in a clause for the first screen; empty where nothing stands out.
std::string simulation_clause(const std::vector<CoreStudy>& cores);
/// Which kind of observable of one ball contradicts the others; empty where none does.
std::string contradiction_of(const CoreStudy& core);
/// What one effect of all cores is worth at the unseen speed, in a clause; empty where none is
/// nearer than the believed model.
std::string joint_clause(const std::vector<CoreStudy>& cores, const JointScalars& joint);

/// FE against what it was fitted to, and against what it was not.
report::Section check_section(const std::vector<CoreStudy>& cores);

/// Every fitted number with its interval and verdict.
report::Section parameter_section(const std::vector<CoreStudy>& cores);

/// Slow compression: modulus and stiffness by every route, geometry factors right.
report::Section quasistatic_section(const std::vector<CoreStudy>& cores);

/// Closures and numerical spread of the FE runs.
report::Section credibility_section(const std::vector<CoreStudy>& cores);

report::Section provenance_section(const std::vector<CoreStudy>& cores,
                                   const Provenance& provenance);

/// `paper`: what the paper's printed numbers imply, if the study asks for it;
/// placed after the checks of the FE model and the diagnoses.
report::Report study_report(const StudyFile& study, const std::vector<CoreStudy>& cores,
                            const std::optional<JointScalars>& joint,
                            const std::vector<ExperimentStudy>& experiments,
                            const std::vector<report::Section>& paper,
                            const Provenance& provenance);

/// Key of the overlay of one impact, e.g. "A/15".
std::string overlay_key(const CoreStudy& core, const StudyShot& shot);

/// Numerical spread of an FE scalar: its distance between the two meshes.
double spread(const StudyShot& shot, double ImpactScalars::*scalar);

}  // namespace rebound
