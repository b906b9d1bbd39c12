package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.TimeUnit;

/** Other programs that read Sunbeam's files. The tests of a program are skipped if it is not installed. */
final class OtherPrograms {
    /** Ten times what the slowest program takes (Mitsuba: 12 s beside eight busy processes). */
    private static final long LIMIT_SECONDS = 120;

    private static final Path ANYWHERE = Path.of(System.getProperty("java.io.tmpdir"));

    private OtherPrograms() {}

    static void requirePython(String module) throws InterruptedException {
        requirePython(module, "import " + module);
    }

    /** Mitsuba's LLVM variants abort where LLVM is older than its minimum of two numbers. */
    static void requireMitsuba() throws InterruptedException {
        requirePython(
                "mitsuba and LLVM 17 or newer",
                "import drjit, mitsuba; mitsuba.set_variant('llvm_ad_rgb');"
                        + " print(drjit.minimum(drjit.arange(mitsuba.Float, 9), 1))");
    }

    private static void requirePython(String what, String program) throws InterruptedException {
        assumeTrue(run(ANYWHERE, List.of("python3", "-c", program)) != null, "skipped: no python3 with " + what);
    }

    static void requireChromium() throws InterruptedException {
        assumeTrue(run(ANYWHERE, List.of("chromium", "--version")) != null, "skipped: no chromium");
    }

    static String python(Path folder, String... arguments) throws InterruptedException {
        return said(folder, List.of("python3"), arguments);
    }

    /** Runs a browser and returns its output; screenshots go into the folder. The page's time is virtual, so that it draws completely. */
    static String chromium(Path folder, String... arguments) throws InterruptedException {
        return said(
                folder,
                List.of(
                        "chromium",
                        "--headless",
                        "--no-sandbox",
                        "--user-data-dir=" + folder.resolve("browser"),
                        "--use-gl=angle",
                        "--use-angle=swiftshader",
                        "--enable-unsafe-swiftshader",
                        "--hide-scrollbars",
                        "--virtual-time-budget=20000"),
                arguments);
    }

    private static String said(Path folder, List<String> program, String... arguments) throws InterruptedException {
        List<String> command = new ArrayList<>(program);
        command.addAll(List.of(arguments));
        String said = run(folder, command);
        assertThat(said).as("%s", command).isNotNull();
        return said;
    }

    /**
     * Runs a program to its end.
     *
     * @return its output, or null if it is not installed or fails
     * @throws AssertionError if it does not end in time
     */
    private static String run(Path folder, List<String> command) throws InterruptedException {
        Path output = folder.resolve("output-" + UUID.randomUUID());
        try {
            ProcessBuilder builder = new ProcessBuilder(command)
                    .directory(folder.toFile())
                    .redirectErrorStream(true)
                    .redirectOutput(output.toFile());
            // These programs need no screen, and a browser would use one.
            builder.environment().remove("DISPLAY");
            Process process = builder.start();
            try {
                boolean ended = process.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS);
                assertThat(ended)
                        .as("%s ends within %d s; until then: %s", command, LIMIT_SECONDS, Files.readString(output))
                        .isTrue();
                return process.exitValue() == 0 ? Files.readString(output) : null;
            } finally {
                process.descendants().forEach(ProcessHandle::destroyForcibly);
                process.destroyForcibly();
            }
        } catch (IOException absent) {
            return null;
        } finally {
            output.toFile().delete();
        }
    }
}
