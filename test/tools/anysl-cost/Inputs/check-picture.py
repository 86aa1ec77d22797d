"""Checks that a browser's picture (PNG) of a report shows the plot, or the heat map.

usage: check-picture.py PICTURE light|dark|heat
"""
import struct
import sys
import zlib

COLORS = {"light": ["2563b8", "1d8a4e", "c47f00", "c7362f"], "dark": ["6aa5f5", "56c987", "f0b541", "f4766d"]}
BACK = {"light": "ffffff", "dark": "12161c"}


def read_png(path):
    """Width, height and rows of bytes; 8 bits a channel, not interlaced, as browsers write."""
    data = open(path, "rb").read()
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        chunk = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", chunk[:10])
        elif kind == b"IDAT":
            packed += chunk
        at += length + 12
    assert bits == 8 and color in (2, 6)
    step = 3 if color == 2 else 4
    raw, rows, above = zlib.decompress(packed), [], bytearray(width * step)
    for y in range(height):
        filter_type, row = raw[y * (width * step + 1)], bytearray(raw[y * (width * step + 1) + 1:(y + 1) * (width * step + 1)])
        for i in range(len(row)):
            a = row[i - step] if i >= step else 0
            b, c = above[i], above[i - step] if i >= step else 0
            if filter_type == 1:
                row[i] = (row[i] + a) & 255
            elif filter_type == 2:
                row[i] = (row[i] + b) & 255
            elif filter_type == 3:
                row[i] = (row[i] + (a + b) // 2) & 255
            elif filter_type == 4:
                p = a + b - c
                near = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
                row[i] = (row[i] + near) & 255
        rows.append(row)
        above = row
    return width, height, step, rows


path, scheme = sys.argv[1:]
width, height, step, rows = read_png(path)
count, places = {}, {}
for y, row in enumerate(rows):
    for x in range(width):
        color = bytes(row[x * step:x * step + 3]).hex()
        count[color] = count.get(color, 0) + 1
        places.setdefault(color, []).append((x, y))
most = max(count, key=count.get)
assert most == BACK.get(scheme, "ffffff"), f"the background is {most}"
if scheme == "heat":
    # Shades of one red, from pale to strong, in the map and in the scale beside it.
    reds = [color for color in count for r, g, b in [bytes.fromhex(color)] if r > g + 20 and abs(g - b) < 20]
    pixels = [p for color in reds for p in places[color]]
    assert len(reds) >= 12 and len(pixels) > 50000, (len(reds), len(pixels))
    print("the map is there")
    sys.exit()
for color in COLORS[scheme]:
    # The key has a dot of each colour; marks of the plot are see-through, and darker or paler for it.
    assert count.get(color, 0) > 60, f"colour {color} is there {count.get(color, 0)} times"
colorful = [color for color in count if max(bytes.fromhex(color)) - min(bytes.fromhex(color)) > 70]
marks = [p for color in colorful for p in places[color] if p[0] < 0.7 * width]
assert len(marks) > 1000, f"{len(marks)} pixels belong to marks"
spread = [max(p[k] for p in marks) - min(p[k] for p in marks) for k in (0, 1)]
assert spread[0] > 0.15 * width, f"marks spread over {spread[0]} of {width} pixels"
assert spread[1] > 150, f"marks spread over {spread[1]} lines"
print(scheme + ": the plot is there")
