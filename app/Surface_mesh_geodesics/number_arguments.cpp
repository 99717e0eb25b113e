#include "number_arguments.h"

#include "Command_error.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace geodesics_app {

namespace {

template <typename Number>
bool parse(const std::string& text, Number& value)
{
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  return !text.empty() && result.ec == std::errc() && result.ptr == end;
}

[[noreturn]] void complain(const std::string& option, const std::string& text, const std::string& wanted)
{
  throw Command_error(Exit_code::BAD_USAGE, "--" + option + ": '" + text + "' is not " + wanted);
}

} // namespace

bool parse_index(const std::string& text, std::size_t& value)
{
  return parse(text, value);
}

bool parse_number(const std::string& text, double& value)
{
  return parse(text, value) && std::isfinite(value);
}

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for(const char c : text)
  {
    if(c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::size_t count_argument(const std::string& option, const std::string& text, std::size_t minimum)
{
  std::size_t value = 0;
  if(!parse_index(text, value) || value < minimum)
    complain(option, text, "a number of " + std::to_string(minimum) + " or more");
  return value;
}

double positive_argument(const std::string& option, const std::string& text)
{
  double value = 0;
  if(!parse_number(text, value) || !(value > 0))
    complain(option, text, "a positive number");
  return value;
}

double number_argument(const std::string& option, const std::string& text)
{
  double value = 0;
  if(!parse_number(text, value))
    complain(option, text, "a number");
  return value;
}

double positive_argument_or(const Arguments& arguments, const std::string& option, double otherwise)
{
  return has(arguments, option) ? positive_argument(option, arguments[option].as<std::string>()) : otherwise;
}

} // namespace geodesics_app
