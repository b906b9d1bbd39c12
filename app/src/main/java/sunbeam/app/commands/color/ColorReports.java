package sunbeam.app.commands.color;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import jrtr.RenderContext;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.ModelError;

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
    private static final double FIRST = 380e-9;
    private static final double BAND = 400e-9;
    private static final int NANOMETRES = 400;
    // Samples across the narrowest order that the window makes, up to a most in each nanometre.
    private static final double FINENESS = 3;
    private static final int MOST_A_NANOMETRE = 20;

    ColorReport of(RenderContext context, ColorStrips strips, ColorStrips.Colours seen) {
        MirrorReach reach = strips.reach();
        List<SeenColor> colours = new ArrayList<>();
        for (int i = 0; i < strips.views().size(); i++) {
            colours.add(colour(strips.views().get(i), seen.shown().get(i), reach));
        }
        OptionalInt best = new PurestColor(reach, cie).of(strips.candidates(), seen.candidates());
        Optional<SeenColor> purest = best.isPresent()
                ? Optional.of(colour(
                        strips.candidates().get(best.getAsInt()),
                        seen.candidates().get(best.getAsInt()),
                        reach))
                : Optional.empty();
        List<SeenColor.View> chosen = new ArrayList<>();
        purest.ifPresent(colour -> chosen.add(colour.view()));
        spectra.forEach(angle -> chosen.add(strips.view(true, thetas.get(0), angle)));
        if (chosen.isEmpty()) {
            chosen.add(brightest(colours).view());
        }
        List<ColorReport.SeenSpectrum> all = spectra(context, strips, chosen);
        return new ColorReport(
                strips.setup().patch().name(),
                strips.setup().patch().source(),
                strips.direction(),
                strips.lightAzimuthDegrees(),
                reach.window().coherenceLength(),
                strips.plan().summary(),
                ModelError.of(strips.setup().patch().scan()).describe(),
                thetas,
                colours,
                spectra.isEmpty() ? all : all.subList(all.size() - spectra.size(), all.size()),
                purest.map(colour -> purest(colour, all.get(0), reach)),
                reach);
    }

    private SeenColor colour(SeenColor.View view, double[] xyz, MirrorReach reach) {
        return SeenColor.of(view, xyz, factor, tolerance, reach, cie);
    }

    private static ColorReport.Purest purest(SeenColor colour, ColorReport.SeenSpectrum spectrum, MirrorReach reach) {
        double peak = spectrum.width().peak();
        return new ColorReport.Purest(
                colour, spectrum.width(), reach.orderWidth(peak, colour.view().pair()));
    }

    private static SeenColor brightest(List<SeenColor> colours) {
        double theta = colours.get(0).view().thetaIDegrees();
        return colours.stream()
                .filter(colour -> colour.view().along() && colour.view().thetaIDegrees() == theta)
                .max(Comparator.comparingDouble(colour -> colour.xyz()[1]))
                .orElseThrow();
    }

    /** Every nanometre, but looked at finely enough for the narrowest order when its width is measured. */
    private List<ColorReport.SeenSpectrum> spectra(
            RenderContext context, ColorStrips strips, List<SeenColor.View> chosen) {
        double narrowest = chosen.stream()
                .mapToDouble(view -> strips.reach().orderWidth(FIRST, view.pair()))
                .min()
                .orElseThrow();
        int fine = (int) Math.max(1, Math.min(MOST_A_NANOMETRE, Math.ceil(FINENESS * 1e-9 / narrowest)));
        double[] wavelengths = wavelengths(fine);
        double[] nanometres = wavelengths(1);
        List<double[]> radiances = strips.spectra(context, chosen, wavelengths, material);
        List<ColorReport.SeenSpectrum> spectra = new ArrayList<>();
        for (int i = 0; i < chosen.size(); i++) {
            double[] all = radiances.get(i);
            double[] told = IntStream.rangeClosed(0, NANOMETRES)
                    .mapToDouble(n -> all[n * fine])
                    .toArray();
            spectra.add(
                    new ColorReport.SeenSpectrum(chosen.get(i), nanometres, told, SpectralWidth.of(wavelengths, all)));
        }
        return spectra;
    }

    private static double[] wavelengths(int eachNanometre) {
        int steps = NANOMETRES * eachNanometre;
        return IntStream.rangeClosed(0, steps)
                .mapToDouble(i -> FIRST + i * BAND / steps)
                .toArray();
    }
}
