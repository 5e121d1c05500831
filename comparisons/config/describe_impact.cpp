#include "comparisons/config/describe_impact.hpp"

namespace rebound {

void describe_schema(Visitor& visit) {
  int schema = 1;
  visit.whole({.name = "schema",
               .sentence = "Version of the file format.",
               .range = from_to(1.0, 1.0)},
              schema);
}

void describe(Visitor& visit, Sphere& sphere) {
  visit.number({.name = "mass", .sentence = "Mass of the ball.", .unit = "g", .range = above(0.0)},
               sphere.mass);
  visit.number({.name = "diameter",
                .sentence = "Diameter of the undeformed ball.",
                .unit = "mm",
                .range = above(0.0)},
               sphere.diameter);
}

void describe(Visitor& visit, Impact& impact) {
  visit.number({.name = "speed",
                .sentence = "Approach speed at first touch.",
                .unit = "m/s",
                .range = above_up_to(0.0, 1000.0)},
               impact.speed);
  visit.choice<SeparationRule>(
      {.name = "separation",
       .sentence = "When the contact counts as ended: the compressive force stays zero, or the "
                   "centre of mass is back (lumped tier only).",
       .presence = Presence::optional},
      {{"zero-force", SeparationRule::zero_force},
       {"zero-deflection", SeparationRule::zero_deflection}},
      impact.separation);
}

}  // namespace rebound
