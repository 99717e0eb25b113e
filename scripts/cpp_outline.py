"""Finds the functions, namespaces and comments of a C++ file, without a compiler.

A small reader for code in the style of this package. It knows templates, constructors with initializer lists,
operators, attributes and raw strings. Lambdas and local classes belong to the function around them. Preprocessor lines
are skipped; both branches of an #if must have balanced braces.
"""

import dataclasses
import re

TOKEN = re.compile(
    r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<raw>\b(?:u8|[uUL])?R"(?P<mark>[^()\\\s]*)\(.*?\)(?P=mark)")
  | (?P<string>"(?:\\.|[^"\\\n])*")
  | (?P<character>'(?:\\.|[^'\\\n])+')
  | (?P<number>\.?\d(?:[eEpP][+-]|'\w|[\w.])*)
  | (?P<directive>^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<sign>::|->|<=>|<<=|==|!=|<=|>=|&&|\|\||[+\-*/%&|^]=|<<|\+\+|--|[^\s\w])
    """,
    re.VERBOSE | re.DOTALL | re.MULTILINE)

# Parentheses after these words hold no parameters.
NO_FUNCTION_NAMES = {"noexcept", "decltype", "__attribute__", "alignas", "throw", "explicit"}
OPENING = {"(": ")", "[": "]", "{": "}"}


@dataclasses.dataclass
class Token:
    text: str
    line: int


@dataclasses.dataclass
class Function:
    name: str
    first_line: int  # of its declaration, after `template <...>`
    opening_line: int  # where its body begins
    last_line: int

    @property
    def length(self):
        """The number of lines between the braces; 1 for a body on the line of its braces."""
        return max(self.last_line - self.opening_line - 1, 1)


@dataclasses.dataclass
class Outline:
    """What the reader found in one file. Lines begin with 1."""

    number_of_lines: int  # all of them
    number_of_text_lines: int  # without blank lines and the copyright block
    number_of_comment_lines: int  # of these, the lines that hold a comment and no code
    tokens: list  # without comments and preprocessor lines
    functions: list
    namespaces: list  # tuples: name, first line, last line


class Reader:
    """Walks over the tokens of one file."""

    def __init__(self, tokens):
        self.tokens = tokens
        self.functions = []
        self.namespaces = []

    def end_of_group(self, i):
        """The index of the token that closes the parenthesis, bracket or brace at i."""
        closing = []
        while i < len(self.tokens):
            text = self.tokens[i].text
            if text in OPENING:
                closing.append(OPENING[text])
            elif closing and text == closing[-1]:
                closing.pop()
                if not closing:
                    return i
            elif text == "}":
                break
            i += 1
        raise ValueError(f"line {self.tokens[min(i, len(self.tokens) - 1)].line}: brackets do not match")

    def end_of_template_parameters(self, i):
        """The index behind the `>` that closes the `<` at i."""
        depth = 0
        while i < len(self.tokens):
            text = self.tokens[i].text
            if text == "<":
                depth += 1
            elif text == ">":
                depth -= 1
                if depth == 0:
                    return i + 1
            elif text in OPENING:
                i = self.end_of_group(i)
            i += 1
        raise ValueError("a template header does not end")

    def read_scope(self, i, names):
        """Reads declarations from i to the end of a file, namespace or class. Returns the index of its `}`."""
        while i < len(self.tokens) and self.tokens[i].text != "}":
            i = self.read_declaration(i, names)
        return i

    def read_declaration(self, i, names):
        """Reads one declaration or definition. Returns the index behind it."""
        while self.tokens[i].text == "template" and self.tokens[i + 1].text == "<":
            i = self.end_of_template_parameters(i + 1)
        declaration = Declaration(self.tokens[i])
        while i < len(self.tokens):
            token = self.tokens[i]
            if token.text == "}":
                return i
            if token.text == ";" or (token.text == ":" and declaration.is_access_specifier()):
                return i + 1
            if token.text == "{" and not declaration.expects_value():
                return self.read_block(i, declaration, names)
            if declaration.is_operator_name(token):
                i = declaration.take_operator_name(self.tokens, i)
                continue
            if token.text in OPENING:
                end = self.end_of_group(i)
                declaration.take_group(token)
                i = end + 1
                continue
            declaration.take(token)
            i += 1
        return i

    def read_block(self, i, declaration, names):
        """Reads the braces at i, which belong to a namespace, a class or a function."""
        first_line = declaration.first.line
        if declaration.is_namespace():
            name = declaration.name_of_namespace()
            end = self.read_scope(i + 1, names)
            self.namespaces.append((name, first_line, self.tokens[end].line))
        elif declaration.is_class():
            end = self.read_scope(i + 1, names + [declaration.name_of_class()])
        else:
            end = self.end_of_group(i)
            if declaration.function_name:
                name = "::".join(names + [declaration.function_name])
                self.functions.append(Function(name, first_line, self.tokens[i].line, self.tokens[end].line))
        return end + 1


class Declaration:
    """The tokens of a declaration in front of its braces. A group in parentheses counts as one token."""

    def __init__(self, first):
        self.first = first
        self.words = []
        self.function_name = ""
        self.has_initializers = False

    def take(self, token):
        if token.text == ":" and self.function_name:
            self.has_initializers = True
        self.words.append(token.text)

    def take_group(self, token):
        previous = self.words[-1] if self.words else ""
        if token.text == "(" and not self.function_name and not self.expects_value_after_equals():
            if re.fullmatch(r"[A-Za-z_]\w*|~", previous) and previous not in NO_FUNCTION_NAMES:
                is_destructor = len(self.words) > 1 and self.words[-2] == "~"
                self.function_name = ("~" if is_destructor else "") + previous
        self.words.append(token.text + OPENING[token.text])

    def is_operator_name(self, token):
        return token.text == "operator" and not self.function_name

    def take_operator_name(self, tokens, i):
        """Takes `operator` and its sign or type, up to the parameters. Returns their index."""
        start = i
        i += 1
        if tokens[i].text == "(":
            i += 2
        while tokens[i].text != "(":
            i += 1
        self.words += [token.text for token in tokens[start:i] if token.text != "="]
        self.function_name = "operator" + "".join(token.text for token in tokens[start + 1:i])
        return i

    def expects_value_after_equals(self):
        return "=" in self.words

    def expects_value(self):
        """Whether an opening brace begins a value: `x = {`, `int x{`, or `: member{` in a constructor."""
        if self.is_namespace() or self.is_class():
            return False
        if self.expects_value_after_equals() or not self.function_name:
            return True
        if not self.has_initializers:
            return False
        return re.fullmatch(r"[A-Za-z_]\w*|>", self.words[-1]) is not None

    def is_access_specifier(self):
        return len(self.words) == 1 and self.words[0] in ("public", "protected", "private")

    def is_namespace(self):
        return "namespace" in self.words[:2] or (self.words[:1] == ["extern"] and self.function_name == "")

    def is_class(self):
        words = [word for word in self.words if word not in ("[]", "typedef", "static", "constexpr", "inline")]
        return words[:1] in (["class"], ["struct"], ["union"], ["enum"]) and not self.function_name

    def name_of_namespace(self):
        return "".join(self.words[self.words.index("namespace") + 1:]) if "namespace" in self.words else ""

    def name_of_class(self):
        words = [word for word in self.words if re.fullmatch(r"\w+", word) and word not in ("final", "alignas")]
        return words[1] if len(words) > 1 else ""


def comment_lines(text, matches):
    """The numbers of the lines that hold a comment and no code."""
    with_comment, with_code = set(), set()
    for match in matches:
        first = text.count("\n", 0, match.start()) + 1
        lines = range(first, first + match.group().count("\n") + 1)
        (with_comment if match.lastgroup == "comment" else with_code).update(lines)
    return with_comment - with_code


def copyright_lines(lines):
    """The numbers of the lines of the copyright block: the comments at the top, if they name a copyright."""
    length = 0
    while length < len(lines) and lines[length].startswith("//"):
        length += 1
    return set(range(1, length + 1)) if any("Copyright" in line for line in lines[:length]) else set()


def outline(text):
    """Reads a file.

    Throws ValueError if its brackets do not match.
    """
    matches = list(TOKEN.finditer(text))
    tokens = []
    line, position = 1, 0
    for match in matches:
        line += text.count("\n", position, match.start())
        position = match.start()
        if match.lastgroup not in ("comment", "directive"):
            tokens.append(Token(match.group(), line))
    reader = Reader(tokens)
    if reader.read_scope(0, []) != len(tokens):
        raise ValueError("a closing brace has no opening one")
    lines = text.splitlines()
    block = copyright_lines(lines)
    blank = {number for number, each in enumerate(lines, 1) if not each.strip()}
    comments = comment_lines(text, matches) - block - blank
    return Outline(len(lines), len(lines) - len(blank | block), len(comments), tokens, reader.functions,
                   reader.namespaces)
