package sunbeam.app.commands.color;

import java.util.List;

/**
 * What is told of one surface.
 *
 * @param name of the patch
 * @param source of the patch
 * @param azimuthDegrees of the strongest direction
 * @param lightAzimuthDegrees of the light
 * @param coherenceLength that was drawn with, metres
 * @param plan its summary
 * @param thetas of the light, degrees
 * @param colours strip by strip, along first; in a strip light by light; by viewing angle
 * @param spectra at chosen angles along
 */
record ColorReport(
        String name,
        String source,
        double azimuthDegrees,
        double lightAzimuthDegrees,
        double coherenceLength,
        String plan,
        List<Double> thetas,
        List<SeenColor> colours,
        List<SeenSpectrum> spectra) {

    /**
     * Relative radiance by wavelength.
     *
     * @param wavelengths metres
     */
    record SeenSpectrum(SeenColor.View view, double[] wavelengths, double[] radiances) {}

    /** The colours of one strip and light. */
    List<SeenColor> strip(boolean along, double theta) {
        return colours.stream()
                .filter(colour ->
                        colour.view().along() == along && colour.view().thetaIDegrees() == theta)
                .toList();
    }
}
