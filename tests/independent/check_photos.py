#!/usr/bin/env python3
"""Compares what exiftool reads of simulated photos with the truth of their data set.

Usage: check_photos.py DATASET   (exit 0: it agrees; 1: it does not)
"""
import csv
import json
import math
import pathlib
import subprocess
import sys

WGS84_A = 6378137.0
WGS84_E2 = 6.69437999014e-3


def ecef(latitude_deg, longitude_deg, height_m):
    phi, lam = math.radians(latitude_deg), math.radians(longitude_deg)
    n = WGS84_A / math.sqrt(1.0 - WGS84_E2 * math.sin(phi) ** 2)
    flat = (n + height_m) * math.cos(phi)
    return flat * math.cos(lam), flat * math.sin(lam), (n * (1.0 - WGS84_E2) + height_m) * math.sin(phi)


def enu(origin, position):
    phi, lam = math.radians(origin["lat"]), math.radians(origin["lon"])
    base = ecef(origin["lat"], origin["lon"], origin["h"])
    d = [a - b for a, b in zip(ecef(*position), base)]
    east = -math.sin(lam) * d[0] + math.cos(lam) * d[1]
    ahead = math.cos(lam) * d[0] + math.sin(lam) * d[1]
    return east, -math.sin(phi) * ahead + math.cos(phi) * d[2], math.cos(phi) * ahead + math.sin(phi) * d[2]


def main():
    dataset = pathlib.Path(sys.argv[1])
    description = json.loads((dataset / "truth/dataset.json").read_text())
    with open(dataset / "truth/cameras.csv", newline="") as file:
        truth = {row["name"]: row for row in csv.DictReader(file)}
    output = subprocess.run(["exiftool", "-n", "-j", "-ext", "jpg", str(dataset / "images")],
                            capture_output=True, text=True, check=True).stdout
    photos = {photo["FileName"]: photo for photo in json.loads(output)}
    wrong = []

    def expect(good, what):
        if not good:
            wrong.append(what)

    expect(set(photos) == set(truth), f"photos {sorted(set(photos) ^ set(truth))}")
    camera = description["camera"]
    times = []
    for name, photo in sorted(photos.items()):
        if name not in truth:
            continue
        row = truth[name]
        expect("Warning" not in photo and "Error" not in photo, f"{name}: {photo.get('Warning', photo.get('Error'))}")
        expect((photo["ImageWidth"], photo["ImageHeight"]) == (camera["width"], camera["height"]), f"{name}: size")
        expect(photo.get("Make") and photo.get("Model"), f"{name}: camera")
        place = enu(description["origin"], (photo["GPSLatitude"], photo["GPSLongitude"], photo["GPSAltitude"]))
        fix = [float(row[key]) for key in ("gnss_e", "gnss_n", "gnss_u")]
        expect(max(abs(a - b) for a, b in zip(place, fix)) < 0.01, f"{name}: at {place}, not {fix}")
        # A lens is known to its maker to a few per cent.
        focal_px = photo["FocalLengthIn35mmFormat"] / 36.0 * camera["width"]
        expect(abs(focal_px / camera["f"] - 1.0) < 0.1, f"{name}: focal length {focal_px} px")
        expect(photo["GPSHPositioningError"] == description["gnss"]["sigma_h"], f"{name}: positioning error")
        times.append((float(row["time"]), photo["SubSecDateTimeOriginal"]))
    expect([t for _, t in sorted(times)] == sorted(t for _, t in times), "order of the times")
    for line in wrong[:10]:
        print(line)
    print(f"exiftool: {len(photos)} photos, {len(wrong)} wrong")
    return 1 if wrong or not photos else 0


if __name__ == "__main__":
    sys.exit(main())
