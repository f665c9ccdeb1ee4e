// Compares what `hybridfusion convert` reads of LAS files by others with what the npm package copc reads of them.
// Usage: check_las_read.mjs PROGRAM FOLDER...   (exit 0 good, 1 bad, 77 the reader is not installed)
// The program leaves out withheld points and turns feet into metres; so is done here. copc knows LAS 1.2 and 1.4.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";

let Las;
try {
  ({ Las } = (await import("copc")).default ?? (await import("copc")));
} catch {
  console.log("skipped: copc is not installed; run: npm install --prefix tests/independent");
  process.exit(77);
}

const [program, ...folders] = process.argv.slice(2);
const work = fs.mkdtempSync(path.join(os.tmpdir(), "las-read-"));
const versions = new Map();
const failures = [];

const METERS_PER_UNIT = [1.0, 0.3048, 1200.0 / 3937.0];

/** Places of all points that are not withheld, or nothing where copc does not read the file. */
function places(file) {
  const bytes = new Uint8Array(fs.readFileSync(file));
  try {
    const header = Las.Header.parse(bytes.slice(0, 375));
    const view = Las.View.create(bytes.slice(header.pointDataOffset), header);
    const [x, y, z] = ["X", "Y", "Z"].map((name) => view.getter(name));
    const flags = header.pointDataRecordFormat >= 6 ? { at: 15, bit: 4 } : { at: 15, bit: 128 };
    const isWithheld = (i) =>
      bytes[header.pointDataOffset + i * header.pointDataRecordLength + flags.at] & flags.bit;
    const list = Array.from({ length: header.pointCount }, (_, i) => i).filter((i) => !isWithheld(i))
      .map((i) => [x(i), y(i), z(i)]);
    return { list, version: `1.${header.minorVersion}`, format: header.pointDataRecordFormat };
  } catch {
    return undefined;
  }
}

for (const folder of folders) {
  for (const name of fs.readdirSync(folder).filter((entry) => entry.endsWith(".las"))) {
    const file = path.join(folder, name);
    const theirs = places(file);
    if (!theirs || theirs.list.length === 0) continue;
    const out = path.join(work, "out.xyz");
    try {
      execFileSync(program, ["convert", file, out, "--quiet"], { stdio: ["ignore", "ignore", "pipe"] });
    } catch {
      continue; // refused, with its reason: the unit tests look at those
    }
    const ours = fs.readFileSync(out, "utf8").trim().split("\n").map((line) => line.split(/\s+/).slice(0, 3).map(Number));
    if (ours.length !== theirs.list.length) {
      failures.push(`${file}: ${ours.length} points instead of ${theirs.list.length}`);
      continue;
    }
    const gap = (scale) => Math.max(...ours.map((p, i) =>
      Math.max(...p.map((v, axis) => Math.abs(v - scale * theirs.list[i][axis])))));
    const worst = Math.min(...METERS_PER_UNIT.map(gap));
    if (!(worst < 0.002)) failures.push(`${file}: a point is ${worst} off`);
    const key = `LAS ${theirs.version} format ${theirs.format}`;
    versions.set(key, (versions.get(key) ?? 0) + 1);
  }
}
fs.rmSync(work, { recursive: true });
console.log([...versions].map(([key, count]) => `${key}: ${count}`).sort().join(", "));
if (failures.length > 0 || versions.size === 0) {
  console.log(`wrong: ${failures.join("; ")}`);
  process.exit(1);
}
