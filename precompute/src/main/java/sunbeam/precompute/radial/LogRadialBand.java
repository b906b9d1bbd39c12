package sunbeam.precompute.radial;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.IntegratedNodes;
import sunbeam.precompute.color.WavelengthNodes;

/** Log-radial band: the rays of one octave of |(u, v)|, divided into sectors, and the positions on them. Immutable. */
final class LogRadialBand {
    // Rays of two sectors, so that two cores share the work; each sector adds margin rays for its splines.
    private static final int TWO_SECTORS_RAYS = 400;
    // Step of ln lambda; resolves the terms' coefficients (color matching functions have exact weights).
    private static final double WIDEST_STEP = 0.01;
    // Wavelengths per position, at least: at the ends of the light's band polynomials and B-splines reach that far.
    private static final int LEAST_STRIDE = 3;
    // Step between positions, in widths of an order.
    private static final double WIDEST_OF_ORDER = 0.5;
    // The same for light with steep edges: flanks of orders beyond the edge are steeper the darker they are.
    private static final double WIDEST_ON_FLANKS = 0.15;
    // Limit of the step in units of widestStep: coefficients of deep reliefs change fast with the wavelength.
    private static final double MOST_WIDER = 2;
    private static final double MOST_MARGINS = 0.5;
    private static final double LITTLE_LONGER = 1.12;
    private static final double LITTLE = 1.005;

    private final double low;
    private final int rays;
    private final int sectors;
    private final Positions positions;
    private final double positionStep;

    /**
     * Lays out the rays.
     *
     * @param widestStep see {@link PowerSpectrum#widestStep}
     * @param sigmaFrequency of the window
     * @param high |(u, v)| of the outermost positions
     * @param step of (u, v) between rays there
     */
    LogRadialBand(CieTable cie, double widestStep, double sigmaFrequency, double high, double step) {
        this.low = high / 2;
        this.rays = (int) Math.ceil(2 * Math.PI * high / step);
        this.sectors = 2 * Math.max(1, rays / TWO_SECTORS_RAYS);
        double orderWidth = sigmaFrequency * cie.shortestWavelength() / high;
        double widerStep = Math.min(MOST_WIDER * widestStep, WIDEST_OF_ORDER * orderWidth);
        double widest = cie.isSmooth() ? Math.max(widestStep, widerStep) : WIDEST_ON_FLANKS * orderWidth;
        this.positions = Positions.widest(cie, widest, Math.min(step / high, WIDEST_STEP));
        this.positionStep = positions.step();
    }

    /**
     * Positions on a ray, and the wavelengths between them.
     *
     * @param covered range of ln |f| that a ray of the octave covers
     */
    private record Positions(WavelengthNodes wavelengths, int stride, double covered) {
        /** Returns the widest step up to one, or slightly wider if that halves the transforms. */
        static Positions widest(CieTable cie, double widest, double wavelengthStep) {
            Positions positions = of(cie, widest, wavelengthStep);
            int transform = positions.transform();
            double margins = positions.length() - positions.covered / positions.step();
            // Short rays consist mostly of margins, which no step shortens.
            if (margins > MOST_MARGINS * transform) {
                return positions;
            }
            // Steps divide the range of wavelengths, so that they may come out smaller.
            double step = positions.covered / (transform - margins);
            positions = of(cie, step, wavelengthStep);
            while (positions.length() > transform) {
                step *= LITTLE;
                positions = of(cie, step, wavelengthStep);
            }
            return positions;
        }

        private static Positions of(CieTable cie, double step, double wavelengthStep) {
            int stride = (int) Math.max(LEAST_STRIDE, Math.ceil(step / wavelengthStep));
            double covered = Math.log(2 * cie.longestWavelength() / cie.shortestWavelength());
            return new Positions(IntegratedNodes.logarithmic(cie, step / stride), stride, covered);
        }

        /** Returns the length of the transforms; the lower power of two if that is only slightly too short. */
        private int transform() {
            int power = Integer.highestOneBit(length() - 1);
            return length() < LITTLE_LONGER * power ? power : 2 * power;
        }

        double step() {
            double[] nodes = wavelengths.wavelengths();
            return stride * Math.log(nodes[nodes.length - 1] / nodes[0]) / (nodes.length - 1);
        }

        int count() {
            return 2 * QuinticSpline.MARGIN + 2 + (int) Math.ceil(Math.log(2) / step());
        }

        private int length() {
            return LogPolarConvolution.length(count(), stride, wavelengths.count());
        }
    }

    /** Returns the kernels for slices of ascending |w|. */
    LogPolarConvolution convolution(WindowedSpectrum powers, double[] depths) {
        return new LogPolarConvolution(
                start(), positions.count(), positions.stride(), positions.wavelengths(), depths, powers::coefficients);
    }

    /** Returns ln |(u, v)| of the first position. */
    private double start() {
        return Math.log(low) - QuinticSpline.MARGIN * positionStep;
    }

    double low() {
        return low;
    }

    int rays() {
        return rays;
    }

    int sectors() {
        return sectors;
    }

    /** Returns the first ray of a sector; the number of rays for the end. */
    int firstRay(int sector) {
        return (int) ((long) rays * sector / sectors);
    }

    /** Returns the fractional ray number, 0 to {@link #rays()}. */
    double ray(double u, double v) {
        double turns = Math.atan2(v, u) / (2 * Math.PI);
        return (turns < 0 ? turns + 1 : turns) * rays;
    }

    int sector(double u, double v) {
        int ray = Math.min(rays - 1, (int) ray(u, v));
        int at = (int) ((long) ray * sectors / rays);
        while (firstRay(at + 1) <= ray) {
            at++;
        }
        while (firstRay(at) > ray) {
            at--;
        }
        return at;
    }

    /** Returns the fractional position of |(u, v)| on a ray. */
    double onRay(double radius) {
        return (Math.log(radius) - start()) / positionStep;
    }
}
