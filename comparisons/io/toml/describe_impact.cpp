#include "comparisons/io/toml/describe_impact.hpp"

namespace rebound {

void describe_schema(Visitor& visit) {
  int schema = 1;
  visit.whole(
      {.name = "schema", .sentence = "Version of the file format.", .range = from_to(1.0, 1.0)},
      schema);
}

void describe(Visitor& visit, Sphere& sphere) {
  visit.number<&Sphere::mass>(sphere, {.sentence = "Mass of the ball."});
  visit.number<&Sphere::diameter>(sphere, {.sentence = "Diameter of the undeformed ball."});
}

void describe(Visitor& visit, Impact& impact) {
  visit.number<&Impact::speed>(impact, {.sentence = "Approach speed at first touch."});
  visit.choice(
      {.name = "separation",
       .sentence = "When the contact counts as ended: the compressive force stays zero, or the "
                   "centre of mass is back (lumped tier only).",
       .presence = Presence::optional},
      impact.separation);
}

}  // namespace rebound
