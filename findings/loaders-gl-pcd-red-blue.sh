#!/bin/sh
# @loaders.gl/pcd 4.4.2 (npm) swaps red and blue of binary PCD files. The field rgb holds 0x00RRGGBB in the bits of a float, as PCL
# writes it; a point of red 13, green 103, blue 203 comes back as 203 103 13. Seen: "203 103 13". Clouds of natural colours turn bluish.
# Exit 0: seen again; 1: the behaviour has changed; 2: could not be tried.
set -e
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
npm install --silent --no-audit --no-fund @loaders.gl/core@4.4.5 @loaders.gl/pcd@4.4.2 @math.gl/types@4.1.0 >/dev/null || exit 2
cat >try.mjs <<'END'
import {parse} from '@loaders.gl/core';
import {PCDLoader} from '@loaders.gl/pcd';
const head = new TextEncoder().encode('# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 1\n' +
    'HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA binary\n');
const bytes = new Uint8Array(head.length + 16);
bytes.set(head);
const view = new DataView(bytes.buffer, head.length);
[1, 2, 3].forEach((value, axis) => view.setFloat32(4 * axis, value, true));
view.setUint32(12, (13 << 16) | (103 << 8) | 203, true);
const cloud = await parse(bytes.buffer, PCDLoader);
console.log(Array.from(cloud.attributes.COLOR_0.value.slice(0, 3)).join(' '));
END
got=$(node try.mjs)
echo "colour of the point: $got (right: 13 103 203)"
[ "$got" = "203 103 13" ]
