package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The private screen that the launcher gives the program and removes afterwards. */
class LauncherScreenTest extends InSandbox {
    private static final int NO_SCREEN = 5;
    private static final Duration PATIENCE = Duration.ofSeconds(60);

    @ParameterizedTest
    @CsvSource({"INT, 130", "TERM, 143", "KILL, 137"})
    void aPrivateScreenEndsWhenTheProgramIsKilled(String signal, int exitCode) throws Exception {
        // A killed launcher passes no signal on, so Java draws to its end.
        installJava("jdk", "17.0.1", "exec sleep 2");

        try (RunningSunbeam running = command("brdf-map").start()) {
            Screen screen = Screen.of(running);
            assertThat(screen.isUp()).isTrue();
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
    void theViewerWithoutAScreenSaysThatItNeedsOne() throws Exception {
        SunbeamResult result = command("view", "--patch", "blaze").run().ended(NO_SCREEN);
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
                            .filter(Screen::isServer)
                            .findFirst()
                            .orElseThrow());
        }

        private static boolean isServer(ProcessHandle process) {
            return process.info().command().orElse("").endsWith("/Xvfb");
        }

        boolean isUp() {
            return server.isAlive() && Files.exists(socket());
        }

        /** Fails unless the server's process and its socket both disappear soon. */
        void assertGone() throws Exception {
            RunningSunbeam.await("the end of " + this, () -> !server.isAlive() && !Files.exists(socket()));
        }

        private Path socket() {
            return Path.of("/tmp/.X11-unix/X" + display);
        }
    }
}
