#include <fmt/format.h>

#include <algorithm>

#include "comparisons/accuracy/foams/foam_rows.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

constexpr int curve_points = 80;
constexpr double deepest = 0.8;  // compressive strain of a curve

struct FoamCurve {
  std::vector<double> strain, stress, lateral;  ///< [-], [kPa], [-]
};

FoamCurve curve_of(const MaterialLaws& laws, const PublishedFoam& foam) {
  double to = foam.stated.stresses.empty() ? 0.2 : 0.0;  // small strain is all that is claimed
  for (const StatedStress& stress : foam.stated.stresses) to = std::max(to, stress.strain_to + 0.1);
  to = std::min(to, deepest);
  FoamCurve curve;
  for (int i = 0; i <= curve_points; ++i) {
    const double strain = to * i / curve_points;
    const UniaxialState state = laws.uniaxial(foam.material, {1.0 - strain}).front();
    curve.strain.push_back(strain);
    curve.stress.push_back(i == 0 ? 0.0 : -1e-3 * state.nominal_stress);
    curve.lateral.push_back(state.lateral_stretch);
  }
  return curve;
}

report::Figure figure_of(const PublishedFoam& foam, const FoamCurve& curve) {
  report::Figure figure{
      .title = foam.name,
      .caption =
          "Slow uniaxial compression, sides free. Points: what the source states, a range by "
          "its middle with the range as bar. " +
          foam.source + ".",
      .x = {.quantity = "compressive strain", .unit = "1"},
      .y = {.quantity = "nominal stress", .unit = "kPa"},
      .series = {{.name = "this program",
                  .origin = report::Origin::predicted,
                  .x = curve.strain,
                  .y = curve.stress}}};
  report::Series stated{.name = "stated",
                        .origin = report::Origin::derived,
                        .style = report::Series::Style::points,
                        .role = report::Series::Role::reference};
  for (const StatedStress& stress : foam.stated.stresses) {
    stated.x.push_back(0.5 * (stress.strain_from + stress.strain_to));
    stated.x_error.push_back(0.5 * (stress.strain_to - stress.strain_from));
    stated.y.push_back(1e-3 * stress.mean_stress);
    stated.y_error.push_back(1e-3 * stress.uncertainty);
  }
  if (!stated.x.empty()) figure.series.push_back(std::move(stated));
  return figure;
}

}  // namespace

void write_foam_curves(const MaterialLaws& laws, const std::vector<PublishedFoam>& foams,
                       const std::filesystem::path& folder) {
  report::Section section{.title = "Published foams"};
  std::string csv = "foam,compressive_strain,nominal_stress_Pa,lateral_stretch\n";
  for (const PublishedFoam& foam : foams) {
    const FoamCurve curve = curve_of(laws, foam);
    for (std::size_t i = 0; i < curve.strain.size(); ++i)
      csv += fmt::format("\"{}\",{:.17g},{:.17g},{:.17g}\n", foam.name, curve.strain[i],
                         1e3 * curve.stress[i], curve.lateral[i]);
    section.blocks.push_back(figure_of(foam, curve));
  }
  write_file_atomically(folder / "foams.csv", csv);
  report::write_report(
      {.title = "Published foams",
       .subtitle = "Constants in comparisons/studies/data/foams",
       .headline = "Initial modulus, Poisson ratio and stresses of published foams, as "
                   "the FE tier's materials give them.",
       .sections = {section}},
      folder / "foams.html");
}

}  // namespace rebound
