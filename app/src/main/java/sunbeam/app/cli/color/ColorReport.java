package sunbeam.app.cli.color;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * Result for one surface.
 *
 * @param period of its lines
 * @param verdict what its heights say of its colors, a sentence
 * @param code of the verdict, for programs
 * @param colored whether it has a color of its own
 * @param azimuthDegrees of the plane along
 * @param coherenceLength that was drawn with, metres
 * @param plan its summary
 * @param colors strip by strip, along first; by viewing angle
 * @param spectrum of the purest color or, of a surface without a color of its own, in the mirror direction
 * @param purest empty for a surface without a color of its own
 */
record ColorReport(
        Patch patch,
        GratingPeriod period,
        String verdict,
        String code,
        boolean colored,
        double azimuthDegrees,
        double coherenceLength,
        String plan,
        List<SeenColor> colors,
        SeenSpectrum spectrum,
        Optional<SeenColor> purest) {
    /** For standard output: the verdict, and for a surface with a color where and how it was looked for. */
    List<String> lines() {
        List<String> lines = new ArrayList<>(List.of(verdict));
        purest.ifPresent(color -> lines.add(Text.format(
                "purest color at %s degrees in the plane of azimuth %.0f degrees (%s): %s, %s",
                Decimals.format(Math.rint(1000 * color.view().thetaRDegrees()) / 1000 + 0.0),
                Math.rint(color.view().phiDegrees()) + 0.0,
                color.view().strip(),
                color.describeHue(),
                color.hex())));
        double reach = CoherenceWindow.ofCoherenceLength(coherenceLength).mirrorReach(0);
        if (colored && colors.stream().noneMatch(color -> color.view().nearest() < reach)) {
            lines.add("the mirror direction lies beside both planes, and most colors with it; without --phi-i the light"
                    + " stands in each plane");
        }
        return lines;
    }
}
