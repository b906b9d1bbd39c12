package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.setting.Choices;

/** Scenes with relief finer than a pixel, whose tables have few tiles. */
class ReliefTableTest extends InAScene {
    private static final int WIDTH = 24;
    private static final int HEIGHT = 16;

    private Scene scene;

    @BeforeEach
    void prepare() {
        Scene blaze = blaze();
        Choices method = Choices.none().with(Methods.METHOD, TableMethod.TYPE);
        scene = blaze.withMethod(new SceneMethod(method))
                .with(Choices.none().with(SceneSettings.ROUGHNESS, Math.toRadians(9)));
    }

    /** A viewer shows a picture as soon as its own tiles are there; the rest of the table comes later. */
    @Test
    void aPictureWaitsForNoOtherTiles() {
        Deque<Runnable> work = new ArrayDeque<>();
        try (SceneSession session = session(scene)) {
            VirtualTexture tiles = session.virtualTexture().orElseThrow();
            tiles.bakeOn(work::add, () -> {});
            assertThat(session.request(WIDTH, HEIGHT, PixelSamples.uniform(1), () -> false))
                    .isTrue();
            while (tiles.requestedShare() < 1) {
                work.remove().run();
                tiles.drain();
            }
            assertThat(tiles.isComplete()).isFalse();
            float[] waited = picture(session, WIDTH, HEIGHT).rgba();
            try (SceneSession whole = session(scene)) {
                float[] drawn = picture(whole, WIDTH, HEIGHT).rgba();
                assertThat(whole.virtualTexture().orElseThrow().isComplete()).isTrue();
                // The same tiles, and so the same bits.
                assertThat(Arrays.equals(waited, drawn)).isTrue();
            }
        }
    }

    private static final int SIDE = 24;
    // Angle between the normal and both light and camera, so that |w| is around 1.44.
    private static final double TILT = Math.toRadians(44);
    // Tangent of half the angle across a picture of 4:3 and of 14 degrees from top to bottom; a square is as wide.
    private static final double HALF_WIDTH = Math.tan(Math.toRadians(7)) * 4 / 3;
    // Standard deviation of a sharp order at a point, in (u, v), at 550 nm: of sunlight's window.
    private static final double POINT_SIGMA = 0.0038;
    // Largest exponent of the distribution: flanks with an eighth of the peak's light.
    private static final double LARGEST_EXPONENT = 2;

    /** The mirror's highlight is the normal distribution of the slopes, white and without edges, at each width. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1.2, 1.7, 3})
    void theHighlightOfAMirrorIsTheDistributionOfItsSlopes(double roughness) throws IOException {
        float[] xyz = drawn(mirror(roughness), SIDE, SIDE);
        double slopes = Math.tan(Math.toRadians(roughness));
        List<Double> ratios = new ArrayList<>();
        for (int i = 0; i < SIDE * SIDE; i++) {
            double[] uvw = uvw(i % SIDE, Math.floorDiv(i, SIDE));
            double square = uvw[0] * uvw[0] + uvw[1] * uvw[1];
            double variance = Math.pow(slopes * uvw[2], 2) + Math.pow(POINT_SIGMA, 2);
            double exponent = square / (2 * variance);
            double sum = square + uvw[2] * uvw[2];
            // Radiance per power: shaders/include/gain.glsl, without its Fresnel factor.
            double gain = sum * sum / (uvw[2] * uvw[2] * (uvw[2] - Math.cos(TILT)));
            if (exponent < LARGEST_EXPONENT) {
                ratios.add(xyz[4 * i + 1] / (gain * Math.exp(-exponent) / variance));
                // White of equal energy: orders at a point are wider in red, by 1 % of this width.
                assertThat(xyz[4 * i] / xyz[4 * i + 1]).isBetween(0.97f, 1.01f);
            }
        }
        assertThat(ratios).as("pixels").hasSizeGreaterThan(50);
        // The Fresnel factor, which varies by 10 % over the widest highlight, and the table's error on flanks.
        assertThat(Collections.max(ratios) / Collections.min(ratios)).isLessThan(1.15);
        assertThat(warnings).noneMatch(line -> line.contains("roughness"));
    }

    /** The levels of a table are steps of brightness there. */
    @Test
    void aWarningTellsOfSlopesTooSmallForATable() throws IOException {
        load(mirror(0.5));
        assertThat(warnings).anyMatch(line -> line.startsWith("heights: roughness 0.50 deg: "));
    }

    /** Returns u, v and |w| of a pixel, whose distance from the mirror direction is that of its line of sight from the middle one. */
    private static double[] uvw(int column, int row) {
        double right = HALF_WIDTH * ((column + 0.5) / SIDE * 2 - 1);
        double up = HALF_WIDTH * (1 - (row + 0.5) / SIDE * 2);
        double y = Math.sin(TILT) + up * Math.cos(TILT);
        double z = Math.cos(TILT) - up * Math.sin(TILT);
        double length = Math.sqrt(right * right + y * y + z * z);
        return new double[] {right / length, y / length - Math.sin(TILT), z / length + Math.cos(TILT)};
    }

    private Scene mirror(double roughness) throws IOException {
        Files.writeString(folder.resolve("heights.txt"), "0 0 0 0\n0 1e-12 0 0\n0 0 0 0\n0 0 0 0\n");
        Path file = Files.writeString(folder.resolve("scene.json"), """
                {
                  "mesh": "plane",
                  "patch": {"file": "heights.txt", "width": "2 um", "height": "2 um", "heightUnit": "m",
                            "levelling": "mean", "edges": "repeat", "periodic": true},
                  "camera": {"position": ["0 cm", "%s cm", "%s cm"], "lookAt": ["0 cm", "0 cm", "0 cm"], "up": [0, 0, 1],
                             "fieldOfView": "14 deg"},
                  "light": {"direction": [0, %s, %s]},
                  "texture": "none",
                  "roughness": "%s deg",
                  "weights": {"diffraction": 1, "texture": 0}
                }
                """.formatted(
                        -20 * Math.sin(TILT), 20 * Math.cos(TILT), Math.sin(TILT), Math.cos(TILT), roughness));
        return Scenes.load(file.toString());
    }
}
