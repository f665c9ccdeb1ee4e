#!/bin/sh
# three 0.187.0 (npm): PCDLoader shows no colours of a PCD file whose colour field is called rgba (TYPE U), the name of PCL's
# PointXYZRGBA; it knows rgb only and says nothing. Seen: "rgb: colours, rgba: none".
# Exit 0: seen again; 1: the behaviour has changed; 2: could not be tried.
set -e
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
npm install --silent --no-audit --no-fund three@0.187.0 >/dev/null || exit 2
cat >try.mjs <<'END'
import {PCDLoader} from 'three/examples/jsm/loaders/PCDLoader.js';
const has = (name) => {
  const head = new TextEncoder().encode(`# .PCD v0.7\nVERSION 0.7\nFIELDS x y z ${name}\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n` +
      'WIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA binary\n');
  const bytes = new Uint8Array(head.length + 16);
  bytes.set(head);
  const view = new DataView(bytes.buffer, head.length);
  [1, 2, 3].forEach((value, axis) => view.setFloat32(4 * axis, value, true));
  view.setUint32(12, 0xff000000 + 13 * 65536 + 103 * 256 + 203, true);
  return new PCDLoader().parse(bytes.buffer).geometry.attributes.color ? 'colours' : 'none';
};
console.log(`rgb: ${has('rgb')}, rgba: ${has('rgba')}`);
END
got=$(node try.mjs)
echo "$got"
[ "$got" = "rgb: colours, rgba: none" ]
