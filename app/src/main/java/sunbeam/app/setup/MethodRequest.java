package sunbeam.app.setup;

import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.resample.PeriodInterpolation;

/**
 * A method and what belongs to it alone.
 *
 * @param kind the method
 * @param interpolation of the period's spectrum, for {@code pq}
 * @param replicas Q along both axes, for {@code pq} and for {@code reference} in its place
 * @param spacing of the lines in metres, for {@code gem}
 */
public record MethodRequest(
        MethodKind kind, PeriodInterpolation interpolation, OptionalInt replicas, OptionalDouble spacing) {

    /** Lines that lie closer diffract no visible light, metres. */
    public static final double SMALLEST_SPACING = 100e-9;

    /** Lines farther apart are no grating, metres. */
    public static final double LARGEST_SPACING = 1e-3;

    /** A method with its defaults. */
    public static MethodRequest of(MethodKind kind) {
        return new MethodRequest(kind, PeriodInterpolation.SINC, OptionalInt.empty(), OptionalDouble.empty());
    }

    /** The replicas that were asked for, or those that come closest to the coherence length. */
    public Replicas replicasOf(HeightMap map, CoherenceWindow window) {
        return replicas.isPresent()
                ? new Replicas(replicas.getAsInt(), replicas.getAsInt())
                : Replicas.filling(window, map.width(), map.height());
    }

    /** The method and its choices, for metadata. */
    public String describe() {
        StringBuilder text = new StringBuilder(kind.label());
        if (kind == MethodKind.PQ) {
            text.append(", ").append(interpolation.label());
        }
        replicas.ifPresent(count -> text.append(", replicas ").append(count));
        spacing.ifPresent(metres -> text.append(", spacing (m) ").append(metres));
        return kind == MethodKind.GEM ? text.append(", for comparison only").toString() : text.toString();
    }
}
