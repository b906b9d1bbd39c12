package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import jrtr.Tile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that need their own virtual machine: its end, its standard streams, its display, its libraries. */
@NeedsDisplay
class OwnJvmTest {
    @TempDir
    private Path folder;

    static final class Program {
        private Program() {}

        public static void main(String[] arguments) {
            try {
                RenderContext context = RenderContext.offscreen();
                System.out.println("rendered by " + context.info().renderer());
                context.close();
            } catch (GraphicsException failure) {
                System.out.println("failed: " + failure.getMessage());
            }
        }
    }

    private OwnJvm run(Map<String, String> environment, boolean headless) throws IOException, InterruptedException {
        return OwnJvm.run(Program.class, folder, environment, "-Djava.awt.headless=" + headless);
    }

    @Test
    void theVirtualMachineEndsByItselfAndSilently() throws IOException, InterruptedException {
        OwnJvm outcome = run(Map.of(), true);

        assertThat(outcome.output()).startsWith("rendered by ");
        assertThat(outcome.errors()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "'', true, DISPLAY is not set. Set DISPLAY",
        ":9999, true, DISPLAY=:9999 does not answer",
        ":9999, false, DISPLAY=:9999 does not answer"
    })
    void aMissingDisplayIsNamed(String display, boolean headless, String problem) throws Exception {
        OwnJvm outcome = run(Map.of("DISPLAY", display), headless);

        assertThat(outcome.output())
                .startsWith("failed: no display: " + problem)
                .hasLineCount(1);
        assertThat(outcome.errors()).isEmpty();
    }

    /** The variables are Mesa's; another driver ignores them and renders, which is right too. */
    @Test
    void aDriverThatIsTooOldOrMissingIsAFailureOnOneLineWithoutStackTraces() throws IOException, InterruptedException {
        Map<String, String> tooOld = Map.of("MESA_GL_VERSION_OVERRIDE", "2.1", "MESA_GLES_VERSION_OVERRIDE", "2.0");
        Map<String, String> missing =
                Map.of("LIBGL_DRIVERS_PATH", folder.resolve("nothing").toString());
        for (Map<String, String> environment : List.of(tooOld, missing)) {
            OwnJvm outcome = run(environment, true);

            assertThat(outcome.output()).as("%s", environment).matches("failed: no OpenGL 3.3 .*|rendered by .*");
            assertThat(outcome.errors()).doesNotContain("Exception", "    [0]: ");
        }
    }

    /** Prints each library that it loaded from the folder for temporary files, with the mode of that folder's child. */
    static final class Libraries {
        private Libraries() {}

        public static void main(String[] arguments) throws IOException {
            try (RenderContext context = RenderContext.offscreen()) {
                Path temporary = Path.of(System.getProperty("java.io.tmpdir")).toRealPath();
                System.out.println("rendered by " + context.info().renderer());
                for (String line : Files.readAllLines(Path.of("/proc/self/maps"))) {
                    int start = line.indexOf('/');
                    if (start > 0
                            && line.endsWith(".so")
                            && Path.of(line.substring(start)).startsWith(temporary)) {
                        Path library = temporary.relativize(Path.of(line.substring(start)));
                        Path top = temporary.resolve(library.getName(0));
                        System.out.println("library "
                                + PosixFilePermissions.toString(Files.getPosixFilePermissions(top)) + " "
                                + Files.getOwner(top).getName().equals(System.getProperty("user.name")) + " "
                                + library);
                    }
                }
            } catch (GraphicsException failure) {
                System.out.println("failed: " + failure.getMessage());
            }
        }
    }

    /** Creates JOGL's default folders in advance; as another user's, if this user is folder. */
    @Test
    void nothingIsLoadedFromAFolderThatAnotherUserMade() throws IOException, InterruptedException {
        assumeTrue(Files.exists(Path.of("/proc/self/maps")), "skipped: only Linux tells what was loaded");
        Path temporary = Files.createDirectory(folder.resolve("temporary"));
        Files.setPosixFilePermissions(temporary, PosixFilePermissions.fromString("rwxrwxrwx"));
        for (String name : List.of("jogamp_0000", "jogamp_0001")) {
            Path foreseen = Files.createDirectories(temporary.resolve(name).resolve("file_cache"));
            for (Path place : List.of(foreseen, foreseen.getParent())) {
                Files.setPosixFilePermissions(place, PosixFilePermissions.fromString("rwxrwxrwx"));
                if (System.getProperty("user.name").equals("root")) {
                    Files.setAttribute(place, "unix:uid", 65534); // "nobody" by custom
                }
            }
        }

        OwnJvm outcome = OwnJvm.run(
                Libraries.class,
                folder,
                // JOGL would try these next.
                Map.of("TMPDIR", temporary.toString(), "HOME", folder.toString()),
                "-Djava.awt.headless=true",
                "-XX:-UsePerfData",
                "-Djava.io.tmpdir=" + temporary);
        List<String> lines = outcome.output().lines().toList();

        assertThat(lines).first().asString().startsWith("rendered by ");
        assertThat(lines.subList(1, lines.size()))
                .isNotEmpty()
                .allMatch(line -> line.startsWith("library rwx------ true jrtr-libraries-"));
        try (Stream<Path> files = Files.walk(temporary)) {
            // Two folders each, and nothing left behind.
            assertThat(files.filter(file -> !file.equals(temporary))).hasSize(4);
        }
    }

    /** One thread draws and reads for about a second, then reads on; the other ends the process with status 7 during the first draw. */
    static final class Drawing {
        private Drawing() {}

        public static void main(String[] arguments) throws InterruptedException {
            CountDownLatch drawing = new CountDownLatch(1);
            Thread artist = new Thread(() -> draw(drawing));
            artist.setDaemon(true);
            artist.start();
            drawing.await();
            // Until the thread is in the middle of reading, which waits for the picture: a second of a software
            // renderer.
            Thread.sleep(200);
            System.out.println("ending");
            System.exit(7);
        }

        private static void draw(CountDownLatch drawing) {
            String code = """
                    #version 330 core
                    out vec4 color;
                    void main() {
                        float sum = 0.0;
                        for (int step = 0; step < 60000; step++) { sum += sin(gl_FragCoord.x + sum); }
                        color = vec4(sum);
                    }
                    """;
            try (RenderContext context = RenderContext.offscreen();
                    FloatTarget target = context.createFloatTarget("pixels", FloatTarget.Spec.color(64, 64))) {
                ShaderProgram program = context.createFullScreenProgram(
                        Rendering.library(Map.of("sum.frag", code)).load("sum.frag"));
                context.drawFullScreen(program, Map.of(), target, Tile.whole(64, 64));
                drawing.countDown();
                while (true) {
                    target.read(0);
                    System.out.println("read");
                }
            }
        }
    }

    @Test
    void theOperationUnderWayIsFinishedAndNoOtherBegins() throws Exception {
        OwnJvm ended = OwnJvm.run(Drawing.class, folder, Map.of(), "-Djava.awt.headless=true");

        assertThat(ended.exitCode()).isEqualTo(7);
        assertThat(ended.errors()).isEmpty();
        assertThat(ended.output().lines()).containsExactly("ending", "read");
    }

    /** What a program printed that ran in a virtual machine of its own. */
    private record OwnJvm(int exitCode, String output, String errors) {
        /**
         * Runs a program to its end.
         *
         * @param environment variables to set; an empty value removes a variable
         */
        static OwnJvm run(Class<?> program, Path folder, Map<String, String> environment, String... options)
                throws IOException, InterruptedException {
            Path output = folder.resolve("output");
            Path errors = folder.resolve("errors");
            List<String> command = new ArrayList<>();
            command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
            command.addAll(List.of(options));
            command.addAll(List.of("-cp", System.getProperty("java.class.path"), program.getName()));
            ProcessBuilder builder = new ProcessBuilder(command);
            environment.forEach((name, value) -> {
                builder.environment().remove(name);
                if (!value.isEmpty()) {
                    builder.environment().put(name, value);
                }
            });
            Process process = builder.redirectOutput(output.toFile())
                    .redirectError(errors.toFile())
                    .start();
            // A start takes about a second, a draw two; a thread that keeps the machine alive would do so for ever.
            boolean ended = process.waitFor(60, TimeUnit.SECONDS);
            process.destroyForcibly();
            assertThat(ended).as("the virtual machine ends by itself").isTrue();
            return new OwnJvm(
                    process.exitValue(),
                    Files.readString(output).strip(),
                    Files.readString(errors).strip());
        }
    }
}
