package sunbeam.precompute.radial;

import java.util.Arrays;
import sunbeam.precompute.colortable.BakeToken;

/** Rays of one sector of a {@link LogRadialBand}, which evaluates colors on them and interpolates samples between them. */
final class PolarTile {
    private static final int COLORS = 3;
    private static final int MARGIN = QuinticSpline.MARGIN;
    /** Most rays that share one blurred spectrum; their working set fits a core's cache. */
    private static final int BATCH_RAYS = 64;

    private final LogRadialBand band;
    private final WindowedSpectrum powers;
    private final DepthInterpolation slices;
    private final LogPolarConvolution convolution;
    private final int firstRay;
    private final int rays;
    private final int positions;

    PolarTile(LogRadialBand band, int sector, WindowedSpectrum powers, DepthInterpolation slices) {
        this.band = band;
        this.powers = powers;
        this.slices = slices;
        this.convolution = band.convolution(powers, slices.depths());
        this.firstRay = band.firstRay(sector) - MARGIN;
        this.rays = band.firstRay(sector + 1) + MARGIN + 1 - firstRay;
        this.positions = convolution.count();
    }

    float[] bake(float[] uvw, BakeToken token) {
        float[][] planes = planes(token);
        float[] xyz = new float[uvw.length];
        double[] alongRay = new double[QuinticSpline.TAPS];
        double[] acrossRays = new double[QuinticSpline.TAPS];
        double[] sum = new double[COLORS];
        int corner = 0;
        for (int at = 0; at < uvw.length; at += COLORS) {
            if (at == 0 || uvw[at] != uvw[at - COLORS] || uvw[at + 1] != uvw[at - COLORS + 1]) {
                corner = locate(uvw[at], uvw[at + 1], alongRay, acrossRays);
            }
            double depth = Math.abs(uvw[at + 2]);
            int first = slices.firstTap(depth);
            Arrays.fill(sum, 0);
            for (int tap = 0; tap < slices.taps(); tap++) {
                double weight = slices.weight(depth, first, tap);
                for (int c = 0; c < COLORS; c++) {
                    double root = interpolated(planes[COLORS * (first + tap) + c], corner, acrossRays, alongRay);
                    sum[c] += weight * root * root;
                }
            }
            for (int c = 0; c < COLORS; c++) {
                // The polynomial in w may be negative between dark slices.
                xyz[at + c] = (float) Math.max(0, sum[c]);
            }
        }
        return xyz;
    }

    /** Computes the spline weights and returns the index of the first coefficient. */
    private int locate(double u, double v, double[] alongRay, double[] acrossRays) {
        double place = band.onRay(Math.sqrt(u * u + v * v));
        double ray = band.ray(u, v) - firstRay;
        // Both numbers are positive, so that a cast rounds down.
        int along = (int) place;
        int across = (int) ray;
        QuinticSpline.weights(place - along, alongRay);
        QuinticSpline.weights(ray - across, acrossRays);
        return (along - 2) * rays + across - 2;
    }

    /** Sums six values per row, unrolled: the C1 compiler does not unroll, and this runs millions of times. */
    private double interpolated(float[] plane, int corner, double[] inRow, double[] acrossRows) {
        double first = inRow[0];
        double second = inRow[1];
        double third = inRow[2];
        double fourth = inRow[3];
        double fifth = inRow[4];
        double sixth = inRow[5];
        double sum = 0;
        int at = corner;
        for (int row = 0; row < QuinticSpline.TAPS; row++) {
            sum += acrossRows[row]
                    * (first * plane[at]
                            + second * plane[at + 1]
                            + third * plane[at + 2]
                            + fourth * plane[at + 3]
                            + fifth * plane[at + 4]
                            + sixth * plane[at + 5]);
            at += rays;
        }
        return sum;
    }

    /** Returns spline coefficients of sqrt(X), sqrt(Y), sqrt(Z) of each slice, {@code [slice * 3 + color][position * rays + ray]}. */
    private float[][] planes(BakeToken token) {
        float[][] planes = new float[COLORS * slices.depths().length][rays * positions];
        LogPolarConvolution.Line line = convolution.line(powers.stride());
        int next;
        for (int i = 0; i < rays; i = next) {
            next = endOfBatch(i);
            RayBatch batch = powers.batch(angle(i), angle(next - 1), convolution.knots());
            for (int ray = i; ray < next; ray++) {
                line.colors(batch, angle(ray), planes, ray * positions);
                token.step(0);
            }
        }
        for (int i = 0; i < planes.length; i++) {
            planes[i] = spline(planes[i]);
        }
        return planes;
    }

    /** A batch ends where rays are closer to the other axis, 90 degrees away, or too many. */
    private int endOfBatch(int first) {
        boolean alongX = WindowedSpectrum.isAlongX(angle(first));
        int end = first + 1;
        while (end < Math.min(rays, first + BATCH_RAYS)
                && WindowedSpectrum.isAlongX(angle(end)) == alongX
                && angle(end) - angle(first) < Math.PI / 2) {
            end++;
        }
        return end;
    }

    /** Counterclockwise from the x axis, in radians; negative for margin rays before ray 0 of the band. */
    private double angle(int ray) {
        return 2 * Math.PI * (firstRay + ray) / band.rays();
    }

    private float[] spline(float[] plane) {
        for (int i = 0; i < plane.length; i++) {
            // The truncated sum of terms may be slightly negative in dark directions.
            plane[i] = (float) Math.sqrt(Math.max(0, plane[i]));
        }
        return QuinticSpline.coefficients(plane, rays, positions);
    }
}
