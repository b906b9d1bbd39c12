package sunbeam.app.cli.brdfmap;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Caption of an annotated map: patch, light, material, window, exposure. */
final class MapCaption {
    private MapCaption() {}

    /**
     * Values that differ from their defaults.
     *
     * @param spectrum name of the light's spectrum
     * @param index refractive index as text
     * @param limiting length of the scan's side to which the coherence length was limited, as text
     */
    record Remarks(Optional<String> spectrum, Optional<String> index, Optional<String> limiting) {}

    /**
     * Returns one paragraph for the patch and one for light and window.
     *
     * @param light towards the light
     * @param coherenceLength four standard deviations of the window that was drawn with, meters
     */
    static List<String> of(
            Patch patch, Direction light, double coherenceLength, Method method, Remarks remarks) {
        HeightMap map = patch.heights();
        String surface = Text.format(
                "%s: %s x %s, relief %s",
                patch.name(),
                Lengths.format(rounded(map.width())),
                Lengths.format(rounded(map.height())),
                Lengths.format(rounded(patch.scan().relief())));
        String lit = Text.format(
                "light %s\u00b0 from the normal, azimuth %s\u00b0; %s%scoherence length %s%s%s; method %s",
                degrees(Math.atan2(Math.hypot(light.x(), light.y()), light.z())),
                degrees(Math.atan2(light.y(), light.x())),
                remarks.spectrum().map(spectrum -> spectrum + "; ").orElse(""),
                remarks.index().map(index -> "refractive index " + index + "; ").orElse(""),
                Lengths.format(rounded(coherenceLength)),
                remarks.limiting().map(side -> " (the scan's " + side + ")").orElse(""),
                average(method, map),
                method.type().label());
        return List.of(surface, lit);
    }

    static List<String> with(List<String> caption, String paragraph) {
        List<String> all = new ArrayList<>(caption);
        all.add(paragraph);
        return all;
    }

    private static String degrees(double radians) {
        return Decimals.format(Math.round(1e4 * Math.toDegrees(radians)) * 1e-4 + 0.0);
    }

    private static double rounded(double meters) {
        return new BigDecimal(meters).round(new MathContext(4)).doubleValue();
    }

    private static String average(Method method, HeightMap map) {
        return method.referenceMethod(map).area() instanceof GaussianArea area
                ? area.average() == Average.COHERENT ? ", one coherence area" : ", ensemble average"
                : "";
    }
}
