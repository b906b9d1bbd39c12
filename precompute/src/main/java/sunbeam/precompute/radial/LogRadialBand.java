package sunbeam.precompute.radial;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.IntegratedNodes;
import sunbeam.precompute.color.WavelengthNodes;

/** Rays of an octave of |(u, v)|, divided into sectors, and places on them. Immutable, safe for use by several threads. */
final class LogRadialBand {
    // Rays of two sectors, so that two processors have as much to do; those beside them that splines see come on top.
    private static final int TWO_SECTORS_RAYS = 400;
    // Of ln lambda: color matching functions have weights of their own, and terms' coefficients turn slower.
    private static final double WIDEST_STEP = 0.01;
    // So many wavelengths to a place, at least: where they end, polynomials and B-splines between them reach no farther
    // than orders are wide.
    private static final int LEAST_STRIDE = 3;
    // From place to place, beside the width of an order: what is smoother than color matching functions needs fewer.
    private static final double WIDEST_OF_ORDER = 0.5;
    // Of light that is not smooth: orders' flanks beyond the end of a filter's band are steeper the darker they are.
    private static final double WIDEST_ON_FLANKS = 0.15;
    // But so many times as far as sharp orders need, at most: terms' coefficients of deep reliefs turn fast.
    private static final double MOST_WIDER = 2;
    private static final double MOST_MARGINS = 0.5;
    private static final double LITTLE_LONGER = 1.12;
    private static final double LITTLE = 1.005;

    private final double low;
    private final int rays;
    private final int sectors;
    private final Places places;
    private final double placeStep;

    /**
     * Lays out rays.
     *
     * @param widestPlaces as {@link PowerSpectrum#widestPlaces}
     * @param sigmaFrequency of the window
     * @param high |(u, v)| of the outermost places
     * @param step of (u, v) between rays there
     */
    LogRadialBand(CieTable cie, double widestPlaces, double sigmaFrequency, double high, double step) {
        this.low = high / 2;
        this.rays = (int) Math.ceil(2 * Math.PI * high / step);
        this.sectors = 2 * Math.max(1, rays / TWO_SECTORS_RAYS);
        double orderWidth = sigmaFrequency * cie.shortestWavelength() / high;
        double fewPlaces = Math.min(MOST_WIDER * widestPlaces, WIDEST_OF_ORDER * orderWidth);
        double widest = cie.isSmooth() ? Math.max(widestPlaces, fewPlaces) : WIDEST_ON_FLANKS * orderWidth;
        this.places = Places.asFarAs(cie, widest, Math.min(step / high, WIDEST_STEP));
        this.placeStep = places.step();
    }

    /**
     * Places on a ray, and the wavelengths between them.
     *
     * @param seen what a ray of the octave sees of ln |f|
     */
    private record Places(WavelengthNodes wavelengths, int stride, double seen) {
        /** As far from each other as may be, or a little farther, but no farther than makes transforms shorter. */
        static Places asFarAs(CieTable cie, double widest, double widestStep) {
            Places places = of(cie, widest, widestStep);
            int transform = places.transform();
            double margins = places.length() - places.seen / places.step();
            // Of a ray of few places nearly all is margins, which no step makes shorter.
            if (margins > MOST_MARGINS * transform) {
                return places;
            }
            // Steps divide the wavelengths' range, so that they may come out smaller than asked for.
            double step = places.seen / (transform - margins);
            places = of(cie, step, widestStep);
            while (places.length() > transform) {
                step *= LITTLE;
                places = of(cie, step, widestStep);
            }
            return places;
        }

        private static Places of(CieTable cie, double step, double widestStep) {
            int stride = (int) Math.max(LEAST_STRIDE, Math.ceil(step / widestStep));
            double seen = Math.log(2 * cie.longestWavelength() / cie.shortestWavelength());
            return new Places(IntegratedNodes.logarithmic(cie, step / stride).withoutDarkEnds(), stride, seen);
        }

        /** How long the transforms are; by half shorter where they would be only a little longer than that. */
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

    /** Prepares the colors in some slices, of ascending |w|. */
    LogPolarConvolution convolution(WindowedSpectrum powers, double[] depths) {
        return new LogPolarConvolution(
                start(), places.count(), places.stride(), places.wavelengths(), depths, powers::coefficients);
    }

    /** ln |(u, v)| of the first place. */
    private double start() {
        return Math.log(low) - QuinticSpline.MARGIN * placeStep;
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

    /** The first ray of a sector; behind the last one the number of all. */
    int firstRay(int sector) {
        return (int) ((long) rays * sector / sectors);
    }

    /** Where a place lies among the rays, 0 to {@link #rays()}. */
    double ray(double u, double v) {
        double turns = Math.atan2(v, u) / (2 * Math.PI);
        return (turns < 0 ? turns + 1 : turns) * rays;
    }

    /** The number of a place's sector. */
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

    /** Where |(u, v)| lies among the places of a ray. */
    double onRay(double radius) {
        return (Math.log(radius) - start()) / placeStep;
    }
}
