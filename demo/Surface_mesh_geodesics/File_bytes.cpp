#include "File_bytes.h"

#include "Command_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>

namespace geodesics_demo {

namespace {

// An open file, which the destructor closes unless it is the standard input.
class Open_file
{
public:
  explicit Open_file(const std::string& name)
    : m_descriptor(name == "-" ? STDIN_FILENO : open(name.c_str(), O_RDONLY | O_CLOEXEC))
  {
    if(m_descriptor < 0)
      reject_file(name, std::string("cannot be read: ") + std::strerror(errno));
  }

  ~Open_file()
  {
    if(m_descriptor != STDIN_FILENO)
      close(m_descriptor);
  }

  Open_file(const Open_file&) = delete;
  Open_file& operator=(const Open_file&) = delete;

  // The size if it is known; 0 for a pipe.
  std::size_t size() const
  {
    struct stat status;
    return fstat(m_descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0
             ? static_cast<std::size_t>(status.st_size)
             : 0;
  }

  // The number of bytes read; 0 at the end of the file, and a negative number on failure.
  ssize_t read_some(char* bytes, std::size_t most) const
  {
    ssize_t number = -1;
    do
      number = read(m_descriptor, bytes, most);
    while(number < 0 && errno == EINTR);
    return number;
  }

private:
  int m_descriptor;
};

} // namespace

std::string bytes_of(const std::string& file_name)
{
  const Open_file file(file_name);
  // One byte more than the size: the last call finds the end of the file without a larger string.
  const std::size_t smallest = std::size_t(1) << 16;
  std::string bytes((std::max)(file.size() + 1, smallest), 0);
  std::size_t length = 0;
  while(const ssize_t number = file.read_some(&bytes[length], bytes.size() - length))
  {
    if(number < 0)
      reject_file(file_name, std::string("cannot be read: ") + std::strerror(errno));
    length += static_cast<std::size_t>(number);
    if(length == bytes.size())
      bytes.resize(2 * bytes.size());
  }
  bytes.resize(length);
  if(bytes.empty())
    reject_file(file_name, "the file is empty");
  return bytes;
}

} // namespace geodesics_demo
