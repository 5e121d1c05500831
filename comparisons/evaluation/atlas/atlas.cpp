#include "comparisons/evaluation/atlas/atlas.hpp"

#include <atomic>
#include <chrono>
#include <mutex>

#include "comparisons/evaluation/atlas/atlas_scores.hpp"
#include "comparisons/inference/references/contact_alone.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double impact_share = 0.6;  // of the work; measured on two cores

/// The trace up to the end of contact.
AtlasImpact over_contact(const FemProblem& problem, const FemResult& result) {
  AtlasImpact impact{.failure = result.incomplete_because, .shot = {}};
  impact.shot.sphere = problem.sphere;
  impact.shot.impact = problem.impact;
  if (!impact.failure.empty()) return impact;
  impact.shot = contact_alone(problem.sphere, problem.impact, result.trace, result.scalars);
  return impact;
}

/// Progress and interruption of many pieces on several threads.
class Tally {
 public:
  Tally(const RunControl& control, double from, double to, std::size_t pieces)
      : control_(control), from_(from), to_(to), pieces_(pieces) {}
  void check() const {
    if (control_.interrupted && control_.interrupted())
      throw Error(ExitCode::interrupted,
                  "the atlas was interrupted; the same command goes on from what is stored");
  }
  void done() {
    const std::lock_guard lock(guard_);
    ++finished_;
    if (control_.progress)
      control_.progress(from_ + (to_ - from_) * static_cast<double>(finished_) /
                                    static_cast<double>(pieces_));
  }

 private:
  const RunControl& control_;
  double from_, to_;
  std::size_t pieces_, finished_ = 0;
  std::mutex guard_;
};

void run_impacts(Atlas& atlas, const FemRunner& run, const ImpactStore& store,
                 const RunControl& control) {
  const std::size_t speeds = atlas.grid.speeds.size(), count = atlas.entries.size() * speeds;
  Tally tally(control, 0.0, impact_share, count);
  std::atomic<int> fresh = 0;
  const auto start = std::chrono::steady_clock::now();
  in_parallel(count, [&](std::size_t i) {
    tally.check();
    AtlasEntry& entry = atlas.entries[i / speeds];
    const FemProblem problem =
        atlas_problem(atlas.grid, entry.material, atlas.grid.speeds[i % speeds]);
    std::optional<AtlasImpact> impact = store.find(problem);
    if (!impact) {
      try {
        impact = over_contact(problem, run(problem));
      } catch (const Error& error) {
        if (error.code() != ExitCode::solver_failed && error.code() != ExitCode::bad_input) throw;
        impact = AtlasImpact{.failure = error.what(), .shot = {}};
      }
      tally.check();  // an interrupted impact is incomplete, not failed
      store.keep(problem, *impact);
      ++fresh;
    }
    entry.impacts[i % speeds] = std::move(*impact);
    tally.done();
  });
  atlas.impacts_run = fresh;
  atlas.impact_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Atlas make_atlas(const AtlasGrid& grid, const FemRunner& run, const ImpactStore& store,
                 const RunControl& control) {
  check_grid(grid);
  Atlas atlas{.grid = grid, .entries = {}};
  for (const auto& material : materials_of(grid))
    atlas.entries.push_back({.material = material,
                             .impacts = std::vector<AtlasImpact>(grid.speeds.size()),
                             .cells = {}});
  run_impacts(atlas, run, store, control);
  Tally tally(control, impact_share, 1.0, atlas.entries.size());
  in_parallel(atlas.entries.size(), [&](std::size_t i) {
    tally.check();
    score_entry(atlas.entries[i]);
    tally.done();
  });
  return atlas;
}

}  // namespace rebound
