#include "System.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/types.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <limits>

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

namespace geodesics_demo {

// --- standard streams ---

void prepare_standard_streams()
{
#ifdef _WIN32
  for(const int stream : {0, 1, 2}) // the library gives their numbers to no other file
    static_cast<void>(_setmode(stream, _O_BINARY));
#else
  for(int stream = 0; stream < 3; ++stream)
    if(fcntl(stream, F_GETFD) == -1)
      static_cast<void>(open("/dev/null", stream == 1 ? O_RDONLY : O_RDWR));
#endif
}

bool is_error_stream_terminal()
{
#ifdef _WIN32
  // Older consoles print the sequences that erase a line, unless they are asked to obey.
  const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  return _isatty(2) != 0 && GetConsoleMode(console, &mode) != 0
      && SetConsoleMode(console, mode | 0x0004 /* ENABLE_VIRTUAL_TERMINAL_PROCESSING */) != 0;
#else
  return isatty(STDERR_FILENO) == 1;
#endif
}

// --- files ---

bool may_read(const std::string& file_name)
{
#ifdef _WIN32
  return _access(file_name.c_str(), 4) == 0;
#else
  return access(file_name.c_str(), R_OK) == 0;
#endif
}

bool may_overwrite(const std::string& file_name)
{
#ifdef _WIN32
  return _access(file_name.c_str(), 2) == 0;
#else
  return access(file_name.c_str(), W_OK) == 0;
#endif
}

Input_descriptor::Input_descriptor(const std::string& name)
#ifdef _WIN32
  : m_descriptor(name == "-" ? 0 : _open(name.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT))
#else
  : m_descriptor(name == "-" ? STDIN_FILENO : open(name.c_str(), O_RDONLY | O_CLOEXEC))
#endif
{}

Input_descriptor::~Input_descriptor()
{
  if(m_descriptor > 0)
#ifdef _WIN32
    _close(m_descriptor);
#else
    close(m_descriptor);
#endif
}

std::size_t Input_descriptor::size() const
{
#ifdef _WIN32
  struct _stat64 status;
  const bool is_file = _fstat64(m_descriptor, &status) == 0 && (status.st_mode & _S_IFMT) == _S_IFREG;
#else
  struct stat status;
  const bool is_file = fstat(m_descriptor, &status) == 0 && S_ISREG(status.st_mode);
#endif
  return is_file && status.st_size > 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

long long Input_descriptor::read_some(char* bytes, std::size_t most) const
{
#ifdef _WIN32
  const std::size_t limit = static_cast<std::size_t>((std::numeric_limits<int>::max)());
  return _read(m_descriptor, bytes, static_cast<unsigned int>((std::min)(most, limit)));
#else
  long long number = -1;
  do
    number = read(m_descriptor, bytes, most);
  while(number < 0 && errno == EINTR);
  return number;
#endif
}

// --- the process and its end ---

long process_number()
{
#ifdef _WIN32
  return _getpid();
#else
  return static_cast<long>(getpid());
#endif
}

void call_before_end(Signal_handler handler)
{
#ifdef _WIN32
  for(const int s : {SIGINT, SIGTERM, SIGBREAK})
#else
  for(const int s : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU})
#endif
    if(signal(s, handler) == SIG_IGN)
      signal(s, SIG_IGN); // nohup expects that
}

void remove_file_in_handler(const char* file_name)
{
#ifdef _WIN32
  // Windows removes no open file. Its handlers run in a thread of their own, so this call may wait for a lock.
  static_cast<void>(_fcloseall());
  static_cast<void>(_unlink(file_name));
#else
  static_cast<void>(unlink(file_name));
#endif
}

void end_by_signal(int signal_number)
{
  signal(signal_number, SIG_DFL);
  raise(signal_number);
}

} // namespace geodesics_demo
