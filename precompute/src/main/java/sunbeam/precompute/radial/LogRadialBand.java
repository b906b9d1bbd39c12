package sunbeam.precompute.radial;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;

/** Rays of one octave of |(u, v)|, divided into sectors, and the positions on them. Immutable. */
final class LogRadialBand {
    // Pairs of sectors let two cores share the work; smaller sectors would waste time on margin rays.
    private static final int RAYS_PER_SECTOR_PAIR = 400;
    // Step of ln lambda; resolves the terms' coefficients.
    private static final double WIDEST_STEP = 0.01;
    // Step between positions, in ln |(u, v)|, at a tolerance of 1, for light with a smooth spectrum: colors vary along
    // a
    // ray only as fast as the color matching functions do, however sharp orders are. Splines err most beside an order
    // that
    // the end of the visible band cuts.
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
    // Share of the positions in margins above which a larger step is not tried.
    private static final double LARGEST_MARGIN_SHARE = 0.5;
    // Length, relative to a power of two, below which the step is enlarged until that power suffices.
    private static final double MOST_ABOVE_POWER = 1.12;
    private static final double STEP_GROWTH = 1.005;

    private final double low;
    private final int rays;
    private final int sectors;
    private final Positions positions;
    private final double positionStep;

    /**
     * @param tolerance error of the power spectrum
     * @param high |(u, v)| of the outermost positions
     * @param step distance in (u, v) between rays at {@code high}
     */
    LogRadialBand(CieTable cie, double tolerance, double sigmaFrequency, double high, double step) {
        this.low = high / 2;
        this.rays = (int) Math.ceil(2 * Math.PI * high / step);
        this.sectors = 2 * Math.max(1, rays / RAYS_PER_SECTOR_PAIR);
        double orderWidth = sigmaFrequency * cie.shortestWavelength() / high;
        double widestStep = WIDEST_SMOOTH * Math.pow(tolerance, STEP_EXPONENT);
        double widerStep = Math.min(MOST_WIDER * widestStep, WIDEST_OF_ORDER * orderWidth);
        double widest = cie.isSmooth() ? Math.max(widestStep, widerStep) : WIDEST_ON_FLANKS * orderWidth;
        this.positions = Positions.widest(cie, widest, Math.min(step / high, WIDEST_STEP));
        this.positionStep = positions.step();
    }

    /**
     * Steps along a ray.
     *
     * @param stride number of wavelength steps per position step
     * @param covered range of ln |f| that a ray of the octave covers
     */
    private record Positions(WavelengthNodes wavelengths, int stride, double covered) {
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

        /** Returns a power of two, which may be slightly too short. */
        private int transform() {
            int power = Integer.highestOneBit(length() - 1);
            return length() < MOST_ABOVE_POWER * power ? power : 2 * power;
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

    LogPolarConvolution convolution(WindowedSpectrum powers, double[] depths) {
        return new LogPolarConvolution(
                start(), positions.count(), positions.stride(), positions.wavelengths(), depths, powers::coefficients);
    }

    /** ln |(u, v)| of the first position. */
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

    /** For {@code sectors()}, the number of rays. */
    int firstRay(int sector) {
        return (int) ((long) rays * sector / sectors);
    }

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

    double onRay(double radius) {
        return (Math.log(radius) - start()) / positionStep;
    }
}
