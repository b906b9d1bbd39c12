package sunbeam.precompute.evaluation;

/**
 * Where a grating's first order is looked for: periods between two lengths.
 *
 * @param shortest metres
 * @param longest metres
 */
public record FirstOrder(double shortest, double longest) {
    // Wavelengths that are tried to see which angles the order takes.
    private static final int TRIED = 41;

    public FirstOrder {
        if (!(shortest > 0 && longest >= shortest && Double.isFinite(longest))) {
            throw new IllegalArgumentException("bad periods: " + shortest + " to " + longest + " m");
        }
    }

    /** Periods from {@code period / factor} to {@code period * factor}. */
    public static FirstOrder around(double period, double factor) {
        return new FirstOrder(period / factor, period * factor);
    }

    /** The period in the middle, in ratios, metres. */
    public double middle() {
        return Math.sqrt(shortest * longest);
    }

    /**
     * The longest wavelength that the middle period's first order sends anywhere above the horizon, metres: |u| of the viewer
     * that is opposite the mirror at the horizon. Of grazing light and view it is twice the period.
     */
    public double longestWavelength(GratingPlane plane) {
        return middle() * (Math.abs(plane.lightAlong()) + Math.sin(plane.largestThetaR()));
    }

    /**
     * The angles theta_r that the order takes over wavelengths (metres): lowest and highest, radians, on the sides of
     * the mirror where the middle period's order is above the horizon at half of the wavelengths or more; empty where
     * there is no such side.
     */
    public double[] angles(GratingPlane plane, double shortestWavelength, double longestWavelength) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int sign = -1; sign <= 1; sign += 2) {
            double[] middles = angles(plane, sign / middle(), shortestWavelength, longestWavelength);
            int seen = 0;
            for (double angle : middles) {
                seen += isSeen(plane, angle) ? 1 : 0;
            }
            if (2 * seen < TRIED) {
                continue;
            }
            for (double period : new double[] {shortest, middle(), longest}) {
                for (double angle : angles(plane, sign / period, shortestWavelength, longestWavelength)) {
                    low = isSeen(plane, angle) ? Math.min(low, angle) : low;
                    high = isSeen(plane, angle) ? Math.max(high, angle) : high;
                }
            }
        }
        return low < high ? new double[] {low, high} : new double[0];
    }

    private static double[] angles(GratingPlane plane, double frequency, double shortest, double longest) {
        double[] angles = new double[TRIED];
        for (int i = 0; i < TRIED; i++) {
            angles[i] = plane.thetaR(frequency * (shortest + (longest - shortest) * i / (TRIED - 1)));
        }
        return angles;
    }

    private static boolean isSeen(GratingPlane plane, double angle) {
        return !Double.isNaN(angle) && Math.abs(angle) <= plane.largestThetaR();
    }
}
