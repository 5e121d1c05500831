"""Values and ranges of files, read by rules of their own: what the program accepts is held against them."""
import math
import re

# Factors to SI of what the files' units are made of.
SYMBOLS = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "cm": 1e-2, "km": 1e3, "s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9,
           "min": 60.0, "h": 3600.0, "kg": 1.0, "g": 1e-3, "mg": 1e-6, "N": 1.0, "kN": 1e3, "MN": 1e6, "mN": 1e-3,
           "Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "J": 1.0, "mJ": 1e-3, "kJ": 1e3, "Hz": 1.0, "kHz": 1e3,
           "MHz": 1e6, "rad": 1.0, "%": 1e-2, "V": 1.0, "mV": 1e-3, "uV": 1e-6}
NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"


def unit_factor(unit):
    """The factor to SI; None where a symbol is not known here."""
    factor, sign = 1.0, 1.0
    for part in re.split(r"([./])", unit):
        if part in "./":
            sign = -1.0 if part == "/" else sign
            continue
        symbol, _, power = part.partition("^")
        if symbol not in SYMBOLS:
            return None
        try:
            factor *= SYMBOLS[symbol] ** (sign * float(power or 1))
        except ValueError:
            return None
    return factor


def in_si(value):
    """A number or a text "number unit" in SI; None where it is neither."""
    if isinstance(value, bool):
        return None
    if isinstance(value, (int, float)):
        return float(value)
    match = re.fullmatch(rf"\s*({NUMBER})\s+(\S+)\s*", value) if isinstance(value, str) else None
    factor = unit_factor(match[2]) if match else None
    return None if factor is None else float(match[1]) * factor


def within(value, allowed):
    """Does a value lie in a range such as "0 < value <= 1000 m/s"? None where that cannot be told."""
    match = re.fullmatch(rf"(?:({NUMBER}) (<=?) )?value(?: (<=?|>=?) ({NUMBER}))?(?: (\S+))?", allowed or "")
    number = in_si(value)
    if not match or number is None:
        return None
    factor = unit_factor(match[5]) if match[5] else 1.0
    if factor is None or not math.isfinite(number):
        return None if factor is None else False
    rules = {"<": lambda a, b: a < b, "<=": lambda a, b: a <= b, ">": lambda a, b: a > b, ">=": lambda a, b: a >= b}
    slack = 1e-12  # the two conversions round differently
    for low, rule, high in ((match[1], match[2], None), (None, match[3], match[4])):
        if low is not None and not rules[rule](float(low) * factor * (1 - slack), number):
            return False
        if high is not None and not rules[rule](number * (1 - slack), float(high) * factor):
            return False
    return True


def out_of_range(schema, value, path=""):
    """Keys whose value is outside the range that the schema states for them."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from out_of_range(schema.get("properties", {}).get(key, {}), inner, f"{path}.{key}")
    elif isinstance(value, list):
        for inner in value:
            yield from out_of_range(schema.get("items", {}), inner, path + "[]")
    elif within(value, schema.get("x-allowed")) is False:
        yield path.lstrip(".")


def different(given, effective, path=""):
    """Keys of a file whose value is another, or is gone, in the effective configuration."""
    for key, value in given.items():
        place = f"{path}.{key}".lstrip(".")
        other = effective.get(key)
        if isinstance(value, dict):
            if isinstance(other, dict):
                yield from different(value, other, place)
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            if isinstance(other, list) and len(other) == len(value):
                for one, another in zip(value, other):
                    yield from different(one, another, place)
            elif isinstance(other, list):
                yield place
        elif other is not None and in_si(value) is not None and in_si(other) is not None:
            if not math.isclose(in_si(value), in_si(other), rel_tol=1e-5, abs_tol=1e-300):
                yield place
        elif other is not None and type(value) is type(other) and in_si(value) is None and value != other:
            yield place
