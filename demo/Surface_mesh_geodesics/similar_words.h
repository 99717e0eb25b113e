#ifndef SURFACE_MESH_GEODESICS_DEMO_SIMILAR_WORDS_H
#define SURFACE_MESH_GEODESICS_DEMO_SIMILAR_WORDS_H

// What a user may have meant by a word that the program does not know.

#include <cstddef>
#include <string>
#include <vector>

namespace geodesics_demo {

// The number of characters that have to be inserted, removed or replaced to make one word of the other.
std::size_t number_of_edits(const std::string& a, const std::string& b);

// Returns the known word with the fewest edits, or of those the first one; an empty word if none is similar: if more
// than a third of the characters are different.
std::string similar_word(const std::string& word, const std::vector<std::string>& known);

// Returns " (did you mean 'known word'?)", or an empty text if none is similar.
std::string hint_at_similar_word(const std::string& word, const std::vector<std::string>& known);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_SIMILAR_WORDS_H
