"""Is every file below a folder whole? By what each kind of file says of itself."""
import contextlib
import csv
import json
import sqlite3
import tomllib
import xml.etree.ElementTree


def whole_csv(data):
    text = data.decode("utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    rows = lines and [len(row) for row in csv.reader(lines, delimiter=";" if ";" in lines[0] else ",")]
    return text.endswith("\n") and len(set(rows)) == 1


def whole_sqlite(path):
    with contextlib.closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as store:
        return store.execute("pragma integrity_check").fetchone() == ("ok",)


def is_whole(path):
    data = path.read_bytes()
    try:
        if path.suffix == ".json":
            json.loads(data)
        elif path.suffix == ".toml":
            return len(tomllib.loads(data.decode("utf-8"))) > 0 and data.endswith(b"\n")
        elif path.suffix == ".csv":
            return whole_csv(data)
        elif path.suffix in (".vtu", ".pvd", ".feb"):
            xml.etree.ElementTree.fromstring(data)
        elif path.suffix == ".html":
            return data.rstrip().endswith(b"</html>")
        elif path.suffix == ".sqlite":
            return whole_sqlite(path)
        elif path.suffix == ".msh":
            return data.rstrip().endswith(b"$EndElements")
        else:
            return len(data) > 0
    except (ValueError, UnicodeDecodeError, sqlite3.DatabaseError, xml.etree.ElementTree.ParseError):
        return False
    return True


def torn_files(folder):
    """Files with a final name that are not whole. Temporary names say that they are none; a journal of SQLite
    and an empty store are what SQLite itself takes back when the store is opened next."""
    def is_final(path):
        return path.is_file() and ".partial-" not in path.name and not path.name.startswith(".writable-") and \
            not path.name.endswith(("-journal", "-wal", "-shm")) and not (path.suffix == ".sqlite" and
                                                                         path.stat().st_size == 0)
    return sorted(str(path) for path in folder.rglob("*") if is_final(path) and not is_whole(path))
