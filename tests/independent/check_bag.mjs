// Reads a bag of `hybridfusion simulate` with @foxglove/rosbag and compares it with the data set's own description.
// Usage: check_bag.mjs DATASET   (exit 0 good, 1 bad, 77 the reader is not installed)
import fs from "node:fs";
import path from "node:path";

let Bag, FileReader, lz4;
try {
  ({ Bag } = await import("@foxglove/rosbag"));
  ({ FileReader } = await import("@foxglove/rosbag/node.js"));
  lz4 = (await import("lz4js")).default;
} catch {
  console.log("skipped: @foxglove/rosbag is not installed; run: npm install --prefix tests/independent");
  process.exit(77);
}

const failures = [];
const expect = (condition, what) => condition || failures.push(what);

const dataset = process.argv[2];
const sensors = Object.fromEntries(
  fs.readFileSync(path.join(dataset, "sensors.yaml"), "utf8").split("\n")
    .map((line) => line.match(/^(\w+_topic): (.*)$/)).filter(Boolean).map((m) => [m[1], m[2]]));
const trajectory = fs.readFileSync(path.join(dataset, "truth/trajectory_imu.tum"), "utf8")
  .split("\n").filter((line) => line && !line.startsWith("#")).map((line) => Number(line.split(" ")[0]));

const bag = new Bag(new FileReader(path.join(dataset, "street.bag")),
                    { decompress: { lz4: (bytes) => lz4.decompress(bytes) } });
await bag.open();
const types = new Map([...bag.connections.values()].map((c) => [c.topic, c.type]));
expect(types.get(sensors.lidar_topic) === "sensor_msgs/PointCloud2", "type of the LiDAR topic");
expect(types.get(sensors.imu_topic) === "sensor_msgs/Imu", "type of the IMU topic");
expect(types.get(sensors.gnss_topic) === "sensor_msgs/NavSatFix", "type of the GNSS topic");

const seconds = (time) => time.sec + time.nsec * 1e-9;
const seen = new Map();
let lastTime = 0;
for await (const { topic, message, timestamp } of bag.messageIterator()) {
  expect(seconds(timestamp) >= lastTime, "the messages are in the order of recording");
  lastTime = seconds(timestamp);
  const entry = seen.get(topic) ?? { count: 0, first: message, last: message };
  ++entry.count;
  entry.last = message;
  seen.set(topic, entry);
}
const stamp = (message) => seconds(message.header.stamp);
const span = (entry) => stamp(entry.last) - stamp(entry.first);
const begin = trajectory[0];
const end = trajectory.at(-1);
const scans = seen.get(sensors.lidar_topic);
const imu = seen.get(sensors.imu_topic);
const fixes = seen.get(sensors.gnss_topic);
for (const [name, entry] of [["LiDAR", scans], ["IMU", imu], ["GNSS", fixes]]) {
  expect(entry && entry.count > 10, `${name} messages`);
  if (!entry) continue;
  expect(stamp(entry.first) >= begin - 1 && stamp(entry.first) < begin + 2, `first stamp of the ${name}`);
  expect(stamp(entry.last) <= end + 1 && stamp(entry.last) > end - 2, `last stamp of the ${name}`);
}
if (scans && imu) {
  expect(Math.abs((scans.count - 1) / span(scans) - 10) < 0.5, "10 scans a second");
  expect(Math.abs((imu.count - 1) / span(imu) - 200) < 4, "200 IMU samples a second");
  const cloud = scans.first;
  const sizes = [0, 1, 1, 2, 2, 4, 4, 4, 8];
  const fields = new Map(cloud.fields.map((f) => [f.name, f]));
  for (const name of ["x", "y", "z", "intensity", "ring", "time"]) expect(fields.has(name), `point field ${name}`);
  for (const f of cloud.fields) expect(f.offset + sizes[f.datatype] <= cloud.point_step, `place of field ${f.name}`);
  expect(cloud.data.length === cloud.height * cloud.row_step, "bytes of the points");
  const view = new DataView(cloud.data.buffer, cloud.data.byteOffset, cloud.data.byteLength);
  let near = 0;
  let latest = 0;
  for (let i = 0; i < cloud.width * cloud.height; ++i) {
    const at = (name) => view.getFloat32(i * cloud.point_step + fields.get(name).offset, true);
    const range = Math.hypot(at("x"), at("y"), at("z"));
    near += range > 0.3 && range < 300;
    latest = Math.max(latest, at("time"));
  }
  expect(near > 0.9 * cloud.width * cloud.height, "points at sensible ranges");
  expect(latest > 0.05 && latest <= 0.11, "point times span a scan");
  const force = imu.first.linear_acceleration;
  expect(Math.abs(Math.hypot(force.x, force.y, force.z) - 9.81) < 0.3, "gravity at rest");
}
if (failures.length > 0) {
  console.log(`${dataset}/street.bag: wrong: ${[...new Set(failures)].join("; ")}`);
  process.exit(1);
}
console.log(`${dataset}/street.bag: ${[...seen].map(([topic, e]) => `${topic} ${e.count}`).join(", ")}`);
