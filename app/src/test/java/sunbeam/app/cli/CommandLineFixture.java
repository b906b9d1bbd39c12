package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.cli.program.Sunbeam;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;

/** Test that runs command lines in this process, with a new folder as home and no environment variables. */
public abstract class CommandLineFixture {
    /** A lit plane with the colors of a grating. */
    protected static final String SCENE = """
            {
              "mesh": "plane",
              "patch": "blaze",
              "camera": { "position": ["-5 cm", "-10 cm", "40 cm"], "lookAt": ["0 m", "0 m", "0 m"] },
              "light": { "direction": [-0.2, 0.3, 0.9] },
              "texture": "none",
              "plan": { "method": "full", "tolerance": 0.05 },
              "weights": { "diffraction": 30, "texture": 0.2, "ambient": 0.1 }
            }
            """;

    @TempDir
    protected Path folder;

    protected final StringWriter out = new StringWriter();

    protected final StringWriter err = new StringWriter();

    /**
     * Runs a command line and returns its exit code. Words that begin with @ are files of the folder.
     *
     * @param line words with a blank between them
     * @param more further words, also with blanks in them
     */
    protected final int sunbeam(String line, String... more) {
        String[] words = Stream.concat(Arrays.stream(line.split(" ", -1)), Arrays.stream(more))
                .map(word -> word.startsWith("@") ? folder + "/" + word.substring(1) : word)
                .toArray(String[]::new);
        return new Sunbeam(new Environment(Map.of(), folder), new PrintWriter(out), new PrintWriter(err)).run(words);
    }

    /** Asserts that a command line ends with an exit code and one line with all of these words. */
    protected final void assertComplaint(ExitCode code, String line, String... words) {
        forgetOutput();
        assertThat(sunbeam(line)).as("%s: %s", line, err).isEqualTo(code.code());
        assertThat(err.toString()).contains(words).hasLineCount(1);
    }

    /** Returns the rows of a file of comma-separated numbers, without its head. */
    protected final double[][] rows(String name) throws IOException {
        return Files.readAllLines(folder.resolve(name)).stream()
                .skip(1)
                .map(line -> Arrays.stream(line.split(",", -1))
                        .mapToDouble(Double::parseDouble)
                        .toArray())
                .toArray(double[][]::new);
    }

    /** Returns the float32 at the end of a NumPy file. */
    protected final float[] floats(String name, int count) throws IOException {
        byte[] bytes = Files.readAllBytes(folder.resolve(name));
        float[] values = new float[count];
        ByteBuffer.wrap(bytes, bytes.length - 4 * count, 4 * count)
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer()
                .get(values);
        return values;
    }

    /** Writes a scan as text: a header, then a line for each row. */
    protected final Path scan(String name, String header, int columns, int rows, DoubleBinaryOperator heights)
            throws IOException {
        StringBuilder text = new StringBuilder(header);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                text.append(heights.applyAsDouble(column, row)).append(column < columns - 1 ? "\t" : "\n");
            }
        }
        return Files.writeString(folder.resolve(name), text);
    }

    /** Writes white noise of 60 nm, sixteen samples a micrometer, and returns the patch's options. */
    protected final String rough(int side) throws IOException {
        SplittableRandom random = new SplittableRandom(4);
        Path file = scan("rough.txt", "", side, side, (column, row) -> random.nextDouble(60));
        return file + " --height-unit nm --width " + side / 16 + "um";
    }

    protected final JsonNode readJson(String name) throws IOException {
        return new ObjectMapper().readTree(folder.resolve(name).toFile());
    }

    protected final void assertSuccess(int exitCode) {
        assertThat(exitCode).as("%s", err).isZero();
    }

    protected final void forgetOutput() {
        out.getBuffer().setLength(0);
        err.getBuffer().setLength(0);
    }
}
