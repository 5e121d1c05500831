"""What can be wrong with a file: bad values for every key, damaged lines, damaged bytes."""
import re

KEY_LINE = re.compile(r"^(\s*)([A-Za-z_]+)(\s*=\s*)(.+?)(\s*#[^\"]*)?$")
LONG = "x" * 1_000_000

# Values that no key takes, or only a few; {unit} is the unit that the key has.
BAD_VALUES = {
    "nan": "nan", "nan text": '"nan {unit}"', "inf": "inf", "minus inf": "-inf", "inf text": '"inf {unit}"',
    "huge": "1e308", "huge text": '"1e308 {unit}"', "minus huge": '"-1e308 {unit}"', "overflow": '"1e999 {unit}"',
    "tiny": '"1e-320 {unit}"', "decimal comma": '"1,5 {unit}"', "bare comma": "1,5", "empty": '""', "blank": '" "',
    "question": '"?"', "yes": "true", "list": "[]", "numbers": "[1, 2]", "texts": '["a", "b"]', "table": "{}",
    "nested": "{ a = { b = [1] } }", "date": "1979-05-27", "hexadecimal": "0x10", "largest": "9223372036854775807",
    "smallest": "-9223372036854775808", "beyond": "9223372036854775808", "zero": "0", "zero text": '"0 {unit}"',
    "negative": "-1", "negative text": '"-1 {unit}"', "fraction": "0.5", "two units": '"1 m/s m/s"',
    "other unit": '"3 kg"', "no such unit": '"3 furlong"', "unit alone": '"{unit}"', "percent": '"10 %"',
    "upward": '"../../../etc/passwd"', "absolute": '"/etc/passwd"', "device": '"/dev/zero"', "home": '"~"',
    "shell": '"$(touch pwned)"', "semicolon": '"; touch pwned"', "backtick": '"`touch pwned`"',
    "pipe": '"| touch pwned"', "markup": '"<script>alert(1)</script>"', "control": r'"a\u0000b"',
    "newline": r'"a\nb = 1"', "format": '"%s%n{0}"', "quote": r'"\""', "greek": '"15 µm"', "emoji": '"🏑"',
    "long": f'"{LONG}"', "long digits": "1" * 5000, "unclosed": '"1 m', "nothing": "", "rest": '"1 m" 2',
}


def unit_of(value):
    match = re.fullmatch(r'"[^" ]+ ([^" ]+)"', value)
    return match[1] if match else "m"


def key_lines(text):
    return [i for i, line in enumerate(text.splitlines()) if KEY_LINE.match(line)]


def with_value(text, line, name):
    lines = text.splitlines()
    indent, key, equals, value, _ = KEY_LINE.match(lines[line]).groups()
    lines[line] = indent + key + equals + BAD_VALUES[name].replace("{unit}", unit_of(value))
    return "\n".join(lines) + "\n"


def edited(text, line, edit):
    lines = text.splitlines()
    indent, key, equals, value, _ = KEY_LINE.match(lines[line]).groups()
    lines[line:line + 1] = edit(indent, key, equals, value)
    return "\n".join(lines) + "\n"


LINE_DAMAGE = {
    "misspelt": lambda i, k, e, v: [i + k[:-1] + "x" + e + v],
    "letters swapped": lambda i, k, e, v: [i + k[1::-1] + k[2:] + e + v] if k[:2] != k[1::-1] else [i + k + "q" + e + v],
    "capitals": lambda i, k, e, v: [i + k.upper() + e + v],
    "twice": lambda i, k, e, v: [i + k + e + v] * 2,
    "gone": lambda i, k, e, v: [],
    "dotted": lambda i, k, e, v: [i + k + ".inner" + e + v],
    "no equals": lambda i, k, e, v: [i + k + " " + v],
    "quoted key": lambda i, k, e, v: [i + f'"{k} "' + e + v],
    "own table": lambda i, k, e, v: [f"[{k}]", i + k + e + v],
}


def cut(random, data):
    return data[:random.randrange(len(data))]


def one_byte(random, data):
    place = random.randrange(len(data))
    return data[:place] + bytes([random.randrange(256)]) + data[place + 1:]


def some_bytes(random, data):
    for _ in range(random.randrange(2, 12)):
        data = one_byte(random, data)
    return data


def piece_out(random, data):
    start, length = random.randrange(len(data)), random.randrange(1, 40)
    return data[:start] + data[start + length:]


def piece_again(random, data):
    start, length, to = random.randrange(len(data)), random.randrange(1, 80), random.randrange(len(data))
    return data[:to] + data[start:start + length] + data[to:]


def lines_shuffled(random, data):
    lines = data.splitlines(keepends=True)
    a, b = random.randrange(len(lines)), random.randrange(len(lines))
    lines[a], lines[b] = lines[b], lines[a]
    return b"".join(lines)


FILE_DAMAGE = {
    "cut": cut, "one byte": one_byte, "some bytes": some_bytes, "a piece out": piece_out,
    "a piece again": piece_again, "lines exchanged": lines_shuffled,
    "empty": lambda r, d: b"", "blank": lambda r, d: b" \n\t\n", "zeros": lambda r, d: bytes(4096),
    "a zero inside": lambda r, d: d[:len(d) // 2] + b"\0" + d[len(d) // 2:],
    "byte-order mark": lambda r, d: b"\xef\xbb\xbf" + d, "lines of Windows": lambda r, d: d.replace(b"\n", b"\r\n"),
    "lines of old": lambda r, d: d.replace(b"\n", b"\r"),
    "sixteen bits": lambda r, d: d.decode("utf-8").encode("utf-16"),
    "not text": lambda r, d: bytes(r.randrange(256) for _ in range(600)),
    "a long line": lambda r, d: d + b"# " + b"y" * 1_000_000 + b"\n",
    "deep": lambda r, d: d + b"a = " + b"[" * 20_000 + b"]" * 20_000 + b"\n",
    "an archive": lambda r, d: b"PK\x03\x04" + d, "JSON": lambda r, d: b'{"schema": 1, "impact": {"speed": 15}}\n',
    "twice": lambda r, d: d + d,
}
