#!/bin/sh
# Starts Sunbeam on macOS and Linux.
here=$(cd "$(dirname "$0")" && pwd -P) || exit 7
java=java
[ -z "$JAVA_HOME" ] || java=$JAVA_HOME/bin/java
command -v "$java" >/dev/null || { echo "sunbeam: there is no Java ($java): install Java 17 or newer, or set JAVA_HOME" >&2; exit 7; }
# Only view opens a window; a Java with windows would show an icon, and end later.
case " $* " in *" view "*) headless=false ;; *) headless=true ;; esac
# shellcheck disable=SC2086 # the user's options are split at blanks
exec "$java" -XX:+DisplayVMOutputToStderr --enable-native-access=ALL-UNNAMED -Djava.awt.headless=$headless -Dfile.encoding=UTF-8 \
    -XX:MaxRAMPercentage=50 $SUNBEAM_JAVA_OPTIONS -cp "$here/lib/*" sunbeam.app.Main "$@"
