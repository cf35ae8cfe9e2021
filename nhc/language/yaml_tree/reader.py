"""YAML to nodes with places, from the parser's events; what this language leaves out of YAML is refused here."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import yaml

from nhc.diagnostics import Bag, Label, Source, Span
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.language.yaml_tree.places import align
from nhc.records import fresh, structure

_DEEPEST = 32  # lists and mappings inside one another; a valid spec needs four
_RETOLD = 1 << 16  # characters up to which a syntax error is told by the slower parser
# what YAML does not print: named one by one, for the compiler of expressions takes five times as long over what it does print
_UNPRINTABLE = re.compile("[\0-\x08\x0b-\x1f\x7f-\x84\x86-\x9f]|[\ud800-\udfff]|\ufffe|\uffff|\ufeff")
_BREAK = re.compile("[\x85\u2028\u2029]")
_ALIAS = "\0alias"  # stands for an alias, which is refused where it is read
_NULL = ("", "~", "null", "Null", "NULL")
EXTENDS = "extends"
_COMMAS = "write a list as `[a, b]`, and a text with commas in quotes"
_QUOTES = "put a text that holds `: `, ` #` or commas between quotes"
# what PyYAML says (a part of it), how it is said here (empty: the same), and what to do
_SYNTAX = (
    ("character '\\t' that cannot start", "", "indent with spaces: YAML takes no tabs there"),
    ("cannot start any token", "", "put the text between quotes"),
    (
        "mapping values are not allowed here",
        "",
        "put a text that contains `: ` in quotes; align each key with its neighbours",
    ),
    (
        "expected <block end>",
        "this does not continue what stands above",
        "indent the entries of one mapping or list alike, each `key: value` on a line of its own",
    ),
    ("could not find expected ':'", "a key without its `:`", "write `key: value`; what goes on is indented below its key"),
    ("expected ',' or '}'", "", "close the `{`, separate its entries by commas, and put texts with commas in quotes"),
    ("expected ',' or ']'", "", "close the `[`, separate its entries by commas, and put texts with commas in quotes"),
    ("sequence entries are not allowed", "", "begin each `- ` on its own line below its key; quote a text that begins so"),
    ("expected '<document start>'", "this does not continue what stands above", "let all keys of a spec begin in one column"),
    ("incompatible YAML document", "", "leave the line out"),
    ("node content, but found ','", "a comma with nothing before it", "leave the `,` out"),
    ("expected chomping or indentation", "", "write `abs(...)`; the lines of a long text begin below its `|`"),
)  # fmt: skip
_PRIME_ENDS = re.compile(r"(?:^|[:,\[{-])\s*'[^'\n]*'\s*$")  # a text in single quotes, up to here
_WIDE_BLANK = re.compile("(?m)^ *([\u00a0\u2000-\u200b\u202f\u3000])")
_NO_BLANK = re.compile(r"\s*(?:- )?([\w']+):[^\s/]")
_FAST: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


class Stop(Exception):
    """Reading cannot go on; its reason is in the bag."""


@structure
class _Open:
    """A list or mapping that is being read."""

    start: int
    mapping: bool
    items: list[Node] = fresh(factory=list)


def _take_events(text: str, loader: Any, bag: Bag) -> list[Any]:
    """Return the events, but stop where the nesting gets too deep: libyaml takes quadratic time there."""
    events: list[Any] = []
    depth = 0
    parsed: Iterator[Any] = yaml.parse(text, Loader=loader)
    for event in parsed:
        events.append(event)
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1
        if depth > _DEEPEST:
            at = event.start_mark.index
            help = "no part of a spec is that deep: look for a list that is never closed"
            bag.error("E0110", f"lists and mappings nested deeper than {_DEEPEST}", Span(at, at + 1), help=(help,))
            raise Stop
    return events


def _scan(source: Source, bag: Bag) -> list[Any]:
    """Return the events.

    A syntax error is told by PyYAML's own parser, so that it does not depend on libyaml; but not in a very large file,
    where that parser takes long.
    """
    loaders = tuple(dict.fromkeys((_FAST, yaml.SafeLoader)))
    last = loaders[0] if len(source.text) > _RETOLD else loaders[-1]
    for loader in loaders:
        try:
            return _take_events(source.text, loader, bag)
        except yaml.MarkedYAMLError as error:
            if loader is last:
                _report_syntax(source.text, error, bag)
                break
        except yaml.YAMLError as error:
            if loader is last:
                help = "save the file as plain UTF-8 text, and look for characters that do not show"
                bag.error("E0104", f"YAML: {str(error).splitlines()[0].lower()}", Span(0, 0), help=(help,))
                break
    raise Stop


def _report_syntax(text: str, error: yaml.MarkedYAMLError, bag: Bag) -> None:
    mark = error.problem_mark or error.context_mark
    at = mark.index if mark else 0
    problem = (error.problem or "syntax error").rstrip(".").replace("\n", " ")
    labels: tuple[Label, ...] = ()
    if error.context_mark and "could not find expected ':'" in problem:
        at = error.context_mark.index  # the key itself: what YAML names is the line below it
    elif error.context_mark and error.context and error.context_mark.index != at:
        start = error.context_mark.index
        labels = (Label(Span(start, start + 1), str(error.context)),)
    told = ((said or problem, advice) for part, said, advice in _SYNTAX if part in problem)
    problem, help = next(told, (problem, _QUOTES))
    help = _look_around(text, at, labels[0].span.start if labels else at) or help
    bag.error("E0104", f"YAML: {problem}", Span(at, at + 1), labels=labels, help=(help,))


def _look_around(text: str, at: int, start: int) -> str:
    """What to do about a slip that shows at other places than its own; nothing where none is seen.

    Args:
        text: the file.
        at: where YAML cannot go on.
        start: where it began what it cannot go on with.
    """
    if at == len(text) and text[start : start + 1] in ("'", '"'):
        return f"close the text with `{text[start]}`"
    lines = text[:at].split("\n")
    if any(line.lstrip().startswith(("//", "% ")) for line in (*lines[-2:], text[start:].split("\n")[0])):
        return "a comment begins with `#`"
    if _PRIME_ENDS.search(lines[-1]):
        return "a prime ends a text between `'`: leave the quotes out, or put it between `\"`"
    for line in (text[text.rfind("\n", 0, start) + 1 :].split("\n")[0], *lines[-2:-1]):
        key = _NO_BLANK.match(line)
        if key:
            return f"put a blank after `{key[1]}:`"
    return ""


def _check_characters(source: Source, bag: Bag) -> None:
    found = _UNPRINTABLE.search(source.text) or _BREAK.search(source.text)
    if found:
        code = f"U+{ord(found.group()):04X}"
        help = "end the line as all others" if _BREAK.match(found.group()) else "remove it"
        bag.error("E0102", f"the character {code} is not allowed in a spec", Span(*found.span()), help=(help,))
        raise Stop
    blank = _WIDE_BLANK.search(source.text)
    if blank:
        message = f"YAML: a line is indented with U+{ord(blank[1]):04X}, which is no blank"
        bag.error("E0104", message, Span(*blank.span(1)), help=("indent with plain blanks",))
        raise Stop


def read_nodes(source: Source, bag: Bag) -> Node | None:
    """Return the one document of a source; what is wrong goes into ``bag``; None: nothing could be read."""
    try:
        _check_characters(source, bag)
        return _build(source, _scan(source, bag), bag)
    except Stop:
        return None


def _build(source: Source, events: list[Any], bag: Bag) -> Node | None:
    stack: list[_Open] = []
    nulls: list[tuple[Text, Node]] = []
    root: Node | None = None
    documents = 0
    for event in events:
        node: Node | None = None
        start, end = event.start_mark.index, event.end_mark.index
        match event:
            case yaml.DocumentStartEvent():
                documents += 1
                if documents > 1:
                    _refuse_document(event, bag)
                    break
            case yaml.MappingStartEvent() | yaml.SequenceStartEvent():
                _check_properties(source, event, bag)
                stack.append(_Open(start, isinstance(event, yaml.MappingStartEvent)))
            case yaml.MappingEndEvent() | yaml.SequenceEndEvent():
                node = _close(source, stack.pop(), end, nulls, bag)
            case yaml.ScalarEvent():
                _check_properties(source, event, bag)
                node = _text(source, event, bag)
            case yaml.AliasEvent():
                span = Span(start, end)
                bag.error("E0106", f"alias `*{event.anchor}`", span, help=("write the value out",))
                node = Text(_ALIAS, span, plain=False)
        if node is not None and stack:
            stack[-1].items.append(node)
        elif node is not None:
            root = node
    if not (isinstance(root, Table) and root.get(EXTENDS) is not None):
        for key, value in nulls:
            _check_filled(source, value, key.span, f"value of `{key.value}`", bag)
    return root


def _refuse_document(event: Any, bag: Bag) -> None:
    at = event.start_mark.index
    bag.error("E0108", "a second document in one file", Span(at, at + 3), help=("put each spec into its own file",))


def _check_properties(source: Source, event: Any, bag: Bag) -> None:
    start = event.start_mark.index
    if event.anchor is not None:
        at = source.text.find("&", start)
        span = Span(at, at + 1 + len(event.anchor)) if at >= 0 else Span(start, start + 1)
        bag.error("E0106", f"anchor `&{event.anchor}`", span, help=("write the value out where it is needed",))
    if event.tag is not None:
        at = source.text.find("!", start)
        span = Span(at, at + 1) if at >= 0 else Span(start, start + 1)
        bag.error("E0107", "a YAML tag", span, help=("remove it: the language knows the type of every value",))


def _text(source: Source, event: Any, bag: Bag) -> Text:
    start, end = event.start_mark.index, event.end_mark.index
    hidden = _UNPRINTABLE.search(event.value)
    if hidden:
        message = f"the escape of the character U+{ord(hidden.group()):04X} is not allowed in a spec"
        bag.error("E0102", message, Span(start, end), help=("remove it",))
    style = event.style or ""
    if event.anchor is not None or event.tag is not None:
        return Text(event.value, Span(start, end), not style)
    if style in ("|", ">"):
        while end > start + 1 and source.text[end - 1] in " \n":
            end -= 1
    offsets = align(source.text, start, end, event.value, style)
    return Text(event.value, Span(start, end), plain=not style, offsets=offsets)


def _close(source: Source, opened: _Open, end: int, nulls: list[tuple[Text, Node]], bag: Bag) -> Node:
    """The list or mapping; entries that are ``null`` in so many words go to ``nulls``: they may leave out what a base has."""
    while end > opened.start + 1 and source.text[end - 1] in " \t\n":
        end -= 1
    span = Span(opened.start, end)
    if not opened.mapping:
        for item in opened.items:
            _check_filled(source, item, item.span, "entry of a list", bag)
        return Items(tuple(opened.items), span)
    entries: list[tuple[Text, Node]] = []
    seen: dict[str, Text] = {}
    pairs = list(zip(opened.items[::2], opened.items[1::2], strict=True))
    filled = {key.value: value for key, value in reversed(pairs) if isinstance(key, Text) and not is_empty(value)}
    for key, value in pairs:
        if not isinstance(key, Text):
            place = Span(key.span.start, key.span.start + 1)
            bag.error("E0301", "a key must be a text", place, help=("write `name: value`",))
            continue
        if key.value == _ALIAS:
            continue
        if key.value in seen:
            first = Label(seen[key.value].span, "first here")
            bag.error("E0105", f"duplicate key `{key.value}`", key.span, labels=(first,), help=("keep one of them",))
            continue
        seen[key.value] = key
        kept = filled.get(key.value, value)  # of a key that is given twice, once without a value, the one with it
        if is_null(kept) and key.value != EXTENDS:
            nulls.append((key, kept))
        else:
            _check_filled(source, kept, key.span, f"value of `{key.value}`", bag)
        entries.append((key, kept))
    return Table(tuple(entries), span)


def is_empty(node: Node) -> bool:
    """Say whether a node is a value that is not there (nothing, ``~``, ``null``, or a blank text)."""
    if not isinstance(node, Text):
        return False
    return not node.value.strip() or node.value == _ALIAS or (node.plain and node.value in _NULL)


def is_null(node: Node) -> bool:
    """Say whether a node is ``null`` or ``~`` in so many words."""
    return isinstance(node, Text) and node.plain and node.value != "" and node.value in _NULL


def _check_filled(source: Source, node: Node, place: Span, what: str, bag: Bag) -> None:
    if is_empty(node) and isinstance(node, Text) and node.value != _ALIAS:
        span = node.span if node.span.end > node.span.start else place
        after_colon = source.text[place.end :].lstrip(" ").startswith(":")
        help = "give it a value, or remove it"
        if span == place and not after_colon and not is_null(node):
            pair = re.fullmatch(r"([\w']+?)\s*[=:]\s*(\S.*)", source.text[place.start : place.end])
            help = f"commas separate entries here: {_COMMAS}"
            if pair:
                help = f"write `{pair[1]}: {pair[2]}`"
            elif (name := source.text[place.start : place.end]).isidentifier():
                help = f"write `{name}: ...` with its value, or `{name}: {{}}` for a parameter without one; {_COMMAS}"
            whole = re.search(r":\s*([-+]?\d+),$", source.text[: place.start])
            if whole and re.fullmatch(r"\d+", source.text[place.start : place.end]):
                help = f"decimal numbers are written with `.`: `{whole[1]}.{source.text[place.start : place.end]}`"
        bag.error("E0109", f"empty {what}", span, help=(help,))
