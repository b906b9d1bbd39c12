package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;
import sunbeam.precompute.reference.SurfaceSums.AxisWeights;
import sunbeam.precompute.reference.SurfaceSums.AxisWeights.Axis;

/**
 * Exact light of evenly lit replicas of a patch with sharp edges, by direct summation in double precision:
 *
 * <pre>|1/(Qx Qy N M) sum over all samples of all replicas of exp(i k w h) exp(i k (u x + v y))|^2</pre>
 *
 * for N x M samples and Qx x Qy replicas. Method {@code pq} has this sum in closed form, as an array factor (thesis section 2.4.1).
 */
public record ReplicaLight(SurfaceSums surface, Axis x, Axis y, Replicas replicas, CieTable cie) implements ExactLight {
    // With all replicas a long and b wide, the power has at most |u| a + |v| b cycles per unit of 1 / lambda.
    private static final double NODES_PER_CYCLE = 3;

    /** Throws IllegalArgumentException if samples are missing. */
    public ReplicaLight(HeightMap map, Replicas replicas, CieTable cie) {
        this(new SurfaceSums(map), Axis.x(map, WindowOrigin.CORNER), Axis.y(map, WindowOrigin.CORNER), replicas, cie);
    }

    @Override
    public double power(DirectionPair pair, double wavelength) {
        AxisWeights alongX = AxisWeights.ofReplicas(pair.u() / wavelength, x, replicas.alongX());
        AxisWeights alongY = AxisWeights.ofReplicas(pair.v() / wavelength, y, replicas.alongY());
        return surface.overRows(pair.w(), wavelength, alongY).power(0, alongX);
    }

    @Override
    public Power powers(DirectionPair pair, double wavelength) {
        double power = power(pair, wavelength);
        return new Power(power, power);
    }

    @Override
    public boolean ensemble() {
        return false;
    }

    @Override
    public CoherenceWindow window() {
        return replicas.equalAreaWindow(x.period(), y.period());
    }

    /** Nine digits with either quadrature, since that is fast enough. */
    @Override
    public double[] xyz(DirectionPair pair, Quadrature quadrature) {
        return WavelengthNodes.exact(cie, wavelength -> power(pair, wavelength), step(pair));
    }

    @Override
    public double products(DirectionPair pair) {
        return CieTable.BAND_WIDTH / step(pair) * x.count() * y.count();
    }

    private double step(DirectionPair pair) {
        double cycles = Math.abs(pair.u()) * replicas.alongX() * x.period()
                + Math.abs(pair.v()) * replicas.alongY() * y.period();
        return 1 / (NODES_PER_CYCLE * cycles + 1 / WindowLight.WIDEST_STEP);
    }
}
