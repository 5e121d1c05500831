#include <fmt/format.h>

#include <algorithm>

#include "comparisons/discrepancy/inspection/inspection_output.hpp"
#include "comparisons/discrepancy/inspection/inspection_tables.hpp"

namespace rebound {
namespace {

using report::milli;
using report::Origin;
using report::Series;

constexpr std::size_t most_records = 12, most_samples = 400;

/// Which records are drawn: all, or as many as can be told apart, spread over the speeds.
std::vector<std::size_t> drawn_records(const Dataset& dataset) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < dataset.shots.size(); ++i)
    if (dataset.shots[i].has_history()) all.push_back(i);
  std::stable_sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
    return dataset.shots[a].impact.speed < dataset.shots[b].impact.speed;
  });
  if (all.size() <= most_records) return all;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < most_records; ++i)
    some.push_back(all[i * (all.size() - 1) / (most_records - 1)]);
  return some;
}

Series points(const std::string& name, Origin origin) {
  Series series;
  series.name = name;
  series.origin = origin;
  series.style = Series::Style::points;
  return series;
}

report::Figure trace_figure(const Inspection& found, const Dataset& dataset) {
  report::Figure figure{
      .title = "Force over time",
      .caption =
          "As read from the files, baseline taken out where the data set asks for it; every "
          "point is a sample.",
      .x = {"time of the record", "ms"},
      .y = {"force", "N"}};
  const auto drawn = drawn_records(dataset);
  std::size_t most_skipped = 1;
  for (const std::size_t i : drawn) {
    const Trace& trace = dataset.shots[i].trace;
    Series series = points(found.shots[i].label, Origin::measured);
    const std::size_t step = trace.time.size() / most_samples + 1;
    for (std::size_t k = 0; k < trace.time.size(); k += step) {
      series.x.push_back(milli * trace.time[k]);
      series.y.push_back(trace.force[k]);
    }
    most_skipped = std::max(most_skipped, step);
    figure.series.push_back(std::move(series));
  }
  const auto records = static_cast<std::size_t>(
      std::count_if(dataset.shots.begin(), dataset.shots.end(),
                    [](const MeasuredImpact& shot) { return shot.has_history(); }));
  if (most_skipped > 1)
    figure.caption += fmt::format(" Of long records one sample in {} is drawn.", most_skipped);
  if (records > drawn.size())
    figure.caption +=
        fmt::format(" {} of {} records are drawn, slowest to fastest.", drawn.size(), records);
  return figure;
}

/// One quantity over the speed of the shots, with its error bars.
void add_over_speed(const Inspection& found, const std::vector<std::string>& keys,
                    const report::Axis& axis, double scale, const std::string& title,
                    std::vector<report::Block>& blocks) {
  report::Figure figure{.title = title,
                        .caption = "Bars are one standard deviation.",
                        .x = {"approach speed", "m/s"},
                        .y = axis};
  for (const std::string& key : keys) {
    Series series = points(key, key.starts_with("stated") ? Origin::measured : Origin::derived);
    for (const InspectedShot& shot : found.shots)
      for (const InspectedNumber& number : shot.numbers)
        if (number.key == key) {
          series.x.push_back(shot.speed);
          series.y.push_back(scale * number.value);
          series.x_error.push_back(shot.speed_uncertainty.value_or(0.0));
          series.y_error.push_back(scale * number.uncertainty.value_or(0.0));
        }
    if (!series.x.empty()) figure.series.push_back(std::move(series));
  }
  if (!figure.series.empty()) blocks.emplace_back(std::move(figure));
}

report::Section noise_section(const Inspection& found) {
  const InspectedNoise& noise = found.noise;
  report::Section section{.title = "Noise", .blocks = {}};
  section.blocks.push_back(report::Paragraph{"Noise from: " + noise.from + "."});
  if (!(noise.deviation > 0.0)) return section;
  section.blocks.push_back(report::Paragraph{fmt::format(
      "{:.3g} N a sample, from {} samples before contact; {}.", noise.deviation, noise.samples,
      noise.autocorrelation.empty()
          ? "white: neighbours are independent"
          : fmt::format("coloured: an autoregressive model of order {} describes it",
                        noise.autocorrelation.size()))});
  if (noise.autocorrelation.empty()) return section;
  Series series = points("autocorrelation", Origin::derived);
  series.x.push_back(0.0);
  series.y.push_back(1.0);
  for (std::size_t k = 0; k < noise.autocorrelation.size(); ++k) {
    series.x.push_back(1e6 * static_cast<double>(k + 1) * noise.interval);
    series.y.push_back(noise.autocorrelation[k]);
  }
  section.blocks.push_back(
      report::Figure{.title = "Colour of the noise",
                     .caption = "How much neighbouring samples are alike before contact.",
                     .x = {"lag", "us"},
                     .y = {"autocorrelation", "1"},
                     .series = {series}});
  return section;
}

std::string headline_of(const Inspection& found) {
  const auto coarse =
      std::count_if(found.shots.begin(), found.shots.end(),
                    [](const InspectedShot& shot) { return !shot.too_coarse.empty(); });
  const std::string usable = coarse == 0
                                 ? ""
                                 : fmt::format(" {} of {} records are too coarse for something.",
                                               coarse, found.shots.size());
  if (found.checks.empty())
    return "Nothing in these data is said twice: no contradiction could show." + usable;
  if (found.contradictions.empty())
    return fmt::format("The data agree with themselves in {} checks.", found.checks.size()) +
           usable;
  return fmt::format("The data contradict themselves in {} of {} checks.",
                     found.contradictions.size(), found.checks.size()) +
         usable;
}

bool any_filters(const Inspection& found) {
  return std::any_of(found.shots.begin(), found.shots.end(),
                     [](const InspectedShot& shot) { return !shot.filters.empty(); });
}

}  // namespace

report::Report inspection_report(const Inspection& found, const Dataset& dataset) {
  report::Report page{
      .title = "Inspection: " + found.name,
      .subtitle = fmt::format("{} shots, {:.4g} g, {:.4g} mm", found.shots.size(),
                              1e3 * dataset.sphere.mass, 1e3 * dataset.sphere.diameter),
      .headline = headline_of(found),
      .notices = {},
      .sections = {}};
  for (const DataCheck& one : found.contradictions)
    page.notices.push_back(
        {report::Notice::Level::failure,
         fmt::format("{} of {}: {:.4g} where {:.4g} is expected, {:+.1f} standard deviations.{}",
                     one.what, one.of, one.measured, one.expected, one.deviations(),
                     one.mended_by.empty() ? "" : " Mended by " + one.mended_by + ".")});
  report::Section records{.title = "What was measured", .blocks = {}};
  if (!drawn_records(dataset).empty()) records.blocks.emplace_back(trace_figure(found, dataset));
  add_over_speed(found, {"stated_restitution", "restitution_from_impulse"}, {"restitution", "1"},
                 1.0, "Restitution over speed", records.blocks);
  add_over_speed(found, {"stated_contact_time_s", "contact_time_s"}, {"contact time", "ms"}, milli,
                 "Contact time over speed", records.blocks);
  add_over_speed(found, {"stated_peak_force_N", "peak_force_N"}, {"peak force", "N"}, 1.0,
                 "Peak force over speed", records.blocks);
  if (report::Table coarse = coarse_table(found); !coarse.rows.empty())
    records.blocks.emplace_back(std::move(coarse));
  if (report::Table numbers = number_table(found); !numbers.rows.empty())
    records.blocks.emplace_back(std::move(numbers));
  page.sections.push_back(std::move(records));
  page.sections.push_back(noise_section(found));
  report::Section more{.title = "Checks, repeats, filters", .blocks = {}};
  if (!found.checks.empty()) more.blocks.emplace_back(data_check_table(found));
  if (!found.repeats.empty()) more.blocks.emplace_back(repeat_table(found));
  if (any_filters(found)) more.blocks.emplace_back(filter_table(found));
  for (const std::string& warning : found.warnings)
    more.blocks.emplace_back(report::Notice{report::Notice::Level::warning, warning});
  for (const std::string& missing : found.missing)
    more.blocks.emplace_back(
        report::Notice{report::Notice::Level::abstention, "Needed: " + missing + "."});
  if (!more.blocks.empty()) page.sections.push_back(std::move(more));
  return page;
}

}  // namespace rebound
