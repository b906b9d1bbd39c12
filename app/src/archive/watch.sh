#!/bin/bash
# Runs Java, and says in one line what Java leaves unsaid: that it has died, or that its screen has. A part of both start scripts.
#   watch.sh window JAVA ...    a program with a window: Xlib ends it at once when the X server has gone
#   watch.sh results JAVA ...   one whose standard output holds results, where Java's report of its own death would go
set -u
readonly NO_SCREEN=5

say() { printf 'sunbeam: %s\n' "$*" >&2; }

# Standard error of a program with a window, without what Xlib makes Java print when the X server has gone; fails if it has.
tell_errors() {
    local line gone=0
    trap '' INT
    while IFS= read -r line || [[ $line ]]; do
        case $line in
            "Nativewindow X11 IOError"* | "FATAL ERROR in native method: Nativewindow X11"* | "XIO: "* | "X connection to "* | \
                "sunbeam: the X server of "*) gone=1 ;;
            *) ((gone)) || printf '%s\n' "$line" ;;
        esac
    done >&2
    return $gone
}

watched=$1 reader="" status=0
shift
if [[ $watched == window ]]; then
    exec {errors}> >(tell_errors)
    reader=$!
else
    exec {errors}>&2
fi
# Without job control a program in the background would ignore Ctrl-C. A core file would hold gigabytes. Bash has words of its own on a
# child that died.
ulimit -Sc 0
exec {own}>&2 2>/dev/null
env --default-signal=INT,QUIT setpriv --pdeathsig TERM "$@" <&0 2>&"$errors" {errors}>&- {own}>&- &
java=$!
exec {errors}>&-
for signal in HUP INT TERM; do
    # shellcheck disable=SC2064 # the process's number is known now
    trap "caught=1; kill -$signal $java || true" $signal
done
caught=1
while [[ $caught ]]; do # a signal ends the waiting
    caught="" status=0
    wait "$java" || status=$?
done
exec 2>&"$own"
if [[ $reader ]] && ! wait "$reader"; then
    say "the X server of DISPLAY=$DISPLAY has ended, and with it the window; start it again"
    exit $NO_SCREEN
fi
# The signals of a fault, of abort (Java's own way to die), and of a kernel without memory.
case $((status - 128)) in
    4 | 5 | 6 | 7 | 8 | 9 | 11 | 31) say "Java has died (signal $(kill -l "$status")): no result is whole" ;;
esac
exit "$status"
