package sunbeam.precompute.patch;

import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.units.Lengths;

/**
 * Whether a measured scan is as large as scans are: a wrong unit makes it a thousand times too large or too small. A profilometer's
 * is millimetres wide and right all the same, so that it is asked, not said.
 */
final class SizeCheck {
    // Metres. Force microscopes reach 150 um, interference microscopes a few hundred.
    private static final double LARGEST = 1e-3;
    // Metres; it holds less than one period of anything that diffracts light.
    private static final double SMALLEST = 300e-9;
    // Metres: what most scans have.
    private static final double USUAL_FROM = 1e-6;
    private static final double USUAL_TO = 300e-6;
    // The unit is one too high, or one too low.
    private static final double[] FACTORS = {1e-3, 1e3};

    private SizeCheck() {}

    /** A warning when the longer side is below 300 nm or above 1 mm. */
    static Optional<String> size(HeightMap map) {
        double side = Math.max(map.width(), map.height());
        if (side >= SMALLEST && side <= LARGEST) {
            return Optional.empty();
        }
        String likely = "";
        for (double factor : FACTORS) {
            if (likely.isEmpty() && side * factor >= USUAL_FROM && side * factor <= USUAL_TO) {
                likely = String.format(
                        Locale.ROOT,
                        " with the next unit %s it would be %s",
                        factor < 1 ? "below" : "above",
                        Lengths.rounded(side * factor, 3));
            }
        }
        return Optional.of(String.format(
                Locale.ROOT,
                "the scan is %s wide, %s: is its unit of length right?%s",
                Lengths.rounded(side, 3),
                side > LARGEST
                        ? "which profilometers scan, but hardly any microscope of heights (" + Lengths.format(LARGEST)
                                + " at most)"
                        : "less than the " + Lengths.format(SMALLEST) + " that microscopes of heights scan at least",
                likely));
    }
}
