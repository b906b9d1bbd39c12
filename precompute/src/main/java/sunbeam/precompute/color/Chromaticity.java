package sunbeam.precompute.color;

/**
 * CIE 1931 chromaticity and what it is called by: dominant wavelength and excitation purity against the light's white
 * (CIE 15:2018, 9.3).
 *
 * @param x of X / (X + Y + Z)
 * @param y of Y / (X + Y + Z)
 */
public record Chromaticity(double x, double y) {
    // Beyond, the locus turns within the rounding of the table.
    private static final int RED_END = 700;
    private static final int BLUE_END = 380;
    // Nearer to white there is no hue: rounding decides it.
    private static final double NO_HUE = 1e-3;

    /** Of linear X, Y, Z; NaN for black. */
    public static Chromaticity of(double[] xyz) {
        double sum = xyz[0] + xyz[1] + xyz[2];
        return new Chromaticity(xyz[0] / sum, xyz[1] / sum);
    }

    /** Of light of one wavelength. */
    public static Chromaticity ofWavelength(CieTable cie, double wavelength) {
        return of(new double[] {cie.at(wavelength, 0), cie.at(wavelength, 1), cie.at(wavelength, 2)});
    }

    /**
     * A hue by its wavelength.
     *
     * @param nanometres dominant wavelength; for purples minus the complementary one; NaN for white, grey and black
     * @param purity excitation purity, 0 for white to 1 for a spectral color or the purest purple; may exceed 1 by rounding
     */
    public record Hue(double nanometres, double purity) {}

    /** Where the line from white through this meets the spectral locus, or for purples the line of purples. */
    public Hue hue(CieTable cie) {
        Chromaticity white = of(cie.white());
        double dx = x - white.x;
        double dy = y - white.y;
        if (!(Math.hypot(dx, dy) > NO_HUE)) {
            return new Hue(Double.NaN, Double.isNaN(x) ? Double.NaN : Math.hypot(dx, dy));
        }
        double[] spectral = white.crossing(cie, dx, dy);
        if (!Double.isNaN(spectral[0])) {
            // Light of one wavelength lies on the locus, but for what its computation errs by.
            return new Hue(spectral[0], Math.min(1, 1 / spectral[1]));
        }
        double[] complement = white.crossing(cie, -dx, -dy);
        double reach = white.reach(dx, dy, ofWavelength(cie, BLUE_END * 1e-9), ofWavelength(cie, RED_END * 1e-9))[0];
        return new Hue(-complement[0], Math.min(1, 1 / reach));
    }

    /** Wavelength in nm and the multiple of (dx, dy) that leads to it from this white; NaN if none does. */
    private double[] crossing(CieTable cie, double dx, double dy) {
        Chromaticity from = ofWavelength(cie, BLUE_END * 1e-9);
        for (int nanometre = BLUE_END; nanometre < RED_END; nanometre++) {
            Chromaticity to = ofWavelength(cie, (nanometre + 1) * 1e-9);
            double[] found = reach(dx, dy, from, to);
            if (found[0] > 0 && found[1] >= 0 && found[1] <= 1) {
                return new double[] {nanometre + found[1], found[0]};
            }
            from = to;
        }
        return new double[] {Double.NaN, Double.NaN};
    }

    /** a and b with this + a (dx, dy) = from + b (to - from). */
    private double[] reach(double dx, double dy, Chromaticity from, Chromaticity to) {
        double ex = to.x - from.x;
        double ey = to.y - from.y;
        double fx = from.x - x;
        double fy = from.y - y;
        double determinant = dy * ex - dx * ey;
        return new double[] {(ex * fy - ey * fx) / determinant, (dx * fy - dy * fx) / determinant};
    }
}
