package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How the launcher starts the program, and the private screen that it gives it and removes afterwards. */
class LauncherStartTest extends InSandbox {
    private static final Duration PATIENCE = Duration.ofSeconds(60);

    @ParameterizedTest
    @CsvSource({"INT, 130", "TERM, 143", "KILL, 137"})
    void aPrivateScreenEndsWhenTheProgramIsKilled(String signal, int exitCode) throws Exception {
        // A killed launcher passes no signal on, so Java draws to its end.
        installJava("jdk", "17.0.1", "exec sleep 2");

        try (RunningSunbeam running = command("brdf-map").start()) {
            Screen screen = Screen.of(running);
            assertThat(screen.server().isAlive()).isTrue();
            assertThat(screen.socket()).exists();
            running.signal(signal);

            assertThat(running.end(PATIENCE).exitCode()).isEqualTo(exitCode);
            screen.assertGone();
        }
    }

    @Test
    void aScreenOfThisMachineThatHasGoneIsReplacedWithAWord() throws Exception {
        SunbeamResult result = command("brdf-map").with("DISPLAY", ":9876.0").run();

        assertThat(result.stdout()).as("%s", result).startsWith("screen :").doesNotStartWith("screen :9876");
        assertThat(result.stderr()).contains("warning: there is no screen :9876.0 any more: drawing on a private one");
    }

    /** The key is an unnamed file that only processes of its owner have open; without it the server refuses all clients. */
    @Test
    void nobodyElseUsesThePrivateScreen() throws Exception {
        installJava("jdk", "17.0.1", "echo \"$XAUTHORITY\" >'" + folder + "/key'; exec sleep 60");

        try (RunningSunbeam running = command("brdf-map").start()) {
            Screen screen = Screen.of(running);
            Path noted = folder.resolve("key");
            RunningSunbeam.await("the key's name", () -> Files.exists(noted) && Files.size(noted) > 0);
            Path key = Path.of(Files.readString(noted).strip());
            assertThat(Files.size(key)).isEqualTo(44);
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(key.getParent())))
                    .isEqualTo("r-x------");
            assertThat(screen.server().info().commandLine().orElse("")).contains("-auth " + key);
            // The abstract socket keeps another server from taking the same number.
            assertThat(Files.readString(Path.of("/proc/net/unix")))
                    .contains(" " + screen.socket(), "@" + screen.socket());
            running.signal("TERM");
            running.end(PATIENCE);
            screen.assertGone();
            RunningSunbeam.await("the end of the key", () -> !Files.exists(key.getParent()));
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "help",
                "--help",
                "-h",
                "--version",
                "precompute",
                "export",
                "mesh",
                "inspect",
                "reflectance --method reference",
                "reflectance --method=reference --patch blaze",
                "brdf-map --help",
                "view -h"
            })
    void whatDrawsNothingGetsNoScreen(String commandLine) throws Exception {
        String[] arguments = commandLine.isEmpty() ? new String[0] : commandLine.split(" ", -1);

        SunbeamResult result = command(arguments).run().ended(0);
        assertThat(result.stdout()).as("%s", result).startsWith("screen none");
    }

    @ParameterizedTest
    @CsvSource({"INT, 130", "TERM, 143", "HUP, 129"})
    void aSignalReachesTheViewer(String signal, int exitCode) throws Exception {
        installJava("jdk", "17.0.1", "exec sleep 60");

        try (RunningSunbeam running =
                command("view").with("DISPLAY", "elsewhere:0").start()) {
            assertThat(running.firstLine()).startsWith("screen elsewhere:0");
            running.signal(signal);

            assertThat(running.end(PATIENCE).exitCode()).isEqualTo(exitCode);
        }
    }

    @Test
    void tooFewOpenFilesAreTold() throws Exception {
        Path limited = folder.resolve("limited");
        Files.writeString(limited, "#!/bin/sh\nulimit -n 64\nexec '" + launcher() + "' \"$@\"\n");
        assertThat(limited.toFile().setExecutable(true)).isTrue();

        SunbeamResult result = equip(Sunbeam.launcher(limited, "inspect")).run().ended(SET_UP_FAILED);
        assertThat(result.stderr())
                .startsWith("sunbeam: only 64 files may be open at once")
                .hasLineCount(1);
    }

    /** The kernel refuses memory to Java, which would say so on standard output. */
    @Test
    void aJavaThatCannotStartSaysSoOnStandardError() throws Exception {
        Path limited = folder.resolve("limited");
        Files.writeString(
                limited,
                "#!/bin/sh\nulimit -v 3000000\nexec '" + Sunbeam.repository().resolve("sunbeam") + "' \"$@\"\n");
        assertThat(limited.toFile().setExecutable(true)).isTrue();

        SunbeamResult result =
                Sunbeam.launcher(limited, "inspect", "blaze", "--json").run().ended(1);
        assertThat(result.stdout()).isEmpty();
        assertThat(result.stderr()).contains("initialization of VM");
    }

    @Test
    void optionsWithWhichJavaDoesNotStartAreOneLineOfStandardError() throws Exception {
        installJava(
                "jdk",
                "17.0.1",
                "echo '#'",
                "echo '# There is insufficient memory for the Java Runtime Environment to continue.'",
                "echo '# Native memory allocation (mmap) failed to map 966367641600 bytes.'",
                "exit 1");

        SunbeamResult result = command("inspect", "blaze", "--json")
                .with("SUNBEAM_JAVA_OPTIONS", "-Xms900g")
                .run()
                .ended(9);

        assertThat(result.stdout()).isEmpty();
        assertThat(result.stderr())
                .endsWith("sunbeam: Java does not start with the options of SUNBEAM_JAVA_OPTIONS or JAVA_TOOL_OPTIONS:"
                        + " There is insufficient memory for the Java Runtime Environment to continue.\n");
    }

    @Test
    void aWindowWhoseScreenHasGoneEndsInOneLine() throws Exception {
        installJava(
                "jdk",
                "17.0.1",
                "echo 'sunbeam: note: before' >&2",
                "echo 'Nativewindow X11 IOError: Display 0x1 (:98): Resource temporarily unavailable' >&2",
                "echo 'FATAL ERROR in native method: Nativewindow X11 IOError: Display 0x1 (:98)' >&2",
                "echo '\tat sun.awt.X11.XlibWrapper.XEventsQueued' >&2",
                "exit 1");

        SunbeamResult gone =
                command("view").with("DISPLAY", "elsewhere:0").run().ended(SunbeamResult.NO_GRAPHICS);
        assertThat(gone.stderr())
                .endsWith("sunbeam: note: before\nsunbeam: the X server of DISPLAY=elsewhere:0 has ended,"
                        + " and with it the window; start it again\n");
        installJava("jdk", "17.0.1", "echo 'sunbeam: wrong' >&2", "exit 4");
        SunbeamResult other =
                command("view").with("DISPLAY", "elsewhere:0").run().ended(4);
        assertThat(other.stderr()).endsWith("sunbeam: wrong\n").doesNotContain("X server");
    }

    /** Java's report of its death would stand among the results, so it is suppressed; the line is the launcher's. */
    @Test
    void aJavaThatDiesAmongResultsIsOneLine() throws Exception {
        installJava("jdk", "17.0.1", "kill -ABRT $$");
        SunbeamResult died = command("inspect", "blaze", "--json").run().ended(128 + 6);
        assertThat(died.stderr()).endsWith("sunbeam: Java has died (signal ABRT): no result is whole\n");

        installJava("jdk", "17.0.1", "echo 'sunbeam: wrong' >&2", "cat", "exit 4");
        SunbeamResult other = command("inspect", "blaze", "--json").run().ended(4);
        assertThat(other.stderr()).endsWith("sunbeam: wrong\n").doesNotContain("died");
    }

    @Test
    void theViewerWithoutAScreenSaysThatItNeedsOne() throws Exception {
        SunbeamResult result = command("view", "--patch", "blaze").run().ended(SunbeamResult.NO_GRAPHICS);
        assertThat(result.stdout()).isEmpty();
        assertThat(result.stderr())
                .startsWith("sunbeam: the viewer needs a screen")
                .contains("DISPLAY")
                .hasLineCount(1);
    }

    private record Screen(int display, ProcessHandle server) {
        /** Returns the screen that the sandbox's Java reports, and the X server among its descendants. */
        static Screen of(RunningSunbeam running) throws Exception {
            String line = running.firstLine();
            assertThat(line).startsWith("screen :");
            return new Screen(
                    Integer.parseInt(line.substring("screen :".length())),
                    running.process()
                            .descendants()
                            .filter(process ->
                                    process.info().command().orElse("").endsWith("/Xvfb"))
                            .findFirst()
                            .orElseThrow());
        }

        /** Fails unless the server's process and its socket both disappear soon. */
        void assertGone() throws Exception {
            RunningSunbeam.await("the end of " + this, () -> !server.isAlive() && !Files.exists(socket()));
        }

        private Path socket() {
            return Path.of("/tmp/.X11-unix/X" + display);
        }
    }

    @Test
    void argumentsAndWorkingFolderReachTheProgramUnchanged() throws Exception {
        Path elsewhere = Files.createDirectories(folder.resolve("some where"));

        SunbeamResult result = command("inspect", "a b", "", "*.png", "../up")
                .in(elsewhere)
                .run()
                .ended(0);
        assertThat(result.stdout().lines().skip(1))
                .startsWith(elsewhere.toRealPath().toString())
                .endsWith("sunbeam.app.Main", "inspect", "a b", "", "*.png", "../up");
    }

    @Test
    void findsItsRepositoryThroughASymbolicLinkAndBlanks() throws Exception {
        Path link = folder.resolve("sunbeam link");
        Files.createSymbolicLink(link, launcher());

        SunbeamResult result = equip(Sunbeam.launcher(link, "inspect")).run();

        Path repository = repository().toRealPath();
        result.ended(0);
        assertThat(result.stdout().lines())
                .contains("-Dsunbeam.home=" + repository)
                .anyMatch(line -> line.matches(Pattern.quote(repository + "/app/target/run/") + "([-0-9]+)/\\*:"
                        + Pattern.quote(repository + "/app/target/run/") + "\\1/lib/\\*"));
    }

    /** Java would warn, on standard output if it may, about a class archive that was made for another folder. */
    @Test
    void aCopiedCheckoutHasAClassArchiveOfItsOwnAndJavaIsSilentAboutIt() throws Exception {
        command("inspect").run();
        Path copied = folder.resolve("copied");
        Process copying = new ProcessBuilder("cp", "-a", repository().toString(), copied.toString()).start();
        assertThat(copying.waitFor()).isZero();

        SunbeamResult result =
                equip(Sunbeam.launcher(copied.resolve("sunbeam"), "inspect")).run();

        Path runs = copied.toRealPath().resolve("app/target/run");
        assertThat(result.stdout().lines())
                .contains("-Xlog:disable", "-Xlog:all=error:stderr")
                .anyMatch(line -> line.matches(
                        "-XX:SharedArchiveFile=" + Pattern.quote(runs.toString()) + "/[-0-9]+/classes.jsa"));
    }

    /** Mesa maps its cache of shaders into memory: on a full disk that would kill Java. */
    @Test
    void aFullDiskNeitherKillsJavaNorDoesADeadJavaLeaveFilesInTheUsersFolder() throws Exception {
        installJava("jdk", "17.0.1", "echo \"Mesa $MESA_SHADER_CACHE_DISABLE $MESA_GLSL_CACHE_DISABLE\"");
        installProgram("df", "echo Filesystem", "echo /dev/disk 100000000 99999000 1000 100% /");

        assertThat(command("brdf-map")
                        .with("DISPLAY", "elsewhere:0")
                        .run()
                        .stdout()
                        .lines())
                .contains(
                        "-XX:ErrorFile=/dev/null", "-XX:-CreateCoredumpOnCrash", "-XX:-UsePerfData", "Mesa true true");
    }

    /** Java writes the report of its fatal error to standard output, whatever its options. */
    @ParameterizedTest
    @CsvSource({
        "--json, true",
        "--output -, true",
        "--output=-, true",
        "--output colors.csv, false",
        "--csv=-x --jsonx, false"
    })
    void aDyingJavaIsSilentWhereResultsGoToStandardOutput(String words, boolean silent) throws Exception {
        List<String> arguments = new ArrayList<>(List.of("inspect", "blaze"));
        arguments.addAll(List.of(words.split(" ")));
        assertThat(command(arguments.toArray(String[]::new))
                        .run()
                        .stdout()
                        .lines()
                        .anyMatch("-XX:+SuppressFatalErrorMessage"::equals))
                .isEqualTo(silent);
    }

    /** A shell with {@code set -f} passes that on in SHELLOPTS. */
    @Test
    void aShellWithoutPatternsStartsTheProgram() throws Exception {
        SunbeamResult result =
                command("inspect").with("SHELLOPTS", "noglob:noclobber").run().ended(0);
        assertThat(result.stdout()).contains("sunbeam.app.Main");
    }

    @Test
    void aFolderThatHasGoneIsALineOfOurs() throws Exception {
        Process process = new ProcessBuilder(
                        "bash",
                        "-c",
                        "mkdir gone; cd gone; rmdir ../gone; exec \"$0\" inspect",
                        launcher().toString())
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();

        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                .endsWith("sunbeam: the current folder does not exist any more: change to another (cd)\n");
        assertThat(process.waitFor()).isEqualTo(2);
    }

    @Test
    void aPathWithoutBashIsALineOfOurs() throws Exception {
        SunbeamResult result =
                command("inspect").with("PATH", folder.toString()).run().ended(7);
        assertThat(result.stderr())
                .isEqualTo("sunbeam: there is no bash on the PATH (" + folder + "); add the folder that has it\n");
    }

    @Test
    void passesOverAJavaThatIsTooOld() throws Exception {
        installJava("old jdk", "11.0.2", "exit 11");
        installJava("jdk", "17.0.1", "exit 17");
        String path = folder.resolve("jdk/bin") + ":" + folder.resolve("programs") + ":" + System.getenv("PATH");

        command("inspect")
                .with("JAVA_HOME", folder.resolve("old jdk").toString())
                .with("PATH", path)
                .run()
                .ended(17);
    }
}
