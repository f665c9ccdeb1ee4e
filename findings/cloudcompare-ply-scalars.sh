#!/bin/sh
# CloudCompare 2.11.3 (Debian 12, cloudcompare 2.11.3-7.1), command line: scalars of a PLY file are dropped without a word unless their
# names begin with scalar_ (or are known ones such as intensity). Seen: a cloud with the property classification is saved with the
# heading "//X Y Z", with scalar_classification as "//X Y Z classification".
# Exit 0: seen again; 1: the behaviour has changed; 2: could not be tried.
set -e
command -v CloudCompare >/dev/null || apt-get install -y -q --no-install-recommends cloudcompare=2.11.3-7.1 >/dev/null || exit 2
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
heading() {
  mkdir "$dir/$1"
  printf 'ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty uchar %s\nend_header\n1 2 3 2\n4 5 6 6\n' \
    "$1" >"$dir/$1/a.ply"
  (cd "$dir/$1" && QT_QPA_PLATFORM=offscreen CloudCompare -SILENT -AUTO_SAVE OFF -O a.ply -C_EXPORT_FMT ASC -ADD_HEADER -SAVE_CLOUDS >log 2>&1)
  head -n 1 "$dir/$1"/a_*.asc
}
plain=$(heading classification)
prefixed=$(heading scalar_classification)
echo "classification: $plain; scalar_classification: $prefixed"
[ "$plain" = "//X Y Z" ] && [ "$prefixed" = "//X Y Z classification" ]
