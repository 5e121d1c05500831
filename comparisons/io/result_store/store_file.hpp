#pragma once

#include <filesystem>
#include <string>

/// A store as a file: made whole, and known before SQLite opens it.
namespace rebound {

/// ", restitution, ..." with a type after each name.
std::string scalar_columns(const char* type = "");

/// Throws Error(corrupt_store).
[[noreturn]] void refuse_store(const std::filesystem::path& file, const std::string& why,
                               const std::string& allowed = {});

/// Makes an empty store under a name of its own, then links it to the final one: a store is there
/// whole or not at all, and of two that make it one wins.
/// Errors: Error(input_output_failed).
void make_store_file(const std::filesystem::path& file, const std::string& program);

/// What a file is, before SQLite opens it: opening may write to a file.
/// Errors: Error(corrupt_store) for another kind of file or another version of the format.
void check_store_file(const std::filesystem::path& file);

}  // namespace rebound
