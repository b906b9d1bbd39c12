package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.stream.LongStream;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

class SampleCommandTest extends CommandLineFixture {
    private static final int ROWS = 301;
    private static final int HEADER_BYTES = 128;

    private int sample(String output, String options) {
        return sunbeam("sample blaze --coherence-length 4um --tolerance 0.05 --output @" + output + " " + options);
    }

    private byte[] values(String file, String array) throws IOException {
        try (ZipFile zip = new ZipFile(folder.resolve(file).toFile())) {
            byte[] all = zip.getInputStream(zip.getEntry(array + ".npy")).readAllBytes();
            return Arrays.copyOfRange(all, HEADER_BYTES, all.length);
        }
    }

    @Test
    void thePartsAreTheWholeBitForBit() throws IOException {
        assertSuccess(sample("whole.npz", "--count " + ROWS));
        for (int part = 1; part <= 2; part++) {
            assertThat(sample(part + ".npz", "--count " + ROWS + " --task " + part + "/2"))
                    .isZero();
        }
        for (String array : new String[] {"light", "view", "xyz", "density"}) {
            ByteArrayOutputStream parts = new ByteArrayOutputStream();
            parts.write(values("1.npz", array));
            parts.write(values("2.npz", array));
            assertThat(parts.toByteArray()).isEqualTo(values("whole.npz", array));
        }
    }

    /** The plan is there before rows are compared and computed, which takes longer; the first words were a bar of progress. */
    @Test
    void thePlanComesFirst() {
        assertSuccess(sample("a.npz", "--count 10"));
        assertThat(err.toString()).startsWith("plan: table: ").contains("; 10 rows\n");
    }

    @ParameterizedTest
    @CsvSource({
        "a.npz, --count 0, --count",
        "a.npz, --count 10 --task 3/2, --task",
        "a.npz, --count 1 --task 1/2, --task",
        "a.npz, --count 1000000000, --count",
        "a.csv, --count 1, a.csv",
        "a.npz, --count 1 --channels spectral --illuminant A, --illuminant"
    })
    void whatCannotBeWrittenIsOneLineAndLeavesNothing(String output, String options, String words) {
        assertThat(sample(output, options)).isEqualTo(2);
        assertThat(err.toString()).contains(words).hasLineCount(1);
        assertThat(folder).isEmptyDirectory();
    }

    private static final int PAIRS = 200_000;
    private static final double WIDTH = 0.1;

    // Two orders, one of them dark at its middle.
    private final PairDensity density = new PairDensity(
            cell -> Math.exp(-Math.pow(PairDensity.radius(cell) / WIDTH, 2))
                    + (PairDensity.u(cell) > 0.7 && PairDensity.u(cell) < 0.8 ? 0.3 : 0),
            5);

    private DirectionPair pair(long row) {
        return density.pair(row, density.random(row));
    }

    private double estimate(ToDoubleFunction<DirectionPair> integrand) {
        return LongStream.range(0, PAIRS)
                .mapToObj(this::pair)
                .mapToDouble(pair -> integrand.applyAsDouble(pair) / density.at(pair))
                .average()
                .orElseThrow();
    }

    private static double cosines(DirectionPair pair) {
        return pair.cosThetaI() * pair.cosThetaR();
    }

    /** Integrates over pairs drawn evenly on two discs, that is, over solid angles weighted by cosines. */
    @Test
    void theDensityIntegratesToOne() {
        SplittableRandom random = new SplittableRandom(1);
        double sum = 0;
        int count = 0;
        while (count < PAIRS) {
            double[] x = random.doubles(4, -1, 1).toArray();
            if (Math.hypot(x[0], x[1]) < 1 && Math.hypot(x[2], x[3]) < 1) {
                DirectionPair pair = new DirectionPair(Direction.ofDisc(x[0], x[1]), Direction.ofDisc(x[2], x[3]));
                sum += density.at(pair) / cosines(pair);
                count++;
            }
        }
        // The density's deviation is five times its mean; three standard errors are 3 * 5 / sqrt(2e5).
        assertThat(sum / count * Math.PI * Math.PI).isCloseTo(1, within(0.035));
    }

    /** Integrates a flat mirror's light: the discs' common area times exp(-r^2 / width^2). */
    @Test
    void meansByTheDensityAreIntegrals() {
        double exact = 0;
        int steps = 20_000;
        for (int i = 0; i < steps; i++) {
            double radius = 2 * (i + 0.5) / steps;
            double half = radius / 2;
            double shared = 2 * (Math.acos(half) - half * Math.sqrt(1 - half * half));
            exact += 2 * Math.PI * radius * 2 / steps * shared * Math.exp(-Math.pow(radius / WIDTH, 2));
        }
        double light = estimate(
                pair -> cosines(pair) * Math.exp(-(pair.u() * pair.u() + pair.v() * pair.v()) / (WIDTH * WIDTH)));
        // Most rows miss the order, so f / p has a deviation of three times its mean; the limit is three standard
        // errors.
        assertThat(light / exact).isCloseTo(1, within(0.02));
        // f / p is at most pi^2 / background; its deviation is 1.7 times the mean.
        assertThat(estimate(SampleCommandTest::cosines)).isCloseTo(Math.PI * Math.PI, within(0.12));
    }

    /** Rows are stratified: of any consecutive rows the background has its share, within two rows. */
    @Test
    void theBackgroundHasItsShareOfAnyRows() {
        long background = LongStream.range(70_000, 71_000)
                .mapToObj(this::pair)
                .filter(pair -> Math.hypot(pair.u(), pair.v()) > 0.5 && !(pair.u() > 0.69 && pair.u() < 0.81))
                .count();
        // Of the 250 background rows a share of 0.84 lies so, with a deviation of 6; the limit is four deviations.
        assertThat(background).isBetween(186L, 234L);
    }
}
