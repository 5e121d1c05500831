#include "comparisons/studies/campaign/campaign_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/sobol.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <numeric>

namespace rebound {
namespace {

/// A whole number that is written only where it says something.
template <class Whole>
void visit_some(Visitor& visit, const Key& key, Whole& member, Whole absent) {
  std::optional<Whole> given;
  if (member != absent) given = member;
  visit.whole(key, given);
  member = given.value_or(absent);
}

void describe_factor(Visitor& visit, CampaignFactor& factor, const std::vector<Key>& known) {
  Key about{.name = "key", .sentence = "Key path of a number that the base file gives."};
  for (const Key& key : known) about.allowed.push_back(key.name);
  visit.text(about, factor.key);
  const auto found = std::find_if(known.begin(), known.end(),
                                  [&](const Key& key) { return key.name == factor.key; });
  if (found != known.end()) factor.about = *found;
  const auto end = [&](const char* name, const char* sentence) {
    return Key{.name = name,
               .sentence = sentence,
               .presence = Presence::optional,
               .unit = factor.about.unit,
               .range = factor.about.range,
               .reason = factor.about.reason,
               .unit_of_another = true};
  };
  visit.number(end("low", "Lowest value, in a unit of the key."), factor.low);
  visit.number(end("high", "Highest value, in a unit of the key."), factor.high);
  visit.numbers(end("values", "Instead of low and high: the values themselves."), factor.values);
  visit_some(visit,
             {.name = "points",
              .sentence = "Values of a grid from low to high, both included.",
              .presence = Presence::optional,
              .range = from_to(2, static_cast<double>(most_members))},
             factor.points, 0);
  visit.choice({.name = "spacing",
                .sentence = "How values lie between low and high.",
                .presence = Presence::optional},
               factor.spacing);
}

double between_ends(const CampaignFactor& factor, double level) {
  const double low = *factor.low, high = *factor.high;
  if (level >= 1.0) return high;
  if (factor.spacing == Spacing::linear) return low + level * (high - low);
  return std::clamp(low * std::pow(high / low, level), low, high);
}

double sampled(const CampaignFactor& factor, double level) {
  if (factor.values.empty()) return between_ends(factor, level);
  const auto count = factor.values.size();
  return factor
      .values[std::min(count - 1, static_cast<std::size_t>(level * static_cast<double>(count)))];
}

std::size_t levels_of(const CampaignFactor& factor) {
  return factor.values.empty() ? static_cast<std::size_t>(factor.points) : factor.values.size();
}

void check_factor(const Document& document, const CampaignDesign& design, std::size_t i) {
  const CampaignFactor& factor = design.factors[i];
  const std::string key = fmt::format("design.factor[{}]", i);
  for (std::size_t j = 0; j < i; ++j)
    if (design.factors[j].key == factor.key)
      throw document.error_at(key + ".key", "this key is varied twice");
  const bool ends = factor.low && factor.high;
  if ((factor.low || factor.high) && !factor.values.empty())
    throw document.error_at(key + ".values", "give either low and high, or values");
  if (!ends && factor.values.empty())
    throw document.error_at(key + (factor.low ? ".high" : ".low"), "between which values?",
                            "low and high, or a list of values");
  if (ends && *factor.low >= *factor.high)
    throw document.error_at(key + ".high", "the range is reversed or empty", "high above low");
  if (ends && factor.spacing == Spacing::logarithmic && *factor.low <= 0.0)
    throw document.error_at(key + ".low", "logarithmic spacing begins above zero", "value > 0");
  if (design.kind == DesignKind::grid && ends && factor.points == 0)
    throw document.error_at(key + ".points", "a grid needs the number of points", "2 or more");
  if (factor.points > 0 && (design.kind != DesignKind::grid || !ends))
    throw document.error_at(key + ".points", "points belong to a grid from low to high");
}

}  // namespace

void describe(Visitor& visit, CampaignDesign& design) {
  visit.choice({.name = "kind", .sentence = "How members lie between the ends of the factors."},
               design.kind);
  visit_some(visit,
             {.name = "count",
              .sentence = "Members of a Latin hypercube or of Sobol points.",
              .presence = Presence::optional,
              .range = from_to(1, static_cast<double>(most_members))},
             design.count, std::int64_t{0});
  visit_some(visit,
             {.name = "seed",
              .sentence = "Of a Latin hypercube.",
              .presence = Presence::optional,
              .range = at_least(0)},
             design.seed, std::int64_t{1});
  visit.visit_list(
      {.name = "factor", .sentence = "A number that is varied; repeat for more."},
      {[&] { return design.factors.size(); }, [&](std::size_t n) { design.factors.resize(n); },
       [&](Visitor& inner, std::size_t i) {
         CampaignFactor example;
         describe_factor(inner, i < design.factors.size() ? design.factors[i] : example,
                         design.known);
       }});
}

void check_design(const Document& document, const CampaignDesign& design) {
  if (design.factors.empty()) throw document.error_at("design.factor", "there is no factor");
  for (std::size_t i = 0; i < design.factors.size(); ++i) check_factor(document, design, i);
  const bool grid = design.kind == DesignKind::grid;
  if (grid && design.count > 0)
    throw document.error_at("design.count", "the points of its factors say how large a grid is");
  if (!grid && design.count == 0)
    throw document.error_at("design.count", "how many members?", "1 or more");
  if (design.kind != DesignKind::latin_hypercube && document.root()["design"]["seed"])
    throw document.error_at("design.seed", "only a Latin hypercube is random");
  double members = grid ? 1.0 : static_cast<double>(design.count);
  if (grid)
    for (const CampaignFactor& factor : design.factors)
      members *= static_cast<double>(levels_of(factor));
  if (members > static_cast<double>(most_members))
    throw document.error_at("design", fmt::format("the design has {:.4g} members", members),
                            fmt::format("{} members at most", most_members));
}

std::size_t member_count(const CampaignDesign& design) {
  if (design.kind != DesignKind::grid) return static_cast<std::size_t>(design.count);
  return std::accumulate(
      design.factors.begin(), design.factors.end(), std::size_t{1},
      [](std::size_t all, const CampaignFactor& factor) { return all * levels_of(factor); });
}

struct DesignSampler::State {
  const CampaignDesign& design;
  std::vector<std::vector<std::uint32_t>> permutations;
  boost::random::sobol points;
  std::size_t next = 0;  ///< Sobol point that comes without a jump

  explicit State(const CampaignDesign& asked) : design(asked), points(asked.factors.size()) {
    if (design.kind != DesignKind::latin_hypercube) return;
    boost::random::mt19937_64 generator(static_cast<std::uint64_t>(design.seed));
    permutations.resize(design.factors.size());
    for (auto& order : permutations) {
      order.resize(static_cast<std::size_t>(design.count));
      std::iota(order.begin(), order.end(), 0U);
      for (std::size_t i = order.size() - 1; i > 0; --i)
        std::swap(order[i],
                  order[boost::random::uniform_int_distribution<std::size_t>(0, i)(generator)]);
    }
  }

  std::vector<double> grid(std::size_t index) const {
    std::vector<double> values(design.factors.size());
    for (std::size_t f = values.size(); f-- > 0;) {
      const CampaignFactor& factor = design.factors[f];
      const std::size_t levels = levels_of(factor), k = index % levels;
      index /= levels;
      values[f] =
          factor.values.empty()
              ? between_ends(factor, static_cast<double>(k) / static_cast<double>(levels - 1))
              : factor.values[k];
    }
    return values;
  }

  double level(std::size_t index, std::size_t factor) {
    if (design.kind == DesignKind::sobol) return static_cast<double>(points() >> 11) * 0x1p-53;
    return (permutations[factor][index] + 0.5) / static_cast<double>(design.count);
  }
};

DesignSampler::DesignSampler(const CampaignDesign& design)
    : state_(std::make_unique<State>(design)) {}
DesignSampler::~DesignSampler() = default;

std::vector<double> DesignSampler::at(std::size_t index) {
  State& state = *state_;
  if (state.design.kind == DesignKind::grid) return state.grid(index);
  if (state.design.kind == DesignKind::sobol && index != state.next) state.points.seed(index);
  state.next = index + 1;
  std::vector<double> values(state.design.factors.size());
  for (std::size_t f = 0; f < values.size(); ++f)
    values[f] = sampled(state.design.factors[f], state.level(index, f));
  return values;
}

}  // namespace rebound
