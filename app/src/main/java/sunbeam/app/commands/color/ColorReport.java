package sunbeam.app.commands.color;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.analysis.PrincipalDirection;

/**
 * What is told of one surface.
 *
 * @param name of the patch
 * @param source of the patch
 * @param direction of most colour
 * @param lightAzimuthDegrees of the light
 * @param coherenceLength that was drawn with, metres
 * @param plan its summary
 * @param model its error, for people
 * @param thetas of the light, degrees
 * @param colours strip by strip, along first; in a strip light by light; by viewing angle
 * @param spectra at chosen angles along
 * @param purest among every degree along under the first light; empty where the mirror's light is all there is
 * @param reach of the mirror's light
 */
record ColorReport(
        String name,
        String source,
        PrincipalDirection direction,
        double lightAzimuthDegrees,
        double coherenceLength,
        String plan,
        String model,
        List<Double> thetas,
        List<SeenColor> colours,
        List<SeenSpectrum> spectra,
        Optional<Purest> purest,
        MirrorReach reach) {

    /**
     * The purest colour.
     *
     * @param width of its spectrum
     * @param windowWidth what the coherence window alone makes of one order there, metres: no spectrum is narrower
     */
    record Purest(SeenColor colour, SpectralWidth width, double windowWidth) {}

    /**
     * Relative radiance by wavelength.
     *
     * @param wavelengths metres
     */
    record SeenSpectrum(SeenColor.View view, double[] wavelengths, double[] radiances, SpectralWidth width) {}

    /** The smallest width that the window alone makes of an order at any angle, metres, at 550 nm. */
    double narrowestOrder() {
        return colours.stream()
                .mapToDouble(colour ->
                        reach.orderWidth(SeenColor.WAVELENGTH, colour.view().pair()))
                .min()
                .orElseThrow();
    }

    /** Whether the mirror's light reaches all angles. */
    boolean isAllMirror() {
        return colours.stream().allMatch(SeenColor::nearMirror);
    }

    /** How many times nearer the mirror's reach must end for the farthest angle to lie outside: 1 or more if none does. */
    double farthest() {
        double largest = colours.stream()
                .mapToDouble(colour -> Math.hypot(
                        colour.view().pair().u(), colour.view().pair().v()))
                .max()
                .orElseThrow();
        return reach.radius() / largest;
    }

    /** The colours of one strip and light. */
    List<SeenColor> strip(boolean along, double theta) {
        return colours.stream()
                .filter(colour ->
                        colour.view().along() == along && colour.view().thetaIDegrees() == theta)
                .toList();
    }
}
