package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class FalseColoursTest {
    private static final int SIDE = 64;

    @TempDir
    Path folder;

    /** Colour maps as microscopes' programs have them: red, green and blue in [0, 1] of a height in [0, 1]. */
    private enum Map {
        /** Black, brown, yellow, white. */
        GOLD {
            @Override
            double[] at(double height) {
                return new double[] {Math.min(1, 1.6 * height), height * height, Math.max(0, 2 * height - 1)};
            }
        },
        /** Blue, green, red. */
        RAINBOW {
            @Override
            double[] at(double height) {
                return new double[] {
                    Math.max(0, 2 * height - 1), 1 - Math.abs(2 * height - 1), Math.max(0, 1 - 2 * height)
                };
            }
        };

        abstract double[] at(double height);
    }

    private static double height(int column, int row) {
        return 0.5 + 0.4 * Math.sin(0.31 * column) * Math.cos(0.17 * row);
    }

    private Path write(TestImages.Samples samples) throws IOException {
        BufferedImage image = TestImages.rgb(SIDE, SIDE, samples);
        return TestImages.write(image, folder.resolve("shot.png"));
    }

    @ParameterizedTest
    @EnumSource(Map.class)
    void noChannelOfAPictureInFalseColoursIsAHeight(Map map) throws IOException {
        // With a colour bar at its right side.
        Path file = write((c, r, b) -> 255 * map.at(c > 56 ? (double) r / SIDE : height(c, r))[b]);

        for (Optional<Channel> channel : List.of(Optional.<Channel>empty(), Optional.of(Channel.RED))) {
            assertThatThrownBy(() -> HeightImageReader.read(file, channel))
                    .isInstanceOf(PatchException.class)
                    .hasMessageContaining("shot.png looks like a picture in false colours")
                    .hasMessageContaining("export the heights themselves");
        }
    }

    @Test
    void aSmoothedPictureInFalseColoursIsStillOne() throws IOException {
        // What scaling a screenshot does: neighbours are mixed.
        Path file = write((c, r, b) ->
                255 * (Map.RAINBOW.at(height(c, r))[b] + Map.RAINBOW.at(height(c + 2, r + 2))[b]) / 2);

        assertThatThrownBy(() -> HeightImageReader.read(file, Optional.of(Channel.RED)))
                .hasMessageContaining("false colours");
    }

    @Test
    void heightsInOneTintAreRead() throws IOException {
        Path file = write((c, r, b) -> Math.rint(255 * height(c, r) * new double[] {1, 0.5, 0.25}[b]));

        assertThat(HeightImageReader.read(file, Optional.of(Channel.RED)).samples()[5])
                .isEqualTo(Math.rint(255 * height(5, 0)));
    }

    @Test
    void channelsThatKnowNothingOfEachOtherAreRead() throws IOException {
        Random random = new Random(7);
        double[] other = random.doubles(SIDE * SIDE).toArray();
        Path file = write((c, r, b) -> 255 * (b == 0 ? height(c, r) : b == 1 ? other[r * SIDE + c] : 0.2));

        assertThat(HeightImageReader.read(file, Optional.of(Channel.RED)).samples())
                .hasSize(SIDE * SIDE);
    }
}
