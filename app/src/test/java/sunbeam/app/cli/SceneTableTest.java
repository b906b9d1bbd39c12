package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.scene.View.Camera;
import org.joml.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.cli.Certificate.Limits;
import sunbeam.app.render.DrawRequest;
import sunbeam.app.render.InAScene;
import sunbeam.app.render.PartSum;
import sunbeam.app.render.PixelSamples;
import sunbeam.app.render.SceneSession;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.Weights;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** Compares method table on meshes with full: a point if a pixel sees a point, else the mean over the pixel. */
class SceneTableTest extends InAScene {
    private static final double TOLERANCE = 1e-2;
    // Orders as bright as the body, as on a skin.
    private static final Choices ON_A_BODY = Weights.of(30, 0.3, 1, 0.1);
    private static final Vector3f EYE = new Vector3f(-0.05f, -0.1f, 0.4f);
    // Across the lines it lies opposite to the eye, so that orders go through the picture's middle.
    private static final Vector3f LIGHT = new Vector3f(-0.2f, 0.242f, 0.949f);

    /** The blazed grating, which sends orders to the camera. */
    private static Scene plane(Vector3f eye, Vector3f light, double fieldOfView, Choices weights, MethodType type) {
        Choices method = Choices.none().with(Methods.METHOD, type).with(MethodSettings.TOLERANCE, TOLERANCE);
        Camera camera = new Camera(eye, new Vector3f(), new Vector3f(0, 0.8f, 0.6f));
        return blaze().with(weights)
                .withView(new Viewpoint(camera, Math.toRadians(fieldOfView)))
                .withLight(new SceneLight(light, 1, 0))
                .withMethod(new SceneMethod(method));
    }

    @Test
    void pixelsThatSeePointsHaveTheColorsOfFull() {
        int width = 24;
        int height = 18;
        try (SceneSession full = session(plane(EYE, LIGHT, 1, DIFFRACTION_ONLY, FullMethod.TYPE));
                SceneSession table = session(plane(EYE, LIGHT, 1, DIFFRACTION_ONLY, TableMethod.TYPE))) {
            float[] exact = picture(full, width, height).rgba();
            float[] drawn = picture(table, width, height).rgba();
            List<Comparison> compared = IntStream.range(0, width * height)
                    .mapToObj(i -> new Comparison(xyz(drawn, i), xyz(exact, i), 1))
                    .toList();
            ErrorStatistics errors = Comparison.relative(compared);
            assertThat(errors.count()).as("bright pixels").isGreaterThan(200);
            // Both keep the tolerance to the truth, and a pixel's side of 7e-4 in (u, v) is a tenth of what orders are
            // wide.
            assertThat(Limits.of(2 * TOLERANCE).hold(errors)).as("%s", errors).isTrue();
        }
    }

    private static double[] xyz(float[] rgba, int pixel) {
        return new double[] {rgba[4 * pixel], rgba[4 * pixel + 1], rgba[4 * pixel + 2]};
    }

    @Test
    void widePixelsHaveTheMeanOfTheirPoints() {
        // They are 0.02 wide in (u, v), several times an order's width, like those of a whole snake.
        assertTableHasTheMeanOfPoints(type -> plane(EYE, LIGHT, 20, ON_A_BODY, type), 3, 40);
    }

    @Test
    void aPlaneSeenAt80DegreesHasTheMeanOfItsPoints() {
        assertTableHasTheMeanOfPoints(SceneTableTest::grazing, 3, 40);
    }

    /** Of few pixels' points, each of which is the mean of 96 slopes. */
    @Test
    @Tag("thorough")
    void reliefFinerThanAPixelHasTheMeanOfItsSlopes() {
        assertTableHasTheMeanOfPoints(
                type -> plane(EYE, LIGHT, 20, ON_A_BODY, type).with(SceneSettings.ROUGHNESS, Math.toRadians(1)), 1, 12);
    }

    /**
     * Points see 96 random directions of the light each; the largest light is drawn as seven. Lit by a point instead, the picture has
     * other colors, though its many pixels between orders show the body alike.
     */
    @ParameterizedTest
    @ValueSource(doubles = {3, 9, 15})
    void aWideLightHasTheMeanOfItsDirections(double degrees) {
        Scene point = plane(EYE, LIGHT, 20, ON_A_BODY, TableMethod.TYPE);
        SceneLight wide = new SceneLight(LIGHT, 1, Math.toRadians(degrees));
        Scene exact = plane(EYE, LIGHT, 20, ON_A_BODY, FullMethod.TYPE).withLight(wide);
        try (SceneSession full = session(exact);
                SceneSession table = session(point)) {
            Certificate.SceneCertifier certifier = new Certificate.SceneCertifier(
                    24, 18, PixelSamples.uniform(1), Environment.ofProcess().progress());
            PartSum sum = new PartSum(List.of(full));
            PartSum tables = new PartSum(List.of(table));
            Certificate certificate = certifier.certify(tables, point.withLight(wide), sum, exact, 1, 12);
            Certificate ofPoint = certifier.certify(tables, point, sum, exact, 1, 12);
            assertThat(certificate.missed()).as(certificate.summary()).isFalse();
            assertThat(ofPoint.colorDifference().mean())
                    .as("point: %s; wide: %s", ofPoint.summary(), certificate.summary())
                    .isGreaterThan(1.5 * certificate.colorDifference().mean());
        }
    }

    /** Lines across the line of sight send the green of their first order there. */
    private static Scene grazing(MethodType type) {
        Vector3f eye = new Vector3f(0, -0.394f, 0.0695f);
        Vector3f light = new Vector3f(0, 0.765f, 0.644f);
        return plane(eye, light, 20, ON_A_BODY, type).with(SceneSettings.ROTATE_PATCH, Math.PI / 2);
    }

    /**
     * Asserts that a table keeps its promise for the mean over each pixel, and that colors of the pixels' centers are far from that mean.
     *
     * @param better least ratio of the centers' mean color difference to the table's
     * @param count number of pixels
     */
    private void assertTableHasTheMeanOfPoints(Function<MethodType, Scene> scene, double better, int count) {
        Certificate.SceneCertifier certifier = new Certificate.SceneCertifier(
                24, 18, PixelSamples.uniform(1), Environment.ofProcess().progress());
        Scene drawn = scene.apply(TableMethod.TYPE);
        Scene exact = scene.apply(FullMethod.TYPE);
        try (SceneSession full = session(exact);
                SceneSession table = session(drawn)) {
            PartSum sum = new PartSum(List.of(full));
            Certificate certificate = certifier.certify(new PartSum(List.of(table)), drawn, sum, exact, 1, count);
            Certificate points = certifier.certify(sum, exact, sum, exact, 1, count);
            assertThat(certificate.missed()).as(certificate.summary()).isFalse();
            // The reason for tables: colors of single points are far off where orders pass.
            assertThat(points.colorDifference().mean())
                    .as("points: %s; table: %s", points.summary(), certificate.summary())
                    .isGreaterThan(better * certificate.colorDifference().mean());
        }
    }

    @Test
    void aMeshThatTurnsItsBackToTheLightIsDark() {
        Scene scene = plane(EYE, new Vector3f(0.2f, 0, -0.9f), 10, DIFFRACTION_ONLY, TableMethod.TYPE);
        try (SceneSession session = session(scene)) {
            float[] drawn = picture(session, 8, 6).rgba();
            assertThat(xyz(drawn, 27)).containsExactly(0, 0, 0);
            assertThat(drawn[4 * 27 + 3]).as("covered").isOne();
        }
    }

    @Test
    void aPictureIsTheSameHoweverItIsDivided() {
        int width = 24;
        int height = 18;
        try (SceneSession one = session(plane(EYE, LIGHT, 10, ON_A_BODY, TableMethod.TYPE));
                SceneSession other = session(plane(EYE, LIGHT, 10, ON_A_BODY, TableMethod.TYPE))) {
            float[] whole = picture(one, width, height).rgba();
            for (Tile tile : Tile.whole(width, height).divide(7)) {
                float[] part = other.draw(DrawRequest.ofPixels(other.scene(), width, height, tile, 1))
                        .rgba();
                int row = tile.y() * width + tile.x();
                assertThat(Arrays.copyOf(part, 4 * tile.width()))
                        .as("%s", tile)
                        .isEqualTo(Arrays.copyOfRange(whole, 4 * row, 4 * (row + tile.width())));
            }
        }
    }
}
