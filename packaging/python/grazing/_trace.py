"""Functions become text: they are called once, with symbols that record the operations on them."""

from __future__ import annotations

import inspect
from typing import Any, Callable

#: Functions whose names in expressions differ from those in numpy.
_OTHER_NAMES = {"arctan": "atan", "log": "ln", "absolute": "abs"}
_OPERATORS = {"add": "+", "subtract": "-", "multiply": "*", "divide": "/", "true_divide": "/", "power": "^", "float_power": "^"}
#: Precedence of operators; names, numbers and functions have the highest.
_LEVELS = {"+": 1, "-": 1, "*": 2, "/": 2, "^": 3}
_ATOM = 4
_WAY_OUT = 'write it as text, such as "-x - 1 + A*cos(omega*t)"'


class Symbol:
    """A value represented by its expression: the text, and the precedence of its outermost operator."""

    __slots__ = ("level", "text")

    def __init__(self, text: str, level: int = _ATOM) -> None:
        self.text, self.level = text, level

    def __neg__(self) -> Symbol:
        return Symbol(f"-{_part(self, _ATOM, True)}", _LEVELS["*"])

    def __pos__(self) -> Symbol:
        return self

    def __abs__(self) -> Symbol:
        return Symbol(f"abs({self.text})")

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Symbol:
        if method != "__call__" or options:
            raise TypeError(f"numpy.{ufunc.__name__}.{method} of a symbol: {_WAY_OUT}")
        if ufunc.__name__ in _OPERATORS:
            return _joined(_OPERATORS[ufunc.__name__], *inputs)
        if ufunc.__name__ in ("negative", "positive"):
            return -inputs[0] if ufunc.__name__ == "negative" else inputs[0]
        if ufunc.__name__ == "square":
            return inputs[0] ** 2
        name = _OTHER_NAMES.get(ufunc.__name__, ufunc.__name__)
        return Symbol(f"{name}({', '.join(_text(value) for value in inputs)})")

    def __float__(self) -> float:
        raise TypeError(f"a function of math, or float(), needs a number, and got the symbol {self.text}: use numpy's function, or {_WAY_OUT}")

    def __bool__(self) -> bool:
        raise TypeError(f"a condition on {self.text} cannot become an expression: {_WAY_OUT}")

    def _compared(self, other: Any) -> Any:
        raise TypeError(f"a comparison with {self.text} cannot become an expression: {_WAY_OUT}")

    __eq__ = __lt__ = __le__ = __gt__ = __ge__ = __ne__ = _compared  # type: ignore[assignment]
    __hash__ = None  # type: ignore[assignment]


def _text(value: Any) -> str:
    return value.text if isinstance(value, Symbol) else repr(float(value)).removesuffix(".0")


def _part(value: Any, least: int, right: bool) -> str:
    """An operand, in parentheses where precedence requires them, so that the order of evaluation is Python's."""
    text = _text(value)
    level = value.level if isinstance(value, Symbol) else _LEVELS["*"] if text.startswith("-") else _ATOM
    return f"({text})" if level < least or (right and text.startswith("-")) else text


def _joined(operator: str, left: Any, right: Any) -> Symbol:
    level = _LEVELS[operator]
    return Symbol(f"{_part(left, level + (operator == '^'), False)} {operator} {_part(right, level + 1, True)}", level)


for _method, _operator in {"add": "+", "sub": "-", "mul": "*", "truediv": "/", "pow": "^"}.items():
    setattr(Symbol, f"__{_method}__", lambda self, other, operator=_operator: _joined(operator, self, other))
    setattr(Symbol, f"__r{_method}__", lambda self, other, operator=_operator: _joined(operator, other, self))


def expression(value: Any, key: str) -> str:
    """The text of an expression, from text, a number or a function."""
    if isinstance(value, str):
        return value
    if not callable(value):
        return _text(value)
    return _traced(value, key)


def _traced(function: Callable[..., Any], key: str) -> str:
    try:
        names = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        raise TypeError(f"{key}: the arguments of {function!r} cannot be inspected: {_WAY_OUT}") from None
    if any(one.kind in (one.VAR_POSITIONAL, one.VAR_KEYWORD) for one in names):
        raise TypeError(f"{key}: a function must name its arguments, x, v, t, parameters and constants: {_WAY_OUT}")
    try:
        # Arguments with a default value are numbers.
        return _text(function(**{one.name: Symbol(one.name) for one in names if one.default is one.empty}))
    except TypeError as error:
        raise TypeError(f"{key}: {error}") from error
    except Exception as error:
        raise TypeError(f"{key}: calling the function with symbols failed ({type(error).__name__}: {error}): {_WAY_OUT}") from error
