package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/**
 * Test of the launcher on a simulated machine in a new folder: a copy of the launcher in a repository of empty sources, a Java that
 * reports how it was started instead of running, a Maven that makes empty jars and notes each call. Folder names have blanks.
 */
abstract class InSandbox {
    static final int SET_UP_FAILED = 7;

    private static final String ESSENTIAL_PROGRAMS =
            "bash cat cksum cp dirname env find flock grep head ls mkdir mktemp"
                    + " mv readlink rm sed setpriv setsid sleep sort touch true uname xargs";

    @TempDir
    Path folder;

    @BeforeEach
    final void layOut() throws IOException {
        for (String source : List.of(
                "pom.xml",
                "precompute/pom.xml",
                "precompute/src/main/java/Precompute.java",
                "jrtr/pom.xml",
                "jrtr/src/main/java/Jrtr.java",
                "app/pom.xml",
                "app/src/main/java/App.java",
                "shaders/full.frag",
                "data/color.csv")) {
            write(repository().resolve(source), "");
        }
        for (String part : List.of("sunbeam", "app/src/archive/archive.sh", "app/src/archive/watch.sh")) {
            Files.createDirectories(repository().resolve(part).getParent());
            Files.copy(Sunbeam.repository().resolve(part), repository().resolve(part));
        }
        installJava("jdk", "17.0.1");
        installMaven();
    }

    Path repository() {
        return folder.resolve("a repository");
    }

    Path launcher() {
        return repository().resolve("sunbeam");
    }

    /** Returns a start of the sandbox's launcher with the sandbox's Java and Maven and without a screen; it may build. */
    Sunbeam command(String... arguments) {
        return equip(Sunbeam.launcher(launcher(), arguments));
    }

    /** Equips a start with the sandbox's Java and Maven and removes its screen. */
    Sunbeam equip(Sunbeam start) {
        return start.with("JAVA_HOME", folder.resolve("jdk").toString())
                .with("PATH", programs() + ":" + System.getenv("PATH"))
                .without("SUNBEAM_NO_BUILD")
                .without("SUNBEAM_JAVA_OPTIONS")
                .without("DISPLAY");
    }

    /**
     * Installs a Java whose {@code java} prints a line with the screen, then the working folder, then its arguments, one a line, and then
     * runs the given shell commands.
     */
    void installJava(String name, String version, String... thenRun) throws IOException {
        Path home = folder.resolve(name);
        write(home.resolve("release"), "IMPLEMENTOR=\"Nobody\"\nJAVA_VERSION=\"" + version + "\"\n");
        write(home.resolve("lib/libawt_xawt.so"), "");
        script(home.resolve("bin/javac"));
        script(
                home.resolve("bin/java"),
                Stream.concat(
                                Stream.of("echo \"screen ${DISPLAY:-none}\"", "printf '%s\\n' \"$PWD\" \"$@\""),
                                Stream.of(thenRun))
                        .toArray(String[]::new));
    }

    /** Installs a Maven that records its call, runs the given shell commands and makes the program's jar. */
    void installMaven(String... thenRun) throws IOException {
        installProgram(
                "mvn",
                "echo \"$@\" >>'" + mavenCalls() + "'",
                String.join("\n", thenRun),
                "mkdir -p app/target/lib && touch app/target/app-0.1.0.jar");
    }

    void installProgram(String name, String... shellLines) throws IOException {
        script(programs().resolve(name), shellLines);
    }

    /**
     * Returns a search path with the sandbox's programs and those of every Debian, which the launcher may expect: no Xvfb, Maven or package
     * manager.
     */
    String pathOfABareMachine() throws IOException {
        Path bare = folder.resolve("bare machine");
        for (String name : ESSENTIAL_PROGRAMS.split(" ", -1)) {
            script(bare.resolve(name), "exec '" + findOnPath(name) + "' \"$@\"");
        }
        return programs() + ":" + bare;
    }

    private static Path findOnPath(String name) {
        return Stream.of(System.getenv("PATH").split(":", -1))
                .map(place -> Path.of(place, name))
                .filter(Files::isExecutable)
                .findFirst()
                .orElseThrow(() -> new IllegalStateException("the tests need the program " + name + " on PATH"));
    }

    int builds() throws IOException {
        return Files.exists(mavenCalls()) ? Files.readAllLines(mavenCalls()).size() : 0;
    }

    private Path mavenCalls() {
        return folder.resolve("maven calls");
    }

    private Path programs() {
        return folder.resolve("programs");
    }

    private void script(Path file, String... lines) throws IOException {
        write(file, "#!/bin/sh\n" + String.join("\n", lines) + "\n");
        assertThat(file.toFile().setExecutable(true)).as("executable: %s", file).isTrue();
    }

    private void write(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }
}
