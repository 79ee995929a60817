#pragma once
// Files that are either whole or not there: written under a temporary name, brought to the disk, then
// renamed; so also after a loss of power.

#include <filesystem>
#include <string>
#include <string_view>

namespace platen::core {

/// As a file's name: standard input where one is read, standard output where one is written.
inline constexpr const char* standard_stream = "-";

/// Whether there is a file, a folder, or standard input of this name.
bool is_there(const std::filesystem::path&);

/// The whole file. IoError when it cannot be read. Standard input is the same each time that it is asked for.
std::string read_file(const std::filesystem::path&);

/// A name beside `file` under which it is written until it is whole; no other process uses the same.
std::filesystem::path temporary_name(const std::filesystem::path& file);

/// Writes a file under the very name, and ends when it is on the disk. IoError removes it.
void write_through(const std::filesystem::path&, std::string_view content);

/// Ends when the names in the folder are on the disk: new, renamed and removed ones.
void sync_folder(const std::filesystem::path&);

/// Renames a file written under temporary_name(file). IoError when that fails.
void put_in_place(const std::filesystem::path& temporary, const std::filesystem::path& file);

/// Writes the file whole or not at all. IoError (a full disk, say) leaves what was there before.
void write_file(const std::filesystem::path&, std::string_view content);

/// Makes the folder where it is missing and tries that a file can be written in it. IoError says what to do;
/// `option` is the one that names another folder.
void prepare_folder(const std::filesystem::path&, std::string_view option = "-o");

} // namespace platen::core
