#include "similar_words.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace geodesics_demo {

std::size_t number_of_edits(const std::string& a, const std::string& b)
{
  // Row i of the table: the edits from the first i characters of a to each beginning of b (Wagner and Fischer).
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for(std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t before = row[0]; // in the row above, one column to the left
    row[0] = i + 1;
    for(std::size_t k = 0; k < b.size(); ++k)
    {
      const std::size_t replaced = before + (a[i] == b[k] ? 0 : 1);
      before = row[k + 1];
      row[k + 1] = (std::min)({replaced, row[k] + 1, row[k + 1] + 1});
    }
  }
  return row.back();
}

std::string similar_word(const std::string& word, const std::vector<std::string>& known)
{
  std::string best;
  std::size_t least = (std::max)(word.size() / 3, std::size_t(1)) + 1;
  for(const std::string& candidate : known)
    if(const std::size_t n = number_of_edits(word, candidate); n < least && n < candidate.size())
    {
      least = n;
      best = candidate;
    }
  return best;
}

std::string hint_at_similar_word(const std::string& word, const std::vector<std::string>& known)
{
  const std::string found = similar_word(word, known);
  return found.empty() ? "" : " (did you mean '" + found + "'?)";
}

} // namespace geodesics_demo
