# shellcheck shell=bash disable=SC2086,SC2154 # exit codes and folders are the launcher's
# ./sunbeam archive: packs what runs on other systems. A part of the launcher, whose functions it uses.

# The bytes of a file from an offset on, in hexadecimal digits.
bytes_of() { od -An -v -tx1 -j"$2" -N"$3" "$1" | tr -d ' \n'; }

# Sets system to that of a Java runtime by the first bytes of its program (PE, ELF, Mach-O), as in windows-x64.
find_system() { # the runtime's folder
    local program=$1/bin/java machine
    if [[ -f $program.exe ]]; then
        # The header's place stands at 60, with its low byte first.
        machine=$(bytes_of "$program.exe" 60 2)
        machine=pe-$(bytes_of "$program.exe" $((16#${machine:2:2}${machine:0:2} + 4)) 2)
    else
        machine=$(bytes_of "$program" 0 4)
        case $machine in
            7f454c46) machine=elf-$(bytes_of "$program" 18 2) ;;
            cffaedfe) machine=mach-$(bytes_of "$program" 4 4) ;;
        esac
    fi
    case $machine in
        pe-6486) system=windows-x64 ;;
        elf-3e00) system=linux-x64 ;;
        elf-b700) system=linux-aarch64 ;;
        mach-07000001) system=macos-x64 ;;
        mach-0c000001) system=macos-aarch64 ;;
        *) stop $USAGE "--with-java $1: this Java is for a system that Sunbeam has no OpenGL for ($machine): give one for Windows (x64)," \
            "Linux or macOS (x64, aarch64)" ;;
    esac
}

# Sets system to that of a whole Java runtime that is to go into the archive, and options to Maven's for it.
choose_runtime() { # the folder as the user named it
    local runtime=$1
    [[ ! -d $1/Contents/Home ]] || runtime=$1/Contents/Home # as macOS has it
    runtime=$(readlink -f "$runtime") || true
    [[ -f $runtime/release && -r $runtime/release && -n $(compgen -G "$runtime/bin/java*") ]] \
        || stop $USAGE "--with-java $1: there is no Java in this folder: give one that holds bin/java and the file release"
    local release module
    release=$(<"$runtime/release")
    [[ $release =~ JAVA_VERSION=\"([0-9]+) && ${BASH_REMATCH[1]} -ge $OLDEST_JAVA ]] \
        || stop $USAGE "--with-java $1: this Java is older than $OLDEST_JAVA: give a newer one"
    # As jdeps lists them; a release file without modules is that of a whole Java.
    for module in java.desktop java.sql jdk.management jdk.unsupported; do
        [[ $release != *MODULES=* || $release =~ [\"\ ]$module[\"\ ] ]] \
            || stop $USAGE "--with-java $1: this Java has no $module, which the program needs: give one that has"
    done
    find_system "$runtime"
    options=("-Dsunbeam.java=$runtime" "-Dsunbeam.system=$system")
}

run_archive() {
    local system=portable options=()
    case $# in
        0) ;;
        2) [[ $1 == --with-java ]] || stop $USAGE "archive: unknown option '$1': it has --with-java FOLDER" ;;
        *) stop $USAGE "archive takes nothing, or --with-java FOLDER" ;;
    esac
    (($# == 0)) || choose_runtime "$2"
    provide build
    lock_build
    { mkdir -p "$target" && rm -f "$target"/sunbeam-*-"$system".*; } 2>/dev/null || stop $NO_SETUP "cannot write to $target: make it writable"
    package "no archives were built" -Parchive "${options[@]}"
    printf '%s\n' "$target"/sunbeam-*-"$system".*
}
