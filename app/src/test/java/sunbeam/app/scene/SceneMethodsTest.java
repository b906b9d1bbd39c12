package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.reference.ReplicaColor;
import sunbeam.precompute.reference.ReplicaEvaluator;
import sunbeam.precompute.resample.PeriodInterpolation;

/** The other methods on a mesh. */
@NeedsDisplay
class SceneMethodsTest {
    private static final int WIDTH = 72;
    private static final int HEIGHT = 56;

    @TempDir
    private Path folder;

    private static Scene with(MethodRequest method, Average average) {
        Scene blaze = PlaneScenes.blaze();
        PlanRequest old = blaze.plan();
        PlanRequest plan = new PlanRequest(
                old.preset(),
                old.tolerance(),
                old.expansion(),
                old.terms(),
                old.radius(),
                old.anchor(),
                old.wavelengthStep(),
                old.origin(),
                old.coherenceLength(),
                Optional.of(average));
        return blaze.withMethod(method, plan);
    }

    private float[] draw(RenderContext context, Scene scene) {
        try (SceneSession session = new SceneSession(context, PlaneScenes.load(scene, folder))) {
            return session.draw(WIDTH, HEIGHT).rgba();
        }
    }

    private static int[] byLuminance(float[] rgba) {
        return IntStream.range(0, WIDTH * HEIGHT)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> -rgba[4 * i + 1]))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    @Test
    void nmmDrawsWhatFullDraws() {
        try (RenderContext context = RenderContexts.offscreen()) {
            float[] full = draw(context, with(MethodRequest.of(MethodKind.FULL), Average.ENSEMBLE));
            float[] nmm = draw(context, with(MethodRequest.of(MethodKind.NMM), Average.ENSEMBLE));
            int[] brightest = Arrays.copyOf(byLuminance(full), 200);
            double[] errors = Arrays.stream(brightest)
                    .mapToDouble(i -> Math.abs(nmm[4 * i + 1] / full[4 * i + 1] - 1))
                    .sorted()
                    .toArray();
            // nmm takes an order's power at its one wavelength: 3e-3 on this grating's maps (docs/methods.md);
            // directions
            // beside the grating's plane, on an order's flank, are a little worse.
            assertThat(errors[errors.length / 2]).as("median error").isLessThan(1e-2);
        }
    }

    @Test
    void pqHasTheExactColourOfItsReplicas() {
        int replicas = 3;
        MethodRequest method = new MethodRequest(
                MethodKind.PQ, PeriodInterpolation.SINC, OptionalInt.of(replicas), OptionalDouble.empty());
        SceneData data = PlaneScenes.load(with(method, Average.COHERENT), folder);
        ReplicaColor reference = new ReplicaColor(
                new ReplicaEvaluator(data.patch().heights(), new Replicas(replicas, replicas)), CieTable.load());
        try (RenderContext context = RenderContexts.offscreen();
                SceneSession session = new SceneSession(context, data)) {
            float[] drawn = session.draw(WIDTH, HEIGHT).rgba();
            int[] ranked = byLuminance(drawn);
            for (int rank : new int[] {0, 20, 150, 400}) {
                int pixel = ranked[rank];
                Pick pick = session.pick(pixel % WIDTH, pixel / WIDTH, WIDTH, HEIGHT)
                        .orElseThrow();
                DirectionPair pair = new DirectionPair(pick.wi(), pick.wr());
                double[] exact = reference.xyz(pair);
                double gain = Gain.relativeRadiance(pair);
                double scale = gain * Math.max(exact[0], Math.max(exact[1], exact[2]));
                for (int c = 0; c < 3; c++) {
                    // As for full: the tolerance of 1e-3 for each of five sources.
                    assertThat((double) drawn[4 * pixel + c])
                            .as("channel %d of pixel %d", c, pixel)
                            .isCloseTo(gain * exact[c], within(5e-3 * scale));
                }
            }
        }
    }

    @Test
    void gemKnowsTheSpacingAndNotTheSurface() {
        MethodRequest wide = new MethodRequest(
                MethodKind.GEM, PeriodInterpolation.SINC, OptionalInt.empty(), OptionalDouble.of(2.5e-6));
        MethodRequest narrow = new MethodRequest(
                MethodKind.GEM, PeriodInterpolation.SINC, OptionalInt.empty(), OptionalDouble.of(1e-6));
        try (RenderContext context = RenderContexts.offscreen()) {
            Scene scene = with(wide, Average.ENSEMBLE);
            float[] blaze = draw(context, scene);
            assertThat(draw(context, scene.withPatch(PatchRequest.of("lamellar"))))
                    .isEqualTo(blaze);
            assertThat(draw(context, with(narrow, Average.ENSEMBLE))).isNotEqualTo(blaze);
        }
    }

    @Test
    void whatAMethodCannotDoIsRefusedWhenTheSceneIsLoaded() {
        Scene replicated = with(MethodRequest.of(MethodKind.PQ), Average.ENSEMBLE);
        assertThatThrownBy(() -> PlaneScenes.load(replicated, folder))
                .isInstanceOf(UsageException.class)
                .hasMessageContaining("ensemble");
        Scene skin = with(MethodRequest.of(MethodKind.GEM), Average.ENSEMBLE).withPatch(PatchRequest.of("elaphe-like"));
        assertThatThrownBy(() -> PlaneScenes.load(skin, folder))
                .isInstanceOf(UsageException.class)
                .hasMessageContaining("--spacing");
        MethodRequest reference = MethodRequest.of(MethodKind.REFERENCE);
        assertThatThrownBy(() -> with(reference, Average.ENSEMBLE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("full, nmm, pq or gem");
    }
}
