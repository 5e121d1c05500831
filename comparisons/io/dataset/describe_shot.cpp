#include "comparisons/io/dataset/describe_dataset.hpp"

namespace rebound {
namespace {

constexpr Presence if_known = Presence::optional;

/// A choice that is written only where it is not the usual one, its first name.
template <NamedEnum Enum>
void describe_unusual(Visitor& visit, Key key, Enum& member) {
  key.presence = if_known;
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
                .presence = if_known,
                .unit = quantity.unit,
                .range = above_up_to(0.0, largest_reading)},
               reading.value);
  visit.number({.name = std::string(quantity.key) + "_uncertainty",
                .sentence = "One standard deviation of one reading of it.",
                .presence = if_known,
                .unit = quantity.unit,
                .range = above_up_to(0.0, largest_reading)},
               reading.uncertainty);
}

void describe_readings(Visitor& visit, ShotReadings& readings) {
  for (const ReadingQuantity& quantity : reading_quantities)
    describe_reading(visit, quantity, readings.*quantity.member);
  visit.number({.name = "repeats",
                .sentence = "Readings that the values above are means of; divides their variances.",
                .presence = if_known,
                .range = from_to(1.0, largest_reading)},
               readings.repeats);
}

}  // namespace

void describe_measured(Visitor& visit, const Key& key, Measured& measured) {
  Key value = key;
  value.presence = if_known;
  visit.number(value, measured.value);
  visit.number({.name = key.name + "_uncertainty",
                .sentence = "One standard deviation of " + key.name + ".",
                .presence = if_known,
                .unit = key.unit,
                .range = above_up_to(0.0, largest_reading)},
               measured.uncertainty);
}

void describe(Visitor& visit, MeasuredImpact& shot) {
  std::optional<double> speed;
  if (shot.impact.speed > 0.0) speed = shot.impact.speed;
  visit.number(
      {.name = "speed",
       .sentence = "Approach speed at first touch; or gates, a drop or flight times below.",
       .presence = if_known,
       .unit = "m/s",
       .range = above_up_to(0.0, 1000.0)},
      speed);
  if (speed) shot.impact.speed = *speed;
  visit.number({.name = "speed_uncertainty",
                .sentence = "One standard deviation of the speed.",
                .presence = if_known,
                .unit = "m/s",
                .range = from_to(0.0, 1000.0)},
               shot.speed_uncertainty);
  visit.text(
      {.name = "trace",
       .sentence =
           "CSV, MATLAB or HDF5 file in this folder: time, force and, if known, deflection, with "
           "units in the headings.",
       .presence = if_known},
      shot.trace_file);
  visit.text({.name = "channel",
              .sentence = "Heading of this shot's force, where the file holds several.",
              .presence = if_known},
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
                     .range = above_up_to(0.0, largest_reading)},
                    shot.contact_time);
  describe_measured(visit,
                    {.name = "peak_force",
                     .sentence = "Largest force.",
                     .unit = "N",
                     .range = above_up_to(0.0, largest_reading)},
                    shot.peak_force);
  describe_measured(visit,
                    {.name = "peak_deflection",
                     .sentence = "Largest deflection of the centre of mass.",
                     .unit = "mm",
                     .range = above_up_to(0.0, largest_reading)},
                    shot.peak_deflection);
  describe_measured(visit,
                    {.name = "mean_deflection",
                     .sentence = "Time mean of that deflection over the contact.",
                     .unit = "mm",
                     .range = above_up_to(0.0, largest_reading)},
                    shot.mean_deflection);
  describe_readings(visit, shot.readings);
}

void describe(Visitor& visit, TraceChannels& channels) {
  const auto heading = [&](const char* name, const char* sentence, std::string& member) {
    visit.text({.name = name, .sentence = sentence, .presence = if_known}, member);
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
                    .presence = if_known},
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
                .presence = if_known,
                .unit = "kg/m^3",
                .range = above_up_to(0.0, 10.0)},
               air.density);
  visit.number({.name = "drag_coefficient",
                .sentence = "Of the ball; default 0.5.",
                .presence = if_known,
                .range = above_up_to(0.0, 5.0)},
               air.drag_coefficient);
}

void describe(Visitor& visit, ShotTable& table) {
  visit.text(
      {.name = "file", .sentence = "CSV, MATLAB or HDF5 file in this folder, one shot a row."},
      table.file);
  visit.text({.name = "only_column",
              .sentence = "Heading of the column that tells which rows are meant.",
              .presence = if_known},
             table.only_column);
  visit.text({.name = "only", .sentence = "What stands there in those rows.", .presence = if_known},
             table.only);
  visit.number({.name = "speed_relative_uncertainty",
                .sentence = "One standard deviation of every speed, as a share of it.",
                .presence = if_known,
                .range = above_up_to(0.0, 1.0)},
               table.speed_relative_uncertainty);
  visit.number({.name = "restitution_relative_uncertainty",
                .sentence = "One standard deviation of every restitution, as a share of it.",
                .presence = if_known,
                .range = above_up_to(0.0, 1.0)},
               table.restitution_relative_uncertainty);
  visit.visit_table(
      {.name = "columns", .sentence = "Which heading holds which key of a shot."},
      [&](Visitor& inner) {
        for (const std::string& key : shot_column_keys()) {
          std::string heading = table.columns[key];
          inner.text({.name = key, .sentence = "Heading of that column.", .presence = if_known},
                     heading);
          if (heading.empty())
            table.columns.erase(key);
          else
            table.columns[key] = heading;
        }
      });
  visit.table({.name = "common",
               .sentence = "What is said of every row alike; any key of a shot.",
               .presence = if_known},
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

}  // namespace rebound
