#ifndef SURFACE_MESH_GEODESICS_DEMO_TEXT_SCANNER_H
#define SURFACE_MESH_GEODESICS_DEMO_TEXT_SCANNER_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace geodesics_demo {

// Reads words and numbers from a text in memory, and knows the line of each of them. Lines end with LF, CR LF or CR. A
// mark of byte order at the beginning is skipped. Throws a Command_error with the name of the file, the line and the
// word if the text is not what the caller asks for.
//
// Numbers are converted by std::from_chars, which does not depend on the language of the user's system.
class Text_scanner
{
public:
  // `comment` begins a comment, which ends with the line; 0 if the format has no comments. If `has_continuation`, a
  // backslash at the end of a line continues it.
  Text_scanner(const std::string& file_name, std::string_view text, char comment, bool has_continuation = false);

  // --- lines ---

  // Moves to the next line that has a word. Returns false at the end of the text.
  bool find_line();

  // Does the current line have another word? Does not leave the line.
  bool has_word();

  // Moves behind the end of the current line.
  void skip_line();

  std::uint32_t line() const { return m_line; } // counted from 1

  // --- words ---

  // The next word; it is empty at the end of the line. The text must be alive when it is used.
  std::string_view word();
  std::string_view peek_word();

  // The next word as a finite number. `what` names it for messages: "a coordinate". The end of the line is an error.
  double number(const char* what);

  // The next word as a whole number from `least` to `most`.
  std::int64_t integer(const char* what, std::int64_t least, std::int64_t most);

  // A whole number that something may follow without a blank, such as a slash; 0 if there is none.
  std::int64_t integer_before_slash();

  // The number of bytes that have not been read. No file has more items than that.
  std::size_t rest() const { return static_cast<std::size_t>(m_end - m_position); }
  const char* position() const { return m_position; }

  // --- messages ---

  [[noreturn]] void complain(const std::string& what) const;
  [[noreturn]] void complain_of(std::string_view word, const std::string& what) const;

private:
  // Moves to the next word of the line.
  void skip_blanks();
  void pass_end_of_line();
  [[noreturn]] void complain_of_number(std::string_view word, const char* what) const;

  std::string m_file_name;
  const char *m_position, *m_end;
  char m_comment;
  bool m_has_continuation;
  std::uint32_t m_line = 1;
};

// The text without a mark of byte order. Throws a Command_error if it is in an encoding of two bytes.
std::string_view without_mark_of_byte_order(const std::string& file_name, std::string_view text);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_TEXT_SCANNER_H
