package sunbeam.app.commands.color;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import jrtr.RenderContext;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayColor;
import sunbeam.precompute.optics.RefractiveIndex;

/**
 * From what is seen to what is told.
 *
 * @param thetas of the light, degrees
 * @param spectra viewing angles along, degrees, at which the spectrum is told; where the colour is purest if there are none
 * @param factor of the exposure
 * @param tolerance that the colours are planned for
 */
record ColorReports(
        List<Double> thetas,
        List<Double> spectra,
        double factor,
        double tolerance,
        RefractiveIndex material,
        CieTable cie) {
    private static final int WHITE = 0xffffff;

    /** @param xyz for each of the strips' views */
    ColorReport of(RenderContext context, ColorStrips strips, List<double[]> xyz) {
        List<SeenColor> colours = new ArrayList<>();
        for (int i = 0; i < xyz.size(); i++) {
            colours.add(SeenColor.of(strips.views().get(i), xyz.get(i), factor, tolerance, strips.window(), cie));
        }
        double[] wavelengths = new double[401];
        for (int i = 0; i < wavelengths.length; i++) {
            wavelengths[i] = (380 + i) * 1e-9;
        }
        List<SeenColor.View> chosen = spectra.isEmpty()
                ? List.of(purest(colours).view())
                : spectra.stream()
                        .map(angle -> strips.view(true, thetas.get(0), angle))
                        .toList();
        List<double[]> radiances = strips.spectra(context, chosen, wavelengths, material);
        List<ColorReport.SeenSpectrum> seen = new ArrayList<>();
        for (int i = 0; i < chosen.size(); i++) {
            seen.add(new ColorReport.SeenSpectrum(chosen.get(i), wavelengths, radiances.get(i)));
        }
        return new ColorReport(
                strips.setup().patch().name(),
                strips.setup().patch().source(),
                strips.azimuthDegrees(),
                strips.lightAzimuthDegrees(),
                strips.window().coherenceLength(),
                strips.plan().summary(),
                thetas,
                colours,
                seen);
    }

    /** The one of most chroma along, under the first light, of those that are not burnt out; else any. */
    private static SeenColor purest(List<SeenColor> colours) {
        double theta = colours.get(0).view().thetaIDegrees();
        return colours.stream()
                .filter(colour -> colour.view().along() && colour.view().thetaIDegrees() == theta)
                .filter(colour -> colour.rgb() != WHITE)
                .max(Comparator.comparingDouble(colour -> colour.lab().chroma()))
                .orElse(colours.get(0));
    }

    static String summary(ColorReport report) {
        SeenColor purest = purest(report.colours());
        double wavelength = purest.hue().nanometres();
        String hue = Double.isNaN(wavelength)
                ? "no hue"
                : String.format(
                        Locale.ROOT,
                        wavelength > 0 ? "dominant wavelength %.0f nm" : "purple, complement of %.0f nm",
                        Math.abs(wavelength));
        return String.format(
                Locale.ROOT,
                "%s: strongest direction at azimuth %.1f degrees; purest colour %s (%s, chroma %.0f +- %.2g) at %.1f degrees;"
                        + " an order is %.2g nm wide there",
                report.name(),
                report.azimuthDegrees(),
                DisplayColor.hex(purest.rgb()),
                hue,
                purest.lab().chroma(),
                purest.uncertainty(),
                purest.view().thetaRDegrees(),
                purest.blurNanometres());
    }
}
