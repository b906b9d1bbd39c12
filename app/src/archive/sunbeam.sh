#!/bin/sh
# Starts Sunbeam on macOS and Linux.
here=$(cd "$(dirname "$0")" && pwd -P) || exit 7
java=java
[ -z "$JAVA_HOME" ] || java=$JAVA_HOME/bin/java
[ ! -x "$here/java/bin/java" ] || java=$here/java/bin/java
"$java" "@$here/lib/java.options" -version >/dev/null 2>&1 \
    || { echo "sunbeam: there is no Java that will do ($java): install Java 17 or newer, or set JAVA_HOME" >&2; exit 7; }
# Only view opens a window; a Java with windows would show an icon, and end later.
case " $* " in *" view "*) headless=false ;; *) headless=true ;; esac
# Java's report of its fatal error goes to standard output: among results there is none, but a line of watch.sh.
case " $* " in
    *" view "*) watch=window silent=- ;;
    *" --json "* | *" - "* | *"=- "*) watch=results silent=+ ;;
    *) watch="" silent=- ;;
esac
# shellcheck disable=SC2086 # the user's options are split at blanks
set -- "$java" "@$here/lib/java.options" -XX:${silent}SuppressFatalErrorMessage -Djava.awt.headless=$headless $SUNBEAM_JAVA_OPTIONS -cp "$here/lib/*" sunbeam.app.Main "$@"
# The watch needs Linux's setpriv; macOS has no X server to lose.
[ -z "$watch" ] || ! { command -v bash && command -v setpriv; } >/dev/null || exec bash "$here/lib/watch.sh" $watch "$@"
exec "$@"
