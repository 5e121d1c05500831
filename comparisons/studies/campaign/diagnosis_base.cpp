#include "comparisons/studies/campaign/diagnosis_base.hpp"

#include <limits>

#include "comparisons/discrepancy/diagnosis/believed_model.hpp"
#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/studies/campaign/campaign_base.hpp"

namespace rebound {
namespace {

constexpr const char* experiment_path = "experiment";
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The experiment that is made for every member.
struct Experiment {
  Document document;
  SynthesisFile file;  ///< as written
};

MemberResult result_of(const Diagnosis& diagnosis) {
  MemberResult result;
  const auto add_text = [&](const char* name, const std::string& text) {
    result.values.push_back({.name = name, .value = text});
  };
  const auto add = [&](const char* name, std::optional<double> number) {
    result.values.push_back({.name = name, .value = number.value_or(none)});
  };
  const bool one = diagnosis.effects.size() == 1 && diagnosis.candidates.size() == 1;
  const NamedEffect* named = one ? &diagnosis.effects.front() : nullptr;
  add_text("verdict", std::string(name_of(diagnosis.verdict)));
  add_text("family", diagnosis.family == EffectFamily::none
                         ? std::string()
                         : std::string(name_of(diagnosis.family)));
  add_text("name", named ? named->effect.name : std::string());
  add("size", named ? named->size.value : none);
  add("size.low", named ? named->size.low : none);
  add("size.high", named ? named->size.high : none);
  add("candidates", static_cast<double>(diagnosis.candidates.size()));
  add("gap_before", diagnosis.gap.before);
  add("gap_after", diagnosis.gap.after);
  add("held_out_before", diagnosis.gap.held_out_before);
  add("held_out_after", diagnosis.gap.held_out_after);
  return result;
}

struct DiagnosisBase final : Campaign::Base {
  DiagnosisFile file;
  std::optional<Document> believed;
  std::vector<Dataset> data;
  std::optional<Experiment> experiment;
  std::string content;  ///< of all files that it reads

  explicit DiagnosisBase(Document read) : Base(std::move(read)) {
    read_document(document, file);
    if (file.data.empty() == file.experiment.empty())
      throw document.error_at(file.data.empty() ? "data" : "experiment", "what is diagnosed?",
                              "data, a list of data-set folders, or experiment, a synthesis file");
    believed = Document::load(document.folder() / file.believed);
    content = "diagnosis\n" + sha256(believed->text()) + "\n";
    for (const std::string& folder : file.data) {
      data.push_back(read_dataset(document.folder() / folder));
      content += digest_of_folder(document.folder() / folder) + "\n";
    }
    if (!file.experiment.empty()) read_experiment();
    const BelievedModel model =
        read_believed_model(*believed, data.empty() ? std::vector<Dataset>{stated()} : data);
    if (model.fem && !model.fem->mesh_file.empty())
      content += sha256(bytes_of(model.fem->mesh_file)) + "\n";
    if (file.ask_fem && has_fem_tier()) fem_tier();  // loaded before there are threads
  }

  void read_experiment() {
    Document read = Document::load(document.folder() / file.experiment);
    SynthesisFile written = read_uncompleted_synthesis(read);
    SynthesisFile complete = written;
    complete_synthesis(read, complete);
    if (!complete.fem.mesh_file.empty()) content += sha256(bytes_of(complete.fem.mesh_file)) + "\n";
    if (written.tier == Tier::fem) fem_tier();
    experiment.emplace(Experiment{std::move(read), std::move(written)});
  }

  /// What the experiment states of itself: the ball and the speeds, nothing measured.
  Dataset stated() const {
    Dataset dataset;
    dataset.sphere = experiment->file.sphere;
    for (const SynthesisShot& shot : experiment->file.shots)
      dataset.shots.push_back({.impact = {.speed = shot.speed}});
    return dataset;
  }

  std::vector<Key> numbers() const override {
    std::vector<Key> keys = numbers_of(file);
    if (experiment)
      for (Key& key : numbers_of(experiment->file, experiment_path)) keys.push_back(std::move(key));
    return keys;
  }

  bool gives(const std::string& path) const override {
    const std::string below = std::string(experiment_path) + ".";
    if (!path.starts_with(below)) return Base::gives(path);
    const std::string inner = path.substr(below.size());
    return inner != "schema" && toml::at_path(experiment->document.root(), inner);
  }

  DiagnosisRequest request_of(const DiagnosisFile& varied, std::vector<Dataset> datasets) const {
    DiagnosisRequest request = request_for(*believed, std::move(datasets));
    request.held_out_speed = varied.held_out_speed;
    request.hold_out = varied.hold_out;
    request.ask_fem = varied.ask_fem;
    request.seed = static_cast<std::uint64_t>(varied.seed);
    if (!varied.bootstrap) request.rules.bootstrap_draws = 0;
    return request;
  }

  std::unique_ptr<Campaign::Member> member(const Campaign& campaign,
                                           std::vector<double> values) const override {
    DiagnosisFile varied = file;
    set_numbers(varied, campaign.design().factors, values);
    std::optional<SynthesisFile> made;
    if (experiment) {
      made = experiment->file;
      set_numbers(*made, campaign.design().factors, values, experiment_path);
    }
    return make_member(
        campaign, content + write_toml(varied) + (made ? write_toml(*made) : ""), std::move(values),
        [&]() -> MemberWork {
          if (made) complete_synthesis(experiment->document, *made);
          return [this, varied, made](const RunControl& control) {
            std::vector<Dataset> datasets = data;
            if (made)
              datasets.push_back(synthesize(*made, simulator_of(*made, control), control).dataset);
            return result_of(diagnose(request_of(varied, std::move(datasets)), control));
          };
        });
  }
};

}  // namespace

void describe(Visitor& visit, DiagnosisFile& file) {
  constexpr Presence optional = Presence::optional;
  describe_schema(visit);
  visit.text({.name = "believed",
              .sentence = "Impact file whose [model] is believed; relative to this file."},
             file.believed);
  visit.texts({.name = "data",
               .sentence = "Data-set folders that are diagnosed together; relative to this file.",
               .presence = optional},
              file.data);
  visit.text({.name = "experiment",
              .sentence = "Instead of data: a synthesis file, made anew for every member. Its keys "
                          "are varied as experiment.KEY.",
              .presence = optional},
             file.experiment);
  visit.whole({.name = "seed",
               .sentence = "Of the draws behind the thresholds.",
               .presence = optional,
               .range = from_to(0.0, 9e15)},
              file.seed);
  visit.number({.name = "held_out_speed",
                .sentence = "Speed that no fit sees; default: the middle one.",
                .presence = optional,
                .unit = "m/s",
                .range = above_up_to(0.0, 1000.0)},
               file.held_out_speed);
  visit.flag(
      {.name = "hold_out", .sentence = "Keep one speed from the fits.", .presence = optional},
      file.hold_out);
  visit.flag({.name = "bootstrap",
              .sentence = "Repeat the choice between candidates on data drawn anew.",
              .presence = optional},
             file.bootstrap);
  visit.flag({.name = "ask_fem",
              .sentence = "May FE be asked what it adds to the believed model?",
              .presence = optional},
             file.ask_fem);
}

std::shared_ptr<const Campaign::Base> read_diagnosis_base(Document document) {
  return std::make_shared<DiagnosisBase>(std::move(document));
}

}  // namespace rebound
