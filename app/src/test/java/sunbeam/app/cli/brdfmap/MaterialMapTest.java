package sunbeam.app.cli.brdfmap;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.app.scene.SceneSettings.ANGULAR_DIAMETER;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import sunbeam.app.cli.options.MethodOptions;
import sunbeam.app.cli.options.PatchOptions;
import sunbeam.app.gpu.InAContext;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.setting.Choices;

class MaterialMapTest extends InAContext {
    private static final int SIZE = 24;
    private static final double THETA = 50;
    private static final double PHI = 20;

    @TempDir
    private Path folder;

    @Test
    void aLampsMapIsTheMeanOverItsDirections() {
        Choices choices = Choices.none()
                .with(AVERAGE, Average.ENSEMBLE)
                .with(COHERENCE_LENGTH, 8e-6)
                .with(ROTATE_PATCH, 0.3);
        double diameter = Math.toRadians(6);
        // Five directions along each axis, 1.2 deviations of the light apart: as the window's orders are wider than
        // that, a sum over them errs by 1e-3; 2 % of the light lie beyond.
        double[] mean = new double[3 * SIZE * SIZE];
        double weights = 0;
        for (int i = 0; i < 25; i++) {
            double along = 1.2 * (i % 5 - 2);
            double across = 1.2 * (i / 5 - 2);
            double weight = Math.exp(-0.5 * (along * along + across * across));
            weights += weight;
            float[] xyz = draw(choices, aside(along * diameter / 4, across * diameter / 4));
            for (int c = 0; c < mean.length; c++) {
                mean[c] += weight * xyz[c];
            }
        }
        double all = weights;
        Arrays.setAll(mean, c -> mean[c] / all);

        // The window has the lamp's width at 550 nm; at 450 nm its variance is a third too small.
        assertThat(error(draw(choices.with(ANGULAR_DIAMETER, diameter), aside(0, 0)), mean))
                .isLessThan(0.1);
        assertThat(error(draw(choices, aside(0, 0)), mean))
                .as("a point of light")
                .isGreaterThan(0.2);
    }

    private static double error(float[] map, double[] mean) {
        double brightest = Arrays.stream(mean).filter(Double::isFinite).max().orElseThrow();
        IntStream lit = IntStream.range(0, mean.length).filter(c -> mean[c] > 0.01 * brightest);
        return Quantiles.of(lit.mapToDouble(c -> Math.abs(map[c] / mean[c] - 1)).toArray(), 0.5);
    }

    private float[] draw(Choices choices, Direction light) {
        DiffractionSetup setup = new DiffractionSetup(
                CommandLine.populateCommand(new PatchOptions(), "blaze").load(Choices.none()),
                new Environment(Map.of(), folder),
                line -> {});
        return new MaterialMap(setup, choices, RefractiveIndex.KERATIN, light)
                .draw(context, SIZE)
                .picture()
                .xyz();
    }

    /** Returns the direction at these distances, in radians, from the lamp's middle along its meridian and across. */
    private static Direction aside(double along, double across) {
        Direction middle = Direction.ofDegrees(THETA, PHI);
        Direction down = Direction.ofDegrees(THETA + 90, PHI);
        Vector3d place = new Vector3d(middle.x(), middle.y(), middle.z())
                .fma(along, new Vector3d(down.x(), down.y(), down.z()))
                .fma(across, new Vector3d(-Math.sin(Math.toRadians(PHI)), Math.cos(Math.toRadians(PHI)), 0))
                .normalize();
        return new Direction(place.x, place.y, place.z);
    }

    private static final Choices ASKED =
            new CommandLine(new MethodOptions()).<MethodOptions>getCommand().choices();
    private static final Direction LIGHT = Direction.ofDegrees(30, 0);

    /** Returns a scan of 20 x 10 um. */
    private static Patch scan(Patch.Repetition repetition) {
        double[] heights = new double[32 * 16];
        Arrays.setAll(heights, i -> 1e-8 * (i * i % 7));
        HeightMap map = new HeightMap(32, 16, 20e-6 / 32, 10e-6 / 16, heights);
        return new Patch("scan", map, map, "made up", List.of(), List.of(), List.of(), List.of(), repetition);
    }

    @Test
    void whatIsNotAsByDefaultIsToldAndNothingElse() {
        assertThat(caption(Patch.Repetition.NONE, "refractive index 0.97+6.5i; "))
                .contains("; refractive index 0.97+6.5i; coherence length 10 um (the scan's height), ");
        assertThat(caption(Patch.Repetition.PERIODIC, ""))
                .contains("azimuth 0\u00b0; coherence length 10 um, ")
                .endsWith("; exposure 2");
    }

    private static String caption(Patch.Repetition repetition, String remarks) {
        MaterialMap.Result map =
                new MaterialMap.Result(scan(repetition), LIGHT, Methods.of(ASKED), "", "", 10e-6, null);
        return String.join("; ", MapSheet.caption(map, remarks, ASKED, "exposure 2"));
    }
}
