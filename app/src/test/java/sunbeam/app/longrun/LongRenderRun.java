package sunbeam.app.longrun;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.cli.Sunbeam;
import sunbeam.app.terminal.Environment;

/**
 * An animation of many small frames, in one process. Not among the tests: {@code ./sunbeam test -Dtest=LongRenderRun
 * -Dsunbeam.frames=2000}.
 */
final class LongRenderRun {
    @TempDir
    private Path folder;

    @Test
    void memoryResourcesAndFilesDoNotGrowWithFrames() throws Exception {
        int frames = Integer.getInteger("sunbeam.frames", 2000);
        StringWriter err = new StringWriter();
        Sunbeam sunbeam = new Sunbeam(
                new Environment(Map.of("XDG_CACHE_HOME", folder.resolve("cache").toString()), folder),
                new PrintWriter(new StringWriter()),
                new PrintWriter(err));
        Path output = folder.resolve("frames");
        try (Footprint footprint = new Footprint(1000)) {
            int code = sunbeam.run(
                    "render",
                    "elaphe",
                    "--turntable",
                    "" + frames,
                    "--size",
                    "48x36",
                    "--output",
                    output.toString(),
                    "--method",
                    "full",
                    "--tolerance",
                    "0.01",
                    "--mesh",
                    "cylinder",
                    "--texture",
                    "none");

            assertThat(code).as(err.toString()).isZero();
            try (Stream<Path> files = Files.list(output)) {
                assertThat(files.filter(file -> file.toString().endsWith(".png")))
                        .hasSize(frames);
            }
            // A collector of garbage may wait, so the heap says little; what leaks with each frame is far more than
            // this.
            assertThat(footprint.growth(Footprint.Look::residentMebibytes))
                    .as("growth of memory / MiB")
                    .isLessThan(100 + 0.05 * frames);
            assertThat(footprint.growth(Footprint.Look::files))
                    .as("growth of open files")
                    .isLessThan(3);
        }
    }
}
