#!/usr/bin/env python3
"""Reduces the empty margin of each picture to 40 pixels, and its colours to 64: trim.py PICTURE..."""
import sys

from PIL import Image, ImageChops, ImageOps

for name in sys.argv[1:]:
    picture = Image.open(name).convert("RGB")
    empty = Image.new("RGB", picture.size, picture.getpixel((0, 0)))
    box = ImageChops.difference(picture, empty).point(lambda value: 255 * (value > 8)).getbbox()
    ImageOps.expand(picture.crop(box), 40, picture.getpixel((0, 0))).quantize(64).save(name, optimize=True)
