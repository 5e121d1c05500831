// Runs what a table of bars lacks: the families of `rebound fem --reference`, fine families that
// are the truth, and nine-node families that hold the truth. Each is kept in a store of results as
// it ends, and the table is written anew with it, so that a kill or Ctrl-C costs what was running.
//
//   build/coverage_campaign STORE comparisons/accuracy/numerical_error/error_bars/coverage.csv
//   build/coverage_campaign --again comparisons/accuracy/numerical_error/error_bars/coverage.csv
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string_view>
#include <thread>
#include <tuple>

#include "comparisons/accuracy/numerical_error/coverage_store.hpp"
#include "comparisons/io/result_store/result_store.hpp"
#include "comparisons/io/result_store/running_program.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/atomic_file.hpp"
#include "lumped/problem/error.hpp"
#include "tests/verification/fem/coverage/families.hpp"
#include "tests/verification/fem/coverage/repetition.hpp"

namespace rebound {
namespace {

MemberResult failed_because(const std::string& reason) {
  MemberResult failed = member_of({});
  failed.failure = reason;
  return failed;
}

/// What a family gave, or why it gave nothing.
MemberResult result_of(const PlannedFamily& family) {
  try {
    return member_of(run_family(family));
  } catch (const Error& error) {
    if (error.code() == ExitCode::input_output_failed) throw;
    return failed_because(error.what());
  } catch (const std::exception& error) {
    return failed_because(error.what());
  }
}

class CoverageCampaign {
 public:
  CoverageCampaign(const std::filesystem::path& store, std::filesystem::path table)
      : table_(std::move(table)),
        program_(running_program()),
        store_(store, ResultStore::Access::write, program_) {
    if (std::filesystem::exists(table_)) rows_ = read_coverage(table_);
    for (const CoverageRow& row : rows_) in_table_.insert(name_of(row));
  }

  /// The table is written with every family that it lacked, the cheapest points first.
  void run(const std::vector<PlannedFamily>& planned) {
    std::vector<const PlannedFamily*> missing;
    {
      const std::lock_guard lock(guard_);  // stop() may come at any time
      for (const PlannedFamily& family : planned) {
        place_.emplace(name_of(family.row), place_.size());
        if (!in_table_.contains(name_of(family.row))) missing.push_back(&family);
      }
    }
    std::map<int, double> cost_of_point;
    for (const PlannedFamily* family : missing)
      cost_of_point[family->row.number] += relative_cost(*family);
    std::stable_sort(missing.begin(), missing.end(),
                     [&](const PlannedFamily* a, const PlannedFamily* b) {
                       return cost_of_point[a->row.number] < cost_of_point[b->row.number];
                     });
    in_parallel(missing.size(), [&](std::size_t i) {
      const MemberResult result = found_or_run(*missing[i], missing.size());
      add_to_table(rows_of(result, missing[i]->row));
    });
    fmt::print("{} families in the table before, {} found in the store, {} run, {} of all failed\n",
               in_table_.size(), found_, run_, failed_);
  }

  /// Ends the program between two writes: what is complete is in store and table.
  [[noreturn]] void stop() {
    const std::lock_guard lock(guard_);
    fmt::print(stderr, "stopped; the table has {} of {} families, the same command goes on\n",
               in_table_.size() + static_cast<std::size_t>(added_), place_.size());
    ::_exit(static_cast<int>(ExitCode::interrupted));
  }

 private:
  using Name = std::tuple<int, FamilyUse, int>;
  static Name name_of(const CoverageRow& row) { return {row.number, row.use, row.cells}; }

  /// In the order of the plan, whatever ended first and however often it was begun anew; rows of
  /// another plan stay before them.
  void add_to_table(const std::vector<CoverageRow>& rows) {
    const std::lock_guard lock(guard_);
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    const auto place = [&](const CoverageRow& row) {
      const auto found = place_.find(name_of(row));
      return found == place_.end() ? 0 : 1 + found->second;
    };
    std::stable_sort(rows_.begin(), rows_.end(), [&](const CoverageRow& a, const CoverageRow& b) {
      return place(a) < place(b);
    });
    std::string text = coverage_heading() + "\n";
    for (const CoverageRow& row : rows_) text += to_csv(row);
    write_file_atomically(table_, text);
    ++added_;
  }

  MemberResult found_or_run(const PlannedFamily& family, std::size_t missing) {
    const CoverageRow& row = family.row;
    const std::string key = key_of_family(program_, family.problem, row.use, row.cells);
    {
      const std::lock_guard lock(guard_);
      if (auto found = store_.find(key)) {
        ++found_;
        failed_ += !found->failure.empty();
        return *std::move(found);
      }
    }
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    MemberResult result = result_of(family);
    const std::lock_guard lock(guard_);
    store_.keep({{.key = key,
                  .factors = fmt::format("{{\"point\":{},\"use\":{},\"cells\":{}}}", row.number,
                                         static_cast<int>(row.use), row.cells),
                  .result = result}});
    ++run_;
    failed_ += !result.failure.empty();
    fmt::print(stderr, "{} of {}: point {}, {} cells: {:.1f} s{}{}\n", found_ + run_, missing,
               row.number, row.cells, std::chrono::duration<double>(Clock::now() - start).count(),
               result.failure.empty() ? "" : "; ", result.failure);
    return result;
  }

  std::filesystem::path table_;
  std::string program_;
  std::mutex guard_;
  ResultStore store_;
  std::vector<CoverageRow> rows_;
  std::set<Name> in_table_;            ///< before this run
  std::map<Name, std::size_t> place_;  ///< in the plan
  int found_ = 0, run_ = 0, failed_ = 0, added_ = 0;
};

/// Ctrl-C and SIGTERM come to one thread that waits for them; all others, begun later, have them
/// blocked. It ends before the campaign does: a signal after the last family meets no object that
/// is gone, and nothing else either.
class StopWhenAsked {
 public:
  explicit StopWhenAsked(CoverageCampaign& campaign) {
    sigset_t asked;
    sigemptyset(&asked);
    sigaddset(&asked, SIGINT);
    sigaddset(&asked, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &asked, nullptr);
    waiting_ = std::thread([this, asked, &campaign] {
      int signal = 0;
      ::sigwait(&asked, &signal);
      if (!done_) campaign.stop();
    });
  }
  StopWhenAsked(const StopWhenAsked&) = delete;
  StopWhenAsked& operator=(const StopWhenAsked&) = delete;
  ~StopWhenAsked() {
    done_ = true;
    ::pthread_kill(waiting_.native_handle(), SIGTERM);
    waiting_.join();
  }

 private:
  std::atomic<bool> done_{false};
  std::thread waiting_;
};

}  // namespace
}  // namespace rebound

int main(int count, char** arguments) try {
  const bool to_try = count == 4 && std::string_view(arguments[3]) == "--try";
  const bool again = count == 3 && std::string_view(arguments[1]) == "--again";
  if (count != 3 && !to_try) {
    fmt::print(stderr,
               "usage: coverage_campaign STORE.sqlite TABLE.csv [--try]\n"
               "       coverage_campaign --again TABLE.csv\n"
               "STORE keeps what is run, TABLE gets what it lacks of the plan; --try: few cells\n"
               "--again: a dozen families of TABLE beside what it says, status 1 if a verdict "
               "differs\n");
    return 2;
  }
  if (again) return rebound::repeat_families(arguments[2], 12) == 0 ? 0 : 1;
  const std::filesystem::path folder = std::filesystem::path(arguments[1]).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder);
  rebound::CoverageCampaign campaign(arguments[1], arguments[2]);
  const rebound::StopWhenAsked stop_when_asked(campaign);
  campaign.run(to_try ? rebound::families_to_try() : rebound::planned_families());
  return 0;
} catch (const rebound::Error& error) {
  fmt::print(stderr, "{}: {}\n", error.location().file, error.what());
  return static_cast<int>(error.code());
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 3;
}
