package sunbeam.app.commands.color;

/**
 * How broad a spectrum is.
 *
 * @param width metres, between the outermost wavelengths at which it has half of its maximum: of several orders or of
 *     speckle all that is seen
 * @param peak where its maximum lies, metres
 * @param from below which a quarter of its light lies, metres
 * @param to above which a quarter of its light lies, metres
 * @param whole whether it falls to half of its maximum at both sides; else it is broader than the band that was looked at
 */
record SpectralWidth(double width, double peak, double from, double to, boolean whole) {

    /**
     * Of values at ascending wavelengths, linear between them.
     *
     * @param wavelengths metres, at least two
     */
    static SpectralWidth of(double[] wavelengths, double[] radiances) {
        int top = 0;
        for (int i = 1; i < radiances.length; i++) {
            top = radiances[i] > radiances[top] ? i : top;
        }
        double half = radiances[top] / 2;
        int last = radiances.length - 1;
        int from = 0;
        while (radiances[from] < half) {
            from++;
        }
        int to = last;
        while (radiances[to] < half) {
            to--;
        }
        double left = from == 0 ? wavelengths[0] : crossing(wavelengths, radiances, from - 1, half);
        double right = to == last ? wavelengths[last] : crossing(wavelengths, radiances, to, half);
        return new SpectralWidth(
                right - left,
                wavelengths[top],
                quantile(wavelengths, radiances, 0.25),
                quantile(wavelengths, radiances, 0.75),
                from > 0 && to < last);
    }

    /** Below which this share of the light lies, by trapezia. */
    private static double quantile(double[] wavelengths, double[] radiances, double share) {
        double[] below = new double[radiances.length];
        for (int i = 1; i < below.length; i++) {
            below[i] = below[i - 1] + 0.5 * (radiances[i - 1] + radiances[i]) * (wavelengths[i] - wavelengths[i - 1]);
        }
        double wanted = share * below[below.length - 1];
        int before = 0;
        while (before < below.length - 2 && below[before + 1] < wanted) {
            before++;
        }
        double step = below[before + 1] - below[before];
        double part = step > 0 ? (wanted - below[before]) / step : 0;
        return wavelengths[before] + part * (wavelengths[before + 1] - wavelengths[before]);
    }

    private static double crossing(double[] wavelengths, double[] radiances, int before, double value) {
        double share = (value - radiances[before]) / (radiances[before + 1] - radiances[before]);
        return wavelengths[before] + share * (wavelengths[before + 1] - wavelengths[before]);
    }
}
