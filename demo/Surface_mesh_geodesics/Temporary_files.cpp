#include "Temporary_files.h"

#include "System.h"

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
      remove_file_in_handler(name.text.data());
  end_by_signal(signal_number);
}

void install_handlers()
{
  static const bool is_done = []
  {
    call_before_end(remove_files_and_end);
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
