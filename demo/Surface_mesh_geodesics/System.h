#ifndef SURFACE_MESH_GEODESICS_DEMO_SYSTEM_H
#define SURFACE_MESH_GEODESICS_DEMO_SYSTEM_H

// What the standard library does not have: permissions of files, streams that are a terminal, signals, reading without
// a buffer in between. System.cpp is the only file of the program that knows POSIX and Windows; their headers stay
// there. A call that fails leaves the reason in errno.

#include <cstddef>
#include <string>

namespace geodesics_demo {

// Call it first. No file may get the number of a standard stream that is closed: it would receive the remarks.
// Where the system converts ends of lines, the standard streams stop it: a table has the same bytes on each system.
void prepare_standard_streams();

// Is the error stream a terminal that can erase a line?
bool is_error_stream_terminal();

// May this process read, or overwrite, a file that exists?
bool may_read(const std::string& file_name);
bool may_overwrite(const std::string& file_name);

// Distinguishes the names of temporary files of processes that run at the same time.
long process_number();

// A function for signals that end the program (Ctrl-C, a closed terminal, kill). It gets the number of the signal.
using Signal_handler = void (*)(int);
void call_before_end(Signal_handler handler);

// For such a function only: removes a file that the program may be writing.
void remove_file_in_handler(const char* file_name);

// For such a function only, as its last call: ends the program so that the shell sees the signal.
void end_by_signal(int signal_number);

// A file that is open for reading, or the standard input if the name is "-". The destructor closes the file.
class Input_descriptor
{
public:
  explicit Input_descriptor(const std::string& name);
  ~Input_descriptor();

  Input_descriptor(const Input_descriptor&) = delete;
  Input_descriptor& operator=(const Input_descriptor&) = delete;

  bool is_open() const { return m_descriptor >= 0; }

  // The size if it is known; 0 for a pipe.
  std::size_t size() const;

  // The number of bytes read; 0 at the end of the file, and a negative number on failure.
  long long read_some(char* bytes, std::size_t most) const;

private:
  int m_descriptor;
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_SYSTEM_H
