// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_SYSTEM_FILES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_SYSTEM_FILES_H

// What the standard library does not have for files and processes: writing that survives a loss of power, creating a
// file exclusively, and asking whether a process lives. The only file of the store that knows POSIX and Windows.
//
// A failure throws a Geodesic_matrix_store_error that names the file, unless the comment of the function says
// otherwise.

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <sys/stat.h>
#else
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>
#endif

// Visual C++ warns of functions of the C library, such as std::fopen(), for which it has others of its own.
#ifdef _MSC_VER
#pragma warning(push)
#pragma warning(disable : 4996)
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Every message begins with the name of the file: a user with many folders needs it first.
[[noreturn]] inline void complain_of_file(const std::filesystem::path& path, const std::string& what)
{
  throw Geodesic_matrix_store_error(Geodesic_matrix_store_error::Reason::FILE_ERROR, path.string() + ": " + what);
}

// The message of the last failed call of the C library.
inline std::string system_message()
{
  return errno != 0 ? std::generic_category().message(errno) : "the reason is unknown";
}

// --- writing ---

// Returns when the contents of an open file are on the disk; false on failure.
// What the C library has in its buffer goes to the system first, and then from the system to the disk.
inline bool sync_stream(std::FILE* file)
{
#ifdef _WIN32
  return std::fflush(file) == 0 && _commit(_fileno(file)) == 0;
#else
  return std::fflush(file) == 0 && ::fsync(fileno(file)) == 0;
#endif
}

// Returns when the names in a folder are on the disk, as far as the system can tell: Windows has no such call, and some
// file systems reject it for folders. Throws if the disk fails.
inline void sync_folder(const std::filesystem::path& folder)
{
#ifdef _WIN32
  static_cast<void>(folder);
#else
  const int file = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
  if(file < 0)
    return;
  errno = 0;
  const bool has_failed = ::fsync(file) != 0 && errno == EIO;
  ::close(file);
  if(has_failed)
    complain_of_file(folder, "cannot be written: " + std::generic_category().message(EIO));
#endif
}

// Gives a complete file its final name, instead of a file that has the name already: a reader sees one or the other.
inline void rename_file(const std::filesystem::path& from, const std::filesystem::path& to)
{
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if(error)
    complain_of_file(to, "cannot be written: " + error.message());
}

// Gives a file a second name; returns whether it has it. If not, `error` says why: another file may have that name, or
// the file system knows no second names.
inline bool add_name(const std::filesystem::path& from, const std::filesystem::path& to, std::error_code& error)
{
  std::error_code no_error;
  std::filesystem::create_hard_link(from, to, error);
  // A server may lose its answer: then the second name counts, not the error.
  return !error || std::filesystem::hard_link_count(from, no_error) == 2;
}

// Gives a complete file its final name, unless there is a file of that name; returns whether it did. Of several
// processes that try, one gets true. (On file systems without second names, two may get it within an instant of each
// other.)
inline bool give_new_name(const std::filesystem::path& from, const std::filesystem::path& to)
{
  std::error_code error, no_error;
  const bool has_second_name = add_name(from, to, error);
  if(!has_second_name && error != std::errc::file_exists && !std::filesystem::exists(to, no_error))
  {
    rename_file(from, to);
    return true;
  }
  std::filesystem::remove(from, no_error);
  return has_second_name;
}

// Writes a new file and syncs it, but not its folder.
// Requires: nobody else writes a file of this name, which temporary_name() makes sure of. The file may be incomplete if
// the process ends meanwhile; if the function throws, it is gone.
inline void write_synced(const std::filesystem::path& path, const std::string& text)
{
  errno = 0;
  std::FILE* const file = std::fopen(path.string().c_str(), "wb");
  if(file == nullptr)
    complain_of_file(path, "cannot be written: " + system_message());
  const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size() && sync_stream(file);
  const std::string message = system_message();
  if(std::fclose(file) == 0 && is_written)
    return;
  std::error_code error;
  std::filesystem::remove(path, error);
  complain_of_file(path, "cannot be written: " + message);
}

// Creates a file with a text; returns false if it exists already. Of several processes that try, one gets true. The
// text is complete as soon as the file has its name: the file is written as `temporary`, which then gets a second name.
// On file systems without second names, the text follows after the creation.
inline bool create_exclusively(const std::filesystem::path& path, const std::filesystem::path& temporary,
                               const std::string& text)
{
  std::error_code error, no_error;
  {
    std::ofstream os(temporary, std::ios::binary | std::ios::trunc);
    os << text;
    if(!os.flush())
    {
      const std::string message = system_message();
      os.close();
      std::filesystem::remove(temporary, no_error);
      complain_of_file(path, "cannot be written: " + message);
    }
  }
  const bool has_second_name = add_name(temporary, path, error);
  std::filesystem::remove(temporary, no_error);
  if(has_second_name)
    return true;
  if(error == std::errc::file_exists)
    return false;
#ifdef _WIN32
  const int file = _open(path.string().c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY, _S_IREAD | _S_IWRITE);
  const bool is_written = file >= 0 && _write(file, text.data(), static_cast<unsigned int>(text.size())) >= 0;
  if(file >= 0)
    _close(file);
#else
  // The rest is for file systems without second names, such as FAT. The lock may be seen without its text for a moment.
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  const bool is_written = file >= 0 && ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if(file >= 0)
    ::close(file);
#endif
  if(file < 0 && errno == EEXIST)
    return false;
  if(!is_written)
    complain_of_file(path, "cannot be created: " + system_message());
  return true;
}

// Sets the time of the last change to that of the file system's clock, which is the server's if it has one. A file that
// does not exist stays so.
inline void set_time_to_now(const std::filesystem::path& path)
{
#ifdef _WIN32
  std::error_code error;
  std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now(), error);
#else
  static_cast<void>(::utimensat(AT_FDCWD, path.c_str(), nullptr, 0));
#endif
}

// Returns the contents of a small file; an empty text if it cannot be read.
// Files that other processes rename into place are read whole, before or after the change. A file that is removed
// between two calls reads as an empty one; callers treat both alike.
inline std::string text_of_file(const std::filesystem::path& path)
{
  // (The operator catches what a buffer throws that opens a folder, or loses its server.)
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// --- processes ---

// A process of a machine: "host.number.birth". The birth distinguishes a process from a later one with the same number;
// it is 0 where the system does not tell.
struct Process_owner
{
  std::string host;
  long number = 0;
  std::string birth;

  std::string text() const { return host + '.' + std::to_string(number) + '.' + birth; }
};

// Reads an owner; returns false if the text is none. The name of the host may contain dots.
// The numbers are searched for from the end. A text of another program, or a lock that was not written to its end, is
// not an owner.
inline bool parse_owner(const std::string& text, Process_owner& owner)
{
  const std::size_t second = text.rfind('.');
  const std::size_t first
    = second == std::string::npos || second == 0 ? std::string::npos : text.rfind('.', second - 1);
  if(first == std::string::npos || first == 0)
    return false;
  const std::string number = text.substr(first + 1, second - first - 1);
  if(number.empty() || number.size() > 18 || number.find_first_not_of("0123456789") != std::string::npos)
    return false;
  owner.host = text.substr(0, first);
  owner.number = std::stol(number);
  owner.birth = text.substr(second + 1);
  return true;
}

// The state and the birth of a process, from Linux; an empty birth if there is no such file.
inline void read_process(long number, char& state, std::string& birth)
{
  state = '?';
  birth.clear();
  const std::string line = text_of_file("/proc/" + std::to_string(number) + "/stat");
  // The line is "number (name) state parent ...". The name may contain blanks and parentheses.
  const std::size_t name_end = line.rfind(')'); // the name may contain anything
  if(name_end == std::string::npos || name_end + 2 >= line.size())
    return;
  state = line[name_end + 2];
  std::size_t begin = name_end + 2; // field 3; the birth is field 22
  for(int field = 3; field < 22 && begin != std::string::npos; ++field)
  {
    begin = line.find(' ', begin);
    begin = begin == std::string::npos ? begin : begin + 1;
  }
  if(begin != std::string::npos)
    birth = line.substr(begin, line.find(' ', begin) - begin);
}

// What the number of a process refers to besides the host: containers of one host may have its name, and they count
// their processes anew. Empty outside of containers, and where the system does not tell.
inline std::string container_of_processes()
{
  std::error_code error;
  const std::string text = std::filesystem::read_symlink("/proc/self/ns/pid", error).string(); // "pid:[4026532201]"
  const std::string of_the_host = "pid:[4026531836]"; // the same on all hosts
  const std::size_t begin = text.find('[');
  if(error || begin == std::string::npos || text == of_the_host)
    return "";
  return '-' + text.substr(begin + 1, text.find(']') - begin - 1);
}

// Not stored between calls: the number changes in a child process. Characters that cannot be in names of files are
// replaced, as names of temporary files contain the owner.
inline Process_owner this_process()
{
  Process_owner owner;
#ifdef _WIN32
  const char* const host = std::getenv("COMPUTERNAME");
  owner.host = host != nullptr ? host : "";
  owner.number = _getpid();
#else
  char host[256] = "";
  if(gethostname(host, sizeof host - 1) == 0)
    owner.host = host + container_of_processes();
  owner.number = static_cast<long>(getpid());
#endif
  char state = '?';
  read_process(owner.number, state, owner.birth);
  for(char& c : owner.host)
    if(c == '/' || c == '\\' || c == ':')
      c = '-';
  if(owner.host.empty())
    owner.host = "localhost";
  if(owner.birth.empty())
    owner.birth = "0";
  return owner;
}

// Does the system tell whether a process of this host is dead? If not, the age of its files decides, as for processes
// of other hosts.
#ifdef _WIN32
constexpr bool knows_dead_processes = false;
#else
constexpr bool knows_dead_processes = true;
#endif

// Is the process certainly dead? False for processes of other hosts, and where the system does not tell.
inline bool is_dead(const Process_owner& owner)
{
#ifdef _WIN32
  static_cast<void>(owner);
  return false;
#else
  if(owner.host != this_process().host)
    return false;
  // Signal 0 only asks. A process of another user answers EPERM: it lives.
  if(::kill(static_cast<pid_t>(owner.number), 0) != 0 && errno == ESRCH)
    return true;
  char state = '?';
  std::string birth;
  read_process(owner.number, state, birth);
  // A zombie has ended, but its parent has not asked for its status.
  return state == 'Z' || state == 'X' || (!birth.empty() && owner.birth != "0" && birth != owner.birth);
#endif
}

// A name for a temporary file: "NAME.owner.count.tmp". The count is different for each call in the process.
// So two threads, two processes and two hosts never write the same file, and a later process can see whose remains
// a file is (Store_folder::remove_stale_files()).
inline std::filesystem::path temporary_name(const std::filesystem::path& path)
{
  static std::atomic<unsigned long> count{0};
  return path.string() + '.' + this_process().text() + '.' + std::to_string(count++) + ".tmp";
}

// The clock of the file system of a folder: that of other machines, and of this one, may go wrong. Makes a temporary
// file.
class Folder_clock
{
public:
  explicit Folder_clock(const std::filesystem::path& folder)
  {
    const std::filesystem::path probe = temporary_name(folder / "clock");
    std::error_code error, other_error;
    std::ofstream(probe).put(' ');
    m_now = std::filesystem::last_write_time(probe, error);
    if(error) // the folder can be read only
      m_now = std::filesystem::file_time_type::clock::now();
    std::filesystem::remove(probe, other_error);
  }

  // How far from now was a file of the folder written, before or after? 0 if it does not exist.
  std::chrono::seconds distance(const std::filesystem::path& path) const
  {
    std::error_code error;
    const auto written = std::filesystem::last_write_time(path, error);
    if(error)
      return std::chrono::seconds(0);
    return std::chrono::duration_cast<std::chrono::seconds>(written < m_now ? m_now - written : written - m_now);
  }

private:
  // The time at which the object was made; objects live for a moment only.
  std::filesystem::file_time_type m_now;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#ifdef _MSC_VER
#pragma warning(pop)
#endif

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_FILES_SYSTEM_FILES_H
