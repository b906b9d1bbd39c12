package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Programs of others that read what Sunbeam wrote. Where one is not installed, its tests are skipped with a word. */
final class OtherPrograms {
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

    /** What Python says. */
    static String python(Path folder, String... arguments) throws InterruptedException {
        return said(folder, List.of("python3"), arguments);
    }

    /** What a browser says, whose screenshots go into the folder. Time stands still in the page until it has drawn. */
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

    /** What a program says, or null where there is none, or it fails. */
    private static String run(Path folder, List<String> command) throws InterruptedException {
        try {
            Process process = new ProcessBuilder(command)
                    .directory(folder.toFile())
                    .redirectErrorStream(true)
                    .start();
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return process.waitFor(60, TimeUnit.SECONDS) && process.exitValue() == 0 ? said : null;
        } catch (IOException absent) {
            return null;
        }
    }
}
