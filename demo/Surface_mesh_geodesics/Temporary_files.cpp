#include "Temporary_files.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>

namespace geodesics_app {

namespace {

// A signal handler may neither allocate nor lock: the names stand in memory that is there from the beginning. A name
// counts once its flag is set. A longer name, or one file too many, is left behind by an interrupted program.
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
  raise(signal_number); // so that the shell sees how the program has ended
}

void install_handlers()
{
  static const bool is_done = []
  {
    for(const int s : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU})
      if(signal(s, remove_files_and_end) == SIG_IGN)
        signal(s, SIG_IGN); // as nohup wants it
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

} // namespace geodesics_app
