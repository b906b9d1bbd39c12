package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.app.scene.Scenes;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.text.Text;

/**
 * Tables on meshes keep their tolerance, for surfaces on which an earlier version missed it. Windows are shorter than those of sunlight,
 * and periods are not longer than windows, so that tables take seconds.
 */
class MeshTablePromiseTest extends InAScene {
    private static final double TOLERANCE = 1e-2;
    private static final int SIDE = 64;
    private static final PixelSamples SAMPLES = PixelSamples.uniform(2);
    private static final int COLUMNS = 200;

    /**
     * A surface on a mesh.
     *
     * @param width of a period along x, micrometers
     * @param length along y
     * @param height meters, at a place in micrometers
     * @param lone whether its orders are isolated, so that linear interpolation would miss the tolerance
     */
    record Case(
            String name,
            String mesh,
            double width,
            double length,
            DoubleBinaryOperator height,
            String eye,
            String fieldOfView,
            boolean lone) {
        @Override
        public String toString() {
            return name;
        }
    }

    static Stream<Case> cases() {
        return Stream.of(
                // Linear interpolation errs by 0.026 in the median.
                new Case(
                        "500 nm ribs with cross ribs of 5 um on a cylinder",
                        "cylinder",
                        5,
                        5,
                        (x, y) -> 80e-9 * wave(x / 0.5) + 120e-9 * Math.pow(wave(y / 5), 4),
                        "[\"0 cm\", \"-80 cm\", \"30 cm\"]",
                        "15 deg",
                        true),
                // Linear interpolation errs by 0.03.
                new Case(
                        "hexagonal dots on a sphere",
                        "sphere",
                        0.8,
                        1.4,
                        MeshTablePromiseTest::dots,
                        "[\"0 cm\", \"-80 cm\", \"56 cm\"]",
                        "20 deg",
                        true),
                // Linear interpolation errs by 0.1 in the median, and 0.14 at the 95th percentile of its brighter half.
                new Case(
                        "a blazed grating, most of which is dark",
                        "plane",
                        2.5,
                        2.5,
                        (x, y) -> 1e-7 * x,
                        "[\"0 cm\", \"20 cm\", \"35 cm\"]",
                        "60 deg",
                        true),
                new Case(
                        "flat facets of a rough surface from far away",
                        "facets.obj",
                        60,
                        60,
                        rough(),
                        "[\"0 cm\", \"-8000 cm\", \"5600 cm\"]",
                        "0.2 deg",
                        false));
    }

    private static double wave(double turns) {
        return 0.5 + 0.5 * Math.cos(2 * Math.PI * turns);
    }

    private static double dots(double x, double y) {
        double nearest = Math.hypot(x - 0.4, y - 0.7);
        for (int corner = 0; corner < 4; corner++) {
            nearest = Math.min(nearest, Math.hypot(x - 0.8 * (corner & 1), y - 0.7 * (corner & 2)));
        }
        return 150e-9 * Math.sqrt(Math.max(0, 1 - Math.pow(nearest / 0.3, 2)));
    }

    private static DoubleBinaryOperator rough() {
        SplittableRandom random = new SplittableRandom(5);
        return (x, y) -> 40e-9 * random.nextDouble();
    }

    @ParameterizedTest
    @MethodSource("cases")
    void theToleranceIsKeptAndNoLineSaysOtherwise(Case one) throws IOException {
        SceneData data = load(Scenes.load(write(one).toString()));
        try (SceneSession session = new SceneSession(context, data)) {
            PartSum sum = new PartSum(List.of(session));
            SceneSession.parts(session.scene(), SIDE, SIDE, SAMPLES).forEach(sum::draw);
            sum.validate();
            ErrorStatistics errors =
                    session.tableErrors(session.scene(), SIDE, SIDE, SAMPLES).orElseThrow();

            assertThat(errors.count()).as("samples with light").isGreaterThan(5);
            assertThat(data.method().colorTable().orElseThrow().table().pointLevelCount())
                    .isEqualTo(one.lone ? 0 : 1);
            assertThat(errors.keep(TOLERANCE)).as("%s", errors).isTrue();
            assertThat(warnings).noneMatch(line -> line.contains("the table of colors errs"));
        }
    }

    private Path write(Case one) throws IOException {
        int rows = (int) Math.round(COLUMNS * one.length / one.width);
        StringBuilder heights = new StringBuilder();
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                double x = column * one.width / COLUMNS;
                double y = row * one.length / rows;
                heights.append(Text.format("%.4e ", one.height.applyAsDouble(x, y)));
            }
            heights.append('\n');
        }
        Files.writeString(folder.resolve("heights.txt"), heights);
        Files.writeString(folder.resolve("facets.obj"), FACETS);
        return Files.writeString(folder.resolve("scene.json"), """
                {
                  "mesh": "%s",
                  "patch": {"file": "heights.txt", "width": "%s um", "height": "%s um", "heightUnit": "m",
                            "levelling": "mean", "edges": "repeat", "periodic": true},
                  "camera": {"position": %s, "lookAt": ["0 cm", "0 cm", "0 cm"], "fieldOfView": "%s"},
                  "light": {"direction": [0.3, -0.5, 0.8]},
                  "texture": "none",
                  "plan": {"coherenceLength": "20 um", "tolerance": %s},
                  "weights": {"diffraction": 1, "texture": 0}
                }
                """.formatted(
                        one.mesh, one.width, one.length, one.eye, one.fieldOfView, TOLERANCE));
    }

    /** A pyramid of four faces, each with its normal. */
    private static final String FACETS = """
            v 0 0 0.05
            v 0.1 0 0
            v 0 0.1 0
            v -0.1 0 0
            v 0 -0.1 0
            vt 0 0
            vt 1 0
            vt 0 1
            vn 0.4082 0.4082 0.8165
            vn -0.4082 0.4082 0.8165
            vn -0.4082 -0.4082 0.8165
            vn 0.4082 -0.4082 0.8165
            f 2/1/1 3/2/1 1/3/1
            f 3/1/2 4/2/2 1/3/2
            f 4/1/3 5/2/3 1/3/3
            f 5/1/4 2/2/4 1/3/4
            """;
}
