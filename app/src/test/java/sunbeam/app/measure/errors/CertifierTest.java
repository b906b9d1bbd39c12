package sunbeam.app.measure.errors;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ExactLight.Quadrature;

/** On a picture of one row: the plane of incidence of a sawtooth, where its orders lie. */
final class CertifierTest {
    private static final int WIDTH = 60;

    private static ExactLight reference;
    private static float[] exact;

    @BeforeAll
    static void drawTheExactPicture() {
        double[] heights =
                IntStream.range(0, 40).mapToDouble(i -> 250e-9 * i / 40).toArray();
        HeightMap map = new HeightMap(40, 1, 62.5e-9, 2.5e-6, heights);
        reference = GaussianArea.STANDARD.over(map, CieTable.load());
        exact = new float[3 * WIDTH];
        Arrays.fill(exact, Float.NaN);
        // The last ten pixels show no surface.
        for (int pixel = 0; pixel < WIDTH - 10; pixel++) {
            DirectionPair pair = pair(pixel);
            double[] xyz = reference.xyz(pair, Quadrature.INTEGRATED);
            for (int c = 0; c < 3; c++) {
                exact[3 * pixel + c] = (float) (xyz[c] * Gain.relativeRadiance(pair));
            }
        }
    }

    private static DirectionPair pair(int pixel) {
        double x = (2.0 * pixel + 1) / WIDTH - 1;
        return new DirectionPair(Direction.ofDegrees(0, 0), Direction.ofDisc(x, 0));
    }

    private static Certificate certify(float[] xyz, int count) {
        return new Certifier(
                        reference, CertifierTest::pair, pair -> 1, new Environment(Map.of(), Path.of("")).progress())
                .certify(new LinearPicture(WIDTH, 1, xyz), count, 1, 1e-3);
    }

    @Test
    void theExactPicturePasses() {
        Certificate certificate = certify(exact.clone(), 40);
        assertThat(certificate.places()).startsWith("40 random pixels, at most a quarter of them dark");
        assertThat(certificate.relative().count()).isPositive();
        // Rounding to float32, 6e-8.
        assertThat(certificate.relative().maximum()).isLessThan(1e-7);
        assertThat(certificate.colorDifference().maximum()).isLessThan(1e-4);
        assertThat(certificate.missed()).isFalse();
    }

    @Test
    void aPictureThatIsTwoPercentTooBrightMissesAThousandth() {
        float[] bright = exact.clone();
        for (int i = 0; i < bright.length; i++) {
            bright[i] *= 1.02f;
        }
        Certificate certificate = certify(bright, 40);
        assertThat(certificate.missed()).isTrue();
        assertThat(certificate.relative().median()).isBetween(0.0199, 0.0201);
        assertThat(certificate.colorDifference().maximum()).isPositive();
        assertThat(certificate.comparison()).contains("0.02").contains("0.001");
    }

    @Test
    void missingLightIsFoundAndSoIsLightWhereThereIsNone() {
        float[] dark = exact.clone();
        Arrays.fill(dark, 0, 3 * (WIDTH - 10), 0);
        assertThat(certify(dark, 50).missed()).isTrue();
        float[] gray = exact.clone();
        Arrays.fill(gray, 0, 3 * (WIDTH - 10), 0.5f);
        assertThat(certify(gray, 50).missed()).isTrue();
    }

    @Test
    void aPictureMirroredLeftToRightIsWrong() {
        float[] mirrored = exact.clone();
        for (int pixel = 10; pixel < WIDTH - 10; pixel++) {
            System.arraycopy(exact, 3 * (WIDTH - 1 - pixel), mirrored, 3 * pixel, 3);
        }
        assertThat(certify(mirrored, 50).missed()).isTrue();
    }

    @Test
    void noMorePixelsAreEvaluatedThanThereAreAndTheSameSeedTakesTheSame() {
        Certificate certificate = certify(exact.clone(), 1000);
        assertThat(certificate.places()).startsWith((WIDTH - 10) + " random pixels");
        assertThat(certify(exact.clone(), 20)).isEqualTo(certify(exact.clone(), 20));
    }

    @Test
    void aBlackPictureOfNothingHasNothingToCompare() {
        float[] none = new float[3 * WIDTH];
        Arrays.fill(none, Float.NaN);
        Certificate certificate = certify(none, 10);
        assertThat(certificate.missed()).isFalse();
        assertThat(certificate.summary()).contains("nothing to compare");
    }
}
