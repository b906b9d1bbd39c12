package sunbeam.precompute.reference;

import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.optics.WindowOrigin;

/**
 * Diffracted power of evenly lit replicas of a patch with sharp edges, by direct summation in double precision:
 *
 * <pre>|1/(Qx Qy N M) sum over all samples of all replicas of exp(i k w h) exp(i k (u x + v y))|^2</pre>
 *
 * for N x M samples and Qx x Qy replicas. Method {@code pq} has this sum in closed form, as an array factor (thesis section 2.4.1).
 * Immutable and safe for use by several threads.
 */
public final class ReplicaEvaluator {
    private final SurfaceSums surface;
    private final Axis x;
    private final Axis y;
    private final Replicas replicas;

    /** @throws IllegalArgumentException when samples are missing */
    public ReplicaEvaluator(HeightMap map, Replicas replicas) {
        this.surface = new SurfaceSums(map);
        this.x = Axis.x(map, WindowOrigin.CORNER);
        this.y = Axis.y(map, WindowOrigin.CORNER);
        this.replicas = replicas;
    }

    /** Returns the power at a wavelength in meters; 1 for a flat mirror in specular direction. */
    public double power(DirectionPair pair, double wavelength) {
        AxisWeights alongX = AxisWeights.ofReplicas(pair.u() / wavelength, x, replicas.alongX());
        AxisWeights alongY = AxisWeights.ofReplicas(pair.v() / wavelength, y, replicas.alongY());
        return surface.overRows(pair.w(), wavelength, alongY).power(0, alongX);
    }

    long samples() {
        return (long) x.count() * y.count();
    }

    /** Returns the extent of all replicas along x, in meters. */
    public double width() {
        return replicas.alongX() * x.period();
    }

    /** Returns the extent of all replicas along y, in meters. */
    public double height() {
        return replicas.alongY() * y.period();
    }
}
