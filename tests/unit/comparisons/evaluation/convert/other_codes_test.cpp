#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <set>

#include "comparisons/evaluation/convert/code_conversion.hpp"
#include "comparisons/evaluation/convert/code_conversion_text.hpp"
#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

ConversionRequest request_of_law() {
  ConversionRequest request;
  request.sphere = test::core_a();
  request.impact = {.speed = 15.0, .separation = SeparationRule::zero_force};
  request.given.convention = Convention::law;
  request.given.model = test::typical_problem("kuwabara-kono").model;
  return request;
}

double setting(const CodeConversion& conversion, const std::string& name) {
  for (const auto& parameter : conversion.settings)
    if (parameter.name == name) return parameter.value;
  throw std::logic_error("no setting " + name);
}

TEST(OtherCodesTest, TheIssuesTwelve) {
  std::set<std::string> names;
  for (const OtherCode& code : other_codes()) names.insert(code.name);
  EXPECT_EQ(names,
            (std::set<std::string>{"lammps", "liggghts", "yade", "mercurydpm", "chrono", "simbody",
                                   "drake", "mujoco", "bullet", "ode", "sdf", "urdf"}));
  EXPECT_THROW(other_code("granular"), Error);
}

TEST(OtherCodesTest, HoldAtTheirOwnSpeed) {
  for (const OtherCode& code : other_codes()) {
    const CodeConversion conversion =
        convert_to_code(code, request_of_law(), {.speeds = {5.0, 15.0}});
    ASSERT_EQ(conversion.errors.size(), 2u);
    const CodeError& own = conversion.errors[1];
    ASSERT_EQ(own.failure, "") << code.name;
    // Codes that step: first order in the step, a 500th of the contact.
    EXPECT_NEAR(*own.of_law->restitution, 0.0, code.stepping ? 0.01 : 1e-8) << code.name;
    EXPECT_NEAR(*own.of_law->contact_time, 0.0, code.stepping ? 0.01 : 1e-7) << code.name;
    // Elsewhere every one of them misses: none has the law that was given.
    EXPECT_GT(std::abs(*conversion.errors[0].of_law->restitution), 0.01) << code.name;
  }
}

// What is pasted carries the settings that are listed, to nine digits.
TEST(OtherCodesTest, LinesHoldTheirNumbers) {
  for (const OtherCode& code : other_codes()) {
    const CodeConversion conversion = convert_to_code(code, request_of_law(), {});
    const std::regex number(R"([0-9]+\.?[0-9]*(e[+-]?[0-9]+)?)");
    std::vector<double> numbers;
    const std::string& lines = conversion.lines;
    for (std::sregex_iterator at(lines.begin(), lines.end(), number), end; at != end; ++at)
      numbers.push_back(std::stod(at->str()));
    for (const auto& parameter : conversion.settings) {
      if (code.name == std::string("urdf") && parameter.name == "max_step_size") continue;
      bool there = false;
      for (const double value : numbers) there |= std::abs(value / parameter.value - 1.0) < 1e-8;
      EXPECT_TRUE(there) << code.name << " " << parameter.name << "\n" << lines;
    }
  }
}

// The Hertz codes: their force, written anew from their own documentation, against the law that
// the numbers were matched with.
TEST(OtherCodesTest, SettingsMeanTheLawInTheCodesOwnFormula) {
  const Sphere ball = test::core_a();
  const double radius = ball.radius(), x = 2e-3, v = 3.0;
  const auto force = [&](const std::string& name) {
    const CodeConversion conversion = convert_to_code(other_code(name), request_of_law(), {});
    const auto& values = conversion.contact.values;
    return std::pair{conversion, values.at("stiffness") * std::pow(x, 1.5) +
                                     values.at("damping") * std::pow(x, 0.25) * v};
  };
  const auto beta = [](double e) {
    return std::log(e) / std::hypot(std::log(e), std::numbers::pi);
  };
  const auto hertz = [&](double modulus, double r, double e) {
    const double sn = 2.0 * modulus * std::sqrt(r * x);
    return 2.0 / 3.0 * sn * x -
           2.0 * std::sqrt(5.0 / 6.0) * beta(e) * std::sqrt(sn * ball.mass) * v;
  };
  const double both = 1.0 / (2.0 * (1.0 - 0.09));
  {
    const auto [made, expected] = force("liggghts");
    EXPECT_NEAR(hertz(setting(made, "youngsModulus") * both, radius,
                      setting(made, "coefficientRestitution")) /
                    expected,
                1.0, 1e-9);
  }
  {
    const auto [made, expected] = force("chrono");
    EXPECT_NEAR(hertz(setting(made, "young_modulus") * both, setting(made, "effective_radius"),
                      setting(made, "restitution")) /
                    expected,
                1.0, 1e-9);
  }
  {
    const auto [made, expected] = force("yade");
    EXPECT_NEAR(hertz(setting(made, "young") * both, radius / 2.0, setting(made, "en")) / expected,
                1.0, 1e-9);
  }
  {
    const auto [made, expected] = force("mercurydpm");
    EXPECT_NEAR(
        hertz(setting(made, "effective_elastic_modulus"), radius, setting(made, "restitution")) /
            expected,
        1.0, 1e-9);
  }
  {
    const auto [made, expected] = force("lammps");
    const double kn = setting(made, "kn") * std::sqrt(radius * x);
    const double damping = std::sqrt(5.0) * -beta(setting(made, "en")) * std::sqrt(ball.mass * kn);
    EXPECT_NEAR((kn * x + damping * v) / expected, 1.0, 1e-9);
  }
}

TEST(OtherCodesTest, DissipationsMeanTheLawToo) {
  const double x = 2e-3, v = 3.0, radius = test::core_a().radius();
  const CodeConversion simbody = convert_to_code(other_code("simbody"), request_of_law(), {});
  const double k = std::pow(setting(simbody, "stiffness"), 2.0 / 3.0) / 2.0;
  const double hertz = 4.0 / 3.0 * k * x * std::sqrt(radius * k * x);
  const auto& hc = simbody.contact.values;
  EXPECT_NEAR(hertz * (1.0 + 1.5 * setting(simbody, "dissipation") * v) /
                  ((hc.at("stiffness") + hc.at("damping") * v) * std::pow(x, 1.5)),
              1.0, 1e-9);
  const CodeConversion drake = convert_to_code(other_code("drake"), request_of_law(), {});
  const auto& point = drake.contact.values;
  EXPECT_NEAR(setting(drake, "point_contact_stiffness") / 2.0 * x *
                  (1.0 + setting(drake, "hunt_crossley_dissipation") * v) /
                  ((point.at("stiffness") + point.at("damping") * v) * x),
              1.0, 1e-9);
}

TEST(OtherCodesTest, ScalarsKnowNoOtherSpeed) {
  ConversionRequest request = request_of_law();
  request.given.convention = Convention::restitution;
  request.given.stiffness = 3.5e6;
  request.given.restitution = 0.5;
  const auto conversion = convert_to_code(other_code("lammps"), request, {});
  EXPECT_FALSE(conversion.errors.front().of_law.has_value());
  EXPECT_NEAR(*conversion.errors[2].of_law->restitution, 0.0, 1e-8);
  EXPECT_FALSE(conversion.errors[2].of_law->contact_time.has_value());
}

TEST(OtherCodesTest, ErrorsAgainstFe) {
  CodeRequest options{.speeds = {10.0}};
  options.fem.emplace().sphere = test::core_a();
  options.run = [](const FemProblem& problem) {
    FemResult result;
    result.scalars.restitution = 0.4;
    result.scalars.contact_time = 2e-3;
    result.scalars.peak_force = 1000.0;
    EXPECT_EQ(problem.impact.speed, 10.0);
    return result;
  };
  const CodeError error =
      convert_to_code(other_code("simbody"), request_of_law(), options).errors.front();
  EXPECT_NEAR(*error.of_fem->restitution, *error.returned.restitution - 0.4, 1e-12);
  EXPECT_NEAR(*error.of_fem->peak_force, *error.returned.peak_force / 1000.0 - 1.0, 1e-12);
  options.fem->sphere.mass *= 1.01;
  EXPECT_THROW(convert_to_code(other_code("simbody"), request_of_law(), options), Error);
}

TEST(OtherCodesTest, Refusals) {
  for (const double speed : {0.0, -1.0, std::nan(""), 1e4})
    EXPECT_THROW(convert_to_code(other_code("ode"), request_of_law(), {.speeds = {speed}}), Error);
  for (const double step : {0.0, -1e-3, std::nan(""), 2.0})
    EXPECT_THROW(convert_to_code(other_code("ode"), request_of_law(), {.step = step}), Error);
  // Overcritical: a code that keeps its tension can be asked for no restitution that gives this.
  EXPECT_THROW(
      (CodeContact{.sphere = test::core_a(), .values = {{"stiffness", 1e6}, {"damping", 1e4}}}
           .asked_restitution()),
      Error);
}

TEST(SteppedContactTest, TendsToTheLawAtFirstOrder) {
  const LinearKelvinVoigt law{.stiffness = 2e5, .damping = 40.0};
  const KelvinVoigtImpact exact(law, {.mass = 0.0896, .speed = 15.0});
  const double e = exact.restitution(SeparationRule::zero_force);
  for (const auto stepping :
       {ContactStepping::implicit, ContactStepping::predicted, ContactStepping::semi_implicit}) {
    double last = 0.0;
    for (const double step : {4e-6, 2e-6, 1e-6}) {
      const Observed found = stepped_impact({.mass = 0.0896,
                                             .speed = 15.0,
                                             .spring = law.stiffness,
                                             .dashpot = law.damping,
                                             .step = step,
                                             .stepping = stepping});
      const double miss = std::abs(*found.restitution - e);
      if (last > 0.0) {
        EXPECT_LT(miss, 0.75 * last);
      }
      last = miss;
      EXPECT_NEAR(*found.contact_time / exact.contact_time(SeparationRule::zero_force), 1.0, 0.02);
    }
    EXPECT_LT(last, 2e-3);
  }
}

// A first step from before the touch, as Bullet sets up its constraint: the speed that is left for
// the impulse is v - d/h, and erp and cfm are those of the spring and dashpot.
TEST(SteppedContactTest, APredictedContactIsThatOfBullet) {
  const double m = 0.3, h = 1e-3, k = 4e4, c = 25.0, v = 6.0, late = 0.4;
  const double distance = (1.0 - late) * h * v, cfm = 1.0 / (h * k + c), erp = h * k * cfm;
  double x = -distance, speed = v, peak = 0.0;
  do {
    const double asked = x < 0.0 ? speed + x / h : speed + erp * x / h;
    const double impulse = std::max(0.0, asked / (1.0 / m + cfm / h));
    peak = std::max(peak, impulse / h);
    speed -= impulse / m;
    x += h * speed;
  } while (x > 0.0);
  const Observed found = stepped_impact({.mass = m,
                                         .speed = v,
                                         .spring = k,
                                         .dashpot = c,
                                         .step = h,
                                         .late = late,
                                         .stepping = ContactStepping::predicted});
  EXPECT_NEAR(*found.restitution, -speed / v, 1e-12);
  EXPECT_NEAR(*found.peak_force / peak, 1.0, 1e-12);
}

TEST(SteppedContactTest, ALateTouchBouncesHigher) {
  SteppedContact contact{.mass = 1.0, .speed = 1.0, .spring = 1.0, .dashpot = 0.2, .step = 0.2};
  const double early = *stepped_impact(contact).restitution;
  contact.late = 1.0;
  EXPECT_GT(*stepped_impact(contact).restitution, early);
}

}  // namespace
}  // namespace rebound
