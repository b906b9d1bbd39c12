package sunbeam.app.commands.evaluate;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.Sunbeam;
import sunbeam.app.terminal.Environment;

/** Scans that a scanner has spoiled, and lattices: 10 um, 128 x 128 samples, lines aslant. */
final class FaultyScansTest {
    private static final int SAMPLES = 128;

    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    /** Heights in nanometres at a column and a row, with noise. */
    private Path scan(String name, DoubleBinaryOperator height) throws IOException {
        SplittableRandom random = new SplittableRandom(4);
        StringBuilder text = new StringBuilder();
        for (int row = 0; row < SAMPLES; row++) {
            for (int column = 0; column < SAMPLES; column++) {
                text.append(height.applyAsDouble(column, row) + random.nextGaussian())
                        .append(column + 1 < SAMPLES ? "\t" : "\n");
            }
        }
        return Files.writeString(folder.resolve(name), text);
    }

    private int run(String... arguments) {
        List<String> all = new ArrayList<>(List.of(arguments));
        all.addAll(List.of("--width", "10um", "--height-unit", "nm"));
        return new Sunbeam(new Environment(Map.of(), folder), new PrintWriter(out), new PrintWriter(err))
                .run(all.toArray(String[]::new));
    }

    private int evaluate(Path scan, String... more) {
        List<String> all = new ArrayList<>(List.of("evaluate", "--patch", scan.toString(), "--method", "bins"));
        all.addAll(List.of(
                "--wavelengths",
                "380:780:50",
                "--output",
                folder.resolve("result").toString()));
        all.addAll(List.of(more));
        return run(all.toArray(String[]::new));
    }

    /** A wave of a period in samples. */
    private static double wave(double column, double row, double samples, double degrees) {
        double angle = Math.toRadians(degrees);
        return Math.cos(2 * Math.PI / samples * (column * Math.cos(angle) - row * Math.sin(angle)));
    }

    /** 1004 nm, 95 % interval 943 to 1074 nm, was told of a scan whose last two fifths are one row. */
    @Test
    void aScanThatWasStoppedTellsNoPeriodUntilItIsCropped() throws IOException {
        double[] last = new double[SAMPLES];
        SplittableRandom random = new SplittableRandom(1);
        Path scan = folder.resolve("stopped.txt");
        StringBuilder text = new StringBuilder();
        for (int row = 0; row < SAMPLES; row++) {
            for (int column = 0; column < SAMPLES; column++) {
                last[column] = row < 80 ? 40 * wave(column, row, 12.8, 30) + random.nextGaussian() : last[column];
                text.append(last[column]).append(column + 1 < SAMPLES ? "\t" : "\n");
            }
        }
        Files.writeString(scan, text);
        assertThat(evaluate(scan)).isEqualTo(4);
        assertThat(err.toString())
                .contains(
                        "stopped: no period is told of a scan of which rows 81 to 128 of 128",
                        "--crop 0:10um,3.75um:10um");
        assertThat(evaluate(scan, "--crop", "0:10um,3.75um:10um"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString()).containsPattern("period +1000");
    }

    /** "No periodicity" was the reason, and a levelling the remedy, where rows that were never scanned hide the lines. */
    @Test
    void rowsThatWereNotScannedAreTheReasonWhereTheyHideThePeriod() throws IOException {
        SplittableRandom random = new SplittableRandom(1);
        Path scan = folder.resolve("begun.txt");
        StringBuilder text = new StringBuilder();
        for (int row = 0; row < SAMPLES; row++) {
            for (int column = 0; column < SAMPLES; column++) {
                text.append(row < 50 ? 40 * wave(column, row, 12.8, 30) + random.nextGaussian() : -400)
                        .append(column + 1 < SAMPLES ? "\t" : "\n");
            }
        }
        Files.writeString(scan, text);
        String reason = "no period is told of a scan of which rows 51 to 128 of 128";
        assertThat(evaluate(scan)).isEqualTo(4);
        assertThat(err.toString()).contains("begun: " + reason, "--crop 0:10um,6.");
        assertThat(err.toString()).doesNotContain("no order", "--level");
        String picture = folder.resolve("i.png").toString();
        assertThat(run("inspect", scan.toString(), "--json", "--output", picture))
                .isZero();
        JsonNode told = new ObjectMapper().readTree(out.toString());
        assertThat(told.at("/periodNotTold").textValue()).startsWith(reason);
    }

    /** Every second row is shifted by a third of a period: the wave stays, weaker, and its image is an alias that is not told. */
    @Test
    void traceAndRetraceInTurnTellNoAlias() throws IOException {
        Path scan = scan("mixed.txt", (column, row) -> 40 * wave(column + row % 2 * 4, row, 12.8, 30));
        assertThat(evaluate(scan)).as(err.toString()).isZero();
        JsonNode report =
                new ObjectMapper().readTree(folder.resolve("result.json").toFile());
        assertThat(report.at("/period/low_nm").doubleValue()).isBetween(900.0, 1000.0);
        assertThat(report.at("/period/high_nm").doubleValue()).isBetween(1000.0, 1100.0);
    }

    /** Half of the slip's phase over half of the scan draws the wave aside by up to 3 %: the interval holds what the rows tell. */
    @Test
    void aSlipWidensTheInterval() throws IOException {
        Path scan = scan("slip.txt", (column, row) -> 40 * wave(column + (row < 50 ? 0 : 4), row, 12.8, 30));
        assertThat(evaluate(scan)).as(err.toString()).isZero();
        JsonNode report =
                new ObjectMapper().readTree(folder.resolve("result.json").toFile());
        assertThat(report.at("/period/low_nm").doubleValue()).isBetween(940.0, 1000.0);
        assertThat(report.at("/period/high_nm").doubleValue()).isBetween(1000.0, 1060.0);
    }

    /** 180 nm are 2.3 samples: no heights tell them from an alias. */
    @Test
    void fewSamplesAPeriodMayBeAnAlias() throws IOException {
        Path scan = scan("fine.txt", (column, row) -> 20 * wave(column, row, 3.1, 0));
        assertThat(evaluate(scan)).isEqualTo(4);
        assertThat(err.toString()).contains("too few samples: a wave of about 242 nm has 3.1 of them");
    }

    /** The light was sent along the strongest wave, and the period was that of another. */
    @Test
    void aPeriodThatIsAskedForIsLookedForAlongItsWave() throws IOException {
        Path scan = scan(
                "crossed.txt", (column, row) -> 30 * wave(column, row, 12.8, 10) + 15 * wave(column, row, 7.68, 70));
        assertThat(evaluate(scan, "--azimuth", "auto", "--period", "600nm"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString())
                .containsPattern("light at 75 degrees, azimuth (70|69\\.9|-110)")
                .containsPattern("period +(599|600|601)");
    }

    /** Both waves are as strong: either is right. */
    @Test
    void aLatticeTellsOneOfItsWaves() throws IOException {
        Path scan =
                scan("lattice.txt", (column, row) -> 20 * (wave(column, row, 12.8, 10) + wave(column, row, 12.8, 70)));
        assertThat(evaluate(scan, "--azimuth", "auto")).as(err.toString()).isZero();
        assertThat(out.toString()).containsPattern("A grating of (1.000|0.99|1.00)[0-9]* um .* across (10|70) degrees");
    }
}
