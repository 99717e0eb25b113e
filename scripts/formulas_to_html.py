#!/usr/bin/env python3
"""Replaces the formulas in doxygen's pages by plain HTML, so that they can be read without MathJax and a network.

Usage: formulas_to_html.py FOLDER | --self-test

Knows the TeX that the manual uses: letters, numbers, the symbols below, powers, indices and square roots. Complains
about anything else, which then needs a line here or a simpler formula.
"""

import html
import pathlib
import re

from complaints import report, run_script

FORMULA = re.compile(r"\\\((.*?)\\\)", re.DOTALL)
MATHJAX = re.compile(r'<script type="text/x-mathjax-config">.*?</script>\s*<script[^>]*mathjax[^>]*></script>\n?',
                     re.DOTALL | re.IGNORECASE)
TOKEN = re.compile(r"\s*(\\[A-Za-z]+|\d+(?:\.\d+)?|.)", re.DOTALL)
RELATIONS = {"=": "=", "<": "&lt;", ">": "&gt;", "\\le": "≤", "\\leq": "≤", "\\ge": "≥", "\\geq": "≥", "\\in": "∈",
             "\\approx": "≈"}
OPERATORS = {"+": "+", "-": "−", "\\cdot": "·", "\\pm": "±"}
SYMBOLS = {"\\pi": "π", "\\epsilon": "ε", "\\sigma": "σ", "\\delta": "δ", "\\mu": "μ",
           "\\alpha": "α", "\\Theta": "Θ", "\\ldots": "…", "\\log": "log ",
           "\\left": "", "\\right": "", ",": ", "}
PLAIN = set("()[]|/'.")


class Formula:
    """A recursive descent over the tokens of one formula."""

    def __init__(self, text):
        self.tokens = TOKEN.findall(text.strip())
        self.position = 0

    def next(self):
        if self.position == len(self.tokens):
            raise ValueError("ends too early")
        self.position += 1
        return self.tokens[self.position - 1]

    def group(self):
        """One token, or all tokens of a pair of braces."""
        if self.tokens[self.position:self.position + 1] != ["{"]:
            return self.atom(self.next(), True)
        self.next()
        return self.sequence("}")

    def atom(self, token, is_first):
        if token == "^":
            return f"<sup>{self.group()}</sup>"
        if token == "_":
            return f"<sub>{self.group()}</sub>"
        if token == "\\sqrt":
            return f'√<span class="root">{self.group()}</span>'
        if token in RELATIONS:
            return f" {RELATIONS[token]} "
        if token in OPERATORS:  # a sign has no blanks around it
            return OPERATORS[token] if is_first else f" {OPERATORS[token]} "
        if token in SYMBOLS:
            return SYMBOLS[token]
        if token.isascii() and token.isalpha():
            return f"<i>{token}</i>"
        if token in PLAIN or re.fullmatch(r"\d+(\.\d+)?", token):
            return token
        raise ValueError(f"unknown: {token}")

    def sequence(self, end=None):
        result, is_first = "", True
        while self.position < len(self.tokens) or end is not None:
            token = self.next()
            if token == end:
                break
            result += self.atom(token, is_first)
            is_first = token in RELATIONS or token == "("
        return result.replace("  ", " ")


def to_html(text):
    """A formula in TeX, with the entities of HTML, as HTML."""
    return f'<span class="formula">{Formula(html.unescape(text)).sequence()}</span>'


def convert(page):
    """Returns the page without formulas in TeX, and the complaints."""
    complaints = []

    def replace(match):
        try:
            return to_html(match.group(1))
        except ValueError as error:
            complaints.append(f"the formula {match.group(1).strip()}: {error}")
            return match.group(0)

    return MATHJAX.sub("", FORMULA.sub(replace, page)), complaints


def self_test():
    cases = {
        "2\\pi": "2π", "x &lt; y_0": "<i>x</i> &lt; <i>y</i><sub>0</sub>", "10^{-15}": "10<sup>−15</sup>",
        "a - b": "<i>a</i> − <i>b</i>", "-a": "−<i>a</i>", "O(n^2)": "<i>O</i>(<i>n</i><sup>2</sup>)",
        "\\sqrt{x + 1}": '√<span class="root"><i>x</i> + 1</span>', "O\\left(\\log n\\right)": "<i>O</i>(log <i>n</i>)",
        "\\sqrt\\epsilon / 16": '√<span class="root">ε</span>/16',
    }
    failures = [f"{text}: {to_html(text)}" for text, expected in cases.items()
                if to_html(text) != f'<span class="formula">{expected}</span>']
    for text in ("\\int x", "10^{2", "x^"):
        if not convert(f"<p>\\( {text} \\)</p>")[1]:
            failures.append(f"no complaint: {text}")
    return report(failures, f"self-test: {len(cases) + 3} formulas")


def main(folder):
    complaints, number_of_formulas = [], 0
    for path in sorted(pathlib.Path(folder).rglob("*.html")):
        page = path.read_text(encoding="utf-8")
        number_of_formulas += len(FORMULA.findall(page))
        converted, found = convert(page)
        complaints += [f"{path.name}: {complaint}" for complaint in found]
        if converted != page:
            path.write_text(converted, encoding="utf-8")
    return report(complaints, f"{number_of_formulas} formulas")


if __name__ == "__main__":
    run_script(__doc__, self_test, main, [1])
