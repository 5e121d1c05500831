#include "comparisons/accuracy/foams/published_foam.hpp"

#include <algorithm>

#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/describe_material.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/models/installation.hpp"

namespace rebound {

void describe(Visitor& visit, StatedStress& stress) {
  visit.number({.name = "strain_from",
                .sentence = "Compressive strain where the mean begins.",
                .range = from_to(0.0, 0.95)},
               stress.strain_from);
  visit.number({.name = "strain_to",
                .sentence = "Where it ends; the same for one strain.",
                .range = from_to(0.0, 0.95)},
               stress.strain_to);
  visit.number({.name = "mean_stress",
                .sentence = "Mean compressive nominal stress.",
                .unit = "kPa",
                .range = above(0.0)},
               stress.mean_stress);
  visit.number({.name = "uncertainty",
                .sentence = "Of it; absent: the source's formula, exact.",
                .presence = Presence::optional,
                .unit = "kPa",
                .range = at_least(0.0)},
               stress.uncertainty);
}

void describe(Visitor& visit, StatedValues& stated) {
  visit.number({.name = "youngs_modulus",
                .sentence = "At small strain.",
                .unit = "MPa",
                .range = above(0.0)},
               stated.youngs_modulus);
  visit.number({.name = "youngs_modulus_uncertainty",
                .sentence = "Of it; absent: it follows from the constants.",
                .presence = Presence::optional,
                .unit = "MPa",
                .range = at_least(0.0)},
               stated.youngs_modulus_uncertainty);
  visit.number({.name = "poisson_ratio",
                .sentence = "At small strain; absent: not stated.",
                .presence = Presence::optional,
                .range = between(-1.0, 0.5)},
               stated.poisson_ratio);
  visit.list({.name = "stress",
              .sentence = "A stated stress; repeat for more.",
              .presence = Presence::optional},
             stated.stresses);
}

void describe(Visitor& visit, PublishedFoam& foam) {
  describe_schema(visit);
  visit.text({.name = "name", .sentence = "The foam."}, foam.name);
  visit.text({.name = "source", .sentence = "Where constants and stated values are from."},
             foam.source);
  visit.table({.name = "material", .sentence = "Its constants."}, foam.material);
  visit.table({.name = "stated", .sentence = "What they must give."}, foam.stated);
}

PublishedFoam read_foam(const std::filesystem::path& file) {
  PublishedFoam foam;
  read_document(Document::load(file), foam);
  return foam;
}

std::vector<PublishedFoam> published_foams() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "foams"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<PublishedFoam> foams;
  foams.reserve(files.size());
  for (const auto& file : files) foams.push_back(read_foam(file));
  return foams;
}

}  // namespace rebound
