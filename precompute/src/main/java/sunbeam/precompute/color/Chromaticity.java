package sunbeam.precompute.color;

/** CIE 1931 chromaticity with dominant wavelength and excitation purity against the light's white (CIE 15:2018, 9.3). */
public record Chromaticity(double x, double y) {
    // Ends of the locus in nm; beyond, it moves by less than the table's rounding.
    private static final int RED_END = 700;
    // Below this distance from white rounding would decide the hue.
    private static final double NO_HUE = 1e-3;

    /** NaN for black. */
    public static Chromaticity of(double[] xyz) {
        double sum = xyz[0] + xyz[1] + xyz[2];
        return new Chromaticity(xyz[0] / sum, xyz[1] / sum);
    }

    /** Returns the chromaticity of monochromatic light; wavelength in meters. */
    public static Chromaticity ofWavelength(CieTable cie, double wavelength) {
        return of(new double[] {cie.at(wavelength, 0), cie.at(wavelength, 1), cie.at(wavelength, 2)});
    }

    /**
     * Hue: dominant wavelength in nanometers, negative and complementary for purples, NaN for white, gray and black; and excitation purity,
     * from 0 for white to 1 for a spectral color or the purest purple.
     */
    public record Hue(double nanometers, double purity) {}

    /** Intersects the line from white through this color with the spectral locus, or with the line of purples. */
    public Hue hue(CieTable cie) {
        Chromaticity white = of(cie.white());
        double dx = x - white.x;
        double dy = y - white.y;
        if (!(Math.hypot(dx, dy) > NO_HUE)) {
            return new Hue(Double.NaN, Double.isNaN(x) ? Double.NaN : Math.hypot(dx, dy));
        }
        double[] spectral = white.crossing(cie, dx, dy);
        if (!Double.isNaN(spectral[0])) {
            // Monochromatic light lies on the locus up to rounding.
            return new Hue(spectral[0], Math.min(1, 1 / spectral[1]));
        }
        double[] complement = white.crossing(cie, -dx, -dy);
        double reach =
                white.reach(dx, dy, ofWavelength(cie, firstLit(cie) * 1e-9), ofWavelength(cie, lastLit(cie) * 1e-9))[0];
        return new Hue(-complement[0], Math.min(1, 1 / reach));
    }

    /** Returns the blue end of the locus in nm, or of the light's wavelengths, without which a table has no chromaticity. */
    private static int firstLit(CieTable cie) {
        return Math.max(CieTable.FIRST_NANOMETER, (int) Math.rint(1e9 * cie.shortestWavelength()) + 1);
    }

    private static int lastLit(CieTable cie) {
        return Math.min(RED_END, (int) Math.rint(1e9 * cie.longestWavelength()) - 1);
    }

    /** Returns the wavelength in nm and the multiple of (dx, dy) that reaches it from this white; NaN if there is none. */
    private double[] crossing(CieTable cie, double dx, double dy) {
        int first = firstLit(cie);
        int last = lastLit(cie);
        Chromaticity from = ofWavelength(cie, first * 1e-9);
        for (int nanometer = first; nanometer < last; nanometer++) {
            Chromaticity to = ofWavelength(cie, (nanometer + 1) * 1e-9);
            double[] found = reach(dx, dy, from, to);
            if (found[0] > 0 && found[1] >= 0 && found[1] <= 1) {
                return new double[] {nanometer + found[1], found[0]};
            }
            from = to;
        }
        return new double[] {Double.NaN, Double.NaN};
    }

    /** Returns the a and b that solve this + a (dx, dy) = from + b (to - from). */
    private double[] reach(double dx, double dy, Chromaticity from, Chromaticity to) {
        double ex = to.x - from.x;
        double ey = to.y - from.y;
        double fx = from.x - x;
        double fy = from.y - y;
        double determinant = dy * ex - dx * ey;
        return new double[] {(ex * fy - ey * fx) / determinant, (dx * fy - dy * fx) / determinant};
    }
}
