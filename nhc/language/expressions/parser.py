"""Expressions to syntax trees, by operator precedence on an explicit stack.

equation   = expression "=" expression
expression = term { ("+" | "-" | "*" | "/" | "^") term }     + -  <  * /  <  unary -  <  ^ (to the right)
term       = { "-" } primary { "'" }
primary    = number | name | "(" expression ")" | function "(" expression { "," expression } ")"
"""

from __future__ import annotations

from fractions import Fraction

from nhc.diagnostics import Bag, Span, nearest
from nhc.language.expressions.loanwords import ACCELERATIONS, COMMENT, CONDITIONS, meant_call, meant_power, within
from nhc.language.expressions.names import DOT, FUNCTIONS, TIME
from nhc.language.expressions.numbers import DOUBLES, exact
from nhc.language.expressions.syntax import Binary, Call, Name, Negate, Number, Prime, Syntax
from nhc.language.expressions.tokens import LONGEST, ExpressionError, Locate, Token, tokenise
from nhc.records import fresh, structure

DEEPEST = 200  # parentheses, calls, unary minus and right-hand powers inside one another
_LEVEL = {"+": 10, "-": 10, "*": 20, "/": 20, "^": 40}
_NEGATE = 30
_UNCLOSED = "add `)`"
_ARITY = {**FUNCTIONS, DOT: (1, 1)}


@structure
class _Frame:
    """A pending operator, or an open parenthesis (``kind`` "(" ; ``function`` is empty for a plain one)."""

    kind: str
    level: int
    token: Token
    function: str = ""
    arguments: list[tuple[Syntax, int, int]] = fresh(factory=list)


class _Parser:
    """Operands are kept with their offsets in the text, parentheses included, so that spans come out whole."""

    def __init__(self, text: str, locate: Locate, equation: bool) -> None:
        self.text = text
        self.locate = locate
        self.equation = equation
        self.operands: list[tuple[Syntax, int, int]] = []
        self.frames: list[_Frame] = []
        self.depth = 0
        self.sides: list[Syntax] = []
        self.equals: Token | None = None

    def run(self) -> list[Syntax]:
        if len(self.text) > LONGEST:
            raise ExpressionError(
                "E0205",
                f"expression longer than {LONGEST} characters",
                self.locate(0, 1),
                "name parts of it under `define`",
            )
        wants_operand = True
        previous: Token | None = None
        for token in tokenise(self.text, self.locate):
            wants_operand = self._operand(token) if wants_operand else self._operator(token, previous)
            previous = token
        return self.sides

    # --- where a term is expected ---

    def _operand(self, token: Token) -> bool:
        match token.kind:
            case "number":
                self._push(Number(self._value(token), self._span(token)), token.start, token.end)
                return False
            case "name":
                self._push(Name(token.text, self._span(token)), token.start, token.end)
                return False
            case "-":
                self._open(_Frame("negate", _NEGATE, token))
                return True
            case "(":
                self._open(_Frame("(", 0, token))
                return True
            case _:
                raise self._unexpected(token)

    def _value(self, token: Token) -> Fraction:
        try:
            value = exact(token.text)
            return value if value is not None else Fraction(0)
        except ValueError as error:
            shown = token.text if len(token.text) <= 24 else token.text[:20] + "..."
            raise ExpressionError("E0210", f"the number `{shown}` {error}", self._span(token), DOUBLES) from None

    def _unexpected(self, token: Token) -> ExpressionError:
        if token.kind == "end":
            at = self.locate(max(0, token.start - 1), token.end)
            help = "write a number, a name or `(`, or leave the last operator out"
            return ExpressionError("E0202", "the expression ends where a term is expected", at, help)
        if token.kind == ")" and self.frames and self.frames[-1].kind == "(" and self.frames[-1].function:
            name = self.frames[-1].function
            return ExpressionError(
                "E0206", f"`{name}` needs an argument", self._span(token), f"write `{_sample(name)}`"
            )
        if token.kind == "=" and self.equals is not None and self.equals.end == token.start:
            return ExpressionError("E0208", "`==` in place of `=`", self._span(token), "write a single `=`")
        advice = {"+": "leave the `+` out", "prime": "the prime follows a name or a parenthesis: `x'`"}
        help = advice.get(token.kind, f"leave the `{token.text}` out, or write the operand before it")
        if token.kind == "/" and self.text[: token.start].endswith("/"):
            help = COMMENT
        return ExpressionError(
            "E0202", f"expected a number, a name or `(`, found `{token.text}`", self._span(token), help
        )

    # --- where an operator is expected ---

    def _operator(self, token: Token, previous: Token | None) -> bool:
        match token.kind:
            case "+" | "-" | "*" | "/" | "^":
                level = _LEVEL[token.kind]
                self._reduce(level if token.kind != "^" else level + 1)
                frame = _Frame(token.kind, level, token)
                if token.kind == "^":
                    self._open(frame)
                else:
                    self.frames.append(frame)
                return True
            case "prime":
                self._prime(token, previous)
                return False
            case ")":
                self._close(token)
                return False
            case ",":
                self._comma(token)
                return True
            case "=":
                self._equal(token)
                return True
            case "end":
                self._end(token)
                return False
            case _:
                return self._juxtaposed(token, previous)

    def _juxtaposed(self, token: Token, previous: Token | None) -> bool:
        if token.kind == "(" and previous is not None and previous.kind == "name":
            self.operands.pop()
            self._check_function(previous)
            self._open(_Frame("(", 0, previous, previous.text))
            return True
        if token.text in ("if", "else", "and", "or", "not"):
            raise ExpressionError("E0203", f"expected an operator, found `{token.text}`", self._span(token), CONDITIONS)
        node, start, end = self.operands[-1]
        left = self.text[start:end] if isinstance(node, Number | Name) else self.text[start:end].strip()
        left = left if len(left) <= 24 else "..."
        right = "(...)" if token.kind == "(" else token.text
        raise ExpressionError(
            "E0203",
            f"expected an operator before `{token.text}`; multiplication is never implicit",
            self.locate(start, token.end) if previous and previous.end == token.start else self._span(token),
            self._advise(token, node, right) or f"write `{left}*{right}`",
        )

    def _advise(self, token: Token, node: Syntax, right: str) -> str:
        """What was meant where a function stands without its parentheses, or a number as programming languages write it."""
        argument = within(self.text[token.start :]) if token.kind == "(" else right
        goes_on = token.kind != "(" and self.text[token.end :].lstrip()[:1] in tuple("*/^")
        inner = node.operand if isinstance(node, Prime) else node
        if isinstance(inner, Name) and inner.name in _ARITY:
            call = f"{inner.name}({'...' if goes_on else argument})"
            return f"write `{call if inner is node else f'{DOT}({call})'}`"
        if token.text == DOT and isinstance(node, Name):
            return f"write `{node.name}'`"
        start, end = self.operands[-1][1:]
        if argument == TIME and isinstance(inner, Name):
            return f"write `{self.text[start:end]}`: nhc knows which names change in time"
        if isinstance(node, Name) and node.name == "near" and token.kind == "number":
            return f"write `{{near: {token.text}}}`"
        if not isinstance(node, Number):
            return ""
        if token.kind == "number":
            return f"write the digits of a number without blanks: `{self.text[start:end]}{token.text}`"
        pending = [frame.kind for frame in self.frames[-2:]]
        base = self.operands[-2][0] if pending[-1:] == ["^"] or pending == ["^", "negate"] else None
        if isinstance(base, Name) and base.name in _ARITY:
            return meant_power(base.name, argument, "-" * (pending[-1] == "negate") + self.text[start:end])
        if token.text in ("deg", "degree", "degrees"):
            return f"angles are in radians: write `{self.text[start:end]}*pi/180`"
        if token.text in ("e", "E"):
            return "write the exponent behind the `e`, as in `1e3`"
        if not node.value and token.text[:1] in ("x", "b", "o") and len(token.text) > 1:
            return "write numbers in decimals"
        return ""

    def _check_function(self, name: Token) -> None:
        if name.text in _ARITY:
            return
        meant = nearest(name.text, _ARITY)
        help = meant_call(name.text, self.text[name.end :].lstrip())
        if not help:
            help = f"write `{name.text}*(...)` for a product; `nhc explain E0206` lists the functions"
            help = f"did you mean `{meant}`? {help}" if meant and len(name.text) != 1 else help
        raise ExpressionError("E0206", f"`{name.text}` is not a function", self._span(name), help)

    def _prime(self, token: Token, previous: Token | None) -> None:
        node, start, _ = self.operands[-1]
        if previous is not None and previous.kind == "prime" and isinstance(node, Prime):
            raise ExpressionError(
                "E0207",
                "second time derivative",
                self.locate(start, token.end),
                ACCELERATIONS,
            )
        self.operands[-1] = (Prime(node, self.locate(start, token.end)), start, token.end)

    def _close(self, token: Token) -> None:
        self._reduce(0)
        if not self.frames:
            raise ExpressionError(
                "E0204", "`)` without its `(`", self._span(token), "leave the `)` out, or open it before"
            )
        frame = self.frames.pop()
        self.depth -= 1
        node = self.operands.pop()[0]
        if not frame.function:
            self._push(node, frame.token.start, token.end)
            return
        arguments = (*(argument for argument, _, _ in frame.arguments), node)
        span = self.locate(frame.token.start, token.end)
        least, most = _ARITY[frame.function]
        if not least <= len(arguments) <= most:
            count = f"{least} argument{'s' if least > 1 else ''}"
            help = f"write `{_sample(frame.function)}`"
            raise ExpressionError("E0206", f"`{frame.function}` takes {count}, found {len(arguments)}", span, help)
        call: Syntax = Prime(node, span) if frame.function == DOT else Call(frame.function, arguments, span)
        self._push(call, frame.token.start, token.end)

    def _comma(self, token: Token) -> None:
        self._reduce(0)
        if not self.frames or not self.frames[-1].function:
            raise ExpressionError(
                "E0202",
                "`,` outside of a function's arguments",
                self._span(token),
                self._advise_comma(token),
            )
        self.frames[-1].arguments.append(self.operands.pop())

    def _advise_comma(self, token: Token) -> str:
        around = self.text[max(0, token.start - 1) : token.start], self.text[token.end : token.end + 1]
        if all(x.isdigit() for x in around):
            return "decimal numbers are written with `.`"
        if not self.text[token.end :].strip():
            return "leave the `,` out"
        return "write one equation per entry of the list" if self.equation else "write one expression here"

    def _equal(self, token: Token) -> None:
        self._reduce(0)
        if self.frames:
            help = "close the parenthesis before the `=`"
            raise ExpressionError("E0208", "`=` inside of a parenthesis", self._span(token), help)
        if not self.equation:
            help = "only constraints and `holonomic` hold equations"
            if isinstance(self.operands[-1][0], Name):
                help = f"leave `{self.text[: token.end].strip()}` out: {help}"
            raise ExpressionError("E0208", "`=` in an expression", self._span(token), help)
        if self.equals is not None:
            raise ExpressionError("E0208", "more than one `=`", self._span(token), "write one equation per entry")
        self.equals = token
        self._finish()

    def _end(self, token: Token) -> None:
        self._reduce(0)
        if self.frames:
            opening = self.frames[-1].token
            raise ExpressionError("E0204", "`(` is never closed", self.locate(opening.start, opening.end), _UNCLOSED)
        if self.equation and self.equals is None:
            whole = self.locate(0, len(self.text))
            raise ExpressionError("E0208", "expected an equation, found no `=`", whole, "write `... = 0`")
        self._finish()

    # --- the stacks ---

    def _finish(self) -> None:
        self.sides.append(self.operands.pop()[0])

    def _push(self, node: Syntax, start: int, end: int) -> None:
        self.operands.append((node, start, end))

    def _open(self, frame: _Frame) -> None:
        self.depth += 1
        if self.depth > DEEPEST:
            raise ExpressionError(
                "E0205",
                f"expression nested deeper than {DEEPEST}",
                self._span(frame.token),
                "name parts of it under `define`",
            )
        self.frames.append(frame)

    def _reduce(self, level: int) -> None:
        """Apply the pending operators that bind at least as tightly as ``level``, up to an open parenthesis."""
        while self.frames and self.frames[-1].kind != "(" and self.frames[-1].level >= level:
            frame = self.frames.pop()
            right, _, end = self.operands.pop()
            if frame.kind == "negate":
                self.depth -= 1
                self._push(Negate(right, self.locate(frame.token.start, end)), frame.token.start, end)
                continue
            if frame.kind == "^":
                self.depth -= 1
            left, start, _ = self.operands.pop()
            node = Binary(frame.kind, left, right, self.locate(start, end), self._span(frame.token))
            self._push(node, start, end)

    def _span(self, token: Token) -> Span:
        return self.locate(token.start, token.end)


def _run(text: str, locate: Locate, bag: Bag, equation: bool) -> list[Syntax]:
    try:
        return _Parser(text, locate, equation).run()
    except ExpressionError as error:
        after = bag.source.text[locate(0, len(text)).end :].lstrip(" ")[:1]
        cut = error.help == _UNCLOSED and after == ","  # which nothing but a list or a mapping in brackets has there
        if cut and any(found.code == "E0109" for found in bag.diagnostics):
            return []  # its other half, which has no value, was told
        help = "a comma ends a text inside of `{}` and `[]`: put the whole text in quotes" if cut else error.help
        bag.error(error.code, error.message, error.span, help=(help,))
        return []


def parse_expression(text: str, locate: Locate, bag: Bag) -> Syntax | None:
    """Parse one expression; a mistake goes into ``bag`` and gives None. Names are not looked up yet."""
    sides = _run(text, locate, bag, equation=False)
    return sides[0] if sides else None


def parse_equation(text: str, locate: Locate, bag: Bag) -> tuple[Syntax, Syntax] | None:
    """Parse ``left = right``; a mistake goes into ``bag`` and gives None."""
    sides = _run(text, locate, bag, equation=True)
    return (sides[0], sides[1]) if len(sides) == 2 else None


def _sample(function: str) -> str:
    """A call of a function with as many arguments as it takes."""
    return f"{function}({'y, x' if function == 'atan2' else ', '.join('xyz'[: _ARITY[function][0]])})"
