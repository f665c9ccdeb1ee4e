// Reads a LAS file of `hybridfusion convert` with the npm package copc and compares it with the points that went in.
// Usage: check_las.mjs FILE.las POINTS.xyz CRS [VERSION]   (exit 0 good, 1 bad, 77 the reader is not installed)
// POINTS.xyz: "x y z r g b" lines in the coordinates of the LAS file; CRS: part of its WKT, or "none".
import fs from "node:fs";

let Las;
try {
  ({ Las } = (await import("copc")).default ?? (await import("copc")));
} catch {
  console.log("skipped: copc is not installed; run: npm install --prefix tests/independent");
  process.exit(77);
}

const [file, pointsFile, crs, version = "1.4"] = process.argv.slice(2);
const formats = version === "1.4" ? { color: 7, plain: 6 } : { color: 3, plain: 1 };
const failures = [];
const expect = (condition, what) => condition || failures.push(what);
const bytes = new Uint8Array(fs.readFileSync(file));
const read = async (begin, end) => bytes.slice(begin, end);
const points = fs.readFileSync(pointsFile, "utf8").trim().split("\n").map((line) => line.trim().split(/\s+/).map(Number));

const header = Las.Header.parse(bytes.slice(0, 375));
expect(`${header.majorVersion}.${header.minorVersion}` === version, `version ${version}`);
expect(header.pointCount === points.length, `point count ${header.pointCount}`);
expect(header.pointDataRecordFormat === (points[0].length >= 6 ? formats.color : formats.plain), `point format ${header.pointDataRecordFormat}`);
const vlrs = await Las.Vlr.walk(read, header);
const wkt = Las.Vlr.find(vlrs, "LASF_Projection", 2112);
if (crs === "none") {
  expect(!wkt, "no WKT");
} else {
  const text = wkt && new TextDecoder().decode(await Las.Vlr.fetch(read, wkt));
  expect(text?.includes(crs), `WKT names ${crs}`);
}
const view = Las.View.create(bytes.slice(header.pointDataOffset), header);
const [x, y, z] = ["X", "Y", "Z"].map((name) => view.getter(name));
const colors = points[0].length >= 6 ? ["Red", "Green", "Blue"].map((name) => view.getter(name)) : [];
points.forEach((point, i) => {
  const at = [x(i), y(i), z(i)];
  const gap = Math.max(...at.map((value, axis) => Math.abs(value - point[axis])));
  expect(gap <= 0.0011, `place of a point (${at} instead of ${point.slice(0, 3)})`);
  at.forEach((value, axis) =>
    expect(value >= header.min[axis] - 1e-6 && value <= header.max[axis] + 1e-6, "bounds of the header"));
  colors.forEach((channel, k) => expect(channel(i) === point[3 + k] * 257, "colour of a point"));
});
if (failures.length > 0) {
  console.log(`${file}: wrong: ${[...new Set(failures)].slice(0, 5).join("; ")}`);
  process.exit(1);
}
console.log(`${file}: ${header.pointCount} points agree`);
