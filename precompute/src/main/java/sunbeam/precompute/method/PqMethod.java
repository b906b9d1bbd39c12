package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.INTERPOLATION;
import static sunbeam.precompute.plan.MethodSettings.REPLICAS;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Accuracy;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.ReplicatedArea;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.resample.PeriodInterpolation;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * The patch repeated Q times, with a sharp edge in place of a window. The replicas lie at one place, so that there is one
 * average only.
 *
 * @param table the tables and wavelengths
 * @param interpolation between the bins of one period's DFT
 * @param repetition how often
 */
public record PqMethod(TableChoices table, PeriodInterpolation interpolation, Repetition repetition) implements Method {
    /** Its name and settings. */
    public static final MethodType TYPE = new MethodType(
                    "pq", "the patch repeated Q times, sharp edge.", settings(), PqMethod::of)
            .fixing(AVERAGE, Average.COHERENT);

    /** How often the patch is repeated. */
    public sealed interface Repetition {
        /** For a patch. */
        Replicas of(HeightMap map);
    }

    /**
     * As often as comes closest to a coherence length.
     *
     * @param window that length's
     */
    public record Filling(CoherenceWindow window) implements Repetition {
        @Override
        public Replicas of(HeightMap map) {
            return Replicas.filling(window, map.width(), map.height());
        }
    }

    /**
     * So many times along both axes, whatever the coherence length.
     *
     * @param replicas 1..{@link Replicas#MOST}
     */
    public record Times(int replicas) implements Repetition {
        public Times {
            REPLICAS.kind().check(replicas);
        }

        @Override
        public Replicas of(HeightMap map) {
            return new Replicas(replicas, replicas);
        }
    }

    private static List<Setting<?>> settings() {
        List<Setting<?>> settings = new ArrayList<>(TableChoices.SETTINGS);
        settings.addAll(List.of(COHERENCE_LENGTH, INTERPOLATION, REPLICAS));
        return settings;
    }

    private static PqMethod of(Choices choices) {
        Repetition repetition = choices.find(REPLICAS)
                .<Repetition>map(Times::new)
                .orElseGet(() -> new Filling(GaussianArea.windowOf(choices)));
        return new PqMethod(TableChoices.of(choices), choices.get(INTERPOLATION), repetition);
    }

    /** Planned for a tolerance, filling sunlight's coherence length. */
    public static PqMethod within(double tolerance, PeriodInterpolation interpolation) {
        return new PqMethod(
                TableChoices.of(new Accuracy.ByTolerance(tolerance)),
                interpolation,
                new Filling(GaussianArea.STANDARD.window()));
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public ReferenceMethod exact(HeightMap map) {
        return new ReferenceMethod(new ReplicatedArea(repetition.of(map)));
    }
}
