package sunbeam.app.commands.color;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import jrtr.RenderContext;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;

/**
 * What is told of one surface.
 *
 * @param patch the surface
 * @param order what its heights say of its colors
 * @param verdict what they come to
 * @param lightAzimuthDegrees of the light
 * @param coherenceLength that was drawn with, metres
 * @param plan its summary
 * @param thetas of the light, degrees
 * @param colors strip by strip, along first; in a strip light by light; by viewing angle
 * @param spectra at chosen angles along, the purest color's first; never empty
 * @param purest under the first light, with its spectrum; empty for a surface without a color of its own
 */
record ColorReport(
        Patch patch,
        SurfaceOrder order,
        Verdict verdict,
        double lightAzimuthDegrees,
        double coherenceLength,
        String plan,
        List<Double> thetas,
        List<SeenColor> colors,
        List<SeenSpectrum> spectra,
        Optional<SeenColor> purest) {
    private static final int FIRST_NANOMETRE = 380;
    private static final int NANOMETRES = 400;
    // The window alone makes an order 4 nm wide in sunlight.
    private static final int SAMPLES_PER_NANOMETRE = 4;
    // Of the luminances along: what is darker than this share of the angles has little say in which color is purest.
    private static final double BRIGHT = 0.9;

    /**
     * Relative radiance by wavelength.
     *
     * @param wavelengths metres
     */
    record SeenSpectrum(SeenColor.View view, double[] wavelengths, double[] radiances, SpectralBand band) {}

    /**
     * How colors become numbers.
     *
     * @param display what a screen shows of linear light
     * @param tolerance that the colors are planned for
     */
    record Scale(DisplayTransform display, double tolerance, CieTable cie) {}

    /**
     * Of the colors that strips have, and the spectra of some.
     *
     * @param spectrumAngles viewing angles along, degrees
     */
    static ColorReport of(
            RenderContext context,
            StripColors strips,
            List<double[]> xyz,
            Verdict verdict,
            List<Double> thetas,
            List<Double> spectrumAngles,
            RefractiveIndex material,
            Scale scale) {
        List<SeenColor> colors = IntStream.range(0, xyz.size())
                .mapToObj(i -> SeenColor.of(
                        strips.views().get(i), xyz.get(i), scale.display(), scale.tolerance(), scale.cie()))
                .toList();
        List<SeenColor> along = strip(colors, true, thetas.get(0));
        Optional<SeenColor> purest = verdict.colored() ? purest(along, strips.gloss()) : Optional.empty();
        List<SeenColor.View> chosen = new ArrayList<>();
        purest.ifPresent(color -> chosen.add(color.view()));
        spectrumAngles.forEach(angle -> chosen.add(strips.view(true, thetas.get(0), angle)));
        if (chosen.isEmpty()) {
            chosen.add(strips.view(true, thetas.get(0), -thetas.get(0)));
        }
        return new ColorReport(
                strips.setup().patch(),
                strips.order(),
                verdict,
                strips.lightAzimuthDegrees(),
                strips.gloss().window().coherenceLength(),
                strips.plan().summary(),
                thetas,
                colors,
                spectra(context, strips, chosen, material),
                purest);
    }

    private static List<SeenSpectrum> spectra(
            RenderContext context, StripColors strips, List<SeenColor.View> chosen, RefractiveIndex material) {
        double[] fine = wavelengths(SAMPLES_PER_NANOMETRE);
        List<double[]> radiances = strips.spectra(context, chosen, fine, material);
        List<SeenSpectrum> spectra = new ArrayList<>();
        for (int i = 0; i < chosen.size(); i++) {
            double[] all = radiances.get(i);
            double[] told = IntStream.rangeClosed(0, NANOMETRES)
                    .mapToDouble(n -> all[n * SAMPLES_PER_NANOMETRE])
                    .toArray();
            spectra.add(new SeenSpectrum(chosen.get(i), wavelengths(1), told, SpectralBand.of(fine, all)));
        }
        return spectra;
    }

    private static double[] wavelengths(int perNanometre) {
        return IntStream.rangeClosed(0, NANOMETRES * perNanometre)
                .mapToDouble(i -> (FIRST_NANOMETRE + i / (double) perNanometre) * 1e-9)
                .toArray();
    }

    /**
     * The color outside the gloss with the largest product of excitation purity and lightness, the cube root of luminance: what is
     * dark beside the others does not win. No exposure changes it.
     */
    static Optional<SeenColor> purest(List<SeenColor> along, Gloss gloss) {
        List<SeenColor> outside = along.stream()
                .filter(color -> gloss.leaves(color.view(), color.xyz()))
                .toList();
        double[] luminances =
                outside.stream().mapToDouble(color -> color.xyz()[1]).sorted().toArray();
        double bright = luminances.length == 0 ? 1 : luminances[(int) (BRIGHT * (luminances.length - 1))];
        SeenColor best = null;
        double largest = -1;
        for (SeenColor color : outside) {
            double purity = Math.min(1, color.hue().purity());
            double seen = purity * Math.cbrt(Math.min(1, color.xyz()[1] / bright));
            if (seen > largest) {
                largest = seen;
                best = color;
            }
        }
        return Optional.ofNullable(best);
    }

    /** The colors of one strip and light. */
    List<SeenColor> strip(boolean along, double theta) {
        return strip(colors, along, theta);
    }

    private static List<SeenColor> strip(List<SeenColor> colors, boolean along, double theta) {
        return colors.stream()
                .filter(color -> color.view().along() == along && color.view().thetaIDegrees() == theta)
                .toList();
    }

    /** For standard output: the verdict, and for a surface with a color where and how it was looked for. */
    List<String> lines() {
        List<String> lines = new ArrayList<>(List.of(verdict.sentence()));
        lines.add("looked at in the plane of azimuth " + order.describePlane());
        purest.ifPresent(color -> lines.add(String.format(
                Locale.ROOT,
                "purest color at %.0f degrees: %s, %s; half of its light lies within %.0f nm, from %.0f to %.0f nm",
                color.view().thetaRDegrees(),
                color.describeHue(),
                color.hex(),
                1e9 * spectra.get(0).band().width(),
                1e9 * spectra.get(0).band().from(),
                1e9 * spectra.get(0).band().to())));
        return lines;
    }
}
