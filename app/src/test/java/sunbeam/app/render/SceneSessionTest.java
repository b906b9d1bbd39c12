package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.scene.View.Camera;
import org.joml.Vector3f;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.SkinIndex;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.Weights;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.method.GemMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;

/** Pictures of a session, and of the sum of sessions for a skin with an index file. */
class SceneSessionTest extends InAScene {
    private static final int WIDTH = 72;
    private static final int HEIGHT = 56;

    private SceneSession session;

    @BeforeEach
    void prepare() {
        session = session(blaze());
    }

    @AfterEach
    void closeSession() {
        session.close();
    }

    private ScenePicture draw(Scene scene) {
        session.update(scene);
        return picture(session, WIDTH, HEIGHT);
    }

    private static void assertFinite(ScenePicture picture) {
        assertThat(picture.rgba()).doesNotContain(Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY);
    }

    private static float[] pixel(ScenePicture picture, int x, int y) {
        int at = 4 * (y * picture.width() + x);
        return Arrays.copyOfRange(picture.rgba(), at, at + 4);
    }

    @Test
    void aPixelHasTheExactColorOfItsDirection() {
        SceneData data = session.data();
        ExactLight reference = data.scene().method().area().over(data.patch().heights(), CieTable.load());
        Function<DirectionPair, double[]> exact =
                pair -> DoubleStream.of(reference.xyz(pair, ExactLight.Quadrature.EXACT))
                        .map(value -> Gain.relativeRadiance(pair) * value)
                        .toArray();
        assertExact(session, picture(session, WIDTH, HEIGHT), exact, 0, 5, 20, 60, 150);
    }

    /** A light's irradiance does not change with its coherence; twice the length makes an order four times as bright, and a quarter as large. */
    @Test
    void lightOfAnyCoherenceIsAsMuchLight() {
        double brief = light(8e-6);
        // The picture's border cuts off the flanks of broad orders.
        assertThat(light(16e-6)).isCloseTo(brief, within(0.1 * brief)).isPositive();
    }

    @Test
    void methodGemIsAsBrightUnderAnyWindow() {
        Choices gem = Choices.none().with(Methods.METHOD, GemMethod.TYPE);
        double brief = light(gem.with(MethodSettings.COHERENCE_LENGTH, 8e-6));
        assertThat(light(gem.with(MethodSettings.COHERENCE_LENGTH, 32e-6)))
                .isEqualTo(brief)
                .isPositive();
    }

    private double light(double coherenceLength) {
        return light(Choices.none()
                .with(MethodSettings.COHERENCE_LENGTH, coherenceLength)
                .with(MethodSettings.AVERAGE, Average.ENSEMBLE));
    }

    private double light(Choices chosen) {
        Scene scene = blaze();
        float[] rgba = drawn(scene.withMethod(scene.method().with(chosen)), WIDTH, HEIGHT);
        return IntStream.range(0, WIDTH * HEIGHT)
                .mapToDouble(i -> rgba[4 * i + 1])
                .sum();
    }

    @Test
    void tilesMakeUpTheVeryPictureOfOneDraw() {
        int width = 2060; // wider than a block
        ScenePicture whole = session.draw(DrawRequest.ofPixels(session.scene(), width, 24, Tile.whole(width, 24), 1));
        ScenePicture tiled = ScenePicture.empty(width, 24);
        for (Tile tile : Tile.whole(width, 24).divide(333)) {
            tiled.put(session.draw(DrawRequest.ofPixels(session.scene(), width, 24, tile, 1)), tile.x(), tile.y());
        }
        assertThat(tiled.rgba()).isEqualTo(whole.rgba());
        assertThat(picture(session, width, 24).rgba()).isEqualTo(whole.rgba());
    }

    @Test
    void lightBelowTheSurfaceLeavesTheAmbientPart() {
        Scene scene = blaze();
        ScenePicture picture = draw(scene.withLight(new SceneLight(new Vector3f(0.3f, 0, -0.5f), 2, 0))
                .with(Weights.of(50, 1, 1, 0.25)));
        // Intensity 2, ambient 0.25, white. Seven digits of the matrix.
        assertThat(pixel(picture, 36, 28)[1]).isCloseTo(0.5f, within(1e-5f));
        assertFinite(picture);
    }

    @Test
    void grazingLightAndViewStayFinite() {
        Scene scene = blaze().withLight(new SceneLight(new Vector3f(0, 1, 1e-6f), 1, 0))
                .withView(new Viewpoint(
                        new Camera(new Vector3f(0, -0.4f, 0.004f), new Vector3f(), new Vector3f(0, 0, 1)), 0.6));
        for (float value : draw(scene).rgba()) {
            assertThat(value).isFinite().isNotNegative();
        }
    }

    @Test
    void picksTellPlaceAndFrame() {
        Scene scene = blaze().with(Choices.none().with(SceneSettings.ROTATE_PATCH, Math.PI / 2));
        session.update(scene);
        Pick pick = session.pick(WIDTH / 2, HEIGHT / 2, WIDTH, HEIGHT).orElseThrow();
        // Half a pixel of 0.4 m * 2 tan(20 deg) / 56.
        assertThat(pick.position().length()).isLessThan(4e-3f);
        assertThat(pick.normal().z()).isCloseTo(1, within(1e-6f));
        // A quarter turn counter-clockwise takes the tangent from x to y.
        assertThat(pick.tangent().y()).isCloseTo(1, within(1e-6f));
        assertThat(pick.wi().x()).isCloseTo(scene.light().towards().y(), within(1e-6));
        assertThat(session.pick(0, 0, WIDTH, HEIGHT)).isEmpty();
    }

    private static final int SIDE = 16;

    @ParameterizedTest
    @CsvSource({
        // Sides of the square and distance of the eye, meters; whether it covers the picture's middle.
        "1e-12, 0.6, false",
        "1e-7,  0.6, false",
        "1e-7,  1e-7, true",
        "1,     1e6, false",
        "1e6,   1e6, true",
        "1,     1e-2, true"
    })
    void aMeshIsDrawnWhateverItsSizeAndDistance(double side, float distance, boolean covers) throws IOException {
        Path mesh = Files.writeString(
                folder.resolve("square.obj"),
                Text.format("v -%1$g -%1$g 0\nv %1$g -%1$g 0\nv %1$g %1$g 0\nv -%1$g %1$g 0\n", side / 2)
                        + "f 1 2 3 4\n");
        // Beside the middle, so that small meshes miss the center of a pixel.
        Camera camera = new Camera(new Vector3f(0, -0.1f * distance, distance), new Vector3f(), new Vector3f(0, 1, 0));
        Scene scene =
                blaze().withMesh(MeshSource.of(mesh.toString())).withView(new Viewpoint(camera, Math.toRadians(30)));
        try (SceneSession session = session(scene)) {
            ScenePicture picture = picture(session, SIDE, SIDE);

            float alpha = picture.rgba()[4 * (SIDE / 2 * SIDE + SIDE / 2) + 3];
            assertThat(alpha).isEqualTo(covers ? 1 : 0);
            assertFinite(picture);
        }
    }

    private static final int SIZE = 48;

    @Test
    void anIndexByWavelengthHasTheExactColors() throws IOException {
        // More reflected in the red than in the blue, as by copper.
        String copper = "wl,n,k\n0.38,1.2,2.2\n0.55,1.0,2.6\n0.6,0.3,3.3\n0.8,0.25,5\n";
        Path file = Files.writeString(folder.resolve("index.csv"), copper);
        Scene scene = blaze().with(SceneSettings.INDEX, SkinIndex.of(file.toString()));
        List<SceneData> parts = parts(scene);
        try (SceneSession session = new SceneSession(context, parts.get(0))) {
            assertExact(session, sum(parts, SIZE, SIZE), pair -> exact(parts, pair), 0, 5, 20);
        }
    }

    /** At the rim of a body all 16 samples of a pixel count, or 64, elsewhere the 4 that it has in any case. */
    @Test
    void aPixelWhoseMeanIsUnsureEqualsThatOfMoreSamples() {
        Scene scene = Scenes.load("elaphe");
        Tile whole = Tile.whole(SIZE, SIZE);
        PixelSamples adaptive = new PixelSamples(4, List.of(4, 8));
        try (SceneSession session = session(scene)) {
            PartSum sum = new PartSum(List.of(session));
            PixelPicture first = new PixelPicture(SIZE, SIZE, scene.display(1), scene.background());
            BitSet unsure = first.setAll(sum.draw(DrawRequest.first(scene, SIZE, SIZE, whole, adaptive)), 1, 4);
            PixelPicture all = new PixelPicture(SIZE, SIZE, scene.display(1), scene.background());
            BitSet still = all.setAll(sum.draw(DrawRequest.ofPixels(scene, SIZE, SIZE, whole, 4)), 4, 4);
            PixelPicture most = sum.draw(scene, SIZE, SIZE, whole, PixelSamples.uniform(8), 1);
            PixelPicture drawn = sum.draw(scene, SIZE, SIZE, whole, adaptive, 1);
            for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
                PixelPicture expected = !unsure.get(pixel) ? first : still.get(pixel) ? most : all;
                assertThat(light(drawn, pixel)).as("pixel %d", pixel).isEqualTo(light(expected, pixel));
                assertThat(drawn.image().getRGB(pixel % SIZE, pixel / SIZE))
                        .isEqualTo(expected.image().getRGB(pixel % SIZE, pixel / SIZE));
            }
            // A body of many scales, most of whose rims are within a pixel of this small picture; ground around it.
            assertThat(unsure.cardinality()).isBetween(SIZE * SIZE / 20, SIZE * SIZE / 2);
            still.and(unsure);
            assertThat(still.cardinality()).isBetween(1, unsure.cardinality() - 1);

            int pixel = unsure.nextSetBit(SIZE * SIZE / 2);
            Tile alone = new Tile(pixel % SIZE, pixel / SIZE, 1, 1);
            assertThat(light(sum.draw(scene, SIZE, SIZE, alone, adaptive, 1), 0))
                    .isEqualTo(light(drawn, pixel));
        }
    }

    /** A pixel with a scale's edge that shines over a sixteenth of it: with 16 samples its color differs by 8. */
    @Test
    void aGlintNarrowerThanASampleIsNearlyThatOfManySamples() {
        Scene scene = Scenes.load("elaphe");
        Tile pixel = new Tile(207, 150, 1, 1);
        try (SceneSession session = session(scene)) {
            PartSum sum = new PartSum(List.of(session));
            PixelPicture drawn = sum.draw(scene, 640, 360, pixel, PixelSamples.of(scene.method(), 640, 360), 1);
            PixelPicture many = sum.draw(scene, 640, 360, pixel, PixelSamples.uniform(16), 1);
            assertThat(lab(drawn).difference(lab(many))).isLessThan(4);
        }
    }

    private static CieLab lab(PixelPicture picture) {
        return CieLab.ofSrgb(picture.image().getRGB(0, 0));
    }

    private static float[] light(PixelPicture picture, int pixel) {
        return Arrays.copyOfRange(picture.light().rgba(), 4 * pixel, 4 * pixel + 4);
    }

    private static double[] exact(List<SceneData> parts, DirectionPair pair) {
        double[] sum = new double[3];
        for (SceneData part : parts) {
            var area = part.scene().method().area();
            ReflectionPart reflection =
                    part.reflectanceComponent().orElseThrow().reflection();
            double[] xyz = area.over(part.patch().heights(), reflection.cie()).xyz(pair, ExactLight.Quadrature.EXACT);
            for (int c = 0; c < 3; c++) {
                sum[c] += reflection.gain(pair) * xyz[c];
            }
        }
        return sum;
    }
}
