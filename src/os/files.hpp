// Plain files as the operating system has them, by their descriptors: numbers of open files, which programs that we
// start do not inherit. Errors are numbers of errno; 0: none. Not for: words about errors (read_file.hpp), and files
// that are there whole or not at all (io/files/files.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace terp {

enum class OpenAs {
  new_file,       ///< empty, whatever was there
  end_of_file,    ///< what is written is added; made if it is not there
  there_already,  ///< as it is; an error if it is not there
};

/// Opens a file for writing. -1: errno says why it cannot.
int open_to_write(const std::string& path, OpenAs how);

int write_all(int descriptor, std::string_view text);

/// [bytes]; -1: not known, or no plain file.
std::int64_t size_of(int descriptor);

/// Cuts the file off, or fills it with zeros.
int resize(int descriptor, std::int64_t n_bytes);

/// Makes the file longer by n_bytes that are surely on the disk.
int reserve(int descriptor, std::int64_t n_bytes);

int close_file(int descriptor);

/// Returns when a file or folder is on the disk.
int wait_for_disk(const std::string& path);

/// Gives a file another name, in place of the file that may have it: readers see the old one or the new.
int replace_file(const std::string& from, const std::string& to);

/// What a number of errno means, as the end of a sentence.
std::string words_of_errno(int error);

/// The file under a second name: a link, on Windows a copy. Throws std::filesystem::filesystem_error.
void link_or_copy(const std::string& file, const std::string& name);

/// Whether a path leads to its place from any folder.
bool is_absolute(const std::string& path);

/// Whether the file or folder may be read, or written to.
int may_read(const std::string& path);
int may_write(const std::string& path);

/// Makes a folder that was not there, for this user alone: `start` and some letters. Its path; empty: it cannot.
std::string make_unique_folder(const std::string& start);

/// Of this user, for what can be made again; empty: the environment names none.
std::string cache_folder();

/// What this program prints goes to the end of a file from now on. False: it cannot, and nothing changed.
bool print_to_file(const std::string& path);

/// Path under which the file of this program can be read.
std::string program_file();

/// Of this process, no other has it now.
long process_number();

}  // namespace terp
