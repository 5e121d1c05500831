#include "comparisons/studies/reproduce/claim_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Nominal value and range of one quantity; a whole list of them is one column.
struct Ranged {
  double value = 0.0;
  Interval range;
};
using Column = std::vector<Ranged>;

Ranged per_cent_above(const Ranged& model, const PrintedNumber& measured) {
  const Interval base = rounding_interval(measured);
  return {
      100.0 * (model.value / measured.value - 1.0),
      {100.0 * (model.range.low / base.high - 1.0), 100.0 * (model.range.high / base.low - 1.0)}};
}

Ranged printed(const PrintedNumber& number) {
  return {number.value, rounding_interval(number)};
}

std::vector<Interval> ranges_of(const Column& column) {
  std::vector<Interval> ranges;
  for (const Ranged& item : column) ranges.push_back(item.range);
  return ranges;
}

Column folded(const Column& column) {
  Column result;
  for (const Ranged& item : column) result.push_back({std::abs(item.value), magnitude(item.range)});
  return result;
}

ClaimValue mean(const Column& column, double speed = 0.0) {
  double sum = 0.0;
  for (const Ranged& item : column) sum += item.value;
  return {sum / static_cast<double>(column.size()), mean_of(ranges_of(column)), speed};
}

ClaimValue largest(const Column& column) {
  double value = column.front().value;
  for (const Ranged& item : column) value = std::max(value, item.value);
  return {value, largest_of(ranges_of(column))};
}

ClaimValue count_above_zero(const Column& column) {
  ClaimValue count;
  for (const Ranged& item : column) {
    count.computed += item.value > 0.0 ? 1.0 : 0.0;
    count.range.low += item.range.low > 0.0 ? 1.0 : 0.0;
    count.range.high += item.range.high > 0.0 ? 1.0 : 0.0;
  }
  return count;
}

Column negated(const Column& column) {
  Column result;
  for (const Ranged& item : column)
    result.push_back({-item.value, {-item.range.high, -item.range.low}});
  return result;
}

/// One entry per core at that speed, or all twelve in order of speed.
template <class Entry>
Column at_speed(const Paper& paper, std::size_t speed, const Entry& entry) {
  Column column;
  for (std::size_t core = 0; core < paper.cores.size(); ++core)
    column.push_back(entry(core, speed));
  return column;
}

template <class Entry>
Column at_all_speeds(const Paper& paper, const Entry& entry) {
  Column column;
  for (std::size_t speed = 0; speed < paper.speeds(); ++speed)
    for (const Ranged& item : at_speed(paper, speed, entry)) column.push_back(item);
  return column;
}

double sample_deviation(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double average = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - average) * (value - average);
  return std::sqrt(squares / (count - 1.0));
}

ClaimValue deviation_of_restitution(const Paper& paper, std::size_t speed) {
  std::vector<PrintedNumber> inputs;
  std::vector<double> nominal;
  for (const PaperCore& core : paper.cores) {
    inputs.push_back(core.shots[speed].restitution);
    nominal.push_back(inputs.back().value);
  }
  return {sample_deviation(nominal), corner_range(sample_deviation, inputs), paper.speed(speed)};
}

using Values = std::map<std::string, ClaimValue>;

constexpr const char* speed_names[] = {"lowest", "middle", "highest"};

/// The Hunt–Crossley model against the measured contact times.
void add_nonlinear(Values& values, const Paper& paper,
                   const std::vector<std::vector<ModelRun>>& runs) {
  const auto contact_time = [&](std::size_t core, std::size_t speed) {
    const ModelRun& run = runs[core][speed];
    return Ranged{run.result.scalars.contact_time, run.contact_time};
  };
  const auto difference = [&](std::size_t core, std::size_t speed) {
    return per_cent_above(contact_time(core, speed), paper.cores[core].shots[speed].contact_time);
  };
  const Column differences = at_all_speeds(paper, difference);
  values["nonlinear-contact-time-under-predicted"] = count_above_zero(negated(differences));
  values["nonlinear-contact-time-largest-difference"] = largest(folded(differences));
  values["nonlinear-contact-time-mean-difference"] = mean(folded(differences));
  for (std::size_t speed = 0; speed < paper.speeds(); ++speed)
    values[std::string("nonlinear-contact-time-at-") + speed_names[speed] + "-speed"] =
        mean(at_speed(paper, speed, contact_time), paper.speed(speed));
}

/// The linear model's columns of Table 5, as printed, against the measured ones.
void add_linear(Values& values, const Paper& paper) {
  const auto shot = [&](std::size_t core, std::size_t speed) -> const PaperShot& {
    return paper.cores[core].shots[speed];
  };
  const auto time = [&](std::size_t core, std::size_t speed) {
    const PaperShot& at = shot(core, speed);
    return per_cent_above(printed(at.published.linear_contact_time), at.contact_time);
  };
  const auto restitution = [&](std::size_t core, std::size_t speed) {
    const PaperShot& at = shot(core, speed);
    return per_cent_above(printed(at.published.linear_restitution), at.restitution);
  };
  values["restitution-over-predicted"] = count_above_zero(at_all_speeds(paper, restitution));
  const auto add = [&](const std::string& name, const auto& entry) {
    const Column all = folded(at_all_speeds(paper, entry));
    values[name + "-mean-difference"] = mean(all);
    values[name + "-largest-difference"] = largest(all);
    for (std::size_t speed = 0; speed < paper.speeds(); ++speed)
      values[name + "-difference-at-" + speed_names[speed] + "-speed"] =
          mean(folded(at_speed(paper, speed, entry)), paper.speed(speed));
  };
  add("linear-contact-time", time);
  add("restitution", restitution);
}

/// Means over the four cores of printed columns.
void add_means(Values& values, const Paper& paper) {
  for (std::size_t speed = 0; speed < paper.speeds(); ++speed) {
    const auto mean_of_cores = [&](const auto& member) {
      return mean(at_speed(paper, speed,
                           [&](std::size_t core, std::size_t at) {
                             return printed(member(paper.cores[core].shots[at]));
                           }),
                  paper.speed(speed));
    };
    const std::string suffix = std::string("-at-") + speed_names[speed] + "-speed";
    values["mean-deflection" + suffix] =
        mean_of_cores([](const PaperShot& at) { return at.mean_deflection; });
    values["linear-restitution" + suffix] =
        mean_of_cores([](const PaperShot& at) { return at.published.linear_restitution; });
    values["restitution-mean" + suffix] =
        mean_of_cores([](const PaperShot& at) { return at.restitution; });
    values["restitution-deviation" + suffix] = deviation_of_restitution(paper, speed);
  }
  const auto nominal = [&](std::size_t speed) {
    const double v = paper.speed(speed);
    return ClaimValue{v, {v, v}, v};
  };
  values["lowest-speed"] = nominal(0);
  values["highest-speed"] = nominal(paper.speeds() - 1);
}

Verdict judge_claim(const Claim& claim, const ClaimValue& value) {
  if (claim.relation == Claim::Relation::equals)
    return judge(claim.value, value.computed, value.range);
  const double sign = claim.relation == Claim::Relation::below ? 1.0 : -1.0;
  const auto holds = [&](double x) { return sign * (claim.value.value - x) > 0.0; };
  if (holds(value.computed)) return Verdict::reproduces;
  return holds(value.range.low) || holds(value.range.high) ? Verdict::within_rounding
                                                           : Verdict::differs;
}

/// A pooled peak against the published models of all cores.
Row peak_row(const RowKey& key, double published, const Column& models) {
  const double unit = unit_size(key);
  Row row{.key = key, .published = {.value = published, .half_width = 0.5 * unit}};
  const ClaimValue average = mean(models);
  row.computed = average.computed;
  row.range = models.front().range;
  for (const Ranged& model : models)
    row.range = {std::min(row.range.low, model.range.low),
                 std::max(row.range.high, model.range.high)};
  row.verdict = judge(row.published, row.computed, row.range);
  return row;
}

}  // namespace

Values claim_values(const Paper& paper, const std::vector<std::vector<ModelRun>>& runs) {
  Values values;
  add_nonlinear(values, paper, runs);
  add_linear(values, paper);
  add_means(values, paper);
  return values;
}

std::vector<Row> claim_rows(const Paper& paper, const std::vector<std::vector<ModelRun>>& runs) {
  const Values values = claim_values(paper, runs);
  std::vector<Row> rows;
  for (const Claim& claim : paper.claims) {
    const auto found = values.find(claim.id);
    if (found == values.end())
      throw Error(ExitCode::bad_input, "nothing computes a claim of this id",
                  {.file = "claims.toml", .key = "claim.id", .value = claim.id});
    const ClaimValue& value = found->second;
    rows.push_back({.key = {claim.section, "", value.speed, claim.quantity, claim.unit},
                    .published = claim.value,
                    .computed = value.computed,
                    .range = value.range,
                    .verdict = judge_claim(claim, value)});
  }
  for (std::size_t i = 0; i < paper.typical_peaks.size(); ++i) {
    const PooledPeak& peak = paper.typical_peaks[i];
    const auto models = [&](double ImpactScalars::*scalar, Interval ModelRun::*range) {
      return at_speed(paper, i, [&](std::size_t core, std::size_t speed) {
        const ModelRun& run = runs[core][speed];
        return Ranged{run.result.scalars.*scalar, run.*range};
      });
    };
    rows.push_back(peak_row({"Section 4.3", "", peak.speed, "typical peak force", "N"}, peak.force,
                            models(&ImpactScalars::peak_force, &ModelRun::peak_force)));
    rows.push_back(peak_row({"Section 4.3", "", peak.speed, "typical peak deflection", "mm"},
                            peak.deflection,
                            models(&ImpactScalars::peak_deflection, &ModelRun::peak_deflection)));
  }
  return rows;
}

}  // namespace rebound
