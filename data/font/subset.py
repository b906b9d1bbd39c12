#!/usr/bin/env python3
"""Makes SunbeamSans-*.ttf: Source Sans 3.052 (npm pack source-sans@3.52.0, its folder TTF) with the letters of pictures, without hints.

    pip install fonttools==4.68.0
    python3 subset.py FOLDER_OF_TTF

The name differs since the license reserves the name "Source" for the original.
"""
import pathlib
import sys

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

RANGES = [
    (0x20, 0x7E), (0xA0, 0x17F),  # Latin
    (0x370, 0x3FF), (0x400, 0x45F),  # Greek, Cyrillic
    (0x2010, 0x2026), (0x2030, 0x203A), (0x20AC, 0x20AC),  # dashes, quotes, primes
    (0x2070, 0x209C),  # superscripts and subscripts
    (0x2190, 0x2199),  # arrows
    (0x2202, 0x2265),  # mathematics, such as minus
]

for style in ("Regular", "Bold"):
    font = TTFont(pathlib.Path(sys.argv[1]) / f"SourceSans3-{style}.ttf", recalcTimestamp=False)
    options = Options(hinting=False, layout_features=["kern"], notdef_outline=True, name_IDs=[0, 1, 2, 3, 4, 5, 6, 13, 14])
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=[code for first, last in RANGES for code in range(first, last + 1)])
    subsetter.subset(font)
    names = {1: "Sunbeam Sans", 3: f"3.052;SunbeamSans-{style}", 4: f"Sunbeam Sans {style}", 6: f"SunbeamSans-{style}"}
    for number, name in names.items():
        font["name"].setName(name, number, 3, 1, 0x409)
    font.save(pathlib.Path(__file__).parent / f"SunbeamSans-{style}.ttf")
