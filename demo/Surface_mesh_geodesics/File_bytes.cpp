#include "File_bytes.h"

#include "Command_error.h"
#include "System.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>

namespace geodesics_demo {

std::string bytes_of(const std::string& file_name)
{
  const Input_descriptor file(file_name);
  if(!file.is_open())
    reject_file(file_name, std::string("cannot be read: ") + std::strerror(errno));
  // One byte more than the size: the last call finds the end of the file without a larger string.
  const std::size_t smallest = std::size_t(1) << 16;
  std::string bytes((std::max)(file.size() + 1, smallest), 0);
  std::size_t length = 0;
  while(const long long number = file.read_some(&bytes[length], bytes.size() - length))
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
