#!/bin/sh
# copc 0.0.8 (npm) reads the scale of an extra byte field of LAS 1.4 with the bytes in the wrong order: a field of scale 0.5 and raw
# value 60 gives 1.7e-317 instead of 30, without an error. Seen: "scale 2.8363e-319, value 1.7017696e-317".
# Exit 0: seen again; 1: the behaviour has changed; 2: could not be tried.
set -e
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
npm install --silent --no-audit --no-fund copc@0.0.8 >/dev/null || exit 2
cat >try.mjs <<'END'
import {Las} from 'copc';
// LAS 1.4 R15, table "Extra Bytes": type 3 (unsigned short), option bit 3 (scale), the scale at byte 112.
const descriptor = new Uint8Array(192);
descriptor[2] = 3;
descriptor[3] = 0x08;
descriptor.set(new TextEncoder().encode('Amplitude'), 4);
new DataView(descriptor.buffer).setFloat64(112, 0.5, true);
const fields = Las.ExtraBytes.parse(descriptor);
const header = {pointDataRecordFormat: 6, pointDataRecordLength: 32, scale: [1, 1, 1], offset: [0, 0, 0], pointCount: 1};
const record = new Uint8Array(32);
new DataView(record.buffer).setUint16(30, 60, true);
const value = Las.View.create(record, header, fields).getter('Amplitude')(0);
console.log(`scale ${fields[0].scale}, value ${value}`);
END
got=$(node try.mjs)
echo "$got (right: scale 0.5, value 30)"
[ "$got" = "scale 2.8363e-319, value 1.7017696e-317" ]
