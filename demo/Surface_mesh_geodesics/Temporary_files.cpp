#include "Temporary_files.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>

namespace geodesics_demo {

namespace {

// A signal handler may neither allocate nor lock, so the names are in static memory. A name is valid when its flag is
// set. An interrupted program does not remove files with longer names, nor files beyond the capacity.
struct Name
{
  std::atomic<bool> is_set{false};
  std::array<char, 4096> text;
};

std::array<Name, 16> names;

extern "C" void remove_files_and_end(int signal_number)
{
  for(const Name& name : names)
    if(name.is_set.load())
      unlink(name.text.data());
  signal(signal_number, SIG_DFL);
  raise(signal_number); // so that the shell sees how the program ended
}

void install_handlers()
{
  static const bool is_done = []
  {
    for(const int s : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU})
      if(signal(s, remove_files_and_end) == SIG_IGN)
        signal(s, SIG_IGN); // nohup expects that
    return true;
  }();
  static_cast<void>(is_done);
}

} // namespace

void remove_if_interrupted(const std::string& file_name)
{
  install_handlers();
  for(Name& name : names)
    if(!name.is_set.load() && file_name.size() < name.text.size())
    {
      std::memcpy(name.text.data(), file_name.c_str(), file_name.size() + 1);
      name.is_set.store(true);
      return;
    }
}

void keep_if_interrupted(const std::string& file_name)
{
  for(Name& name : names)
    if(name.is_set.load() && file_name == name.text.data())
      name.is_set.store(false);
}

} // namespace geodesics_demo
