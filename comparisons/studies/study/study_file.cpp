#include "comparisons/studies/study/study_file.hpp"

#include <set>

#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "fem/interface/elastic_models.hpp"

namespace rebound {

void describe(Visitor& visit, StudyBranch& branch) {
  visit.number({.name = "ratio",
                .sentence = "Branch over long-term modulus; where the fit starts.",
                .range = above(0.0)},
               branch.ratio);
  visit.number({.name = "relaxation_time",
                .sentence = "Time constant; where the fit starts.",
                .unit = "ms",
                .range = above(0.0)},
               branch.relaxation_time);
  visit.flag({.name = "fit_ratio",
              .sentence = "Fit the ratio, or keep it.",
              .presence = Presence::optional},
             branch.fit_ratio);
  visit.flag({.name = "fit_time",
              .sentence = "Fit the relaxation time, or keep it.",
              .presence = Presence::optional},
             branch.fit_time);
}

/// Models that a study can fit: those made from their moduli alone.
static std::vector<std::pair<std::string, ElasticModel>> models_of_moduli() {
  std::vector<std::pair<std::string, ElasticModel>> models;
  for (const ElasticModelCard& card : elastic_models())
    if (card.shape == ElasticShape::moduli) models.emplace_back(card.name, card.model);
  return models;
}

void describe(Visitor& visit, StudyFem& fem) {
  visit.choice<ElasticModel>({.name = "elastic",
                              .sentence = "Stored energy of the ball's material.",
                              .presence = Presence::optional},
                             models_of_moduli(), fem.elastic);
  visit.number({.name = "poisson_ratio",
                .sentence = "Poisson ratio; assumed, not fitted.",
                .range = from_to(0.2, 0.45)},
               fem.poisson_ratio);
  const auto cells = [&](const char* name, const char* sentence, int& member) {
    visit.whole({.name = name,
                 .sentence = sentence,
                 .presence = Presence::optional,
                 .range = from_to(50, 100000)},
                member);
  };
  cells("cells", "Cells of the reference runs.", fem.cells);
  cells("coarse_cells", "Cells of the second run; its distance is the numerical spread shown.",
        fem.coarse_cells);
  cells("calibration_cells", "Cells of the runs inside the material fit.", fem.calibration_cells);
  const auto travel = [&](const char* name, const char* sentence, double& member) {
    visit.number({.name = name,
                  .sentence = sentence,
                  .presence = Presence::optional,
                  .unit = "mm",
                  .range = at_least(0.0)},
                 member);
  };
  travel("platen_from", "Shortest platen travel that the stiffness in the data was fitted over.",
         fem.shortest_travel);
  travel("platen_to", "Longest platen travel that it was fitted over.", fem.longest_travel);
  visit.number({.name = "contact_threshold",
                .sentence = "Force that starts and ends contact, where a data set states none.",
                .presence = Presence::optional,
                .unit = "N",
                .range = at_least(0.0)},
               fem.contact_threshold);
  const auto share = [&](const char* name, const char* sentence, double& member) {
    visit.number({.name = name,
                  .sentence = sentence,
                  .presence = Presence::optional,
                  .range = from_to(0.001, 1.0)},
                 member);
  };
  share("mean_deflection_uncertainty",
        "Share of a mean deflection that it is uncertain by, where the data set states none.",
        fem.mean_deflection_uncertainty);
  share("pooled_peak_uncertainty", "The same of a peak that stands for several balls.",
        fem.pooled_peak_uncertainty);
  visit.list({.name = "branch", .sentence = "One Prony branch of the fit; repeat for more."},
             fem.branches);
}

void describe(Visitor& visit, StudyCore& core) {
  visit.text({.name = "label", .sentence = "How the core is called in the report."}, core.label);
  visit.text(
      {.name = "data", .sentence = "Data-set folder; a relative path starts at the study file."},
      core.data);
}

void describe(Visitor& visit, StudyExperiment& experiment) {
  visit.text({.name = "label", .sentence = "How the experiment is called in the report."},
             experiment.label);
  visit.text({.name = "synthesis",
              .sentence = "Synthesis file; a relative path starts at the study file."},
             experiment.synthesis);
  visit.text({.name = "model", .sentence = "Impact file whose [model] is believed."},
             experiment.model);
}

void describe(Visitor& visit, StudyFile& study) {
  describe_schema(visit);
  visit.text({.name = "title", .sentence = "Title of the report."}, study.title);
  visit.text({.name = "reproduce",
              .sentence = "Folder of the paper's data: its printed numbers are checked against "
                          "each other. A relative path starts at the study file.",
              .presence = Presence::optional},
             study.reproduce);
  visit.table({.name = "fem", .sentence = "The finite-element model."}, study.fem);
  visit.list({.name = "core", .sentence = "One ball; repeat for more."}, study.cores);
  visit.list({.name = "experiment",
              .sentence = "A synthetic experiment to be diagnosed; repeat for more.",
              .presence = Presence::optional},
             study.experiments);
}

StudyFile read_study(const Document& document) {
  StudyFile study;
  Reader reader(document);
  describe(static_cast<Visitor&>(reader), study);
  reader.finish();
  if (study.cores.empty()) throw document.error_at("core", "the study names no core");
  if (study.fem.branches.empty())
    throw document.error_at("fem.branch", "the material needs a branch to lose energy with");
  if (study.fem.longest_travel <= study.fem.shortest_travel)
    throw document.error_at("fem.platen_to", "the range of platen travel is empty",
                            "above platen_from");
  if (!study.reproduce.empty()) study.reproduce = (document.folder() / study.reproduce).string();
  std::set<std::string> labels;
  for (std::size_t i = 0; i < study.cores.size(); ++i) {
    const std::string key = "core[" + std::to_string(i) + "].label";
    const std::string& label = study.cores[i].label;
    if (label.empty() || label.find_first_of("/\\.") != std::string::npos)
      throw document.error_at(key, "a label names a folder too", "text without / \\ .");
    if (!labels.insert(label).second) throw document.error_at(key, "two cores of one label");
    study.cores[i].data = (document.folder() / study.cores[i].data).string();
  }
  for (StudyExperiment& experiment : study.experiments) {
    experiment.synthesis = (document.folder() / experiment.synthesis).string();
    experiment.model = (document.folder() / experiment.model).string();
  }
  return study;
}

}  // namespace rebound
