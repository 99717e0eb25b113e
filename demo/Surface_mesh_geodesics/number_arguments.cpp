#include "number_arguments.h"

#include "Command_error.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace geodesics_demo {

namespace po = boost::program_options;

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

std::string range_of_counts(std::size_t minimum, std::size_t maximum)
{
  const std::string first = std::to_string(minimum);
  return maximum == (std::numeric_limits<std::size_t>::max)()
           ? "a whole number of " + first + " or more"
           : "a whole number from " + first + " to " + std::to_string(maximum);
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

std::string without_blanks(const std::string& text)
{
  static const char* const blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> cells_of_row(const std::string& line, char separator)
{
  std::vector<std::string> cells = split(line, separator);
  for(std::string& cell : cells)
  {
    cell = without_blanks(cell);
    if(cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
  }
  return cells;
}

bool ends_with(const std::string& text, const std::string& ending)
{
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

Text_value* count_value(const std::string& option, std::size_t minimum, std::size_t maximum)
{
  return po::value<std::string>()->notifier([=](const std::string& text)
  {
    std::size_t value = 0;
    if(!parse_index(text, value) || value < minimum || value > maximum)
      complain(option, text, range_of_counts(minimum, maximum));
  });
}

Text_value* positive_value(const std::string& option)
{
  return po::value<std::string>()->notifier([=](const std::string& text)
  {
    double value = 0;
    if(!parse_number(text, value) || !(value > 0))
      complain(option, text, "a positive number, such as 0.5 or 1e-3");
  });
}

Texts_value* numbers_value(const std::string& option)
{
  return po::value<std::vector<std::string>>()->composing()->notifier([=](const std::vector<std::string>& texts)
  {
    double value = 0;
    for(const std::string& numbers : texts)
      for(const std::string& text : split(numbers, ','))
        if(!parse_number(text, value))
          complain(option, text, "a number, such as -0.5 or 1e-3");
  });
}

std::size_t count_argument_or(const Arguments& arguments, const std::string& option, std::size_t otherwise)
{
  std::size_t value = otherwise;
  if(has(arguments, option))
    parse_index(arguments[option].as<std::string>(), value);
  return value;
}

double positive_argument_or(const Arguments& arguments, const std::string& option, double otherwise)
{
  double value = otherwise;
  if(has(arguments, option))
    parse_number(arguments[option].as<std::string>(), value);
  return value;
}

std::vector<double> number_arguments(const Arguments& arguments, const std::string& option)
{
  std::vector<double> result;
  for(const std::string& numbers : all_values(arguments, option))
    for(const std::string& text : split(numbers, ','))
    {
      result.push_back(0);
      parse_number(text, result.back());
    }
  return result;
}

} // namespace geodesics_demo
