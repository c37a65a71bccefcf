"""Finds the places of a C++ file that can be mutated and rewrites each to ask mutant.hpp, at run time, whether its
mutant is on. Works on tokens, not on a grammar: the sources are formatted, so that a binary operator has a space on
either side and a template's bracket or a reference has not. No line is added or removed.

Left alone: what is computed while compiling (static_assert, if constexpr, constants, template arguments, case labels),
assertions, and what can only change the time taken (reserve, prefetch)."""

import bisect
import re

TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<preprocessor>(?m:^)[ \t]*\#(?:[^\n\\]|\\.)*(?:\\\n[^\n]*)*)
  | (?P<text>"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')
  | (?P<number>\.?[0-9](?:[eEpP][+-]|'?[0-9a-zA-Z_.])*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<sign><=>|->\*|<<=|>>=|\.\.\.|::|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[^\s])
""", re.VERBOSE | re.DOTALL)

INFIX = {"<": ("Less", "<=", ">="), "<=": ("LessEqual", "<", ">"), ">": ("Greater", ">=", "<="),
         ">=": ("GreaterEqual", ">", "<"), "==": ("Equal", "!="), "!=": ("Unequal", "=="), "+": ("Plus", "-"),
         "-": ("Minus", "+"), "*": ("Times", "+"), "/": ("Over", "*"), "%": ("Modulo", "/"),
         "<<": ("ShiftLeft", ">>"), ">>": ("ShiftRight", "<<"), "&": ("And", "|"), "|": ("Or", "&"),
         "^": ("Xor", "|"), "+=": ("PlusAssign", "-="), "-=": ("MinusAssign", "+="), "*=": ("TimesAssign", "+="),
         "/=": ("OverAssign", "*="), "&=": ("AndAssign", "|="), "|=": ("OrAssign", "&="),
         ">>=": ("ShiftRightAssign", "<<="), "<<=": ("ShiftLeftAssign", ">>=")}
KEYWORDS = {"if", "else", "for", "while", "do", "return", "switch", "case", "default", "break", "continue", "const",
            "constexpr", "static", "struct", "class", "enum", "namespace", "using", "template", "typename", "public",
            "private", "protected", "friend", "operator", "inline", "extern", "auto", "void", "noexcept", "requires",
            "concept", "explicit", "throw", "new", "delete", "sizeof", "goto", "typedef", "mutable"}
UNTIMED = {"reserve", "prefetch", "__builtin_prefetch", "THALWEG_ASSERT", "static_assert", "sizeof", "alignas",
           "shrink_to_fit"}
CLOSING = {"(": ")", "[": "]", "{": "}"}


class Token:
    def __init__(self, kind, text, start):
        self.kind, self.text, self.start, self.end = kind, text, start, start + len(text)


class File:
    """One source: its tokens, which bracket belongs to which, what is left alone, and the mutants found."""

    def __init__(self, source):
        self.source = source
        self.tokens = [Token(m.lastgroup, m.group(), m.start()) for m in TOKEN.finditer(source)
                       if m.lastgroup not in ("comment", "preprocessor")]
        self.partner = self._partners()
        self.alone = [False] * len(self.tokens)
        self.lines = [m.end() for m in re.finditer("\n", source)]
        self._leave_alone()
        self.mutants = []  # (line, column, what, site)
        self.edits = []    # (start, end, rank, text with {N}, site)
        self.sites = 0

    def text(self, i):
        return self.tokens[i].text if 0 <= i < len(self.tokens) else ""

    def kind(self, i):
        return self.tokens[i].kind if 0 <= i < len(self.tokens) else ""

    def spaced(self, i):
        t = self.tokens[i]
        return self.source[t.start - 1].isspace() and self.source[t.end:t.end + 1].isspace()

    def _partners(self):
        partner, open_ = {}, []
        for i, t in enumerate(self.tokens):
            if t.kind != "sign":
                continue
            if t.text in CLOSING:
                open_.append(i)
            elif t.text in CLOSING.values() and open_:
                j = open_.pop()
                partner[i], partner[j] = j, i
        return partner

    def _angle_end(self, i):
        """The > that closes the template bracket at i."""
        depth = 0
        for j in range(i, min(i + 200, len(self.tokens))):
            if self.text(j) == "<" and not (j != i and self.spaced(j)):
                depth += 1
            elif self.text(j) in (">", ">>"):
                depth -= len(self.text(j))
                if depth <= 0:
                    return j
            elif self.text(j) in (";", "{"):
                break
        return i

    def _mark(self, first, last):
        for i in range(first, last + 1):
            self.alone[i] = True

    def _statement_end(self, i):
        while i < len(self.tokens) and self.text(i) != ";":
            i = self.partner.get(i, i) if self.text(i) in CLOSING else i
            i += 1
        return min(i, len(self.tokens) - 1)

    def _leave_alone(self):
        for i, t in enumerate(self.tokens):
            after = self.text(i + 1)
            if t.text in UNTIMED and after == "(":
                self._mark(i, self.partner[i + 1])
            elif t.text == "if" and after == "constexpr":
                self._mark(i, self.partner[i + 2])
            elif t.text in ("template",) and after == "<":
                self._mark(i, self._angle_end(i + 1))
            elif t.text == "<" and not self.spaced(i) and self.kind(i - 1) == "name":
                self._mark(i, self._angle_end(i))
            elif t.text == "[" and after == "[":
                self._mark(i, self.partner[i])
            elif t.text == "case":
                j = i
                while self.text(j) != ":":
                    j += 1
                self._mark(i, j)
            elif t.text in ("using", "requires", "concept", "typedef"):
                self._mark(i, self._statement_end(i))
            elif t.text == "enum":
                self._mark(i, self._statement_end(i))
            elif t.text == "constexpr" and self._is_constant(i):
                self._mark(i, self._statement_end(i))
            elif t.text == "operator":
                self._mark(i, i + 1)
            elif t.text == "=" and after in ("0", "default", "delete") and self.text(i + 2) == ";" \
                    and self.text(i - 1) in (")", "const", "noexcept", "override"):
                self._mark(i, i + 2)

    def _is_constant(self, i):
        """Whether the constexpr at i begins a variable and not a function."""
        for j in range(i + 1, len(self.tokens)):
            if self.text(j) in ("=", "{", ";"):
                return True
            if self.text(j) == "(":
                return False
        return False

    # -- finding

    def _site(self, i, what, edits):
        """A site at token i with as many mutants as there are words in `what`, and edits (start, end, rank, text)."""
        at = self.tokens[i].start
        line = bisect.bisect_right(self.lines, at)
        column = at - (self.lines[line - 1] if line else 0) + 1
        for word in what:
            self.mutants.append((line + 1, column, word, self.sites))
        for start, end, rank, text in edits:
            self.edits.append((start, end, rank, text, self.sites))
        self.sites += 1

    def find(self):
        for i, t in enumerate(self.tokens):
            if self.alone[i]:
                continue
            if t.kind == "number":
                self._literal(i)
            elif t.kind == "name":
                self._name(i)
                self._statement(i)
            elif t.text in ("&&", "||") and self.spaced(i) and self.text(i + 1) not in ("{", ";"):
                self._logic(i)
            elif t.text in INFIX and self.spaced(i):
                self._infix(i)
            elif t.text == "?":
                self._choice(i)
            elif t.text in ("!", "-", "++", "--") and not self._is_operand_end(i - 1):
                self._prefix(i)
        return self

    def _is_operand_end(self, i):
        return (self.kind(i) in ("number", "text") or self.text(i) in (")", "]", "}") or
                (self.kind(i) == "name" and self.text(i) not in KEYWORDS))

    def _replace(self, i, text, what):
        t = self.tokens[i]
        self._site(i, what, [(t.start, t.end, 0, text)])

    def _literal(self, i):
        t = self.tokens[i]
        digits = t.text.replace("'", "")
        is_float = not digits.startswith("0x") and any(c in digits for c in ".eE") or "p" in digits
        if is_float:
            what = [f"{t.text} -> its double", f"{t.text} -> its half"]
        elif digits.rstrip("uU") == "0":
            self._replace(i, "::mutant::zero<{N}>(" + t.text + ")", ["0 -> 1"])
            return
        else:
            what = [f"{t.text} -> +1", f"{t.text} -> -1"]
        self._replace(i, "::mutant::number<{N}>(" + t.text + ")", what)

    def _name(self, i):
        t = self.tokens[i]
        if t.text in ("true", "false"):
            self._replace(i, "::mutant::flipped<{N}>(" + t.text + ")", [f"{t.text} -> the other"])
        elif t.text in ("min", "max") and self.text(i - 1) == "::" and self.text(i - 2) == "std":
            self._extreme(i)
        elif re.fullmatch(r"k[A-Z]\w*", t.text) and self.text(i + 1) not in ("(", "[", "{", "<", "::", "=", "->", "."):
            first = i
            while self.text(first - 1) == "::" and self.kind(first - 2) == "name":
                first -= 2
            if self.text(first - 1) in ("::", ".", "->", ">"):
                return
            start = self.tokens[first].start
            self._site(i, [f"{t.text} -> more", f"{t.text} -> less"],
                       [(start, t.end, 0, "::mutant::number<{N}>(" + self.source[start:t.end] + ")")])

    def _extreme(self, i):
        t = self.tokens[i]
        name = "least" if t.text == "min" else "greatest"
        start = self.tokens[i - 2].start
        if self.text(i + 1) == "(":
            self._site(i, [f"{t.text} -> the other"], [(start, t.end, 0, f"::mutant::{name}<{{N}}>")])
        elif self.text(i + 1) == "<":
            self._site(i, [f"{t.text} -> the other"],
                       [(start, self.tokens[i + 1].end, 0, f"::mutant::{name}<{{N}}, ")])

    def _infix(self, i):
        t = self.tokens[i]
        name, *others = INFIX[t.text]
        if self.text(i - 1) == "..." or self.text(i + 1) == "...":
            return
        self._replace(i, f"{t.text} ::mutant::{name}<{{N}}>{{}} {t.text}", [f"{t.text} -> {o}" for o in others])

    def _chain_before(self, i):
        """Whether the operator at i continues a chain of the same operator."""
        j = i - 1
        while j >= 0:
            s = self.text(j)
            if s in (")", "]", "}") and j in self.partner:
                j = self.partner[j] - 1
                continue
            if s == self.text(i) and self.spaced(j):
                return True
            if s in ("(", "[", "{", ",", ";", "=", "?", ":", "return", "&&", "||"):
                return False
            j -= 1
        return False

    def _logic(self, i):
        t = self.tokens[i]
        if self.text(i - 1) == "..." or self.text(i + 1) == "...":
            return
        inner, name = ("|", "True") if t.text == "&&" else ("&", "False")
        right = f"{t.text} ::mutant::{name}<{{N}}>{{}} {inner}"
        what = f"without what {t.text} stands before"
        if self._chain_before(i):
            self._replace(i, right, [what])
            return
        left = f"{inner} ::mutant::{name}<{{N1}}>{{}} "
        self._replace(i, left + right, [what, f"without what {t.text} stands after"])

    def _choice(self, i):
        """A condition of ?: that has no other mutant."""
        j = i - 1
        while j >= 0:
            s = self.text(j)
            if s in (")", "]") and j in self.partner:
                j = self.partner[j] - 1
                continue
            if s in INFIX and self.spaced(j) or s in ("!", "&&", "||"):
                return
            if s in ("(", "[", "{", ",", ";", "=", ":", "return", "?"):
                break
            j -= 1
        t = self.tokens[i]
        self._replace(i, "| ::mutant::Opposite<{N}>{} ?", ["the other choice"])

    def _prefix(self, i):
        name = {"!": "Not", "-": "Negative", "++": "Increment", "--": "Decrement"}[self.text(i)]
        what = {"!": "! left out", "-": "- left out", "++": "++ -> --", "--": "-- -> ++"}[self.text(i)]
        self._replace(i, f"::mutant::{name}<{{N}}>{{}} ->* ", [what])

    def _begins_statement(self, i):
        before = self.text(i - 1)
        if before in (";", "{", "}", "else"):
            return True
        if before != ")" or i - 1 not in self.partner:
            return False
        return self.text(self.partner[i - 1] - 1) in ("if", "for", "while")

    def _statement(self, i):
        """A call or an assignment left out; a condition without operators turned round."""
        t = self.tokens[i]
        if t.text in ("if", "while") and self.text(i + 1) == "(":
            self._bare_condition(i)
            return
        if not self._begins_statement(i):
            return
        if t.text in ("break", "continue") and self.text(i + 1) == ";":
            self._site(i, [f"{t.text} left out"], [(t.start, t.start, -1, "if (::mutant::on<{N}>()) {{}} else ")])
            return
        if t.text in KEYWORDS:
            return
        j, called = i, False
        while True:
            if self.kind(j) == "name" and self.text(j) not in KEYWORDS:
                j, called = j + 1, False
                if self.text(j) == "<" and self.alone[j]:
                    j = self._angle_end(j) + 1
            if self.text(j) in (".", "->", "::"):
                j += 1
                continue
            if self.text(j) in ("(", "["):
                called = self.text(j) == "("
                j = self.partner[j] + 1
                continue
            break
        if self.text(j) == ";" and called:
            what = "call left out"
        elif self.text(j) == "=" or (self.text(j) in INFIX and self.text(j).endswith("=")
                                     and self.text(j) not in ("<=", ">=", "==", "!=")):
            what = f"{self.text(j)} left out"
        else:
            return
        if not self._inside_function(i) or any(self.text(k) == "{" for k in range(i, self._statement_end(i))):
            return
        self._site(i, [what], [(t.start, t.start, -1, "if (::mutant::on<{N}>()) {{}} else ")])

    def _inside_function(self, i):
        """Whether the innermost braces around i are those of a function or a block, not of a class or namespace."""
        depth = 0
        for j in range(i - 1, -1, -1):
            if self.text(j) in (")", "}"):
                depth += 1
            elif self.text(j) == "(":
                if depth == 0:
                    return False
                depth -= 1
            elif self.text(j) == "{":
                if depth == 0:
                    k = j - 1
                    while k >= 0 and self.text(k) not in (";", "{", "}"):
                        if self.text(k) in (")", "else", "do"):
                            return True
                        if self.text(k) in ("struct", "class", "namespace", "enum"):
                            return False
                        k -= 1
                    return False
                depth -= 1
        return False

    def _bare_condition(self, i):
        first, last = i + 1, self.partner[i + 1]
        inside = range(first + 1, last)
        depth = 0
        for j in inside:
            s = self.text(j)
            if s == ";" or s == "=" or s in ("!", "&&", "||", "?") or (s in INFIX and self.spaced(j)):
                if depth == 0:
                    return
            depth += (s in CLOSING) - (s in CLOSING.values())
        self._site(i, ["condition turned round"],
                   [(self.tokens[first].end, self.tokens[first].end, -1, "::mutant::condition<{N}>(static_cast<bool>("),
                    (self.tokens[last].start, self.tokens[last].start, 1, "))")])

    # -- rewriting

    def rewritten(self, first_number, dropped):
        """The source with every site but those dropped, its mutants as (number, line, column, what, site), and the
        number after the last. Those dropped keep their numbers, so that no other file changes with them."""
        numbers, listed, n = {}, [], first_number
        for line, column, what, site in self.mutants:
            if site not in dropped:
                numbers.setdefault(site, n)
                listed.append((n, line, column, what, site))
            n += 1
        out, at = [], 0
        for start, end, _, text, site in sorted(self.edits, key=lambda e: (e[0], e[2])):
            if site not in numbers or start < at:
                continue
            out.append(self.source[at:start])
            number = numbers[site]
            out.append(text.replace("{{}}", "{ }").replace("{N1}", str(number + 1)).replace("{N}", str(number)))
            at = end
        out.append(self.source[at:])
        return "".join(out), listed, n
