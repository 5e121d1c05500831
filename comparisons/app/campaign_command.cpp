#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/human_text.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/studies/campaign/campaign_query.hpp"
#include "comparisons/studies/campaign/diagnosis_base.hpp"
#include "comparisons/studies/campaign/run_campaign.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct CampaignOptions {
  std::vector<std::string> what;
  std::string shard, csv, hdf5, traces;
};

std::string campaign_help() {
  return "campaign FILE varies an impact, a synthesis, a calibration or a diagnosis, and keeps of\n"
         "each member its scalars, those of its shots, the fitted parameters and their cost, or\n"
         "the verdict with name, family and size, in --out DIR (default\n"
         "results/campaigns/NAME of FILE): SQLite files, one a shard. A member that is there is\n"
         "not run again, so the same command goes on after a kill, and costs nothing when done.\n"
         "Several shards, of a job array or of mpirun -n N, share DIR; each writes its own file.\n"
         "campaign query FILE|DIR|FILE.sqlite --csv TABLE.csv merges them into one table, in SI;\n"
         "--hdf5 TABLE.h5 writes it as data sets, one a column. With traces = true in FILE,\n"
         "--traces TRACES.csv (or .h5) writes the traces of all members, one below the other.\n"
         "A member that cannot be run (the contact does not end, the combination is refused) is\n"
         "kept with the reason. Results of another program than this one are refused, exit 5.\n\n"
         "  rebound campaign speeds.toml --shard $SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT\n"
         "  mpirun -n 8 rebound campaign speeds.toml --threads 1\n"
         "  rebound campaign query speeds.toml --csv speeds.csv\n\n"
         "Keys of FILE (TOML):\n" +
         help_text<CampaignFile>() + "\nKeys of a diagnosis that is varied (TOML):\n" +
         help_text<DiagnosisFile>() + "\n" + exit_code_help();
}

std::filesystem::path store_of(const Session& session, const std::filesystem::path& file) {
  if (!session.out.empty()) return session.out;
  return std::filesystem::path("results") / "campaigns" / file.stem();
}

void write_traces(const Campaign& campaign, const std::filesystem::path& store,
                  const std::filesystem::path& file) {
  const CampaignTable traces = query_traces(campaign, store);
  if (file.extension() == ".h5")
    write_hdf5(traces, campaign, file);
  else
    write_file_atomically(file, csv_of(traces));
}

ExitCode run_query(const Session& session, const CampaignOptions& options) {
  const std::filesystem::path source = options.what[1];
  const bool is_file = source.extension() == ".toml";
  const auto store = is_file ? store_of(session, source) : source;
  const Campaign campaign = is_file ? Campaign::load(source) : stored_campaign(store);
  const CampaignTable table = query_campaign(campaign, store);
  if (!options.csv.empty()) write_file_atomically(options.csv, csv_of(table));
  if (!options.hdf5.empty()) write_hdf5(table, campaign, options.hdf5);
  if (!options.traces.empty()) write_traces(campaign, store, options.traces);
  if (session.json())
    fmt::print("{}", dump({{"schema", 1},
                           {"members", table.members},
                           {"found", table.found},
                           {"failed", table.failed},
                           {"complete", table.found == table.members},
                           {"csv", options.csv},
                           {"hdf5", options.hdf5},
                           {"traces", options.traces}}));
  else if (options.csv.empty() && options.hdf5.empty() && options.traces.empty())
    fmt::print("{}", csv_of(table));
  else {
    std::vector<std::string> files;
    for (const std::string& file : {options.csv, options.hdf5, options.traces})
      if (!file.empty()) files.push_back(file);
    print_text(fmt::format("{} of {} members, {} without a result, in {}\n",
                           count_text(table.found), count_text(table.members),
                           count_text(table.failed), fmt::join(files, " and ")));
  }
  return ExitCode::done;
}

ExitCode run_all(const Session& session, const CampaignOptions& options) {
  const std::string& file = options.what.front();
  const Shard shard = options.shard.empty() ? shard_of_launcher() : parse_shard(options.shard);
  const Campaign campaign = Campaign::load(file);
  const auto store = store_of(session, file);
  make_writable_folder(store);
  const CampaignProgress done = [&] {
    ProgressLine progress("campaign");
    try {
      return run_campaign(campaign, store, shard, progress.control());
    } catch (const Error& error) {
      if (error.code() != ExitCode::interrupted) throw;
      throw Error(ExitCode::interrupted,
                  "interrupted; what was run is kept, and the same command goes on with the rest",
                  {.file = store.string()});
    }
  }();
  if (session.json())
    fmt::print("{}", dump(to_json(done)));
  else
    print_text(fmt::format(
        "shard {}/{}: {} members, {} run now in {}, {} found, {} without a result; {}\n",
        shard.number, shard.of, count_text(done.members), count_text(done.run),
        duration_text(done.elapsed_seconds), count_text(done.found), count_text(done.failed),
        done.file.string()));
  return ExitCode::done;
}

ExitCode run_campaign_command(const Session& session, const CampaignOptions& options) {
  const bool query = options.what.size() == 2;
  if (!query && options.what.front() == "query" && !std::filesystem::exists("query"))
    throw Error(ExitCode::bad_input, "which campaign's results?",
                {.key = "FILE", .value = "query", .allowed = "query FILE.toml, or query STORE"});
  if (query && options.what.front() != "query")
    throw Error(ExitCode::bad_input, "one campaign at a time",
                {.key = "FILE", .value = options.what[1], .allowed = "FILE, or query FILE|STORE"});
  for (const auto& [key, value] :
       {std::pair{"--csv", options.csv}, {"--hdf5", options.hdf5}, {"--traces", options.traces}})
    if (!query && !value.empty())
      throw Error(ExitCode::bad_input, "a table belongs to a query",
                  {.key = key,
                   .value = value,
                   .allowed = fmt::format("campaign query FILE|STORE {}", key)});
  return query ? run_query(session, options) : run_all(session, options);
}

}  // namespace

Action declare_campaign(CLI::App& command) {
  const auto options = std::make_shared<CampaignOptions>();
  command.add_option("FILE", options->what, "Campaign file; or query, then a file or a store")
      ->required()
      ->expected(1, 2);
  command.add_option("--shard", options->shard,
                     "Run one part of the members, i/N; default: the rank of mpirun, else all");
  command.add_option("--csv", options->csv, "Of a query: where the table goes");
  command.add_option("--hdf5", options->hdf5,
                     "Of a query: an HDF5 file with one data set a column");
  command.add_option("--traces", options->traces,
                     "Of a query: where the traces go, as CSV or, by the name, HDF5");
  command.footer(campaign_help);
  return [options](const Session& session) { return run_campaign_command(session, *options); };
}

}  // namespace rebound
