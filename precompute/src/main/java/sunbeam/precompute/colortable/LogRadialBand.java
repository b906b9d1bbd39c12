package sunbeam.precompute.colortable;

import java.util.Arrays;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.colortable.Interpolation.SplineFilter;
import sunbeam.precompute.work.Progress;

/** Rays of one octave of |(u, v)|, divided into sectors, and the positions on them. Immutable. */
record LogRadialBand(double low, int rays, int sectors, LogRadialBand.Positions positions) {
    private static final int COLORS = 3;
    private static final int MARGIN = QuinticSpline.MARGIN;
    // Most rays that share one blurred spectrum; their working set fits a core's cache.
    private static final int BATCH_RAYS = 64;
    // Pairs of sectors let two cores share the work; smaller sectors would waste time on margin rays.
    private static final int RAYS_PER_SECTOR_PAIR = 400;
    private static final double WIDEST_STEP = 0.01;
    // In ln |(u, v)|, at a tolerance of 1, for smooth light: colors vary along a ray only as fast as the color matching
    // functions do, however sharp orders are. Splines err most beside an order that the visible band cuts.
    private static final double WIDEST_SMOOTH = 0.01424;
    // Exponent p: this step is proportional to tolerance^p.
    private static final double STEP_EXPONENT = 0.1;
    // At the ends of the light's band, polynomials and B-splines extend that many wavelength steps.
    private static final int LEAST_STRIDE = 3;
    // Largest step between positions, in widths of an order.
    private static final double WIDEST_OF_ORDER = 0.5;
    // The same for light with steep edges: flanks of orders beyond an edge are the steeper the darker they are.
    private static final double WIDEST_ON_FLANKS = 0.15;
    // Limit where orders are wide, in units of widestStep: coefficients of deep reliefs change fast with wavelength.
    private static final double MOST_WIDER = 2;
    private static final double LARGEST_MARGIN_SHARE = 0.5;
    // Relative to a power of two; below it the step is enlarged until that power suffices.
    private static final double MOST_ABOVE_POWER = 1.12;
    private static final double STEP_GROWTH = 1.005;

    /** The outermost positions are at |(u, v)| {@code high}, with {@code step} between rays there. */
    static LogRadialBand of(CieTable cie, double tolerance, double sigmaFrequency, double high, double step) {
        int rays = (int) Math.ceil(2 * Math.PI * high / step);
        double orderWidth = sigmaFrequency * cie.shortestWavelength() / high;
        double widestStep = WIDEST_SMOOTH * Math.pow(tolerance, STEP_EXPONENT);
        double widerStep = Math.min(MOST_WIDER * widestStep, WIDEST_OF_ORDER * orderWidth);
        double widest = cie.isSmooth() ? Math.max(widestStep, widerStep) : WIDEST_ON_FLANKS * orderWidth;
        Positions positions = Positions.widest(cie, widest, Math.min(step / high, WIDEST_STEP));
        return new LogRadialBand(high / 2, rays, 2 * Math.max(1, rays / RAYS_PER_SECTOR_PAIR), positions);
    }

    /** Steps along a ray: {@code stride} wavelength steps each; a ray of the octave covers this range of ln |f|. */
    record Positions(WavelengthNodes wavelengths, int stride, double covered) {
        /** Returns the largest step up to {@code widest}, or a slightly larger one that halves the length of the transforms. */
        static Positions widest(CieTable cie, double widest, double wavelengthStep) {
            Positions positions = of(cie, widest, wavelengthStep);
            int transform = positions.transform();
            double margins = positions.length() - positions.covered / positions.step();
            // Short rays consist mostly of margins, whose number of positions does not depend on the step.
            if (margins > LARGEST_MARGIN_SHARE * transform) {
                return positions;
            }
            // A step divides the range of wavelengths, so that it may be smaller than requested.
            double step = positions.covered / (transform - margins);
            positions = of(cie, step, wavelengthStep);
            while (positions.length() > transform) {
                step *= STEP_GROWTH;
                positions = of(cie, step, wavelengthStep);
            }
            return positions;
        }

        private static Positions of(CieTable cie, double step, double wavelengthStep) {
            int stride = (int) Math.max(LEAST_STRIDE, Math.ceil(step / wavelengthStep));
            double covered = Math.log(2 * cie.longestWavelength() / cie.shortestWavelength());
            return new Positions(WavelengthNodes.logarithmic(cie, step / stride, 0), stride, covered);
        }

        private int transform() {
            int power = Integer.highestOneBit(length() - 1);
            return length() < MOST_ABOVE_POWER * power ? power : 2 * power;
        }

        double step() {
            double[] nodes = wavelengths.wavelengths();
            return stride * Math.log(nodes[nodes.length - 1] / nodes[0]) / (nodes.length - 1);
        }

        int count() {
            return 2 * MARGIN + 2 + (int) Math.ceil(Math.log(2) / step());
        }

        /** Returns the least length of the transform in which the convolution does not wrap around. */
        int length() {
            return count() + LogPolarConvolution.AverageProjection.knots(stride, wavelengths.count()) - 1;
        }
    }

    /** Returns the first ray of a sector; for the number of sectors, that of rays. */
    private int firstRay(int sector) {
        return (int) ((long) rays * sector / sectors);
    }

    private double ray(double u, double v) {
        double turns = Math.atan2(v, u) / (2 * Math.PI);
        return (turns < 0 ? turns + 1 : turns) * rays;
    }

    int sector(double u, double v) {
        int ray = Math.min(rays - 1, (int) ray(u, v));
        // The last sector whose first ray is not beyond this one.
        return (int) (((ray + 1L) * sectors - 1) / rays);
    }

    final class Tile {
        private final WindowedSpectrum powers;
        private final DepthInterpolation slices;
        private final double step = positions.step();
        private final double start = Math.log(low) - MARGIN * step;
        private final int firstRay;
        private final int tileRays;

        Tile(int sector, WindowedSpectrum powers, DepthInterpolation slices) {
            this.powers = powers;
            this.slices = slices;
            this.firstRay = firstRay(sector) - MARGIN;
            this.tileRays = firstRay(sector + 1) + MARGIN + 1 - firstRay;
        }

        float[] bake(float[] uvw, Progress token) {
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

        private int locate(double u, double v, double[] alongRay, double[] acrossRays) {
            double place = (Math.log(Math.sqrt(u * u + v * v)) - start) / step;
            double ray = ray(u, v) - firstRay;
            // Both numbers are positive, so that a cast rounds down.
            int along = (int) place;
            int across = (int) ray;
            QuinticSpline.weights(place - along, alongRay);
            QuinticSpline.weights(ray - across, acrossRays);
            return (along - 2) * tileRays + across - 2;
        }

        /** Sums six values per row, unrolled: the C1 compiler, which most commands run with, does not unroll, and takes twice as long. */
        private double interpolated(float[] plane, int corner, double[] inRow, double[] acrossRows) {
            double first = inRow[0];
            double second = inRow[1];
            double third = inRow[2];
            double fourth = inRow[3];
            double fifth = inRow[4];
            double sixth = inRow[5];
            double sum = 0;
            int at = corner;
            for (int row = 0; row < QuinticSpline.TAPS; row++, at += tileRays) {
                sum += acrossRows[row]
                        * (first * plane[at]
                                + second * plane[at + 1]
                                + third * plane[at + 2]
                                + fourth * plane[at + 3]
                                + fifth * plane[at + 4]
                                + sixth * plane[at + 5]);
            }
            return sum;
        }

        /** Returns spline coefficients of sqrt(X), sqrt(Y), sqrt(Z), {@code [slice * 3 + color][position * tileRays + ray]}. */
        private float[][] planes(Progress token) {
            float[][] planes = new float[COLORS * slices.depths().length][tileRays * positions.count()];
            LogPolarConvolution convolution = new LogPolarConvolution(start, positions, slices.depths(), powers.bins());
            int next;
            for (int i = 0; i < tileRays; i = next) {
                next = endOfBatch(i);
                WindowedSpectrum.RayBatch batch = powers.new RayBatch(angle(i), angle(next - 1), convolution.knots());
                for (int ray = i; ray < next; ray++) {
                    convolution.colors(batch, angle(ray), planes, ray * positions.count());
                    token.step(0);
                }
            }
            for (int i = 0; i < planes.length; i++) {
                for (int sample = 0; sample < planes[i].length; sample++) {
                    // The truncated sum of terms may be slightly negative in dark directions.
                    planes[i][sample] = (float) Math.sqrt(Math.max(0, planes[i][sample]));
                }
                planes[i] = QuinticSpline.coefficients(planes[i], tileRays, positions.count());
            }
            return planes;
        }

        /** A batch ends where rays are closer to the other axis, 90 degrees away, or too many. */
        private int endOfBatch(int first) {
            boolean alongX = WindowedSpectrum.isAlongX(angle(first));
            int end = first + 1;
            while (end < Math.min(tileRays, first + BATCH_RAYS)
                    && WindowedSpectrum.isAlongX(angle(end)) == alongX
                    && angle(end) - angle(first) < Math.PI / 2) {
                end++;
            }
            return end;
        }

        /** Returns radians; negative for margin rays before ray 0 of the band. */
        private double angle(int ray) {
            return 2 * Math.PI * (firstRay + ray) / rays;
        }
    }

    /** Interpolation by B-splines of degree 5 (Unser, see {@link SplineFilter}). Where cubic B-splines err by 1 %, these err by 0.1 %. */
    private static final class QuinticSpline {
        static final int TAPS = 6;
        /** A step of the samples farther away changes a coefficient by less than 2e-5 of the step. */
        static final int MARGIN = 14;
        // Table 1 of the paper.
        private static final double[] POLES = {-0.4305753470999738, -0.04309628820326465};

        /** Returns the coefficients of samples, transposed; overwrites the samples. */
        static float[] coefficients(float[] plane, int rows, int columns) {
            SplineFilter.alongColumns(plane, rows, columns, POLES);
            float[] transposed = new float[plane.length];
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    transposed[column * rows + row] = plane[row * columns + column];
                }
            }
            SplineFilter.alongColumns(transposed, columns, rows, POLES);
            return transposed;
        }

        /** Computes the weights of six coefficients, from the sample two before the one below the position, at a fraction beyond it. */
        static void weights(double fraction, double[] weights) {
            // De Boor's recursion: B-splines of degree d from those of degree d - 1.
            weights[0] = 1;
            for (int degree = 1; degree < TAPS; degree++) {
                double carried = 0;
                for (int i = 0; i < degree; i++) {
                    double right = i + 1 - fraction;
                    double left = fraction + degree - 1 - i;
                    double share = weights[i] / degree;
                    weights[i] = carried + right * share;
                    carried = left * share;
                }
                weights[degree] = carried;
            }
        }
    }
}
