#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "comparisons/discrepancy/trials/generator/trial_files.hpp"

namespace trials {
namespace {

using Json = nlohmann::ordered_json;

Json effect_json(const HiddenEffect& effect, const Scales& scales) {
  const EffectForm& form = *effect.form;
  Json parameters = Json::object();
  for (const auto& [name, value] : effect.parameters) parameters[name] = value;
  Json json = {{"family", form.family},
               {"name", form.name},
               {"form", form.formula},
               {"size", effect.size},
               {"parameters", parameters},
               {"in_registry", effect.in_registry()},
               {"registry_name", form.registry_name},
               {"visible_chi_square_alone", effect.visible_alone}};
  if (effect.in_registry())
    json["registry_size"] =
        form.registry_size ? form.registry_size(effect.size, scales) : effect.size;
  return json;
}

Json noise_json(const Trial& trial) {
  return {{"colour", name_of(trial.noise.colour)},
          {"parameter", trial.noise.parameter},
          {"share_of_smallest_baseline_peak", trial.noise.fraction},
          {"deviation_N", trial.noise.deviation},
          {"stated", name_of(trial.noise_statement)}};
}

Json rival_json(const Rival& rival) {
  return {{"form", rival.form}, {"cosine", rival.cosine}};
}

Json shots_json(const Trial& trial) {
  Json shots = Json::array();
  for (const TrialShot& shot : trial.shots)
    shots.push_back({{"speed_m_s", shot.true_speed},
                     {"restitution", shot.true_restitution},
                     {"contact_time_s", shot.true_contact_time},
                     {"peak_force_N", shot.true_peak_force}});
  return shots;
}

/// Of a ball in finite elements: what it is made of, and the deck of its first shot as it was run.
Json fem_ball_json(const Trial& trial) {
  HiddenWorld world;
  world.fem = trial.fem;
  world.impact.mass = trial.ball.mass;
  for (const HiddenEffect& effect : trial.effects) apply(effect, trial.scales, world);
  return {{"tier", "fem"},
          {"material", trial.fem.material},
          {"deck", deck_text(world.fem, {.mass = trial.ball.mass,
                                         .radius = trial.radius,
                                         .speed = trial.shots.front().true_speed})}};
}

Json scales_json(const Scales& scales) {
  return {{"x_ref_m", scales.deflection}, {"F_ref_N", scales.force},
          {"v_mid_m_s", scales.speed},    {"v_max_m_s", scales.largest_speed},
          {"T_s", scales.contact_time},   {"R_m", scales.radius}};
}

}  // namespace

std::string dataset_text(const Trial& trial) {
  std::string text = "schema = 1\n";
  auto out = std::back_inserter(text);
  fmt::format_to(out, "name = \"{} {:04}\"\n\n[sphere]\n", trial.request.set, trial.request.number);
  fmt::format_to(out, "mass = \"{:.7g} g\"\nmass_uncertainty = \"{:.3g} g\"\n",
                 1e3 * trial.mass.value, 1e3 * trial.mass.uncertainty);
  fmt::format_to(out, "diameter = \"{:.7g} mm\"\ndiameter_uncertainty = \"{:.3g} mm\"\n",
                 1e3 * trial.diameter.value, 1e3 * trial.diameter.uncertainty);
  text += "\n[instrument]\n";
  if (trial.stated_noise) fmt::format_to(out, "force_noise = \"{:.4g} N\"\n", *trial.stated_noise);
  fmt::format_to(out, "force_gain_uncertainty = {:.4g}\n", trial.gain_uncertainty);
  int number = 0;
  for (const TrialShot& shot : trial.shots) {
    fmt::format_to(out, "\n[[shot]]\nspeed = \"{:.6g} m/s\"\nspeed_uncertainty = \"{:.3g} m/s\"\n",
                   shot.speed.value, shot.speed.uncertainty);
    fmt::format_to(out, "trace = \"shot-{:02}.csv\"\n", ++number);
    if (shot.restitution)
      fmt::format_to(out, "restitution = {:.5f}\nrestitution_uncertainty = {:.3g}\n",
                     shot.restitution->value, shot.restitution->uncertainty);
  }
  return text;
}

std::string csv_text(const TrialShot& shot) {
  std::string text = "time_s,force_N\n";
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < shot.time.size(); ++i)
    fmt::format_to(out, "{:.9g},{:.7g}\n", shot.time[i], shot.force[i]);
  return text;
}

/// The material of the ball with nothing hidden, off by as much as the numbers of a law are.
std::string believed_fem_text(const Trial& trial) {
  FemBall believed = trial.fem;
  believed.modulus *= trial.believed_stiffness / trial.ball.stiffness;
  const double loss = trial.believed_damping / (trial.ball.stiffness * trial.ball.damping);
  for (FemBranch& branch : believed.branches) branch.ratio *= loss;
  return "# What is believed: the ball is made of this. The numbers are where a fit starts.\n" +
         fem_model_text(believed);
}

std::string model_text(const Trial& trial) {
  if (trial.request.believe_fem) return believed_fem_text(trial);
  return fmt::format(
      "# What is believed: Hunt-Crossley. The numbers are where a fit starts.\n"
      "schema = 1\n[model]\ntier = \"lumped\"\nlaw = \"hunt-crossley\"\n"
      "stiffness = \"{:.4g} N/m^1.5\"\ndamping = \"{:.4g} N.s/m^2.5\"\n",
      trial.believed_stiffness, trial.believed_damping);
}

std::string truth_text(const Trial& trial, const std::string& nonce) {
  Json effects = Json::array(), families = Json::array();
  for (const HiddenEffect& effect : trial.effects) {
    effects.push_back(effect_json(effect, trial.scales));
    families.push_back(effect.form->family);
  }
  Json truth = {{"schema", 1},
                {"set", trial.request.set},
                {"trial", trial.request.number},
                {"seed", trial.request.seed},
                {"kind", trial.kind},
                {"families", families},
                {"effects", effects},
                {"visible_chi_square", trial.visible_chi_square},
                {"resolvable", trial.visible_chi_square >= 25.0},
                {"nearest_of_other_family", rival_json(trial.rivals.of_other_family)},
                {"nearest_of_other_name", rival_json(trial.rivals.of_other_name)},
                {"baseline",
                 {{"mass_kg", trial.ball.mass},
                  {"radius_m", trial.radius},
                  {"stiffness_N_m^1.5", trial.ball.stiffness},
                  {"lambda_s_m", trial.ball.damping},
                  {"damping_N_s_m^2.5", trial.ball.stiffness * trial.ball.damping},
                  {"restitution_at_v_mid", trial.restitution_at_mid_speed}}},
                {"gain", trial.true_gain},
                {"noise", noise_json(trial)},
                {"sampling_rate_Hz", trial.sampling_rate},
                {"scales", scales_json(trial.scales)},
                {"shots", shots_json(trial)},
                {"nonce", nonce}};
  if (in_fem(trial.request)) {
    truth["ball"] = fem_ball_json(trial);
    truth["believed"] = trial.request.believe_fem ? "fem" : "lumped";
  }
  return truth.dump(2) + "\n";
}

}  // namespace trials
