#include "comparisons/io/dataset/describe_dataset.hpp"

#include "comparisons/io/toml/describe_impact.hpp"

namespace rebound {
namespace {

constexpr Presence optional = Presence::optional;

/// A scalar `name` and its standard deviation `name_uncertainty`.
void describe_measured(Visitor& visit, const Key& key, Measured& measured) {
  Key value = key;
  value.presence = optional;
  visit.number(value, measured.value);
  visit.number({.name = key.name + "_uncertainty",
                .sentence = "One standard deviation of " + key.name + ".",
                .presence = optional,
                .unit = key.unit,
                .range = above(0.0)},
               measured.uncertainty);
}

/// A choice that is written only where it is not the usual one, its first name.
template <NamedEnum Enum>
void describe_unusual(Visitor& visit, Key key, Enum& member) {
  key.presence = optional;
  key.allowed = all_names<Enum>();
  std::optional<std::string> text;
  if (member != Enum{}) text = name_of(member);
  visit.visit_text(key, text);
  if (text) read_name(*text, member);
}

/// A reading `name` and its standard deviation `name_uncertainty`.
void describe_reading(Visitor& visit, const ReadingQuantity& quantity, Reading& reading) {
  visit.number({.name = quantity.key,
                .sentence = quantity.sentence,
                .presence = optional,
                .unit = quantity.unit,
                .range = above(0.0)},
               reading.value);
  visit.number({.name = std::string(quantity.key) + "_uncertainty",
                .sentence = "One standard deviation of one reading of it.",
                .presence = optional,
                .unit = quantity.unit,
                .range = above(0.0)},
               reading.uncertainty);
}

void describe_readings(Visitor& visit, ShotReadings& readings) {
  for (const ReadingQuantity& quantity : reading_quantities)
    describe_reading(visit, quantity, readings.*quantity.member);
  visit.number({.name = "repeats",
                .sentence = "Readings that the values above are means of; divides their variances.",
                .presence = optional,
                .range = at_least(1.0)},
               readings.repeats);
}

void describe_sphere(Visitor& visit, Dataset& dataset) {
  describe(visit, dataset.sphere);
  visit.number({.name = "mass_uncertainty",
                .sentence = "One standard deviation of the mass.",
                .presence = optional,
                .unit = "g",
                .range = at_least(0.0)},
               dataset.mass_uncertainty);
  visit.number({.name = "diameter_uncertainty",
                .sentence = "One standard deviation of the diameter.",
                .presence = optional,
                .unit = "mm",
                .range = at_least(0.0)},
               dataset.diameter_uncertainty);
}

}  // namespace

void describe(Visitor& visit, Instrument& instrument) {
  visit.number({.name = "force_noise",
                .sentence = "One standard deviation of the force per sample.",
                .presence = optional,
                .unit = "N",
                .range = at_least(0.0)},
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
                .range = above(0.0)},
               instrument.force_bandwidth);
  visit.number({.name = "contact_threshold",
                .sentence = "Force at which contact was taken to start and to end.",
                .presence = optional,
                .unit = "N",
                .range = at_least(0.0)},
               instrument.contact_threshold);
  visit.number({.name = "camera_rate",
                .sentence = "Frames per second of the camera that gave the speeds.",
                .presence = optional,
                .unit = "Hz",
                .range = above(0.0)},
               instrument.camera_rate);
  visit.choice({.name = "deflection",
                .sentence = "A double integral of force over mass, or measured on its own.",
                .presence = optional},
               instrument.deflection);
  visit.number({.name = "deflection_noise",
                .sentence = "One standard deviation of an independent deflection per sample.",
                .presence = optional,
                .unit = "mm",
                .range = above(0.0)},
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

void describe(Visitor& visit, MeasuredImpact& shot) {
  std::optional<double> speed;
  if (shot.impact.speed > 0.0) speed = shot.impact.speed;
  visit.number(
      {.name = "speed",
       .sentence = "Approach speed at first touch; or gates, a drop or flight times below.",
       .presence = optional,
       .unit = "m/s",
       .range = above_up_to(0.0, 1000.0)},
      speed);
  if (speed) shot.impact.speed = *speed;
  visit.number({.name = "speed_uncertainty",
                .sentence = "One standard deviation of the speed.",
                .presence = optional,
                .unit = "m/s",
                .range = at_least(0.0)},
               shot.speed_uncertainty);
  visit.text({.name = "trace",
              .sentence = "CSV file in this folder: time, force and, if known, deflection, with "
                          "units in the headings.",
              .presence = optional},
             shot.trace_file);
  visit.text({.name = "channel",
              .sentence = "Heading of this shot's force, where the file holds several.",
              .presence = optional},
             shot.channel);
  describe_measured(visit,
                    {.name = "restitution",
                     .sentence = "Rebound over approach speed.",
                     .range = from_to(0.0, 1.0)},
                    shot.restitution);
  describe_measured(visit,
                    {.name = "contact_time",
                     .sentence = "By the instrument's contact_threshold, if it has one.",
                     .unit = "ms",
                     .range = above(0.0)},
                    shot.contact_time);
  describe_measured(
      visit, {.name = "peak_force", .sentence = "Largest force.", .unit = "N", .range = above(0.0)},
      shot.peak_force);
  describe_measured(visit,
                    {.name = "peak_deflection",
                     .sentence = "Largest deflection of the centre of mass.",
                     .unit = "mm",
                     .range = above(0.0)},
                    shot.peak_deflection);
  describe_measured(visit,
                    {.name = "mean_deflection",
                     .sentence = "Time mean of that deflection over the contact.",
                     .unit = "mm",
                     .range = above(0.0)},
                    shot.mean_deflection);
  describe_readings(visit, shot.readings);
}

void describe(Visitor& visit, TraceChannels& channels) {
  const auto heading = [&](const char* name, const char* sentence, std::string& member) {
    visit.text({.name = name, .sentence = sentence, .presence = optional}, member);
  };
  heading("time", "Heading of the time; default: time.", channels.time);
  heading("force", "Heading of the force; default: force.", channels.force);
  heading("acceleration", "Heading of the ball's deceleration: times its mass, the force.",
          channels.acceleration);
  heading("deflection", "Heading of the deflection; default: deflection, if there is one.",
          channels.deflection);
  heading("time_unit", "Unit of the time, where the heading states none.", channels.time_unit);
  heading("force_unit", "Unit of force or acceleration, where the heading states none.",
          channels.force_unit);
  heading("deflection_unit", "Unit of the deflection, where the heading states none.",
          channels.deflection_unit);
  std::optional<bool> reversed;
  if (channels.reversed) reversed = true;
  visit.visit_flag({.name = "reversed",
                    .sentence = "Compression, or deceleration, was recorded as negative.",
                    .presence = optional},
                   reversed);
  channels.reversed = reversed.value_or(false);
  describe_unusual(visit,
                   {.name = "baseline",
                    .sentence = "What is taken out of the force: nothing, its mean before contact, "
                                "or the line through its means before and after."},
                   channels.baseline);
  describe_unusual(visit,
                   {.name = "keep",
                    .sentence = "The whole record, or five contact lengths before and two after."},
                   channels.keep);
}

void describe(Visitor& visit, AirStatement& air) {
  describe_unusual(visit,
                   {.name = "drag",
                    .sentence = "Is drag taken out of heights and flight times? Its size is told."},
                   air.drag);
  visit.number({.name = "density",
                .sentence = "Of the air; default 1.204 kg/m^3.",
                .presence = optional,
                .unit = "kg/m^3",
                .range = above_up_to(0.0, 10.0)},
               air.density);
  visit.number({.name = "drag_coefficient",
                .sentence = "Of the ball; default 0.5.",
                .presence = optional,
                .range = above_up_to(0.0, 5.0)},
               air.drag_coefficient);
}

void describe(Visitor& visit, ShotTable& table) {
  visit.text({.name = "file", .sentence = "CSV file in this folder, one shot a row."}, table.file);
  visit.text({.name = "only_column",
              .sentence = "Heading of the column that tells which rows are meant.",
              .presence = optional},
             table.only_column);
  visit.text({.name = "only", .sentence = "What stands there in those rows.", .presence = optional},
             table.only);
  visit.number({.name = "speed_relative_uncertainty",
                .sentence = "One standard deviation of every speed, as a share of it.",
                .presence = optional,
                .range = above_up_to(0.0, 1.0)},
               table.speed_relative_uncertainty);
  visit.number({.name = "restitution_relative_uncertainty",
                .sentence = "One standard deviation of every restitution, as a share of it.",
                .presence = optional,
                .range = above_up_to(0.0, 1.0)},
               table.restitution_relative_uncertainty);
  visit.visit_table(
      {.name = "columns", .sentence = "Which heading holds which key of a shot."},
      [&](Visitor& inner) {
        for (const std::string& key : shot_column_keys()) {
          std::string heading = table.columns[key];
          inner.text({.name = key, .sentence = "Heading of that column.", .presence = optional},
                     heading);
          if (heading.empty())
            table.columns.erase(key);
          else
            table.columns[key] = heading;
        }
      });
  visit.table({.name = "common",
               .sentence = "What is said of every row alike; any key of a shot.",
               .presence = optional},
              table.common);
}

std::vector<std::string> shot_column_keys() {
  std::vector<std::string> keys{"speed", "speed_uncertainty", "trace", "repeats"};
  const auto add = [&](const std::string& key) {
    keys.push_back(key);
    keys.push_back(key + "_uncertainty");
  };
  for (const ScalarQuantity& scalar : scalar_quantities) add(scalar.key);
  for (const ReadingQuantity& quantity : reading_quantities) add(quantity.key);
  return keys;
}

void describe(Visitor& visit, Quasistatic& quasistatic) {
  visit.whole({.name = "platens",
               .sentence = "1: sphere on one plate; 2: between two platens, deflection is the "
                           "total.",
               .range = from_to(1.0, 2.0)},
              quasistatic.platens);
  visit.text({.name = "trace",
              .sentence = "CSV file in this folder: deflection_m, force_N.",
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
                .range = above(0.0)},
               quasistatic.duration);
  describe_measured(visit,
                    {.name = "stiffness",
                     .sentence = "Factor of x^1.5 in the force.",
                     .unit = "N/m^1.5",
                     .range = above(0.0)},
                    quasistatic.stiffness);
}

void describe(Visitor& visit, BlockTest& block) {
  describe_measured(visit,
                    {.name = "modulus",
                     .sentence = "Young's modulus of a block cut from the ball.",
                     .unit = "MPa",
                     .range = above(0.0)},
                    block.modulus);
}

void describe(Visitor& visit, PooledPeak& peak) {
  visit.number({.name = "speed", .sentence = "Approach speed.", .unit = "m/s", .range = above(0.0)},
               peak.speed);
  visit.number(
      {.name = "force", .sentence = "Typical largest force.", .unit = "N", .range = above(0.0)},
      peak.force);
  visit.number({.name = "deflection",
                .sentence = "Typical largest deflection.",
                .unit = "mm",
                .range = above(0.0)},
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
