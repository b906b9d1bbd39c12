package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import jrtr.FloatTargetSpec;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.glsl.ShaderLibrary;
import org.joml.Vector3f;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.gpu.Shaders;

/** How pixels look into levels of colors (shaders/include/footprint.glsl), by the variance of what they look at. */
@NeedsDisplay
class FootprintTest {
    private static final double SIGMA = 1e-3;
    private static final int LEVELS = 9;
    private static final String TEXT = """
            #version 330 core
            #include "include/footprint.glsl"
            uniform vec3 alongX;
            uniform vec3 alongY;
            uniform float slopes;
            layout(location = 0) out vec4 color;
            void main() {
                Footprint footprint = footprintOf(vec3(0.3, 0.2, -1.1), alongX, alongY, slopes);
                int column = int(gl_FragCoord.x);
                color = column == 0 ? footprint.place : column == 1 ? footprint.wide : footprint.narrow;
            }
            """;

    private RenderContext context;

    /** Level, and places and change of (u, v) along either side. */
    private record Look(int level, int columns, double[] wide, int rows, double[] narrow) {
        /** Of evenly many places along a line, and of the level: variances along u and v, and mixed. */
        double[] covariance() {
            double blur = (Math.pow(2, level) - 1) * SIGMA * SIGMA;
            double[] covariance = {blur, blur, 0};
            add(covariance, wide, columns);
            add(covariance, narrow, rows);
            return covariance;
        }

        private static void add(double[] covariance, double[] line, int places) {
            // Places in the middles of n equal parts.
            double variance = (1 - 1.0 / (places * places)) / 12;
            covariance[0] += variance * line[0] * line[0];
            covariance[1] += variance * line[1] * line[1];
            covariance[2] += variance * line[0] * line[1];
        }
    }

    @BeforeEach
    void open() {
        context = RenderContext.offscreen();
    }

    @AfterEach
    void close() {
        context.close();
    }

    private Look look(float[] a, float[] b) {
        return look(0, 1, a, b);
    }

    private Look look(float pointLevels, float samplesAcross, float[] a, float[] b) {
        return look(pointLevels, samplesAcross, a, b, 0);
    }

    private Look look(float pointLevels, float samplesAcross, float[] a, float[] b, double slope) {
        ShaderLibrary library = name -> name.equals("look.frag") ? Optional.of(TEXT) : Optional.empty();
        try (ShaderProgram program = context.createFullScreenProgram(
                        library.orElse(Shaders.library()).load("look.frag"));
                FloatTarget target = context.createFloatTarget("look", FloatTargetSpec.color(3, 1))) {
            program.set("pointLevels", pointLevels);
            program.set("finestVariance", (float) (SIGMA * SIGMA));
            program.set("perFinestVariance", (float) (1 / (SIGMA * SIGMA)));
            program.set("levels", LEVELS);
            program.set("mostPlaces", 32f);
            program.set("samplesAcross", samplesAcross);
            program.set("slopes", (float) (slope * slope));
            program.set("alongX", new Vector3f(a));
            program.set("alongY", new Vector3f(b));
            context.drawFullScreen(program, List.of(), target, Tile.whole(3, 1));
            float[] found = target.read(0);
            return new Look(
                    (int) found[3], (int) found[7], new double[] {found[4], found[5]}, (int) found[11], new double[] {
                        found[8], found[9]
                    });
        }
    }

    /** The footprint's variance is (a a^T + b b^T) / 12, whichever way it lies. */
    @ParameterizedTest
    @CsvSource({
        "8, 0, 0, 8",
        "8, 0, 0, 8.01",
        "8.01, 0, 0, 8",
        "6, 6, -6, 6",
        "20, 0, 0, 5",
        "0, 20, 5, 0",
        "9, 7, -7, 9",
        "30, 4, -3, 10",
        "12, 0, 0, 0.1",
        "40, 40, -10, 10",
        "0.3, 0, 0, 0.3",
        "25, 0, 0, -25"
    })
    void whatIsLookedAtVariesAsWhatIsSeen(float ax, float ay, float bx, float by) {
        float sigma = (float) SIGMA;
        float[] a = {sigma * ax, sigma * ay, 0};
        float[] b = {sigma * bx, sigma * by, 0};
        Look look = look(a, b);
        double[] found = look.covariance();
        double trace = ((double) a[0] * a[0] + (double) a[1] * a[1] + (double) b[0] * b[0] + (double) b[1] * b[1]) / 12;
        // A line of n places lacks 1/n^2 of its variance, the rest is the level's; two places at least lie where more
        // than half is
        // left. What is narrower than a Gaussian of the finest level is a point.
        double share = trace < SIGMA * SIGMA ? 1 : 0.3;
        assertThat(found[0] + found[1]).isCloseTo(trace, within(share * trace));
    }

    /** A slope s of relief moves (u, v) by w s: along both axes as much, beside what the pixel sees of the mesh. */
    @ParameterizedTest
    @CsvSource({"8, 0, 0, 8, 10", "20, 0, 0, 5, 30", "12, 0, 0, 0.1, 12", "0.3, 0, 0, 0.3, 50", "0, 0, 0, 0, 20"})
    void reliefFinerThanAPixelWidensWhatIsSeen(float ax, float ay, float bx, float by, double slopes) {
        float sigma = (float) SIGMA;
        float[] a = {sigma * ax, sigma * ay, 0};
        float[] b = {sigma * bx, sigma * by, 0};
        double mesh = ((double) a[0] * a[0] + (double) a[1] * a[1] + (double) b[0] * b[0] + (double) b[1] * b[1]) / 12;
        double relief = 2 * Math.pow(1.1 * slopes * SIGMA, 2);

        double[] found = look(0, 1, a, b, slopes * SIGMA).covariance();

        // As without relief.
        assertThat(found[0] + found[1]).isCloseTo(mesh + relief, within(0.3 * (mesh + relief)));
    }

    @Test
    void onlyPixelsThatSeeLittleMoreThanAPointLookIntoTheTableForPoints() {
        float sigma = (float) SIGMA;
        float[] none = {0, 0, 0};
        // A line of that length has a twelfth of its square as variance; the limit is 0.06 of SIGMA's.
        float[] shorter = {0.8f * sigma, 0, 0};
        float[] longer = {0.9f * sigma, 0, 0};
        assertThat(look(1, 1, none, none).level()).isZero();
        assertThat(look(1, 1, shorter, none).level()).isZero();
        assertThat(look(1, 1, longer, none).level()).isOne();
        // A quarter of a pixel, all of which is seen.
        assertThat(look(1, 2, shorter, none).level()).isOne();
        assertThat(look(1, 2, new float[] {0.4f * sigma, 0, 0}, none).level()).isZero();
        // Where there is no such table, points are looked up where all else is.
        assertThat(look(0, 1, none, none).level()).isZero();
        assertThat(look(0, 1, longer, none).level()).isZero();
    }

    /** Differences of (u, v) are multiples of 2^-24: exact squares occur, and have no wide side. */
    @Test
    void aSquareIsSeenLikeOneThatIsNearlySo() {
        float side = 12 * (float) SIGMA;
        Look square = look(new float[] {side, 0, 0}, new float[] {0, side, 0});
        Look nearly = look(new float[] {1.0001f * side, 0, 0}, new float[] {0, side, 0});
        assertThat(square.level()).isEqualTo(nearly.level());
        assertThat(square.columns()).isEqualTo(nearly.columns());
        assertThat(square.rows()).isEqualTo(nearly.rows());
        for (int axis = 0; axis < 2; axis++) {
            // As far as the sides differ.
            assertThat(Math.abs(square.wide()[axis])).isCloseTo(Math.abs(nearly.wide()[axis]), within(3e-4 * side));
        }
    }
}
