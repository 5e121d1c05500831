#include "comparisons/studies/campaign/run_campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "comparisons/io/result_store/result_store.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "comparisons/models/parallel/processor_time.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t block = 4096;  ///< members that are looked up and run together

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string division(const Shard& shard) {
  return fmt::format("-of-{:05}.sqlite", shard.of);
}

std::filesystem::path shard_file(const std::filesystem::path& store, const Shard& shard) {
  return store / fmt::format("shard-{:05}{}", shard.number, division(shard));
}

/// Results of other divisions of the campaign, which no process of this one writes to.
std::vector<ResultStore> earlier_results(const std::filesystem::path& store, const Shard& shard,
                                         const std::string& program) {
  std::vector<ResultStore> earlier;
  for (const auto& file : store_files(store))
    if (!file.filename().string().ends_with(division(shard)))
      earlier.emplace_back(file, ResultStore::Access::read, program);
  return earlier;
}

std::string factors_json(const Campaign& campaign, const std::vector<double>& values) {
  std::string json = "{";  // keys of files need no escapes; the library's object is ten times this
  for (std::size_t i = 0; i < values.size(); ++i)
    json +=
        fmt::format("{}\"{}\":{}", i == 0 ? "" : ",", campaign.design().factors[i].key, values[i]);
  return json + "}";
}

/// Takes results from all threads and keeps them together, often.
class Keeper {
 public:
  Keeper(ResultStore& store, std::function<void()> kept)
      : store_(store), kept_(std::move(kept)), last_(Clock::now()) {}

  void add(KeptMember member, double seconds, double processor_seconds) {
    const std::lock_guard lock(guard_);
    impact_seconds_ += seconds;
    impact_processor_ += processor_seconds;
    waiting_.push_back(std::move(member));
    if (seconds_since(last_) >= wait_) keep();
  }

  void keep_all() {
    const std::lock_guard lock(guard_);
    keep();
  }

  std::size_t run() const { return run_; }
  std::size_t failed() const { return failed_; }
  double impact_seconds() const { return impact_seconds_; }
  double impact_processor() const { return impact_processor_; }

 private:
  void keep() {
    const std::vector<KeptMember> members = std::exchange(waiting_, {});
    const auto start = Clock::now();
    store_.keep(members);
    wait_ = std::clamp(waits_a_commit * seconds_since(start), shortest_wait, longest_wait);
    run_ += members.size();
    failed_ += static_cast<std::size_t>(
        std::count_if(members.begin(), members.end(),
                      [](const KeptMember& member) { return !member.result.failure.empty(); }));
    last_ = Clock::now();
    kept_();
  }

  // A commit writes as many pages as it has members, for keys are random: it is to cost no more
  // than a fiftieth of the time.
  static constexpr double shortest_wait = 0.1, longest_wait = 1.0, waits_a_commit = 50.0;

  ResultStore& store_;
  double wait_ = shortest_wait;
  std::function<void()> kept_;
  std::mutex guard_;
  std::vector<KeptMember> waiting_;
  Clock::time_point last_;
  std::size_t run_ = 0, failed_ = 0;
  double impact_seconds_ = 0.0, impact_processor_ = 0.0;
};

void run_members(const Campaign& campaign, const CampaignMembers& members, Keeper& keeper,
                 const RunControl& control) {
  const auto stopped = [&] { return control.interrupted && control.interrupted(); };
  try {
    in_parallel(members.size(), [&](std::size_t i) {
      if (stopped()) throw Error(ExitCode::interrupted, "interrupted");
      const auto start = Clock::now();
      const double processor = thread_time();
      MemberResult result = members[i]->run(control);
      const double seconds = seconds_since(start);
      keeper.add({.key = members[i]->key,
                  .factors = factors_json(campaign, members[i]->values),
                  .result = std::move(result)},
                 seconds, thread_time() - processor);
    });
  } catch (const Error& error) {
    if (error.code() != ExitCode::input_output_failed) keeper.keep_all();
    throw;
  }
  keeper.keep_all();
}

/// Takes those whose results are known out of `members`.
void find_known(CampaignMembers& members, const std::vector<ResultStore*>& stores,
                CampaignProgress& progress) {
  for (ResultStore* store : stores) {
    std::vector<std::string> keys;
    keys.reserve(members.size());
    for (const auto& member : members) keys.push_back(member->key);
    store->find_each(keys, [&](std::size_t i, const MemberResult& result) {
      ++progress.found;
      if (!result.failure.empty()) ++progress.failed;
      members[i].reset();
    });
    std::erase(members, nullptr);
  }
}

}  // namespace

double CampaignProgress::overhead_per_member() const {
  if (run == 0) return 0.0;
  return (elapsed_seconds * threads - impact_seconds) / static_cast<double>(run);
}

Json to_json(const CampaignProgress& progress) {
  return {{"schema", 1},
          {"members", progress.members},
          {"found", progress.found},
          {"run", progress.run},
          {"failed", progress.failed},
          {"store", progress.file.string()},
          {"threads", progress.threads},
          {"impact_s", progress.impact_seconds},
          {"elapsed_s", progress.elapsed_seconds},
          {"overhead_per_member_s", progress.overhead_per_member()},
          {"impact_processor_s", progress.impact_processor_seconds},
          {"processor_s", progress.processor_seconds}};
}

CampaignProgress run_campaign(const Campaign& campaign, const std::filesystem::path& store,
                              const Shard& shard, const RunControl& control) {
  const auto start = Clock::now();
  const double processor = process_time();
  CampaignProgress progress;
  progress.threads = worker_threads();
  progress.file = shard_file(store, shard);
  const std::size_t all = campaign.size();
  progress.members = members_of(shard, all);
  ResultStore results(progress.file, ResultStore::Access::write, campaign.program());
  results.keep_campaign(campaign.digest(), campaign.text());
  std::vector<ResultStore> earlier = earlier_results(store, shard, campaign.program());
  std::vector<ResultStore*> stores{&results};
  for (ResultStore& one : earlier) stores.push_back(&one);
  Keeper keeper(results, [&] {
    if (control.progress)
      control.progress(static_cast<double>(progress.found + keeper.run()) /
                       static_cast<double>(progress.members));
  });
  DesignSampler sampler(campaign.design());
  for (std::size_t round = 0; round * shard.of < all;) {
    std::vector<std::size_t> numbers;
    for (; round * shard.of < all && numbers.size() < block; ++round)
      if (const std::size_t number = member_in_round(shard, round); number < all)
        numbers.push_back(number);
    CampaignMembers members = make_members(campaign, sampler, numbers);
    find_known(members, stores, progress);
    run_members(campaign, members, keeper, control);
  }
  progress.run = keeper.run();
  progress.failed += keeper.failed();
  progress.impact_seconds = keeper.impact_seconds();
  progress.impact_processor_seconds = keeper.impact_processor();
  progress.elapsed_seconds = seconds_since(start);
  progress.processor_seconds = process_time() - processor;
  return progress;
}

}  // namespace rebound
