package sunbeam.app.commands.color;

/**
 * The band of wavelengths that a color is made of: half of its light lies within, a quarter below and a quarter above. A single
 * grain of speckle, however bright, moves it little, which a width at half of the maximum cannot say.
 *
 * @param from metres
 * @param to metres
 */
record SpectralBand(double from, double to) {

    /**
     * Of values at ascending wavelengths, linear between them.
     *
     * @param wavelengths metres, at least two
     */
    static SpectralBand of(double[] wavelengths, double[] radiances) {
        double[] below = new double[radiances.length];
        for (int i = 1; i < below.length; i++) {
            below[i] = below[i - 1] + 0.5 * (radiances[i - 1] + radiances[i]) * (wavelengths[i] - wavelengths[i - 1]);
        }
        return new SpectralBand(quantile(wavelengths, below, 0.25), quantile(wavelengths, below, 0.75));
    }

    /** Metres. */
    double width() {
        return to - from;
    }

    private static double quantile(double[] wavelengths, double[] below, double share) {
        double wanted = share * below[below.length - 1];
        int before = 0;
        while (before < below.length - 2 && below[before + 1] < wanted) {
            before++;
        }
        double step = below[before + 1] - below[before];
        double part = step > 0 ? (wanted - below[before]) / step : 0;
        return wavelengths[before] + part * (wavelengths[before + 1] - wavelengths[before]);
    }
}
