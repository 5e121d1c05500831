#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_run.hpp"

namespace rebound {

/// All that scores are made of, as CSV: one row a trial, with truth, verdict and controls.
///
/// Lines that begin with '#' stand before the header: the protocols, as "# protocol DIGEST JSON".
/// Effects of a pair are parted by '|', sets of candidates by '|' and their members by '+', the
/// parts of a control's answer by ';'. What is absent is an empty field. Numbers are written so
/// that they come back the same -> test TrialTableTest.ScoresComeBackFromTheTable.
std::string table_csv(const TrialCollection& trials);

/// Errors: Error(input_output_failed) for a file that cannot be read; Error(corrupt_store) with
/// line, column name and value for what table_csv() does not write.
TrialCollection read_trial_table(const std::filesystem::path& file);

/// Several tables as one; a table by itself is taken as it is, of however many protocols.
/// Errors: those of each; Error(bad_input) where several hold outcomes of more than one protocol
/// and `mixed` is not said, and where a trial stands in two of them -> test
/// TrialTableTest.SeveralTablesAreScoredTogetherWhereThatIsSaid.
TrialCollection read_trial_tables(const std::vector<std::string>& files, bool mixed);

/// The same of a text; `name` stands for the file in errors.
TrialCollection trial_table_of(const std::string& text, const std::string& name);

}  // namespace rebound
