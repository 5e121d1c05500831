#include "comparisons/studies/reproduce/paper.hpp"

#include <fmt/format.h>

#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/studies/reproduce/row.hpp"

namespace rebound {
namespace {

struct CoreFolder {
  const char* name;
  const char* folder;
};
constexpr CoreFolder core_folders[] = {{"A", "sliotar-core-a"},
                                       {"B", "sliotar-core-b"},
                                       {"C", "sliotar-core-c"},
                                       {"D", "sliotar-core-d"}};
constexpr const char* claims_file = "sliotar-paper/claims.toml";

/// A line of claims.toml before its number is read with its digits.
struct ClaimText {
  std::string id;
  std::string section;
  std::string quantity;
  std::string unit;
  Claim::Relation relation = Claim::Relation::equals;
  double value = 0.0;
};

struct ClaimFile {
  std::string source;
  double standard_mass = 0.0;
  double standard_diameter = 0.0;
  ParameterStudy parameter_study;
  std::vector<ClaimText> claims;
};

void describe(Visitor& visit, ClaimText& claim) {
  visit.text({.name = "id", .sentence = "What the number is of."}, claim.id);
  visit.text({.name = "section", .sentence = "Where it stands."}, claim.section);
  visit.text({.name = "quantity", .sentence = "What it is, in words."}, claim.quantity);
  visit.text({.name = "unit", .sentence = "Unit of value; % and 1 have no dimension."}, claim.unit);
  visit.choice<Claim::Relation>({.name = "relation",
                                 .sentence = "A value, or a bound on one.",
                                 .presence = Presence::optional},
                                {{"equals", Claim::Relation::equals},
                                 {"below", Claim::Relation::below},
                                 {"above", Claim::Relation::above}},
                                claim.relation);
  visit.number({.name = "value", .sentence = "As printed, with its trailing zeros."}, claim.value);
}

void describe_study(Visitor& visit, ParameterStudy& study) {
  visit.number({.name = "mass", .sentence = "Of the ball.", .unit = "g", .range = above(0.0)},
               study.mass);
  visit.number({.name = "speed", .sentence = "Approach speed.", .unit = "m/s", .range = above(0.0)},
               study.speed);
  visit.number({.name = "restitution", .sentence = "Put into Eq. (8).", .range = from_to(0.0, 1.0)},
               study.restitution);
  visit.number({.name = "lowest_stiffness",
                .sentence = "Of the sweep.",
                .unit = "N/m^1.5",
                .range = above(0.0)},
               study.lowest_stiffness);
  visit.number({.name = "highest_stiffness",
                .sentence = "Of the sweep.",
                .unit = "N/m^1.5",
                .range = above(0.0)},
               study.highest_stiffness);
}

void describe(Visitor& visit, ClaimFile& file) {
  visit.text({.name = "source", .sentence = "Whose claims these are."}, file.source);
  visit.number({.name = "standard_mass", .sentence = "Of the game's ball.", .unit = "g"},
               file.standard_mass);
  visit.number({.name = "standard_diameter", .sentence = "Of the game's ball.", .unit = "mm"},
               file.standard_diameter);
  visit.visit_table({.name = "parameter_study", .sentence = "Stiffness sweep of section 4.5."},
                    [&](Visitor& inner) { describe_study(inner, file.parameter_study); });
  visit.list({.name = "claim", .sentence = "A number of the text; repeat for more."}, file.claims);
}

void read_claims(const std::filesystem::path& file, Paper& paper) {
  const Document document = Document::load(file);
  ClaimFile texts;
  Reader reader(document);
  describe(reader, texts);
  reader.finish();
  paper.standard_mass = printed_number(document, "standard_mass");
  paper.standard_diameter = printed_number(document, "standard_diameter");
  paper.parameter_study = texts.parameter_study;
  for (std::size_t i = 0; i < texts.claims.size(); ++i) {
    const ClaimText& text = texts.claims[i];
    Claim claim{text.id,       text.section,
                text.quantity, text.unit,
                text.relation, printed_number(document, fmt::format("claim[{}].value", i))};
    const double size = unit_size({.unit = text.unit});
    claim.value.value *= size;
    claim.value.half_width *= size;
    paper.claims.push_back(claim);
  }
}

PaperCore read_core(const std::filesystem::path& folder, const std::string& name) {
  const Dataset dataset = read_dataset(folder);
  const Document document = Document::load(folder / "dataset.toml");
  const auto printed = [&](const std::string& key) { return printed_number(document, key); };
  PaperCore core{.name = name,
                 .mass = printed("sphere.mass"),
                 .diameter = printed("sphere.diameter"),
                 .block_modulus = printed("block[0].modulus"),
                 .platen_stiffness = printed("quasistatic[0].stiffness"),
                 .published = read_published_values(folder)};
  constexpr std::size_t speeds = 3;  // 5, 15 and 25 m/s
  if (dataset.shots.size() != speeds)
    throw document.error_at("shot", "the paper has three speeds", "three [[shot]] tables");
  for (std::size_t i = 0; i < speeds; ++i) {
    const auto at = [&](const char* key) { return printed(fmt::format("shot[{}].{}", i, key)); };
    if (i >= core.published.at_speed.size() ||
        core.published.at_speed[i].speed != dataset.shots[i].impact.speed)
      throw document.error_at(fmt::format("shot[{}].speed", i),
                              "published_model_values.toml has no such speed in this place");
    core.shots.push_back({.speed = dataset.shots[i].impact.speed,
                          .restitution = at("restitution"),
                          .contact_time = at("contact_time"),
                          .mean_deflection = at("mean_deflection"),
                          .published = core.published.at_speed[i]});
  }
  return core;
}

}  // namespace

Paper read_paper(const std::filesystem::path& data_folder) {
  Paper paper;
  for (const CoreFolder& core : core_folders) {
    const auto folder = data_folder / core.folder;
    paper.cores.push_back(read_core(folder, core.name));
    if (paper.typical_peaks.empty()) paper.typical_peaks = read_dataset(folder).pooled_peaks;
  }
  read_claims(data_folder / claims_file, paper);
  return paper;
}

std::string paper_text(const std::filesystem::path& data_folder) {
  std::string text;
  for (const CoreFolder& core : core_folders)
    for (const char* file : {"dataset.toml", "published_model_values.toml"})
      text += read_text_file(data_folder / core.folder / file);
  return text + read_text_file(data_folder / claims_file);
}

}  // namespace rebound
