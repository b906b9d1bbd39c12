package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import jrtr.Tile;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSettings.SkinIndex;
import sunbeam.app.scene.Scenes;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ExactLight;

/** The light of a skin with an index file is the sum of two parts, over one body. */
class PartSumTest extends InAScene {
    private static final int SIZE = 48;

    private SkinIndex file(String table) throws IOException {
        return SkinIndex.of(
                Files.writeString(folder.resolve("index.csv"), table).toString());
    }

    @Test
    void anIndexByWavelengthHasTheExactColors() throws IOException {
        // More reflected in the red than in the blue, as by copper.
        Scene scene = blaze().with(
                        SceneSettings.INDEX, file("wl,n,k\n0.38,1.2,2.2\n0.55,1.0,2.6\n0.6,0.3,3.3\n0.8,0.25,5\n"));
        List<SceneData> parts = loader().parts(scene);
        try (SceneSession session = new SceneSession(context, parts.get(0))) {
            assertExact(session, sum(parts, SIZE, SIZE), pair -> exact(parts, pair), 0, 5, 20);
        }
    }

    /** At the rim of a body all 16 samples of a pixel count, elsewhere the 4 that it has in any case. */
    @Test
    void aPixelWhoseFirstSamplesDifferEqualsThatOfAllSamples() {
        Scene scene = Scenes.load("elaphe");
        Tile whole = Tile.whole(SIZE, SIZE);
        PixelSamples adaptive = new PixelSamples(4, true);
        try (SceneSession session = session(scene)) {
            PartSum sum = new PartSum(List.of(session));
            PixelPicture first = new PixelPicture(SIZE, SIZE, scene.display(1), scene.get(SceneSettings.BACKGROUND));
            BitSet differing = first.setAll(sum.draw(DrawRequest.first(scene, SIZE, SIZE, whole, adaptive)), 1, 4);
            PixelPicture all = sum.draw(scene, SIZE, SIZE, whole, PixelSamples.uniform(4), 1);
            PixelPicture drawn = sum.draw(scene, SIZE, SIZE, whole, adaptive, 1);
            for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
                PixelPicture expected = differing.get(pixel) ? all : first;
                assertThat(light(drawn, pixel)).as("pixel %d", pixel).isEqualTo(light(expected, pixel));
                assertThat(drawn.image().getRGB(pixel % SIZE, pixel / SIZE))
                        .isEqualTo(expected.image().getRGB(pixel % SIZE, pixel / SIZE));
            }
            // A body of many scales, most of whose rims are within a pixel of this small picture; ground around it.
            assertThat(differing.cardinality()).isBetween(SIZE * SIZE / 20, SIZE * SIZE / 2);

            int pixel = differing.nextSetBit(SIZE * SIZE / 2);
            Tile alone = new Tile(pixel % SIZE, pixel / SIZE, 1, 1);
            assertThat(light(sum.draw(scene, SIZE, SIZE, alone, adaptive, 1), 0))
                    .isEqualTo(light(drawn, pixel));
        }
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
