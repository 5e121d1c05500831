#include "comparisons/studies/study/study_experiments.hpp"

#include <fmt/format.h>

#include "comparisons/discrepancy/diagnosis/believed_model.hpp"
#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "comparisons/io/toml/describe_effect.hpp"

namespace rebound {
namespace {

std::string hidden_in(const SynthesisFile& file) {
  std::string text = file.tier == Tier::fem ? "FE" : "lumped";
  if (file.effects.empty()) return text + ", nothing";
  for (const EffectChoice& effect : file.effects) {
    const std::string unit = size_unit(find_effect(effect.name).card);
    text += fmt::format(", {} {:.3g}{}", effect.name, effect.size, unit.empty() ? "" : " " + unit);
  }
  return text;
}

}  // namespace

ExperimentStudy study_experiment(const StudyExperiment& experiment, const RunControl& control) {
  const SynthesisFile file = read_synthesis(Document::load(experiment.synthesis));
  const Synthesis made = synthesize(file, simulator_of(file, control), control);
  const DiagnosisRequest request = request_for(Document::load(experiment.model), {made.dataset});
  return {.label = experiment.label,
          .hidden = hidden_in(file),
          .diagnosis = diagnose(request, control)};
}

}  // namespace rebound
