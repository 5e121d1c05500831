#include "comparisons/inference/selection/selection_file.hpp"

#include "comparisons/io/toml/describe_impact.hpp"

namespace rebound {

void describe(Visitor& visit, Candidate& candidate) {
  visit.text({.name = "label", .sentence = "Name of the candidate."}, candidate.label);
  describe_law_request(visit, candidate.request);
}

void describe(Visitor& visit, SelectionFile& file) {
  describe_schema(visit);
  visit.choice({.name = "observable",
                .sentence = "The curve that is fitted.",
                .presence = Presence::optional},
               file.options.observable);
  visit.choice(
      {.name = "weighting",
       .sentence = "Where the force noise is unknown: every newton counts the same, or every "
                   "trace does.",
       .presence = Presence::optional},
      file.options.weighting);
  visit.list({.name = "law", .sentence = "A candidate; repeat for more."}, file.candidates);
  visit.list({.name = "reference", .sentence = "What they are fitted to; repeat for more."},
             file.references);
}

}  // namespace rebound
