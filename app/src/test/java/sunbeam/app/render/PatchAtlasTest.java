package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.Weights;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** Several patches on one mesh, selected by the colors of a map. */
class PatchAtlasTest extends InAScene {
    private static final int WIDTH = 36;
    private static final int HEIGHT = 28;
    private static final int RED = 0xff0000;
    private static final int BLUE = 0x0000ff;

    /** A square of 2 x 2 texels, the upper row first. */
    private String map(int type, int... rgb) throws IOException {
        return image(
                type, 2, Arrays.stream(rgb).map(color -> 0xff00_0000 | color).toArray());
    }

    private static PatchAtlas.Region region(int color, String patch) {
        return new PatchAtlas.Region(new SceneColor(color), PatchRequest.of(patch));
    }

    private static Scene scene(String map, PatchAtlas.Region... regions) {
        return blaze().withPatches(new PatchAtlas(map, List.of(regions)));
    }

    private float[] drawn(Scene scene) {
        return sum(loader().parts(scene), WIDTH, HEIGHT).rgba();
    }

    private int regionAt(SceneSession session, int x, int y) {
        return session.pick(x, y, WIDTH, HEIGHT).orElseThrow().region();
    }

    /** Blaze on the right and below, a flatter one on the left above; over a body, so that the blend is the sum's. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void eachPlaceLooksLikeItsPatch(boolean byTable) throws IOException {
        Choices quick = Choices.none()
                .with(Methods.METHOD, byTable ? TableMethod.TYPE : FullMethod.TYPE)
                .with(MethodSettings.TOLERANCE, 0.05);
        Scene both = scene(
                        map(BufferedImage.TYPE_INT_RGB, RED, BLUE, BLUE, BLUE),
                        region(BLUE, "blaze"),
                        region(RED, "lamellar"))
                .withMethod(new SceneMethod(quick))
                .with(Weights.of(3000, 1, 1, 0));
        float[] mixed = drawn(both);
        float[][] alone = {
            drawn(both.withPatch(PatchRequest.of("blaze"))), drawn(both.withPatch(PatchRequest.of("lamellar")))
        };

        int[] places = new int[2];
        int different = 0;
        try (SceneSession session =
                new SceneSession(context, loader().parts(both).get(1))) {
            for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
                if (mixed[4 * pixel + 3] == 0) {
                    continue;
                }
                int region = regionAt(session, pixel % WIDTH, pixel / WIDTH);
                places[region]++;
                for (int c = 4 * pixel; c < 4 * pixel + 3; c++) {
                    // Light is added to the body on the processor, not on the graphics card: single precision.
                    assertThat(mixed[c]).isCloseTo(alone[region][c], withinPercentage(0.01));
                    different += Math.abs(alone[0][c] - alone[1][c]) > 0.01 ? 1 : 0;
                }
            }
            assertThat(regionAt(session, WIDTH / 2 - 4, HEIGHT / 2 - 4)).isOne();
            assertThat(regionAt(session, WIDTH / 2 + 4, HEIGHT / 2 - 4)).isZero();
            assertThat(regionAt(session, WIDTH / 2 - 4, HEIGHT / 2 + 4)).isZero();
        }
        assertThat(places[1]).isBetween(places[0] / 4, places[0] / 2);
        assertThat(different).as("the patches differ").isGreaterThan(20);
    }

    /** Gray, indexed and 16-bit images. */
    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_BYTE_BINARY, BufferedImage.TYPE_USHORT_GRAY})
    void blackAndWhiteMapsOfAllKindsAreRead(int type) throws IOException {
        Scene scene = scene(map(type, 0, 0, 0xffffff, 0xffffff), region(0, "blaze"), region(0xffffff, "lamellar"));

        assertThat(loader().parts(scene))
                .extracting(part -> part.patch().name())
                .containsExactly("blaze", "lamellar");
    }

    @Test
    void colorsWithoutPatchAndPatchesWithoutPlaceAreRefused() throws IOException {
        String map = map(BufferedImage.TYPE_INT_RGB, RED, BLUE, 0x7f007f, BLUE);
        PatchAtlas.Region red = region(RED, "blaze");
        PatchAtlas.Region blue = region(BLUE, "lamellar");
        PatchAtlas.Region mean = region(0x7f007f, "lamellar");

        assertThatThrownBy(() -> loader().parts(scene(map, red, blue)))
                .isInstanceOf(InputException.class)
                .hasMessageContainingAll(
                        map, "has #7f007f in column 0, row 1, which has no patch; known are #0000ff, #ff0000");
        assertThatThrownBy(() -> loader().parts(scene(map, red, blue, mean, region(0x00ff00, "blaze"))))
                .hasMessageContaining("has nowhere #00ff00");
        assertThatThrownBy(() -> loader().parts(scene(folder + "/none.png", red)))
                .hasMessageContaining("there is no patch map");
    }

    @Test
    void noMoreThanEightPatches() {
        List<PatchAtlas.Region> many = new ArrayList<>();
        for (int i = 0; i <= PatchAtlas.MOST; i++) {
            many.add(region(i, "blaze"));
        }
        assertThatThrownBy(() -> new PatchAtlas("m.png", many)).hasMessageContaining("at most 8");
    }
}
