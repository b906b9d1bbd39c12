package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.cli.Certificate.Limits;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ExactLight.Quadrature;

/** Statistics of errors and their limits; certificates of tables and of pictures. */
final class CertificateTest {
    private static final int ROWS = 200;

    private static double exact(int row) {
        return 1.0 / (row + 1);
    }

    private static Certificate certify(IntToDoubleFunction computed, IntToDoubleFunction exact, int count) {
        return Certificate.ofRows(
                new Environment(Map.of(), Path.of("")).progress(),
                ROWS,
                count,
                row -> new Comparison(
                        new double[] {computed.applyAsDouble(row)}, new double[] {exact.applyAsDouble(row)}, 1),
                "power",
                1e-3);
    }

    @Test
    void theExactTablePassesAndSaysWhatWasCompared() {
        Certificate certificate = certify(CertificateTest::exact, CertificateTest::exact, 50);
        assertThat(certificate.missed()).isFalse();
        assertThat(certificate.relative().maximum()).isZero();
        assertThat(certificate.summary())
                .startsWith("50 random rows, 50 of them")
                .contains("relative error of power")
                .doesNotContain("CIEDE2000");
    }

    @Test
    void rowsAreDrawnOnceAndNoMoreThanThereAre() {
        Set<Integer> seen = ConcurrentHashMap.newKeySet();
        Certificate certificate = certify(
                CertificateTest::exact,
                row -> {
                    assertThat(seen.add(row)).as("row %d", row).isTrue();
                    return exact(row);
                },
                10_000);
        assertThat(certificate.places()).isEqualTo("all 200 rows");
        assertThat(seen).hasSize(ROWS);
    }

    @Test
    void darkRowsAreNotComparedUnlessTheTableHasLightThere() {
        Certificate dark = certify(row -> 1e-12, row -> 2e-12, ROWS);
        assertThat(dark.relative().count()).isZero();
        assertThat(dark.missed()).isFalse();
        assertThat(certify(row -> 1e-3, row -> 2e-12, ROWS).missed()).isTrue();
        assertThat(certify(row -> Double.NaN, CertificateTest::exact, 20).missed())
                .isTrue();
    }

    @Test
    void errorsThatAreNoNumbersAreInfinite() {
        assertThat(ErrorStatistics.of().median()).isNaN();
        assertThat(ErrorStatistics.of(1).pairs()).isEqualTo("1 pair of directions");
        assertThat(ErrorStatistics.of(Double.NaN, 0, 0).maximum()).isInfinite();
    }

    @ParameterizedTest
    @CsvSource({
        "1e-3, 3e-3, true",
        "1.01e-3, 2e-3, false",
        "0.5e-3, 3.1e-3, false",
        "Infinity, Infinity, false",
    })
    void theMedianMayReachTheToleranceAndThePercentileThreeTimesIt(double median, double percentile95, boolean holds) {
        assertThat(Limits.of(1e-3).hold(new ErrorStatistics(9, median, percentile95, 1, 1, 0)))
                .isEqualTo(holds);
        assertThat(Limits.of(1e-3).hold(ErrorStatistics.of())).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"0.15, true", "0.21, false"})
    void anExportThatMissesAtThe95thPercentileAloneMisses(double largest, boolean holds) {
        double[] errors = new double[100];
        Arrays.fill(errors, 0, 90, 0.01);
        Arrays.fill(errors, 90, 100, largest);
        assertThat(Limits.ofExport(0.02).hold(ErrorStatistics.of(errors))).isEqualTo(holds);
    }

    @Test
    void aColorsErrorIsRelativeToItsStrongestChannel() {
        double error = new Comparison(new double[] {0.5, 0.2, 0.02}, new double[] {0.5, 0.21, 0.01}, 1).relative();
        assertThat(error).isCloseTo(0.02, within(1e-12));
    }

    @Test
    void fewErrorsAreReportedAsUncertain() {
        assertThat(ErrorStatistics.of(new double[10]).doubt()).as("0.95^10").contains("with a chance of 60 %");
        assertThat(ErrorStatistics.of(new double[59]).doubt())
                .as("0.95^59 is 4.8 %")
                .isEmpty();
        assertThat(ErrorStatistics.of().doubt()).isEmpty();
    }

    private static final int WIDTH = 60;

    private static ExactLight REFERENCE;
    private static float[] EXACT;

    @BeforeAll
    static void drawTheExactPicture() {
        double[] heights =
                IntStream.range(0, 40).mapToDouble(i -> 250e-9 * i / 40).toArray();
        HeightMap map = new HeightMap(40, 1, 62.5e-9, 2.5e-6, heights);
        REFERENCE = GaussianArea.STANDARD.over(map, CieTable.load());
        EXACT = new float[3 * WIDTH];
        Arrays.fill(EXACT, Float.NaN);
        // The last ten pixels show no surface.
        for (int pixel = 0; pixel < WIDTH - 10; pixel++) {
            DirectionPair pair = pair(pixel);
            double[] xyz = REFERENCE.xyz(pair, Quadrature.INTEGRATED);
            for (int c = 0; c < 3; c++) {
                EXACT[3 * pixel + c] = (float) (xyz[c] * Gain.relativeRadiance(pair));
            }
        }
    }

    private static DirectionPair pair(int pixel) {
        double x = (2.0 * pixel + 1) / WIDTH - 1;
        return new DirectionPair(Direction.ofDegrees(0, 0), Direction.ofDisc(x, 0));
    }

    private static Certificate certifyPicture(float[] xyz, int count) {
        return new Certificate.Certifier(
                        REFERENCE,
                        List.of(CertificateTest::pair),
                        Gain::relativeRadiance,
                        new Environment(Map.of(), Path.of("")).progress())
                .certify(new LinearPicture(WIDTH, 1, xyz), count, 1, Certificate.Limits.of(1e-3));
    }

    @Test
    void theExactPicturePasses() {
        Certificate certificate = certifyPicture(EXACT.clone(), 40);
        assertThat(certificate.places()).startsWith("40 random pixels, at most a quarter of them dark");
        assertThat(certificate.relative().count()).isPositive();
        // Rounding to float32, 6e-8.
        assertThat(certificate.relative().maximum()).isLessThan(1e-7);
        assertThat(certificate.colorDifference().maximum()).isLessThan(1e-4);
        assertThat(certificate.missed()).isFalse();
    }

    @Test
    void aPictureThatIsTwoPercentTooBrightMissesAThousandth() {
        float[] bright = EXACT.clone();
        for (int i = 0; i < bright.length; i++) {
            bright[i] *= 1.02f;
        }
        Certificate certificate = certifyPicture(bright, 40);
        assertThat(certificate.missed()).isTrue();
        assertThat(certificate.relative().median()).isBetween(0.0199, 0.0201);
        assertThat(certificate.colorDifference().maximum()).isPositive();
        assertThat(certificate.comparison()).contains("0.02").contains("0.001");
    }

    @Test
    void missingLightIsFoundAndSoIsLightWhereThereIsNone() {
        float[] dark = EXACT.clone();
        Arrays.fill(dark, 0, 3 * (WIDTH - 10), 0);
        assertThat(certifyPicture(dark, 50).missed()).isTrue();
        float[] gray = EXACT.clone();
        Arrays.fill(gray, 0, 3 * (WIDTH - 10), 0.5f);
        assertThat(certifyPicture(gray, 50).missed()).isTrue();
    }

    @Test
    void noMorePixelsAreEvaluatedThanThereAreAndTheSameSeedTakesTheSame() {
        Certificate certificate = certifyPicture(EXACT.clone(), 1000);
        assertThat(certificate.places()).startsWith((WIDTH - 10) + " random pixels");
        assertThat(certifyPicture(EXACT.clone(), 20)).isEqualTo(certifyPicture(EXACT.clone(), 20));
    }

    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(65e-6);

    @Test
    void aimedDirectionsHitOrdersWithinTheWidthOfTheWindow() {
        DirectionSampler sampler = new DirectionSampler(new HeightMap(4, 2, 0.625e-6, 1e-6, new double[8]), WINDOW, 3);
        double sigma = WINDOW.sigmaFrequency();
        for (int i = 0; i < 300; i++) {
            DirectionQuery query = sampler.aimed();
            DirectionPair pair = query.pair();
            double fx = pair.u() / query.wavelength();
            double fy = pair.v() / query.wavelength();
            // Six standard deviations of a normal deviate; orders lie 41 and 51 of them apart.
            assertThat(Math.abs(fx - Math.rint(fx * 2.5e-6) / 2.5e-6)).isLessThan(6 * sigma);
            assertThat(Math.abs(fy - Math.rint(fy * 2e-6) / 2e-6)).isLessThan(6 * sigma);
        }
    }

    @Test
    void viewsOfALightKeepTheLightEvenWhereItSendsNoOrderUpwards() {
        Direction grazing = Direction.ofDegrees(89.9, 30);
        // Narrower than half a wavelength: there is the specular order alone, which grazes, too.
        HeightMap narrow = new HeightMap(2, 2, 50e-9, 50e-9, new double[4]);
        DirectionSampler sampler = new DirectionSampler(narrow, WINDOW, 5, Optional.of(grazing));
        for (int i = 0; i < 20; i++) {
            for (DirectionQuery query : List.of(sampler.uniform(), sampler.aimed())) {
                assertThat(query.pair().wi()).isEqualTo(grazing);
                assertThat(query.pair().wr().z()).isPositive();
            }
        }
    }
}
