#include "comparisons/io/dataset/describe_dataset.hpp"

#include "comparisons/io/toml/describe_impact.hpp"

namespace rebound {
namespace {

constexpr Presence optional = Presence::optional;

void describe_sphere(Visitor& visit, Dataset& dataset) {
  describe(visit, dataset.sphere);
  visit.number({.name = "mass_uncertainty",
                .sentence = "One standard deviation of the mass.",
                .presence = optional,
                .unit = "g",
                .range = from_to(0.0, largest_reading)},
               dataset.mass_uncertainty);
  visit.number({.name = "diameter_uncertainty",
                .sentence = "One standard deviation of the diameter.",
                .presence = optional,
                .unit = "mm",
                .range = from_to(0.0, largest_reading)},
               dataset.diameter_uncertainty);
}

}  // namespace

void describe(Visitor& visit, Instrument& instrument) {
  visit.number({.name = "force_noise",
                .sentence = "One standard deviation of the force per sample.",
                .presence = optional,
                .unit = "N",
                .range = from_to(0.0, largest_reading)},
               instrument.force_noise);
  visit.number({.name = "force_gain_uncertainty",
                .sentence = "Relative uncertainty of the force scale, one standard deviation.",
                .presence = optional,
                .range = from_to(0.0, 1.0)},
               instrument.force_gain_uncertainty);
  visit.number({.name = "force_bandwidth",
                .sentence = "Frequency up to which the force is passed.",
                .presence = optional,
                .unit = "kHz",
                .range = above_up_to(0.0, largest_reading)},
               instrument.force_bandwidth);
  visit.number({.name = "force_filter_class",
                .sentence = "Channel frequency class (SAE J211) by which the record was filtered, "
                            "without delay: 60, 180, 600, 1000.",
                .presence = optional,
                .unit = "Hz",
                .range = from_to(1.0, 1e6)},
               instrument.force_filter_class);
  visit.number({.name = "noise_correlation_time",
                .sentence = "Time in which the force's noise forgets itself (first-order "
                            "autoregressive); absent: samples are independent.",
                .presence = optional,
                .unit = "ms",
                .range = above(0.0)},
               instrument.noise_correlation_time);
  visit.number({.name = "contact_threshold",
                .sentence = "Force at which contact was taken to start and to end.",
                .presence = optional,
                .unit = "N",
                .range = from_to(0.0, largest_reading)},
               instrument.contact_threshold);
  visit.number({.name = "camera_rate",
                .sentence = "Frames per second of the camera that gave the speeds and, in a "
                            "synthesis, counts contact times in whole frames.",
                .presence = optional,
                .unit = "Hz",
                .range = above_up_to(0.0, largest_reading)},
               instrument.camera_rate);
  visit.choice({.name = "deflection",
                .sentence = "A double integral of force over mass, or measured on its own.",
                .presence = optional},
               instrument.deflection);
  visit.number({.name = "deflection_noise",
                .sentence = "One standard deviation of an independent deflection per sample.",
                .presence = optional,
                .unit = "mm",
                .range = above_up_to(0.0, largest_reading)},
               instrument.deflection_noise);
  visit.number({.name = "deflection_gain_uncertainty",
                .sentence = "Relative uncertainty of the deflection scale, one standard deviation.",
                .presence = optional,
                .range = from_to(0.0, 1.0)},
               instrument.deflection_gain_uncertainty);
  visit.texts({.name = "independent_scalars",
               .sentence = "Scalars that another instrument than the force record gave: "
                           "contact_time, peak_force, peak_deflection, mean_deflection. Others "
                           "repeat a record that stands beside them.",
               .presence = optional},
              instrument.independent_scalars);
}

void describe(Visitor& visit, Quasistatic& quasistatic) {
  visit.whole({.name = "platens",
               .sentence = "1: sphere on one plate; 2: between two platens, deflection is the "
                           "total.",
               .range = from_to(1.0, 2.0)},
              quasistatic.platens);
  visit.text({.name = "trace",
              .sentence = "CSV, MATLAB or HDF5 file in this folder: deflection_m, force_N.",
              .presence = optional},
             quasistatic.trace_file);
  visit.number({.name = "force_uncertainty",
                .sentence = "Relative uncertainty of the force along the trace, one standard "
                            "deviation.",
                .presence = optional,
                .range = above_up_to(0.0, 1.0)},
               quasistatic.force_uncertainty);
  visit.number({.name = "duration",
                .sentence = "Time that the loading took.",
                .presence = optional,
                .unit = "s",
                .range = above_up_to(0.0, largest_reading)},
               quasistatic.duration);
  describe_measured(visit,
                    {.name = "stiffness",
                     .sentence = "Factor of x^1.5 in the force.",
                     .unit = "N/m^1.5",
                     .range = above_up_to(0.0, largest_reading)},
                    quasistatic.stiffness);
}

void describe(Visitor& visit, BlockTest& block) {
  describe_measured(visit,
                    {.name = "modulus",
                     .sentence = "Young's modulus of a block cut from the ball.",
                     .unit = "MPa",
                     .range = above_up_to(0.0, largest_reading)},
                    block.modulus);
}

void describe(Visitor& visit, PooledPeak& peak) {
  visit.number({.name = "speed",
                .sentence = "Approach speed.",
                .unit = "m/s",
                .range = above_up_to(0.0, largest_reading)},
               peak.speed);
  visit.number({.name = "force",
                .sentence = "Typical largest force.",
                .unit = "N",
                .range = above_up_to(0.0, largest_reading)},
               peak.force);
  visit.number({.name = "deflection",
                .sentence = "Typical largest deflection.",
                .unit = "mm",
                .range = above_up_to(0.0, largest_reading)},
               peak.deflection);
  visit.number({.name = "scatter",
                .sentence = "Relative scatter of both, one standard deviation.",
                .presence = optional,
                .range = above_up_to(0.0, 10.0)},
               peak.scatter);
}

void describe(Visitor& visit, Dataset& dataset) {
  describe_schema(visit);
  visit.text({.name = "name", .sentence = "What the data set is called in reports."}, dataset.name);
  visit.texts({.name = "notes",
               .sentence = "Assumptions behind the numbers, shown with every result.",
               .presence = optional},
              dataset.notes);
  visit.visit_table({.name = "sphere", .sentence = "The ball."},
                    [&](Visitor& inner) { describe_sphere(inner, dataset); });
  visit.table({.name = "instrument",
               .sentence = "The measuring chain; what is absent is unknown.",
               .presence = optional},
              dataset.instrument);
  visit.table({.name = "channels",
               .sentence = "Columns of the traces, where they are not time, force, deflection.",
               .presence = optional},
              dataset.channels);
  visit.table(
      {.name = "air", .sentence = "The air that dropped balls fall through.", .presence = optional},
      dataset.air);
  visit.list({.name = "shot_table",
              .sentence = "Impacts in the rows of a table; repeat for more.",
              .presence = optional},
             dataset.shot_tables);
  visit.list({.name = "shot", .sentence = "One impact; repeat for more.", .presence = optional},
             dataset.shots);
  visit.list({.name = "quasistatic",
              .sentence = "A slow compression of the whole ball; repeat for more.",
              .presence = optional},
             dataset.quasistatic);
  visit.list({.name = "block",
              .sentence = "A slow compression of a block cut from the ball; repeat for more.",
              .presence = optional},
             dataset.block_tests);
  visit.list({.name = "pooled_peak",
              .sentence = "Peaks typical of several balls together: an order of magnitude, not a "
                          "measurement of this ball.",
              .presence = optional},
             dataset.pooled_peaks);
}

}  // namespace rebound
